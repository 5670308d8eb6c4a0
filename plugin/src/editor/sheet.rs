//! The sheet on which a mesh becomes an instrument.

use super::theme::{Theme, small};
use crate::mesher::{Facts, Mesher, Phase, Places, Quality, State, guessed_size_m};
use egui::{Align2, ComboBox, DragValue, ProgressBar, RichText, Ui, Window, vec2};
use modes::{FreeFineness, MeshOrder, NAMED_MATERIALS};
use std::path::PathBuf;
use std::sync::{Arc, Mutex, PoisonError};

/// Material of a new sheet.
const USUAL: &str = "bell bronze";
/// Wall of a new sheet as a share of the size.
const WALL: f64 = 0.02;
/// Lowest and highest key that one body is spread over.
const KEYS: [u8; 2] = [36, 96];
/// Width, in points.
const WIDE: f32 = 340.0;

/// Tells the window that there is something new to draw.
pub(super) type News = Arc<dyn Fn() + Send + Sync>;

/// What was chosen, on its way to the sheet.
#[derive(Clone)]
pub(super) struct Chosen<T>(Arc<Mutex<Option<T>>>);

impl<T> Default for Chosen<T> {
    fn default() -> Self {
        Self(Arc::new(Mutex::new(None)))
    }
}

impl<T> Chosen<T> {
    pub(super) fn put(&self, it: T) {
        *self.0.lock().unwrap_or_else(PoisonError::into_inner) = Some(it);
    }

    fn take(&self) -> Option<T> {
        self.0.lock().unwrap_or_else(PoisonError::into_inner).take()
    }
}

/// What is chosen on the sheet.
struct Choice {
    material: &'static str,
    /// Longest side of the bounding box, in mm.
    size_mm: f64,
    hollow: bool,
    wall_mm: f64,
    object: Option<String>,
    spread: bool,
    loudest: bool,
    quality: Quality,
}

impl Choice {
    fn of(facts: &Facts) -> Self {
        let size_mm = 1e3 * guessed_size_m(facts.longest);
        Self {
            material: USUAL,
            size_mm,
            hollow: false,
            wall_mm: (WALL * size_mm).max(0.5),
            object: None,
            spread: true,
            loudest: false,
            quality: Quality::Full,
        }
    }

    fn order(&self, facts: &Facts) -> Option<MeshOrder> {
        let fineness = FreeFineness::default();
        Some(MeshOrder {
            file: facts.path.to_str()?.to_owned(),
            object: self.object.clone(),
            material: self.material.to_owned(),
            size_m: Some(1e-3 * self.size_mm),
            wall_m: self.hollow.then_some(1e-3 * self.wall_mm),
            keys: KEYS,
            by: if self.spread { "size" } else { "nothing" }.to_owned(),
            tuned: if self.loudest { "loudest" } else { "lowest" }.to_owned(),
            nodes: fineness.nodes as u32,
            most_modes: fineness.most_modes as u32,
        })
    }
}

/// The sheet, open or not.
pub(super) struct Sheet {
    open: bool,
    chosen: Chosen<PathBuf>,
    /// What is to be built in full quality, as a notice offers.
    unfinished: Chosen<MeshOrder>,
    mesher: Mesher,
    choice: Option<Choice>,
    /// What is wrong with the choice itself.
    fault: Option<String>,
    pub(super) news: News,
}

impl Default for Sheet {
    fn default() -> Self {
        Self {
            open: false,
            chosen: Chosen::default(),
            unfinished: Chosen::default(),
            mesher: Mesher::default(),
            choice: None,
            fault: None,
            news: Arc::new(|| ()),
        }
    }
}

impl Sheet {
    /// Where a dialog puts the mesh that was picked.
    pub(super) fn chosen(&self) -> Chosen<PathBuf> {
        self.chosen.clone()
    }

    /// Opens the sheet and builds in full quality.
    pub(super) fn finish(&self, order: MeshOrder) {
        self.unfinished.put(order);
    }

    /// Draws the sheet, if there is a mesh on it.
    pub(super) fn show(&mut self, ui: &Ui, places: &Places, theme: &Theme) {
        if let Some(path) = self.chosen.take() {
            (self.open, self.choice, self.fault) = (true, None, None);
            let news = Arc::clone(&self.news);
            self.mesher.look(path, move || news());
        }
        if let Some(order) = self.unfinished.take() {
            (self.open, self.fault) = (true, None);
            self.order(order, Quality::Full, places);
        }
        if !self.open {
            return;
        }
        let state = self.mesher.state();
        if self.choice.is_none() {
            self.choice = state.facts.as_ref().map(Choice::of);
        }
        let mut open = true;
        let mut deed = None;
        Window::new("An instrument from a mesh")
            .open(&mut open)
            .collapsible(false)
            .resizable(false)
            .default_width(WIDE)
            .anchor(Align2::CENTER_CENTER, vec2(0.0, 0.0))
            .show(ui.ctx(), |ui| {
                ui.set_width(WIDE);
                if let (Some(choice), Some(facts)) = (&mut self.choice, &state.facts) {
                    let idle = !state.phase.works();
                    ui.add_enabled_ui(idle, |ui| fields(ui, choice, facts, theme));
                }
                ui.separator();
                standing(ui, &state, self.fault.as_deref(), theme);
                deed = buttons(ui, &state);
            });
        match deed {
            Some(Deed::Build) => self.build(&state, places),
            Some(Deed::Cancel) => self.mesher.cancel(),
            Some(Deed::Close) => open = false,
            None => {}
        }
        if !open {
            // What is being built ends; a preview that plays already plays on.
            self.mesher.cancel();
            self.open = false;
        }
    }

