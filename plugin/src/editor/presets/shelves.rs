//! The shelves: all, favourites, the user's own, instruments, categories.

use super::super::theme::{NEAR, SIDE, Theme, body, small};
use super::browser::Browser;
use super::button::line;
use super::session::Session;
use crate::factory::titles;
use crate::presets::{Kind, Search};
use egui::{Align2, ScrollArea, Sense, Ui, vec2};
use std::collections::BTreeSet;

impl Browser {
    /// Draws the shelves, each with how many are on it.
    pub(super) fn shelves(&mut self, ui: &mut Ui, session: &Session, theme: &Theme) {
        ui.spacing_mut().item_spacing.y = 1.0;
        ScrollArea::vertical()
            .auto_shrink([false, false])
            .show(ui, |ui| {
                for (kind, name) in [
                    (Kind::All, "All presets"),
                    (Kind::Favourites, "Favourites"),
                    (Kind::User, "My presets"),
                ] {
                    self.shelf(ui, kind, name, session, theme);
                }
                heading(ui, "INSTRUMENTS", theme);
                for title in titles() {
                    self.shelf(
                        ui,
                        Kind::Instrument(title.to_owned()),
                        title,
                        session,
                        theme,
                    );
                }
                heading(ui, "KINDS", theme);
                for name in categories(session) {
                    self.shelf(ui, Kind::Category(name.clone()), &name, session, theme);
                }
            });
    }

    fn shelf(&mut self, ui: &mut Ui, kind: Kind, name: &str, session: &Session, theme: &Theme) {
        let here = Search {
            kind: kind.clone(),
            text: String::new(),
        };
        let entries = session.library.entries().iter();
        let count = entries.filter(|entry| here.finds(entry)).count();
        let (rect, _) =
            ui.allocate_exact_size(vec2(ui.available_width() - SIDE, 22.0), Sense::hover());
        let chosen = self.search.kind == kind;
        let response = line(
            ui,
            rect,
            &format!("{kind:?}"),
            &format!("Shelf {name}"),
            chosen,
            theme,
        );
        if response.clicked() {
            self.search.kind = kind;
        }
        let ink = if chosen || response.hovered() {
            theme.text
        } else {
            theme.quiet
        };
        ui.painter().text(
            rect.left_center() + vec2(SIDE, 0.0),
            Align2::LEFT_CENTER,
            name,
            body(),
            ink,
        );
        ui.painter().text(
            rect.right_center() - vec2(SIDE, 0.0),
            Align2::RIGHT_CENTER,
            count,
            small(),
            theme.quiet,
        );
    }
}

fn categories(session: &Session) -> BTreeSet<String> {
    let entries = session.library.entries().iter();
    let presets = entries.filter_map(|entry| entry.preset.as_ref().ok());
    let names = presets.map(|preset| preset.card.category.clone());
    names.filter(|name| !name.is_empty()).collect()
}

fn heading(ui: &mut Ui, name: &str, theme: &Theme) {
    ui.add_space(SIDE);
    let (rect, _) = ui.allocate_exact_size(vec2(ui.available_width(), 18.0), Sense::hover());
    ui.painter().text(
        rect.left_center() + vec2(SIDE, 0.0),
        Align2::LEFT_CENTER,
        name,
        small(),
        theme.quiet,
    );
    ui.add_space(NEAR);
}
