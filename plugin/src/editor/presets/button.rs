//! Buttons of the bar and of the browser.

use super::super::icon::Icon;
use super::super::theme::{SIDE, Theme, body, small};
use egui::{
    Align2, Color32, CornerRadius, CursorIcon, Id, Rect, Response, Role, Sense, Stroke, StrokeKind,
    Ui, WidgetInfo, vec2,
};

/// A button with a sign; dim and dead unless it is of use. There is one of that name.
pub(super) fn sign(
    ui: &Ui,
    rect: Rect,
    icon: Icon,
    name: &str,
    live: bool,
    theme: &Theme,
) -> Response {
    one_of(ui, rect, icon, (name, name), live, theme)
}

/// One of several buttons with a sign and a name; each has a key of its own before that.
pub(super) fn one_of(
    ui: &Ui,
    rect: Rect,
    icon: Icon,
    (key, name): (&str, &str),
    live: bool,
    theme: &Theme,
) -> Response {
    let sense = if live { Sense::click() } else { Sense::hover() };
    let response = ui.interact(rect, Id::unique(("sign", key)), sense);
    response.widget_info(|| WidgetInfo::labeled(Role::Button, live, name));
    let lit = live && (response.hovered() || response.has_focus());
    if lit {
        ui.painter()
            .rect_filled(rect, CornerRadius::same(5), theme.raised);
    }
    icon.paint(ui.painter(), rect, shade(live, lit, theme));
    if live {
        response.on_hover_cursor(CursorIcon::PointingHand)
    } else {
        response
    }
}

fn shade(live: bool, lit: bool, theme: &Theme) -> Color32 {
    match (live, lit) {
        (false, _) => theme.line,
        (true, true) => theme.text,
        (true, false) => theme.quiet,
    }
}

/// A button with a word, as wide as it needs; filled if it is what one does next.
pub(super) fn word(ui: &mut Ui, text: &str, first: bool, theme: &Theme) -> Response {
    let width = ui
        .painter()
        .layout_no_wrap(text.to_owned(), body(), theme.text)
        .size()
        .x;
    let (rect, response) = ui.allocate_exact_size(vec2(width + 3.0 * SIDE, 26.0), Sense::click());
    response.widget_info(|| WidgetInfo::labeled(Role::Button, true, text));
    let lit = response.hovered() || response.has_focus();
    let (fill, ink) = if first {
        (theme.glow, theme.ground)
    } else {
        (theme.raised, theme.text)
    };
    let edge = if lit { theme.text } else { fill };
    ui.painter().rect(
        rect,
        CornerRadius::same(5),
        fill,
        Stroke::new(1.0, edge),
        StrokeKind::Inside,
    );
    ui.painter()
        .text(rect.center(), Align2::CENTER_CENTER, text, body(), ink);
    response.on_hover_cursor(CursorIcon::PointingHand)
}

/// A word in a small frame, as a tag.
pub(super) fn tag(ui: &mut Ui, text: &str, theme: &Theme) -> Response {
    let width = ui
        .painter()
        .layout_no_wrap(text.to_owned(), small(), theme.text)
        .size()
        .x;
    let (rect, response) = ui.allocate_exact_size(vec2(width + 2.0 * SIDE, 20.0), Sense::click());
    response.widget_info(|| WidgetInfo::labeled(Role::Button, true, format!("Tag {text}")));
    let ink = if response.hovered() {
        theme.glow
    } else {
        theme.quiet
    };
    ui.painter().rect(
        rect,
        CornerRadius::same(10),
        theme.ground,
        Stroke::new(1.0, theme.line),
        StrokeKind::Inside,
    );
    ui.painter()
        .text(rect.center(), Align2::CENTER_CENTER, text, small(), ink);
    response.on_hover_cursor(CursorIcon::PointingHand)
}

/// A line that can be chosen, with a key of its own; its name is left to the caller to draw.
pub(super) fn line(
    ui: &Ui,
    rect: Rect,
    key: &str,
    name: &str,
    chosen: bool,
    theme: &Theme,
) -> Response {
    let response = ui.interact(rect, Id::unique(("line", key)), Sense::click());
    response.widget_info(|| WidgetInfo::selected(Role::Button, true, chosen, name));
    let fill = if chosen {
        Theme::mix(theme.panel, theme.glow, 0.22)
    } else if response.hovered() {
        theme.raised
    } else {
        Color32::TRANSPARENT
    };
    ui.painter().rect_filled(rect, CornerRadius::same(4), fill);
    response.on_hover_cursor(CursorIcon::PointingHand)
}
