//! What covers the window while files hover over it.

use super::super::theme::{APART, Theme, body, title};
use egui::{
    Align, Area, Color32, CornerRadius, Id, Label, Layout, Order, Rect, RichText, Sense, Stroke,
    StrokeKind, Ui, UiBuilder, vec2,
};

/// Radius of its corners, and width of its edge, in points.
const ROUND: u8 = 12;
const EDGE: f32 = 2.0;
/// Height of a line, in points.
const LINE: f32 = 26.0;

/// Draws it with what would happen, in one line each; `good` if anything would.
pub(super) fn veil(ui: &Ui, promise: &[String], good: bool, theme: &Theme) {
    let all = ui.ctx().content_rect();
    let edge = if good { theme.glow } else { theme.alarm };
    Area::new(Id::unique("dropping"))
        .order(Order::Foreground)
        .fixed_pos(all.min)
        .constrain(false)
        .interactable(false)
        .fade_in(false)
        .show(ui.ctx(), |ui| {
            ui.allocate_rect(all, Sense::hover());
            cover(ui, all, edge, theme);
            let tall = LINE * promise.len() as f32;
            let wide = all.width() - 4.0 * APART;
            let lines = Rect::from_center_size(all.center(), vec2(wide, tall));
            let layout = Layout::top_down(Align::Center);
            ui.scope_builder(UiBuilder::new().max_rect(lines).layout(layout), |ui| {
                for (number, line) in promise.iter().enumerate() {
                    let (font, ink) = if number == 0 {
                        (title(), edge)
                    } else {
                        (body(), theme.text)
                    };
                    let text = RichText::new(line).font(font).color(ink);
                    ui.add(Label::new(text).wrap().selectable(false));
                }
            });
        });
}

/// Dims what is beneath, and draws an edge to drop within.
fn cover(ui: &Ui, all: Rect, edge: Color32, theme: &Theme) {
    let painter = ui.painter();
    painter.rect_filled(all, 0.0, theme.ground.gamma_multiply(0.85));
    painter.rect(
        all.shrink(APART),
        CornerRadius::same(ROUND),
        theme.panel.gamma_multiply(0.6),
        Stroke::new(EDGE, edge),
        StrokeKind::Inside,
    );
}