    fn build(&mut self, state: &State, places: &Places) {
        let (Some(choice), Some(facts)) = (&self.choice, &state.facts) else {
            return;
        };
        let Some(order) = choice.order(facts) else {
            self.fault = Some(format!("{}: name the file in Unicode", facts.file_name()));
            return;
        };
        let quality = choice.quality;
        self.fault = None;
        self.order(order, quality, places);
    }

    fn order(&mut self, order: MeshOrder, quality: Quality, places: &Places) {
        let news = Arc::clone(&self.news);
        self.mesher.build(order, quality, places, move || news());
    }
}

/// What a button asks for.
enum Deed {
    Build,
    Cancel,
    Close,
}

fn quiet(ui: &mut Ui, text: String, theme: &Theme) {
    ui.label(RichText::new(text).font(small()).color(theme.quiet));
}

fn fields(ui: &mut Ui, choice: &mut Choice, facts: &Facts, theme: &Theme) {
    let (name, count) = (facts.file_name(), facts.triangles);
    quiet(ui, format!("{name}: {count} triangles"), theme);
    ComboBox::from_label("Material")
        .selected_text(choice.material)
        .show_ui(ui, |ui| {
            for entry in NAMED_MATERIALS {
                let m = &entry.material;
                let figures = format!(
                    "{:.0} kg/m³, λ {:.1} GPa, μ {:.1} GPa\n{}",
                    m.density_kg_m3,
                    1e-9 * m.lambda_pa,
                    1e-9 * m.mu_pa,
                    entry.source
                );
                ui.selectable_value(&mut choice.material, entry.name, entry.name)
                    .on_hover_text(figures);
            }
        });
    if facts.objects.len() > 1 {
        let all = format!("all {} in one", facts.objects.len());
        let text = choice.object.clone().unwrap_or_else(|| all.clone());
        ComboBox::from_label("Objects")
            .selected_text(text)
            .show_ui(ui, |ui| {
                ui.selectable_value(&mut choice.object, None, all);
                for (name, _) in facts.objects.iter().filter(|(name, _)| !name.is_empty()) {
                    ui.selectable_value(&mut choice.object, Some(name.clone()), name);
                }
            });
    }
    ui.horizontal(|ui| {
        let size = DragValue::new(&mut choice.size_mm)
            .range(1.0..=10_000.0)
            .suffix(" mm");
        let label = ui.label("Longest side");
        ui.add(size).labelled_by(label.id);
    });
    ui.horizontal(|ui| {
        ui.checkbox(&mut choice.hollow, "Hollow, with a wall of");
        let wall = DragValue::new(&mut choice.wall_mm)
            .range(0.2..=1000.0)
            .suffix(" mm");
        ui.add_enabled(choice.hollow, wall);
    });
    ui.checkbox(&mut choice.spread, "Tuned over all keys by its size")
        .on_hover_text("Without, each key strikes the same body at its own pitch");
    ui.add_enabled_ui(choice.spread, |ui| {
        ui.checkbox(&mut choice.loudest, "Tuned by its loudest mode")
            .on_hover_text("Without, by its lowest");
    });
    ui.horizontal(|ui| {
        ui.radio_value(&mut choice.quality, Quality::Preview, "Preview");
        ui.radio_value(&mut choice.quality, Quality::Full, "Full quality");
    });
}

/// How far it is, what was mended, and what is wrong.
fn standing(ui: &mut Ui, state: &State, fault: Option<&str>, theme: &Theme) {
    let left = state
        .left_s
        .map_or_else(String::new, |left_s| format!(", about {left_s:.0} s left"));
    let progress = |what: &str| {
        let percent = 100.0 * state.share;
        ProgressBar::new(state.share).text(format!("{what}: {percent:.0} %{left}"))
    };
    match &state.phase {
        Phase::Idle => {}
        Phase::Looking => quiet(ui, "Reading the file…".to_owned(), theme),
        Phase::Preview => drop(ui.add(progress("Preview"))),
        Phase::Full => drop(ui.add(progress("The preview sounds. Full quality"))),
        Phase::Done => quiet(
            ui,
            "It plays, and its bank is in your folder.".to_owned(),
            theme,
        ),
        Phase::Cancelled => quiet(ui, "Given up.".to_owned(), theme),
        Phase::Stopped => quiet(
            ui,
            "Full quality was given up. The preview plays, and goes with the song.".to_owned(),
            theme,
        ),
        Phase::Refused(reason) => {
            ui.label(RichText::new(reason).font(small()).color(theme.alarm));
        }
    }
    if let Some(fault) = fault {
        ui.label(RichText::new(fault).font(small()).color(theme.alarm));
    }
    for note in &state.notes {
        quiet(ui, format!("· {note}"), theme);
    }
}

fn buttons(ui: &mut Ui, state: &State) -> Option<Deed> {
    let mut deed = None;
    ui.horizontal(|ui| {
        if state.phase.works() {
            if ui.button("Cancel").clicked() {
                deed = Some(Deed::Cancel);
            }
        } else {
            let can = state.facts.is_some();
            if ui.add_enabled(can, egui::Button::new("Build")).clicked() {
                deed = Some(Deed::Build);
            }
            if ui.button("Close").clicked() {
                deed = Some(Deed::Close);
            }
        }
    });
    deed
}
