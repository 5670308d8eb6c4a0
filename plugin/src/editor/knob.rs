//! A knob for a parameter that glides.

use super::hands::Hands;
use super::menu::menu;
use super::param::Param;
use super::theme::{Cause, NEAR, Theme, body, small};
use egui::{
    Align2, CursorIcon, EventFilter, Id, Key, Painter, Pos2, Rect, Response, Sense, Shape, Stroke,
    Ui, Vec2, WidgetInfo, pos2, vec2,
};
use nice_plug::prelude::ParamSetter;
use std::f32::consts::TAU;

/// Width and height that a control takes.
pub(super) const CELL: Vec2 = vec2(92.0, 84.0);

/// Pointer travel from one end to the other, in points.
const TRAVEL: f32 = 180.0;
/// Share of the range that an arrow key or a notch of the wheel moves.
const STEP: f32 = 0.02;
/// What Shift leaves of any movement.
const FINE: f32 = 0.1;
/// Turn at the first value and from there to the last, in turns from pointing right, clockwise.
const FROM: f32 = 0.375;
const SWEEP: f32 = 0.75;

/// Draws a knob with its name above and its value below.
pub(super) fn knob(
    ui: &mut Ui,
    param: &Param,
    theme: &Theme,
    hands: &mut Hands,
    setter: &ParamSetter<'_>,
) -> Response {
    let (cell, _) = ui.allocate_exact_size(CELL, Sense::hover());
    let name = Rect::from_min_size(cell.min, vec2(cell.width(), 16.0));
    let value = Rect::from_min_size(
        pos2(cell.left(), cell.bottom() - 20.0),
        vec2(cell.width(), 20.0),
    );
    let dial = Rect::from_min_max(
        pos2(cell.left(), name.bottom()),
        pos2(cell.right(), value.top()),
    );
    let response = ui.interact(
        dial,
        Id::unique(("knob", param.spec.id)),
        Sense::click_and_drag(),
    );
    response.widget_info(|| WidgetInfo {
        current_text_value: Some(param.text()),
        ..WidgetInfo::slider(ui.is_enabled(), f64::from(param.value()), param.spec.name)
    });
    turn(ui, &response, param, hands, setter);
    menu(&response, param, Some(&mut hands.typing), setter);
    paint(ui.painter(), dial, param, theme, &response);
    caption(ui, cell, param.spec.name, theme);
    read(ui, value, param, theme, hands, setter);
    response
        .on_hover_and_drag_cursor(CursorIcon::ResizeVertical)
        .on_hover_text(param.spec.tooltip)
}

/// What pointer and keys do to the parameter.
fn turn(ui: &Ui, response: &Response, param: &Param, hands: &mut Hands, setter: &ParamSetter<'_>) {
    let fine = if ui.input(|input| input.modifiers.shift) {
        FINE
    } else {
        1.0
    };
    // A click elsewhere just before makes a double click a triple one.
    if response.double_clicked() || response.triple_clicked() {
        hands.hold.let_go(setter);
        param.put(setter, param.default());
        return;
    }
    if response.drag_started() {
        response.request_focus();
        hands.hold.take(param, setter);
    }
    if response.dragged() && hands.hold.holds(param) {
        let drag = response.drag_delta();
        hands.hold.push(fine * (drag.x - drag.y) / TRAVEL, setter);
    }
    if response.drag_stopped() {
        hands.hold.let_go(setter);
    }
    if response.clicked() {
        response.request_focus();
    }
    if response.hovered() {
        let turns = notches(ui);
        if turns != 0.0 {
            param.put(setter, param.value() + fine * STEP * turns);
        }
    }
    if response.has_focus() {
        ui.memory_mut(|memory| {
            memory.set_focus_lock_filter(
                response.id,
                EventFilter {
                    horizontal_arrows: true,
                    vertical_arrows: true,
                    ..EventFilter::default()
                },
            );
        });
        keys(ui, param, fine, hands, setter);
    }
}

/// Notches that the wheel has turned by, up being more; nothing else hears of them.
pub(super) fn notches(ui: &Ui) -> f32 {
    ui.input_mut(|input| {
        let mut turns = 0.0;
        input.events.retain(|event| match event {
            egui::Event::MouseWheel { unit, delta, .. } => {
                let delta = delta.x + delta.y;
                turns += match unit {
                    egui::MouseWheelUnit::Point => delta / 50.0,
                    egui::MouseWheelUnit::Line | egui::MouseWheelUnit::Page => delta,
                };
                false
            }
            _ => true,
        });
        input.smooth_scroll_delta = Vec2::ZERO;
        turns
    })
}

