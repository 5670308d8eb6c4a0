//! The parameters on pages, group by group.

use super::choice::{choice, switch};
use super::hands::Hands;
use super::knob::{CELL, knob};
use super::param::Param;
use super::tabs::{TABS, Tab, tabs};
use super::theme::{NEAR, SIDE, Theme, small};
use crate::maker::recipe_of;
use crate::params::shape::idle;
use egui::{Align, Align2, Layout, Rect, ScrollArea, Sense, Ui, UiBuilder, pos2, vec2};
use modes::Bank;
use nice_plug::prelude::ParamSetter;

/// Pages and the groups that are on them; what is in no group listed here is on the last.
const PAGES: [(Tab, &[&str]); 6] = [
    (
        ("Strike", "Where bodies are struck, how hard, and with what"),
        &["Strike", "Mallet"],
    ),
    (
        ("Damping", "What takes the sound away, and how fast"),
        &["Damping"],
    ),
    (
        ("Bow", "Whether keys rub instead of striking, and how"),
        &["Bow"],
    ),
    (
        (
            "Body",
            "Size, drawing, material and surroundings of the bodies",
        ),
        &["Body", "Shape", "Motor"],
    ),
    (
        ("Sound", "Where you listen, and how loud"),
        &["Listener", "Output"],
    ),
    (("Hands", "What velocity, wheels and pressure do"), &[]),
];

/// Which page is open.
#[derive(Default)]
pub(super) struct Pages {
    open: usize,
    /// The instrument whose idle controls these are.
    instrument: Option<usize>,
    /// Controls that do nothing to it, by id, and why.
    idle: Vec<(&'static str, &'static str)>,
}

/// The page that a parameter is on.
fn page_of(group: &str) -> usize {
    PAGES
        .iter()
        .position(|(_, groups)| groups.contains(&group))
        .unwrap_or(PAGES.len() - 1)
}

/// The parameters on a page. The instrument is above them all.
fn here(params: &[Param], page: usize) -> impl Iterator<Item = &Param> {
    params
        .iter()
        .filter(move |param| page_of(&param.group) == page && param.spec.id != "instr")
}

impl Pages {
    /// Learns which controls do something to the instrument of that number.
    pub(super) fn follow(&mut self, instrument: usize, bank: &Bank) {
        if self.instrument != Some(instrument) {
            self.instrument = Some(instrument);
            self.idle = idle(recipe_of(bank).as_ref());
        }
    }

    /// Draws tabs and the open page at `area`.
    pub(super) fn show(
        &mut self,
        ui: &mut Ui,
        area: Rect,
        params: &[Param],
        theme: &Theme,
        hands: &mut Hands,
        setter: &ParamSetter<'_>,
    ) {
        let there: Vec<usize> = (0..PAGES.len())
            .filter(|page| here(params, *page).next().is_some())
            .collect();
        if !there.contains(&self.open) {
            self.open = there.first().copied().unwrap_or(0);
        }
        let names: Vec<Tab> = there.iter().map(|page| PAGES[*page].0).collect();
        let open = there.iter().position(|page| *page == self.open);
        let chosen = tabs(ui, area, &names, open.unwrap_or(0), theme);
        self.open = there.get(chosen).copied().unwrap_or(self.open);
        let several = {
            let mut groups = here(params, self.open).map(|param| &param.group);
            let first = groups.next();
            groups.any(|group| Some(group) != first)
        };
        let idle = &self.idle;
        let page = Rect::from_min_max(pos2(area.left(), area.top() + TABS + NEAR), area.max);
        let mut inner = ui.new_child(
            UiBuilder::new()
                .id_salt(("page", self.open))
                .max_rect(page)
                .layout(Layout::top_down(Align::Min)),
        );
        inner.set_clip_rect(page.intersect(ui.clip_rect()));
        ScrollArea::vertical()
            .auto_shrink([false, false])
            .show(&mut inner, |ui| {
                let mut rest = here(params, self.open).peekable();
                while let Some(first) = rest.next() {
                    let mut group = vec![first];
                    while let Some(param) = rest.next_if(|param| param.group == first.group) {
                        group.push(param);
                    }
                    if several {
                        heading(ui, &first.group, theme);
                    } else {
                        ui.add_space(SIDE);
                    }
                    ui.horizontal_wrapped(|ui| {
                        ui.spacing_mut().item_spacing = vec2(NEAR, SIDE);
                        for param in group {
                            match idle.iter().find(|(id, _)| *id == param.spec.id) {
                                Some((_, why)) => {
                                    let still = |ui: &mut Ui| {
                                        ui.disable();
                                        knob(ui, param, theme, hands, setter)
                                            .on_disabled_hover_text(*why);
                                    };
                                    ui.scope(still);
                                }
                                None => control(ui, param, theme, hands, setter),
                            }
                        }
                    });
                }
            });
    }
}

/// The name of a group, where there are several.
fn heading(ui: &mut Ui, name: &str, theme: &Theme) {
    let (rect, _) = ui.allocate_exact_size(vec2(ui.available_width(), 18.0), Sense::hover());
    ui.painter().text(
        rect.left_center() + vec2(NEAR, 0.0),
        Align2::LEFT_CENTER,
        name.to_uppercase(),
        small(),
        theme.quiet,
    );
}

/// A parameter's control: a knob if it glides, else a switch or a list.
fn control(ui: &mut Ui, param: &Param, theme: &Theme, hands: &mut Hands, setter: &ParamSetter<'_>) {
    // A list is two cells wide and does not break.
    if ui.available_size_before_wrap().x < CELL.x {
        ui.end_row();
    }
    match param.steps() {
        None => knob(ui, param, theme, hands, setter),
        Some(1) => switch(ui, param, theme, setter),
        Some(_) => choice(ui, param, theme, setter),
    };
}
