//! How far a build is, and what to do about it.

use super::quiet;
use crate::editor::theme::{Theme, small};
use crate::mesher::{Phase, State};
use egui::{Button, ProgressBar, RichText, Ui};

/// What a button asks for.
pub(super) enum Deed {
    Build,
    Cancel,
    Close,
}

/// How far it is, what was mended, and what is wrong.
pub(super) fn standing(ui: &mut Ui, state: &State, fault: Option<&str>, theme: &Theme) {
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

/// The buttons; there is something to build if `can`.
pub(super) fn buttons(ui: &mut Ui, state: &State, can: bool) -> Option<Deed> {
    let mut deed = None;
    ui.horizontal(|ui| {
        if state.phase.works() {
            if ui.button("Cancel").clicked() {
                deed = Some(Deed::Cancel);
            }
        } else {
            if ui.add_enabled(can, Button::new("Build")).clicked() {
                deed = Some(Deed::Build);
            }
            if ui.button("Close").clicked() {
                deed = Some(Deed::Close);
            }
        }
    });
    deed
}
