//! The presets that are found.

use super::super::icon::Icon;
use super::super::theme::{SIDE, Theme, body, small};
use super::browser::Browser;
use super::button::{line, one_of};
use super::session::Session;
use crate::presets::{Entry, Origin, Preset};
use egui::style::ScrollAnimation;
use egui::{Align, Align2, Rect, ScrollArea, Sense, Ui, pos2, vec2};
use nice_plug::prelude::ParamSetter;

/// Height of a line.
const LINE: f32 = 26.0;
/// From a line's left end to its tags.
const TAGS: f32 = 190.0;

impl Browser {
    /// Draws the list; a click on a line loads its preset, one on its star marks it.
    pub(super) fn list(
        &mut self,
        ui: &mut Ui,
        session: &mut Session,
        theme: &Theme,
        setter: &ParamSetter<'_>,
    ) {
        let found = self.found(session);
        if found.is_empty() {
            self.nothing(ui, theme);
            return;
        }
        let chosen = session.chosen().origin();
        let mut clicked = None;
        let mut marked = None;
        ui.spacing_mut().item_spacing.y = 1.0;
        ScrollArea::vertical()
            .auto_shrink([false, false])
            .show(ui, |ui| {
                for origin in &found {
                    let Some(entry) = session.library.find(origin) else {
                        continue;
                    };
                    let (rect, _) = ui.allocate_exact_size(
                        vec2(ui.available_width() - SIDE, LINE),
                        Sense::hover(),
                    );
                    let here = self.shown.as_ref().or(chosen.as_ref()) == Some(origin);
                    if here && self.seek {
                        self.seek = false;
                        ui.scroll_to_rect_animation(
                            rect,
                            Some(Align::Center),
                            ScrollAnimation::none(),
                        );
                    }
                    if ui.is_rect_visible(rect) {
                        match row(ui, rect, entry, here, theme) {
                            Some(Hit::Line) => clicked = Some(origin.clone()),
                            Some(Hit::Star) => marked = Some((origin.clone(), !entry.favourite)),
                            None => {}
                        }
                    }
                }
            });
        if let Some((origin, on)) = marked
            && let Err(broken) = session.library.mark(&origin, on)
        {
            self.say(Err(broken));
        }
        if let Some(origin) = clicked {
            self.form = None;
            session.choose(&origin, setter);
            self.hearing.ask(ui.input(|input| input.time));
            self.shown = is_broken(session, &origin).then_some(origin);
        }
    }

    fn nothing(&self, ui: &Ui, theme: &Theme) {
        let text = if self.search.text.is_empty() {
            "Nothing here yet"
        } else {
            "No preset has all of these words"
        };
        let at = ui.max_rect().center_top() + vec2(0.0, 40.0);
        ui.painter()
            .text(at, Align2::CENTER_CENTER, text, body(), theme.quiet);
    }
}

fn is_broken(session: &Session, origin: &Origin) -> bool {
    let entry = session.library.find(origin);
    entry.is_some_and(|entry| entry.preset.is_err())
}

/// What of a line is clicked.
enum Hit {
    Line,
    Star,
}

fn row(ui: &Ui, rect: Rect, entry: &Entry, here: bool, theme: &Theme) -> Option<Hit> {
    let (name, key) = (entry.name(), entry.origin.key());
    let response = line(ui, rect, &key, name, here, theme);
    let star = Rect::from_min_size(rect.min, vec2(LINE, LINE));
    let label = if entry.favourite { "Unmark" } else { "Mark" };
    let mark = one_of(
        ui,
        star.shrink(2.0),
        if entry.favourite {
            Icon::Star
        } else {
            Icon::Hollow
        },
        (&key, &format!("{label} {name}")),
        true,
        theme,
    );
    if entry.favourite {
        Icon::Star.paint(ui.painter(), star, theme.glow);
    }
    let (side, ink) = match &entry.preset {
        Ok(preset) => (preset.instrument(), theme.text),
        Err(_) => ("broken", theme.alarm),
    };
    let right = ui.painter().text(
        rect.right_center() - vec2(SIDE, 0.0),
        Align2::RIGHT_CENTER,
        side,
        small(),
        if entry.preset.is_ok() {
            theme.quiet
        } else {
            ink
        },
    );
    let room = Rect::from_min_max(rect.min, pos2(right.left() - SIDE, rect.bottom()));
    ui.painter_at(room).text(
        pos2(star.right() + 2.0, rect.center().y),
        Align2::LEFT_CENTER,
        name,
        body(),
        ink,
    );
    if let Ok(preset) = &entry.preset {
        tags(ui, room, preset, theme);
    }
    if mark.clicked() {
        return Some(Hit::Star);
    }
    let hit = response.clicked().then_some(Hit::Line);
    match &entry.preset {
        Ok(preset) => response.on_hover_text(&preset.card.about),
        Err(reason) => response.on_hover_text(reason),
    };
    hit
}

/// The first tags, where there is room between the name and the instrument.
fn tags(ui: &Ui, room: Rect, preset: &Preset, theme: &Theme) {
    let left = room.left() + TAGS;
    if room.right() < left + 120.0 {
        return;
    }
    let place = Rect::from_min_max(pos2(left, room.top()), room.max);
    ui.painter_at(place).text(
        place.left_center(),
        Align2::LEFT_CENTER,
        preset.card.tags_text(),
        small(),
        theme.quiet,
    );
}
