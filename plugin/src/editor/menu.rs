//! What a right click on a control offers.

use super::param::Param;
use super::typing::Typing;
use egui::{Button, Id, Popup, Response, Ui};
use nice_plug::prelude::ParamSetter;

/// Where a value that was copied is kept, as a text.
fn clip() -> Id {
    Id::unique("copied value")
}

/// The menu of a control; typing is offered where there is a field to type in.
pub(super) fn menu(
    response: &Response,
    param: &Param,
    typing: Option<&mut Typing>,
    setter: &ParamSetter<'_>,
) {
    Popup::context_menu(response).show(|ui| {
        ui.set_min_width(170.0);
        let reset = format!("Reset to {}", param.text_at(param.default()));
        if ui.button(reset).clicked() {
            param.put(setter, param.default());
        }
        if let Some(typing) = typing
            && ui.button("Type a value…").clicked()
        {
            typing.open(param);
        }
        ui.separator();
        if ui.button("Copy value").clicked() {
            copy(ui, param);
        }
        paste(ui, param, setter);
    });
}

/// Keeps the value for other controls, and for other programs.
fn copy(ui: &Ui, param: &Param) {
    let text = param.text();
    ui.ctx().copy_text(text.clone());
    ui.data_mut(|data| data.insert_temp(clip(), text));
}

fn paste(ui: &mut Ui, param: &Param, setter: &ParamSetter<'_>) {
    let text = ui.data(|data| data.get_temp::<String>(clip()));
    let value = text.as_deref().and_then(|text| param.read(text));
    let shown = match (&text, value) {
        (Some(text), Some(_)) => format!("Paste {text}"),
        _ => "Paste value".to_owned(),
    };
    let response = ui.add_enabled(value.is_some(), Button::new(shown));
    if let Some(value) = value.filter(|_| response.clicked()) {
        param.put(setter, value);
    }
}
