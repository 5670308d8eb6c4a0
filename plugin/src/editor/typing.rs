//! A value that is being typed.

use super::param::Param;
use super::theme::{Theme, small};
use egui::text::{CCursor, CCursorRange};
use egui::{Align2, Id, Key, Rect, TextEdit, Ui};
use nice_plug::prelude::ParamSetter;

/// At most one field is open.
#[derive(Default)]
pub(super) struct Typing {
    open: Option<Field>,
}

struct Field {
    id: &'static str,
    text: String,
    /// Just opened: takes the keyboard with all its text selected.
    fresh: bool,
    refused: bool,
}

impl Typing {
    /// Whether this parameter's value is being typed.
    pub(super) fn is_open(&self, param: &Param) -> bool {
        self.open
            .as_ref()
            .is_some_and(|field| field.id == param.spec.id)
    }

    /// Opens a field with what the parameter is now.
    pub(super) fn open(&mut self, param: &Param) {
        self.open = Some(Field {
            id: param.spec.id,
            text: param.text(),
            fresh: true,
            refused: false,
        });
    }

    /// Draws the parameter's open field at `rect`. Enter sets the parameter, or says that it cannot be
    /// set so; Escape and a click elsewhere leave it as it was.
    pub(super) fn show(
        &mut self,
        ui: &mut Ui,
        rect: Rect,
        param: &Param,
        theme: &Theme,
        setter: &ParamSetter<'_>,
    ) {
        let Some(field) = self.open.as_mut().filter(|field| field.id == param.spec.id) else {
            return;
        };
        let id = Id::unique(("value", param.spec.id));
        let colour = if field.refused {
            theme.alarm
        } else {
            theme.text
        };
        let edit = TextEdit::singleline(&mut field.text)
            .id(id)
            .font(small())
            .text_color(colour)
            .background_color(theme.ground)
            .align(Align2::CENTER_CENTER)
            .desired_width(rect.width());
        let response = ui
            .put(rect, edit)
            .accessible_name(format!("{} value", param.spec.name));
        if field.fresh {
            field.fresh = false;
            response.request_focus();
            let all = CCursorRange::two(CCursor::new(0), CCursor::new(field.text.chars().count()));
            let mut state = TextEdit::load_state(ui.ctx(), id).unwrap_or_default();
            state.cursor.set_char_range(Some(all));
            TextEdit::store_state(ui.ctx(), id, state);
            return;
        }
        if response.changed() {
            field.refused = false;
        }
        if field.refused {
            response.show_tooltip_text(format!("{} to be had", param.spec.allowed()));
        }
        if !response.lost_focus() {
            return;
        }
        let entered = ui.input(|input| input.key_pressed(Key::Enter));
        match param.read(&field.text) {
            Some(value) if entered => {
                param.put(setter, value);
                self.open = None;
            }
            None if entered => {
                field.refused = true;
                response.request_focus();
            }
            _ => self.open = None,
        }
    }
}
