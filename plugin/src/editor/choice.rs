//! A list for a parameter that is one of some names.

use super::knob::{CELL, caption};
use super::menu::menu;
use super::param::Param;
use super::theme::{NEAR, Theme, body, small};
use egui::{
    Align2, Button, CornerRadius, CursorIcon, EventFilter, FontId, Id, Key, Popup, Rect, Response,
    ScrollArea, Sense, Shape, Stroke, StrokeKind, Ui, Vec2, WidgetInfo, pos2, vec2,
};
use nice_plug::prelude::ParamSetter;

/// A box with a name above it, as wide as a control.
pub(super) fn choice(
    ui: &mut Ui,
    param: &Param,
    theme: &Theme,
    setter: &ParamSetter<'_>,
) -> Response {
    let wide = vec2(2.0 * CELL.x, CELL.y);
    let (cell, _) = ui.allocate_exact_size(wide, Sense::hover());
    caption(ui, cell, param.spec.name, theme);
    let rect = Rect::from_center_size(cell.center(), vec2(wide.x - 2.0 * NEAR, 26.0));
    chooser(ui, rect, param, theme, small(), setter)
}

/// The place 0…1 of a name by number.
pub(super) fn place(index: usize, steps: usize) -> f32 {
    index as f32 / steps.max(1) as f32
}

/// The box alone: click to open the list, arrows and wheel to go through it.
pub(super) fn chooser(
    ui: &mut Ui,
    rect: Rect,
    param: &Param,
    theme: &Theme,
    font: FontId,
    setter: &ParamSetter<'_>,
) -> Response {
    let steps = param.steps().unwrap_or(1);
    let response = closed(ui, rect, (param, &param.text()), theme, font, setter);
    let mut wanted = None;
    Popup::menu(&response).width(rect.width()).show(|ui| {
        ui.set_min_width(rect.width());
        ScrollArea::vertical().max_height(320.0).show(ui, |ui| {
            for index in 0..=steps {
                let value = place(index, steps);
                let here = (param.value() - value).abs() * (steps as f32) < 0.5;
                let line = Button::selectable(here, param.text_at(value))
                    .min_size(vec2(rect.width() - 24.0, 22.0));
                if ui.add(line).clicked() {
                    wanted = Some(value);
                    ui.close();
                }
            }
        });
    });
    let moved = stepped(ui, &response);
    if moved != 0.0 {
        wanted = Some(param.value() + moved / steps as f32);
    }
    if let Some(value) = wanted {
        param.put(setter, value);
    }
    response
        .on_hover_cursor(CursorIcon::PointingHand)
        .on_hover_text(param.spec.tooltip)
}

/// The box while its list is shut, with what it says and its menu.
pub(super) fn closed(
    ui: &Ui,
    rect: Rect,
    (param, text): (&Param, &str),
    theme: &Theme,
    font: FontId,
    setter: &ParamSetter<'_>,
) -> Response {
    let response = ui.interact(rect, Id::unique(("choice", param.spec.id)), Sense::click());
    response.widget_info(|| WidgetInfo {
        current_text_value: Some(text.to_owned()),
        ..WidgetInfo::labeled(egui::Role::ComboBox, true, param.spec.name)
    });
    paint(ui, rect, text, theme, font, &response);
    menu(&response, param, None, setter);
    response
}

/// Names that keys or wheel go on by.
pub(super) fn stepped(ui: &Ui, response: &Response) -> f32 {
    let mut moved = 0.0;
    if response.has_focus() {
        ui.memory_mut(|memory| {
            memory.set_focus_lock_filter(
                response.id,
                EventFilter {
                    vertical_arrows: true,
                    ..EventFilter::default()
                },
            );
        });
        ui.input(|input| {
            moved += f32::from(u8::from(input.key_pressed(Key::ArrowDown)));
            moved -= f32::from(u8::from(input.key_pressed(Key::ArrowUp)));
        });
    }
    if response.hovered() {
        let turns = super::knob::notches(ui);
        if turns != 0.0 {
            moved -= turns.signum();
        }
    }
    moved
}

/// The box itself.
fn paint(ui: &Ui, rect: Rect, text: &str, theme: &Theme, font: FontId, response: &Response) {
    let painter = ui.painter_at(rect);
    let edge = if response.has_focus() {
        theme.glow
    } else if response.hovered() {
        theme.quiet
    } else {
        theme.line
    };
    painter.rect(
        rect,
        CornerRadius::same(5),
        theme.raised,
        Stroke::new(1.0, edge),
        StrokeKind::Inside,
    );
    let left = pos2(rect.left() + 10.0, rect.center().y);
    painter.text(left, Align2::LEFT_CENTER, text, font, theme.text);
    let tip = pos2(rect.right() - 14.0, rect.center().y + 2.5);
    let wing = |x: f32| tip + Vec2::new(x, -5.0);
    painter.add(Shape::line(
        vec![wing(-4.5), tip, wing(4.5)],
        Stroke::new(1.5, theme.quiet),
    ));
}

/// A switch: one of two words, a click for the other.
pub(super) fn switch(
    ui: &mut Ui,
    param: &Param,
    theme: &Theme,
    setter: &ParamSetter<'_>,
) -> Response {
    let (cell, _) = ui.allocate_exact_size(CELL, Sense::hover());
    caption(ui, cell, param.spec.name, theme);
    let rect = Rect::from_center_size(cell.center(), vec2(36.0, 20.0));
    let response = ui.interact(cell, Id::unique(("switch", param.spec.id)), Sense::click());
    let on = param.value() >= 0.5;
    response.widget_info(|| WidgetInfo {
        current_text_value: Some(param.text()),
        ..WidgetInfo::selected(egui::Role::CheckBox, true, on, param.spec.name)
    });
    if response.clicked() {
        param.put(setter, if on { 0.0 } else { 1.0 });
    }
    menu(&response, param, None, setter);
    let colour =
        super::theme::Cause::of(param.spec.id).map_or(theme.glow, |cause| theme.cause(cause));
    let fill = if on { colour } else { theme.line };
    let edge = if response.has_focus() || response.hovered() {
        theme.quiet
    } else {
        fill
    };
    let painter = ui.painter();
    painter.rect(
        rect,
        CornerRadius::same(10),
        fill,
        Stroke::new(1.0, edge),
        StrokeKind::Inside,
    );
    let x = if on {
        rect.right() - 10.0
    } else {
        rect.left() + 10.0
    };
    painter.circle_filled(pos2(x, rect.center().y), 7.0, theme.text);
    painter.text(
        pos2(cell.center().x, cell.bottom() - 10.0),
        Align2::CENTER_CENTER,
        param.text(),
        body(),
        theme.text,
    );
    response
        .on_hover_cursor(CursorIcon::PointingHand)
        .on_hover_text(param.spec.tooltip)
}
