//! Undo, redo, and the two sides of a comparison.

use super::super::icon::Icon;
use super::super::theme::{Theme, body};
use super::button::sign;
use super::session::Session;
use egui::{Align2, CornerRadius, CursorIcon, Id, Rect, Role, Sense, Ui, WidgetInfo, pos2, vec2};
use nice_plug::prelude::ParamSetter;

/// Width of one of its buttons.
const WIDTH: f32 = 26.0;

/// Draws it from `left` on; with a button to copy one side to the other where there is room.
pub(in super::super) fn tools(
    ui: &Ui,
    left: f32,
    middle: f32,
    wide: bool,
    session: &mut Session,
    theme: &Theme,
    setter: &ParamSetter<'_>,
) -> f32 {
    let mut x = left;
    let mut place = |gap: f32| {
        x += gap;
        let rect = Rect::from_center_size(pos2(x + 0.5 * WIDTH, middle), vec2(WIDTH - 2.0, 26.0));
        x += WIDTH;
        rect
    };
    let told = |what: &str, name: Option<String>, keys: &str| match name {
        Some(name) => format!("{what} {name} ({keys})"),
        None => format!("Nothing to {}", what.to_lowercase()),
    };
    let undo = session.past.history.before().map(|step| step.name.clone());
    let redo = session.past.history.after().map(|step| step.name.clone());
    let response = sign(ui, place(0.0), Icon::Undo, "Undo", undo.is_some(), theme);
    if response.clicked() {
        session.undo(setter);
    }
    response.on_hover_text(told("Undo", undo, "Ctrl+Z"));
    let response = sign(ui, place(0.0), Icon::Redo, "Redo", redo.is_some(), theme);
    if response.clicked() {
        session.redo(setter);
    }
    response.on_hover_text(told("Redo", redo, "Ctrl+Shift+Z"));
    for (side, name) in ["A", "B"].into_iter().enumerate() {
        let rect = place(if side == 0 { 6.0 } else { 0.0 });
        let heard = session.past.heard == side;
        if letter(ui, rect, name, heard, theme) {
            session.turn(side, setter);
        }
    }
    if wide {
        let other = ["B", "A"][session.past.heard.min(1)];
        let response = sign(
            ui,
            place(0.0),
            Icon::Copy,
            "Copy to the other side",
            true,
            theme,
        );
        if response.clicked() {
            session.copy();
        }
        response.on_hover_text(format!("Make {other} the same as what you hear now"));
    }
    x
}

/// A side; whether it is wanted.
fn letter(ui: &Ui, rect: Rect, name: &str, heard: bool, theme: &Theme) -> bool {
    let response = ui.interact(rect, Id::unique(("side", name)), Sense::click());
    response
        .widget_info(|| WidgetInfo::selected(Role::Button, true, heard, format!("Side {name}")));
    let fill = if heard { theme.glow } else { theme.raised };
    let ink = match (heard, response.hovered() || response.has_focus()) {
        (true, _) => theme.ground,
        (false, true) => theme.text,
        (false, false) => theme.quiet,
    };
    let (left, right) = if name == "A" { (5, 0) } else { (0, 5) };
    let corners = CornerRadius {
        nw: left,
        sw: left,
        ne: right,
        se: right,
    };
    ui.painter()
        .rect_filled(rect.expand2(vec2(1.0, -1.0)), corners, fill);
    ui.painter()
        .text(rect.center(), Align2::CENTER_CENTER, name, body(), ink);
    let clicked = response.clicked();
    response
        .on_hover_cursor(CursorIcon::PointingHand)
        .on_hover_text("Two sounds to compare: each side keeps its own");
    clicked
}
