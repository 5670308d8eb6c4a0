//! The sheet on which meshes become an instrument.

mod bodies;
mod chosen;
mod fields;
mod kit;
mod piece;
mod standing;

pub(super) use chosen::{Chosen, Place};

use super::theme::{Theme, small};
use crate::mesher::{Mesher, Phase, Places, Quality, State};
use crate::shelf::Library;
use bodies::{More, bodies};
use egui::{Align2, RichText, ScrollArea, Ui, Window, vec2};
use fields::fields;
use kit::{Kit, MOST};
use modes::MeshOrder;
use standing::{Deed, buttons, standing};
use std::collections::VecDeque;
use std::path::PathBuf;
use std::sync::Arc;

/// Width, in points.
const WIDE: f32 = 360.0;
/// Room that it leaves in the window above and below what is asked, in points.
const ROOM: f32 = 160.0;

/// Tells the window that there is something new to draw.
pub(super) type News = Arc<dyn Fn() + Send + Sync>;

/// The sheet, open or not.
pub(super) struct Sheet {
    open: bool,
    chosen: Chosen<(Vec<PathBuf>, Place)>,
    /// What is to be built in full quality, as a notice offers.
    unfinished: Chosen<MeshOrder>,
    mesher: Mesher,
    kit: Kit,
    quality: Quality,
    /// Whether a file is read that is to come onto the sheet.
    coming: bool,
    /// Files that are to be read after it.
    waiting: VecDeque<PathBuf>,
    /// Whether they make a kit together.
    together: bool,
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
            kit: Kit::default(),
            quality: Quality::Full,
            coming: false,
            waiting: VecDeque::new(),
            together: false,
            fault: None,
            news: Arc::new(|| ()),
        }
    }
}

impl Sheet {
    /// Where the meshes are put that come onto it.
    pub(super) fn chosen(&self) -> Chosen<(Vec<PathBuf>, Place)> {
        self.chosen.clone()
    }

    /// Opens the sheet and builds in full quality.
    pub(super) fn finish(&self, order: MeshOrder) {
        self.unfinished.put(order);
    }

    /// Draws the sheet, if there is a mesh on it; whether a dialog is to ask for another mesh.
    pub(super) fn show(&mut self, ui: &Ui, places: &Places, theme: &Theme) -> bool {
        if let Some((paths, place)) = self.chosen.take() {
            self.look(paths, place);
        }
        if let Some(order) = self.unfinished.take() {
            (self.open, self.fault) = (true, None);
            self.order(order, Quality::Full, places);
        }
        if !self.open {
            return false;
        }
        let state = self.mesher.state();
        self.arrive(&state);
        let (mut open, mut deed, mut more) = (true, None, None);
        let tall = ui.ctx().content_rect().height() - ROOM;
        Window::new("An instrument from a mesh")
            .open(&mut open)
            .collapsible(false)
            .resizable(false)
            .default_width(WIDE)
            .anchor(Align2::CENTER_CENTER, vec2(0.0, 0.0))
            .show(ui.ctx(), |ui| {
                ui.set_width(WIDE);
                let idle = !state.phase.works();
                ScrollArea::vertical().max_height(tall).show(ui, |ui| {
                    ui.add_enabled_ui(idle, |ui| more = self.asked(ui, &places.library, theme));
                    ui.separator();
                    standing(ui, &state, self.fault.as_deref(), theme);
                });
                deed = buttons(ui, &state, !self.kit.pieces.is_empty());
            });
        match deed {
            Some(Deed::Build) => self.build(places),
            Some(Deed::Cancel) => {
                self.waiting.clear();
                self.mesher.cancel();
            }
            Some(Deed::Close) => open = false,
            None => {}
        }
        if !open {
            // What is being built ends; a preview that plays already plays on.
            self.mesher.cancel();
            self.waiting.clear();
            self.open = false;
        }
        match more {
            Some(More::File(path)) => self.look(vec![path], Place::Further),
            Some(More::Ask) => return true,
            None => {}
        }
        false
    }

    /// Has files read, for a new sheet or for the one that is open.
    fn look(&mut self, paths: Vec<PathBuf>, place: Place) {
        self.together = place == Place::New && paths.len() > 1;
        if place == Place::New || !self.open {
            self.kit = Kit::default();
            self.quality = Quality::Full;
        }
        (self.open, self.fault) = (true, None);
        if paths.len() > MOST {
            self.fault = Some(format!("A kit has room for {MOST} files: the others stay"));
        }
        self.waiting = paths.into_iter().take(MOST).collect();
        self.next();
    }

    /// Has the next file read, if there is one; else what came together is a kit.
    fn next(&mut self) {
        if let Some(path) = self.waiting.pop_front() {
            self.coming = true;
            let news = Arc::clone(&self.news);
            self.mesher.look(path, move || news());
        } else if std::mem::take(&mut self.together) {
            self.kit.gather();
        }
    }

    /// Puts a file that has been read onto the sheet.
    fn arrive(&mut self, state: &State) {
        if !self.coming || state.phase == Phase::Looking {
            return;
        }
        self.coming = false;
        if let Some(facts) = &state.facts {
            self.kit.add(Arc::new(facts.clone()));
        }
        // What is wrong with the last one stands where it was read.
        if let (Phase::Refused(reason), false) = (&state.phase, self.waiting.is_empty()) {
            let said = self.fault.take().map(|fault| format!("{fault}\n"));
            self.fault = Some(said.unwrap_or_default() + reason);
        }
        self.next();
    }

    /// What is asked of the bodies; which is to come next.
    fn asked(&mut self, ui: &mut Ui, library: &Library, theme: &Theme) -> Option<More> {
        let kit = &mut self.kit;
        if kit.pieces.is_empty() {
            return None;
        }
        let more = bodies(ui, kit, &library.meshes());
        if let Some(piece) = kit.pieces.get_mut(kit.at) {
            let set = ui.push_id(kit.at, |ui| fields(ui, piece, theme)).inner;
            kit.set |= set;
        }
        ui.horizontal(|ui| {
            ui.radio_value(&mut self.quality, Quality::Preview, "Preview");
            ui.radio_value(&mut self.quality, Quality::Full, "Full quality");
        });
        more
    }

    fn build(&mut self, places: &Places) {
        let Some(order) = self.kit.order() else {
            self.fault = Some("Name the mesh's file in Unicode".to_owned());
            return;
        };
        self.fault = None;
        self.order(order, self.quality, places);
    }

    fn order(&mut self, order: MeshOrder, quality: Quality, places: &Places) {
        let news = Arc::clone(&self.news);
        self.mesher.build(order, quality, places, move || news());
    }
}

fn quiet(ui: &mut Ui, text: String, theme: &Theme) {
    ui.label(RichText::new(text).font(small()).color(theme.quiet));
}
