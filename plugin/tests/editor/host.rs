//! A host that writes down what the editor tells it.

use nice_plug::context::gui::GuiContextInner;
use nice_plug::prelude::{ParamPtr, PluginApi, PluginState};
use std::sync::Mutex;

/// What a host is told.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Said {
    /// A gesture begins on a parameter.
    Begin(String),
    /// A parameter goes to a place 0…1.
    Set(String, f32),
    /// The gesture ends.
    End(String),
}

/// Does what it is told, and remembers it.
#[derive(Default)]
pub(crate) struct Host {
    said: Mutex<Vec<Said>>,
}

impl Host {
    fn write(&self, said: Said) {
        self.said.lock().unwrap().push(said);
    }

    /// What it has been told since it was last asked.
    pub(crate) fn said(&self) -> Vec<Said> {
        std::mem::take(&mut self.said.lock().unwrap())
    }
}

#[expect(unsafe_code, reason = "the framework hands out raw pointers")]
fn name(param: ParamPtr) -> String {
    // SAFETY: the bench keeps the parameters for as long as the editor.
    unsafe { param.name() }.to_owned()
}

#[expect(unsafe_code, reason = "the framework's trait is so")]
impl GuiContextInner for Host {
    fn plugin_api(&self) -> PluginApi {
        PluginApi::Clap
    }

    unsafe fn raw_begin_set_parameter(&self, param: ParamPtr) {
        self.write(Said::Begin(name(param)));
    }

    unsafe fn raw_set_parameter_normalized(&self, param: ParamPtr, normalized: f32) {
        // SAFETY: as in `name`.
        unsafe {
            param._internal_set_normalized_value(normalized);
            param._internal_update_smoother(48_000.0, true);
        }
        self.write(Said::Set(name(param), normalized));
    }

    unsafe fn raw_end_set_parameter(&self, param: ParamPtr) {
        self.write(Said::End(name(param)));
    }

    fn get_state(&self) -> PluginState {
        unreachable!("the editor does not ask for the state")
    }

    fn set_state(&self, _: PluginState) {}

    fn request_restart(&self) {}
}
