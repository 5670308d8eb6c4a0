//! A line of tabs.

use super::theme::{NEAR, SIDE, Theme, body};
use egui::{Align2, CursorIcon, Id, Rect, Role, Sense, Stroke, Ui, WidgetInfo, pos2, vec2};

/// Height of the line of tabs.
pub(super) const TABS: f32 = 26.0;

/// A tab's name, and what is on it.
pub(super) type Tab = (&'static str, &'static str);

/// Draws tabs at the top of `area`, of which `open` is open; the one that is from now on.
pub(super) fn tabs(ui: &Ui, area: Rect, all: &[Tab], open: usize, theme: &Theme) -> usize {
    let text_width = |name: &str| {
        let text = ui
            .painter()
            .layout_no_wrap(name.to_owned(), body(), theme.text);
        text.size().x
    };
    let texts: f32 = all.iter().map(|(name, _)| text_width(name)).sum();
    let room = (area.width() - texts) / all.len().max(1) as f32;
    let room = room.clamp(NEAR, 2.0 * SIDE);
    let mut chosen = open;
    let mut x = area.left();
    for (number, (name, tip)) in all.iter().enumerate() {
        let width = text_width(name) + room;
        let rect = Rect::from_min_size(pos2(x, area.top()), vec2(width, TABS));
        x += width;
        let response = ui.interact(rect, Id::unique(("tab", name)), Sense::click());
        let is_open = open == number;
        response.widget_info(|| WidgetInfo::selected(Role::Tab, true, is_open, *name));
        if response.clicked() {
            chosen = number;
        }
        let colour = if is_open || response.hovered() || response.has_focus() {
            theme.text
        } else {
            theme.quiet
        };
        ui.painter()
            .text(rect.center(), Align2::CENTER_CENTER, name, body(), colour);
        if is_open {
            ui.painter().hline(
                rect.shrink2(vec2(0.5 * room, 0.0)).x_range(),
                rect.bottom() - 2.0,
                Stroke::new(2.0, theme.glow),
            );
        }
        response
            .on_hover_cursor(CursorIcon::PointingHand)
            .on_hover_text(*tip);
    }
    ui.painter().hline(
        area.x_range(),
        area.top() + TABS,
        Stroke::new(1.0, theme.line),
    );
    chosen
}
