//! The line at the top: which instrument, how bright a window, how loud.

use super::instruments::Instruments;
use super::meter::Meter;
use super::param::Param;
use super::theme::{APART, SIDE, Theme, body, title};
use egui::{Align2, CursorIcon, Id, Rect, Role, Sense, Stroke, Ui, WidgetInfo, pos2, vec2};
use nice_plug::prelude::ParamSetter;

/// Draws it at `area`; whether the other theme is wanted.
pub(super) fn header(
    ui: &mut Ui,
    area: Rect,
    instrument: Option<&Param>,
    instruments: &Instruments,
    meter: &mut Meter,
    theme: &Theme,
    setter: &ParamSetter<'_>,
) -> bool {
    let wide = area.width() > 760.0;
    let mut left = area.left();
    if wide {
        let name = ui.painter().text(
            area.left_center(),
            Align2::LEFT_CENTER,
            "Idiophone",
            title(),
            theme.glow,
        );
        left = name.right() + 2.0 * APART;
    }
    if let Some(param) = instrument {
        let middle = area.center().y;
        let button = |x: f32| Rect::from_center_size(pos2(x, middle), vec2(26.0, 28.0));
        step(ui, button(left + 13.0), -1.0, param, theme, setter);
        let list = Rect::from_min_size(pos2(left + 28.0, middle - 15.0), vec2(210.0, 30.0));
        instruments.show(ui, list, param, theme, setter);
        step(ui, button(list.right() + 15.0), 1.0, param, theme, setter);
    }
    let meter_width = if wide { 240.0 } else { 170.0 };
    let at = Rect::from_min_max(pos2(area.right() - meter_width, area.top()), area.max);
    meter.show(ui, at, theme);
    let text = if theme.dark { "Light" } else { "Dark" };
    let size = vec2(52.0, 24.0);
    let rect = Rect::from_center_size(
        pos2(at.left() - APART - 0.5 * size.x, area.center().y),
        size,
    );
    let response = ui.interact(rect, Id::unique("theme"), Sense::click());
    response.widget_info(|| WidgetInfo::labeled(Role::Button, true, text));
    let lit = response.hovered() || response.has_focus();
    let colour = if lit { theme.text } else { theme.quiet };
    ui.painter()
        .text(rect.center(), Align2::CENTER_CENTER, text, body(), colour);
    let clicked = response.clicked();
    response
        .on_hover_cursor(CursorIcon::PointingHand)
        .on_hover_text("A window for bright or for dim rooms");
    clicked
}

/// A button to the instrument before or after.
fn step(ui: &Ui, rect: Rect, way: f32, param: &Param, theme: &Theme, setter: &ParamSetter<'_>) {
    let name = if way < 0.0 {
        "Previous instrument"
    } else {
        "Next instrument"
    };
    let response = ui.interact(rect, Id::unique(name), Sense::click());
    response.widget_info(|| WidgetInfo::labeled(Role::Button, true, name));
    if response.clicked() {
        let steps = param.steps().unwrap_or(1) as f32;
        param.put(setter, param.value() + way / steps);
    }
    let lit = response.hovered() || response.has_focus();
    let colour = if lit { theme.text } else { theme.quiet };
    let centre = rect.center();
    let tip = centre + vec2(way * 3.0, 0.0);
    let wing = |y: f32| centre + vec2(-way * 3.0, y);
    ui.painter().line(
        vec![wing(-SIDE * 0.75), tip, wing(SIDE * 0.75)],
        Stroke::new(2.0, colour),
    );
    response
        .on_hover_cursor(CursorIcon::PointingHand)
        .on_hover_text(name);
}
