//! The chosen preset: its name, those beside it, and what can be done with it.

use super::super::icon::Icon;
use super::super::theme::{Theme, body};
use super::browser::Browser;
use super::button::sign;
use super::session::Session;
use egui::{
    Align2, CornerRadius, CursorIcon, Id, Popup, Rect, Role, Sense, Stroke, StrokeKind, Ui,
    WidgetInfo, pos2, vec2,
};
use nice_plug::prelude::ParamSetter;

/// Width of a button.
const WIDTH: f32 = 26.0;

/// Draws it between `left` and `right`.
pub(in super::super) fn bar(
    ui: &Ui,
    span: [f32; 2],
    middle: f32,
    session: &mut Session,
    browser: &mut Browser,
    theme: &Theme,
    setter: &ParamSetter<'_>,
) {
    let [left, right] = span;
    let button = |x: f32| Rect::from_min_size(pos2(x, middle - 13.0), vec2(WIDTH - 2.0, 26.0));
    for (x, icon, name, way) in [
        (left, Icon::Back, "Previous preset", -1),
        (right - 3.0 * WIDTH, Icon::On, "Next preset", 1),
    ] {
        let response = sign(ui, button(x), icon, name, true, theme);
        if response.clicked() {
            let among = browser.among(session);
            session.next(way, &among, setter);
        }
        response.on_hover_text(name);
    }
    let field = Rect::from_min_max(
        pos2(left + WIDTH, middle - 15.0),
        pos2(right - 3.0 * WIDTH - 2.0, middle + 15.0),
    );
    name(ui, field, session, browser, theme);
    let save = sign(
        ui,
        button(right - 2.0 * WIDTH),
        Icon::Save,
        "Save preset",
        true,
        theme,
    );
    if save.clicked() {
        browser.begin_saving(session);
    }
    save.on_hover_text("Save what you hear as a preset");
    let menu = sign(
        ui,
        button(right - WIDTH),
        Icon::Menu,
        "Preset menu",
        true,
        theme,
    );
    Popup::menu(&menu).show(|ui| {
        ui.set_min_width(150.0);
        if ui
            .button("Init")
            .on_hover_text("Everything as new, but the instrument")
            .clicked()
        {
            session.reset(setter);
        }
        if ui.button("Save as…").clicked() {
            browser.begin_saving(session);
        }
        if ui.button("Import…").clicked() {
            browser.begin_importing(session);
        }
        if ui.button("Export…").clicked() {
            browser.begin_exporting(session);
        }
        if ui.button("Copy sound to the other side").clicked() {
            session.copy();
        }
    });
    menu.on_hover_text("More to do with presets");
}

/// The name, which opens and closes the browser.
fn name(ui: &Ui, rect: Rect, session: &mut Session, browser: &mut Browser, theme: &Theme) {
    let chosen = session.chosen();
    let text = session.name();
    let response = ui.interact(rect, Id::unique("preset name"), Sense::click());
    response.widget_info(|| WidgetInfo {
        current_text_value: Some(text.clone()),
        ..WidgetInfo::labeled(Role::Button, true, "Presets")
    });
    if response.clicked() {
        browser.toggle(session);
    }
    let edge = if browser.is_open() || response.has_focus() {
        theme.glow
    } else if response.hovered() {
        theme.quiet
    } else {
        theme.line
    };
    let painter = ui.painter_at(rect);
    painter.rect(
        rect,
        CornerRadius::same(5),
        theme.raised,
        Stroke::new(1.0, edge),
        StrokeKind::Inside,
    );
    let written = painter.text(
        pos2(rect.left() + 10.0, rect.center().y),
        Align2::LEFT_CENTER,
        text,
        body(),
        theme.text,
    );
    if chosen.changed {
        let at = pos2(
            (written.right() + 9.0).min(rect.right() - 9.0),
            rect.center().y,
        );
        painter.circle_filled(at, 3.0, theme.glow);
    }
    let told = if chosen.changed {
        "Changed since it was loaded; click to choose another preset"
    } else {
        "Click to choose a preset"
    };
    response
        .on_hover_cursor(CursorIcon::PointingHand)
        .on_hover_text(told);
}
