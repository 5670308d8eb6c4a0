//! The line at the top: which preset, which instrument, undo and compare, how bright a window, how loud.

use super::icon::Icon;
use super::instruments::Instruments;
use super::meter::Meter;
use super::param::Param;
use super::presets::{Browser, Session, bar, tools};
use super::theme::{APART, SIDE, Theme, body, small, title};
use egui::{Align2, CursorIcon, Id, Rect, Role, Sense, Ui, WidgetInfo, pos2, vec2};
use nice_plug::prelude::ParamSetter;

/// What the header is about.
pub(super) struct Top<'a> {
    pub(super) instrument: Option<&'a Param>,
    pub(super) instruments: &'a Instruments,
    pub(super) meter: &'a mut Meter,
    pub(super) session: &'a mut Session,
    pub(super) browser: &'a mut Browser,
}

/// Draws it at `area`; whether the other theme is wanted.
pub(super) fn header(
    ui: &mut Ui,
    area: Rect,
    top: Top<'_>,
    theme: &Theme,
    setter: &ParamSetter<'_>,
) -> bool {
    let wide = area.width() > 860.0;
    let middle = area.center().y;
    let mut left = area.left();
    if wide {
        let name = ui.painter().text(
            area.left_center(),
            Align2::LEFT_CENTER,
            "Idiophone",
            title(),
            theme.glow,
        );
        left = name.right() + APART;
    }
    if let Some(param) = top.instrument {
        left = instrument(
            ui,
            left,
            middle,
            wide,
            (param, top.instruments),
            theme,
            setter,
        ) + SIDE;
    }
    let spare = area.right() - left - if wide { 330.0 } else { 280.0 };
    let right = left + spare.clamp(150.0, 340.0);
    bar(
        ui,
        [left, right],
        middle,
        top.session,
        top.browser,
        theme,
        setter,
    );
    left = tools(ui, right + NEXT, middle, wide, top.session, theme, setter);
    let rect = Rect::from_min_size(pos2(left + NEXT, middle - 12.0), vec2(40.0, 24.0));
    let meter = Rect::from_min_max(pos2(rect.right() + NEXT, area.top()), area.max);
    top.meter.show(ui, meter, theme);
    brightness(ui, rect, theme)
}

/// Space between what is side by side here.
const NEXT: f32 = 6.0;

/// The list of instruments, between arrows where there is room; where it ends.
fn instrument(
    ui: &mut Ui,
    left: f32,
    middle: f32,
    wide: bool,
    (param, instruments): (&Param, &Instruments),
    theme: &Theme,
    setter: &ParamSetter<'_>,
) -> f32 {
    let arrow = if wide { 22.0 } else { 0.0 };
    let size = vec2(if wide { 148.0 } else { 132.0 }, 30.0);
    let list = Rect::from_min_size(pos2(left + arrow, middle - 15.0), size);
    let font = if wide { body() } else { small() };
    instruments.show(ui, list, param, theme, font, setter);
    if wide {
        let button = |x: f32| Rect::from_center_size(pos2(x, middle), vec2(20.0, 28.0));
        step(ui, button(list.left() - 11.0), -1.0, param, theme, setter);
        step(ui, button(list.right() + 11.0), 1.0, param, theme, setter);
    }
    list.right() + arrow
}

/// The button to the other theme; whether it was clicked.
fn brightness(ui: &Ui, rect: Rect, theme: &Theme) -> bool {
    let text = if theme.dark { "Light" } else { "Dark" };
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
    let (name, icon) = if way < 0.0 {
        ("Previous instrument", Icon::Back)
    } else {
        ("Next instrument", Icon::On)
    };
    let response = ui.interact(rect, Id::unique(name), Sense::click());
    response.widget_info(|| WidgetInfo::labeled(Role::Button, true, name));
    if response.clicked() {
        let steps = param.steps().unwrap_or(1) as f32;
        param.put(setter, param.value() + way / steps);
    }
    let lit = response.hovered() || response.has_focus();
    let colour = if lit { theme.text } else { theme.quiet };
    icon.paint(ui.painter(), rect, colour);
    response
        .on_hover_cursor(CursorIcon::PointingHand)
        .on_hover_text(name);
}
