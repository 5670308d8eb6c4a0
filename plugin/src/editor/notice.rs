//! A line that tells what is the matter, with a button that mends it.

use super::instruments::Instruments;
use super::theme::{CORNER, NEAR, SIDE, Theme, small};
use crate::notices::{Cure, Notice};
use egui::{Align, Color32};
use egui::{
    Button, CornerRadius, Label, Layout, Rect, RichText, Stroke, StrokeKind, Ui, UiBuilder,
};

/// Draws it at `area`, and does what its buttons say.
pub(super) fn notice(
    ui: &mut Ui,
    area: Rect,
    notice: &Notice,
    instruments: &Instruments,
    theme: &Theme,
) {
    let area = area.shrink2(egui::vec2(0.0, 1.0));
    let edge = Stroke::new(1.0, theme.alarm);
    ui.painter().rect(
        area,
        CornerRadius::same(CORNER),
        theme.panel,
        edge,
        StrokeKind::Inside,
    );
    let inner = area.shrink2(egui::vec2(SIDE, 0.0));
    let layout = Layout::right_to_left(Align::Center);
    ui.scope_builder(UiBuilder::new().max_rect(inner).layout(layout), |ui| {
        ui.spacing_mut().item_spacing.x = NEAR;
        let button = |ui: &mut Ui, text: &str, tooltip: &str| {
            let text = RichText::new(text).font(small()).color(theme.glow);
            let button = Button::new(text)
                .fill(Color32::TRANSPARENT)
                .min_size(egui::Vec2::ZERO);
            ui.add(button).on_hover_text(tooltip).clicked()
        };
        let posted = instruments.notices().first().as_ref() == Some(notice);
        if posted && button(ui, "Dismiss", "Hides this until the song is loaded again") {
            instruments.notices().clear(notice.subject);
        }
        match &notice.cure {
            Some(Cure::Stay) => {
                let tooltip = "The song is saved with the instrument that plays now";
                if button(ui, "Keep what plays", tooltip) {
                    instruments.stay();
                }
            }
            Some(Cure::Load(name)) => match instruments.library().named(name) {
                Some(path) => {
                    let tooltip = "Takes the bank of that name from your folder into the song";
                    if button(ui, "Load it from your folder", tooltip) {
                        instruments.library().ask(path);
                    }
                }
                None => {
                    if button(ui, "Show the folder", "Opens the folder of your banks") {
                        instruments.show_folder(ui);
                    }
                }
            },
            Some(Cure::Finish(order)) => {
                let tooltip =
                    "Solves the mesh again, finely; the preview sounds on until that is done";
                if button(ui, "Go on to full quality", tooltip) {
                    instruments.finish(order);
                }
            }
            None => {}
        }
        ui.with_layout(Layout::left_to_right(Align::Center), |ui| {
            let text = RichText::new(&notice.text).font(small()).color(theme.text);
            ui.add(Label::new(text).truncate());
        });
    });
}
