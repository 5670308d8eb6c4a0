//! Partials taken by hand: one alone, louder or softer, longer or shorter.

use super::plot::Line;
use super::theme::{SIDE, Theme, small};
use crate::engine::{Trim, Trims};
use crate::params::TrimTable;
use egui::{
    CursorIcon, EventFilter, Id, Key, Modifiers, PointerButton, Rect, Response, Role, Sense, Ui,
    WidgetInfo, pos2,
};
use modes::ModeLabel;

/// What Shift leaves of any movement.
const FINE: f32 = 0.1;
/// What an arrow key changes: dB, and how many times as long.
const STEP_DB: f32 = 1.0;
const STEP_RINGING: f32 = 1.1;

/// What is done to a partial that is held.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Grasp {
    /// Its level moves.
    Level,
    /// How long it rings moves.
    Ringing,
}

/// What the hands remember.
#[derive(Default)]
pub(super) struct Trimming {
    held: Option<(ModeLabel, Grasp)>,
    /// The partial that keys act on.
    chosen: Option<ModeLabel>,
}

/// How the plot is laid out, for movements to follow the pointer.
pub(super) struct Scales {
    /// dB to a point downwards in the upper half.
    pub(super) db: f32,
    /// e-folds of time to a point downwards in the lower half.
    pub(super) folds: f32,
}

impl Trimming {
    /// The partial that is held, or that keys act on.
    pub(super) fn told(&self) -> Option<ModeLabel> {
        self.held.map(|(label, _)| label).or(self.chosen)
    }

    /// Does what pointer and keys ask for; `pointed` is the partial under the pointer and the half that
    /// it is in.
    pub(super) fn hands(
        &mut self,
        ui: &Ui,
        response: &Response,
        pointed: Option<(ModeLabel, Grasp)>,
        lines: &[Line],
        scales: &Scales,
        table: &TrimTable,
    ) {
        let modifiers = ui.input(|input| input.modifiers);
        if response.clicked() {
            let by_pointer = ui.input(|input| input.pointer.any_released());
            let label = if by_pointer {
                pointed.map(|(label, _)| label)
            } else {
                self.chosen
            };
            table.change(|trims| match label {
                Some(label) => alone(trims, label),
                None => trims.set_solo(None),
            });
        }
        if response.clicked_by(PointerButton::Secondary)
            && let Some((label, _)) = pointed
        {
            set(table, label, Trim::NONE);
        }
        if response.drag_started_by(PointerButton::Primary) {
            response.request_focus();
            self.held = pointed.map(|(label, grasp)| {
                let other = modifiers.command || modifiers.alt;
                (label, if other { Grasp::Ringing } else { grasp })
            });
        }
        if let Some((label, grasp)) = self.held {
            if response.dragged() {
                self.drag(response, modifiers, (label, grasp), scales, table);
            } else {
                self.held = None;
            }
        }
        if response.has_focus() {
            self.keys(ui, response, lines, table);
        } else {
            self.chosen = None;
        }
    }

    fn drag(
        &self,
        response: &Response,
        modifiers: Modifiers,
        (label, grasp): (ModeLabel, Grasp),
        scales: &Scales,
        table: &TrimTable,
    ) {
        let fine = if modifiers.shift { FINE } else { 1.0 };
        let by = response.drag_delta();
        let mut trim = table.get().get(&label);
        match grasp {
            Grasp::Level => trim.level_db -= fine * scales.db * by.y,
            // Down is longer, and so is right.
            Grasp::Ringing => trim.ringing *= (fine * scales.folds * (by.y + by.x)).exp(),
        }
        set(table, label, trim);
    }

    fn keys(&mut self, ui: &Ui, response: &Response, lines: &[Line], table: &TrimTable) {
        let filter = EventFilter {
            horizontal_arrows: true,
            vertical_arrows: true,
            ..EventFilter::default()
        };
        ui.memory_mut(|memory| memory.set_focus_lock_filter(response.id, filter));
        let pressed = |key: Key| ui.input(|input| input.key_pressed(key));
        let at = lines
            .iter()
            .position(|line| Some(line.label) == self.chosen);
        let last = lines.len().saturating_sub(1);
        let next = match at {
            _ if lines.is_empty() => None,
            Some(at) if pressed(Key::ArrowRight) => Some((at + 1).min(last)),
            Some(at) if pressed(Key::ArrowLeft) => Some(at.saturating_sub(1)),
            None if pressed(Key::ArrowRight) || pressed(Key::ArrowLeft) => Some(0),
            at => at,
        };
        self.chosen = next.map(|at| lines[at].label);
        let Some(label) = self.chosen else {
            return;
        };
        let shift = ui.input(|input| input.modifiers.shift);
        let mut trim = table.get().get(&label);
        for (key, way) in [(Key::ArrowUp, 1.0), (Key::ArrowDown, -1.0)] {
            if pressed(key) && shift {
                trim.ringing *= STEP_RINGING.powf(way);
            } else if pressed(key) {
                trim.level_db += way * STEP_DB;
            }
        }
        if pressed(Key::Delete) || pressed(Key::Backspace) {
            trim = Trim::NONE;
        }
        set(table, label, trim);
    }
}

/// One partial alone, or all again if it is.
fn alone(trims: &mut Trims, label: ModeLabel) {
    let is = trims.solo() == Some(label);
    trims.set_solo((!is).then_some(label));
}

fn set(table: &TrimTable, label: ModeLabel, trim: Trim) {
    table.change(|trims| {
        // A table that is full stays as it is.
        let _ = trims.set(&label, trim);
    });
}

/// A trim in words.
pub(super) fn words(trim: &Trim) -> String {
    let mut words = Vec::new();
    if trim.level_db != 0.0 {
        words.push(format!("{:+.1} dB", trim.level_db).replace('-', "−"));
    }
    if trim.ringing != 1.0 {
        words.push(format!("{:.2}× as long", trim.ringing));
    }
    words.join(", ")
}

/// How many modes are trimmed, at the right end of `line`; a click puts all back. The width that it takes.
pub(super) fn all_back(ui: &Ui, line: Rect, table: &TrimTable, theme: &Theme) -> f32 {
    let count = table.get().all().count();
    if count == 0 {
        return 0.0;
    }
    let text = format!("{count} trimmed: reset");
    let galley = |colour| ui.painter().layout_no_wrap(text.clone(), small(), colour);
    let size = galley(theme.quiet).size();
    let rect = Rect::from_min_size(
        pos2(line.right() - size.x - 2.0, line.top() + 8.0 - 0.5 * size.y),
        size,
    );
    let response = ui.interact(rect.expand(3.0), Id::unique("untrim"), Sense::click());
    response.widget_info(|| WidgetInfo::labeled(Role::Button, true, "Reset all trims"));
    if response.clicked() {
        table.change(|trims| {
            let solo = trims.solo();
            *trims = Trims::NONE;
            trims.set_solo(solo);
        });
    }
    let lit = response.hovered() || response.has_focus();
    let colour = if lit { theme.text } else { theme.glow };
    ui.painter().galley(rect.min, galley(colour), colour);
    response
        .on_hover_cursor(CursorIcon::PointingHand)
        .on_hover_text("Every partial as loud and as long as it was built");
    size.x + SIDE
}