fn keys(ui: &Ui, param: &Param, fine: f32, hands: &mut Hands, setter: &ParamSetter<'_>) {
    let pressed = |key| ui.input(|input| input.key_pressed(key));
    let moves = [
        (Key::ArrowUp, STEP),
        (Key::ArrowRight, STEP),
        (Key::ArrowDown, -STEP),
        (Key::ArrowLeft, -STEP),
        (Key::PageUp, 5.0 * STEP),
        (Key::PageDown, -5.0 * STEP),
    ];
    let moved: f32 = moves
        .iter()
        .filter(|(key, _)| pressed(*key))
        .map(|(_, step)| fine * step)
        .sum();
    if moved != 0.0 {
        param.put(setter, param.value() + moved);
    }
    if pressed(Key::Delete) || pressed(Key::Backspace) {
        param.put(setter, param.default());
    }
    if pressed(Key::Enter) {
        hands.typing.open(param);
    }
}

/// The value below a control; a click opens a field to type in.
pub(super) fn read(
    ui: &mut Ui,
    rect: Rect,
    param: &Param,
    theme: &Theme,
    hands: &mut Hands,
    setter: &ParamSetter<'_>,
) {
    if hands.typing.is_open(param) {
        hands
            .typing
            .show(ui, rect.shrink2(vec2(NEAR, 0.0)), param, theme, setter);
        return;
    }
    let response = ui.interact(rect, Id::unique(("read", param.spec.id)), Sense::CLICK);
    let text = param.text();
    response.widget_info(|| {
        WidgetInfo::labeled(
            egui::Role::Button,
            true,
            format!("Type {}", param.spec.name),
        )
    });
    if response.clicked() {
        hands.typing.open(param);
    }
    let colour = if response.hovered() {
        theme.glow
    } else {
        theme.text
    };
    ui.painter()
        .text(rect.center(), Align2::CENTER_CENTER, text, body(), colour);
    response
        .on_hover_cursor(CursorIcon::Text)
        .on_hover_text("Click to type a value");
}

/// A name at the top of a control.
pub(super) fn caption(ui: &Ui, cell: Rect, name: &str, theme: &Theme) {
    let at = pos2(cell.center().x, cell.top() + 8.0);
    ui.painter()
        .text(at, Align2::CENTER_CENTER, name, small(), theme.quiet);
}

/// A point on the rim of a dial, `share` 0…1 of the way round.
fn rim(centre: Pos2, radius: f32, share: f32) -> Pos2 {
    let angle = TAU * (FROM + SWEEP * share);
    centre + radius * Vec2::angled(angle)
}

fn arc(painter: &Painter, centre: Pos2, radius: f32, span: [f32; 2], stroke: Stroke) {
    let [from, to] = span;
    let pieces = 40;
    let points = (0..=pieces)
        .map(|i| {
            rim(
                centre,
                radius,
                from + (to - from) * i as f32 / pieces as f32,
            )
        })
        .collect();
    painter.add(Shape::line(points, stroke));
}

fn paint(painter: &Painter, dial: Rect, param: &Param, theme: &Theme, response: &Response) {
    let centre = dial.center() + vec2(0.0, 2.0);
    let radius = 0.5 * dial.height().min(dial.width()) - 4.0;
    let colour = Cause::of(param.spec.id).map_or(theme.glow, |cause| theme.cause(cause));
    let value = param.value();
    // What can be negative is drawn from zero.
    let from = if param.spec.min < 0.0 && param.spec.max > 0.0 {
        param.place(0.0)
    } else {
        0.0
    };
    arc(
        painter,
        centre,
        radius,
        [0.0, 1.0],
        Stroke::new(3.0, theme.line),
    );
    if (value - from).abs() > 1e-3 {
        arc(
            painter,
            centre,
            radius,
            [from, value],
            Stroke::new(3.0, colour),
        );
    }
    let edge = if response.has_focus() {
        theme.glow
    } else if response.hovered() || response.dragged() {
        theme.quiet
    } else {
        theme.line
    };
    painter.circle(centre, radius - 5.0, theme.raised, Stroke::new(1.0, edge));
    let pointer = Cause::of(param.spec.id).map_or(theme.text, |_| colour);
    painter.line_segment(
        [
            rim(centre, radius - 12.0, value),
            rim(centre, radius - 6.0, value),
        ],
        Stroke::new(2.5, pointer),
    );
}
