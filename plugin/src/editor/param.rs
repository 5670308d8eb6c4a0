//! A parameter as the editor holds it: read without risk, changed through the host.

use super::log::Log;
use crate::params::{Controls, Spec, specs};
use nice_plug::prelude::{ParamPtr, ParamSetter, Params};
use std::sync::Arc;

/// One parameter of an instance.
#[derive(Clone)]
pub(super) struct Param {
    pub(super) spec: &'static Spec,
    /// The group that the host shows it in.
    pub(super) group: String,
    pointer: ParamPtr,
    /// Where gestures are written down.
    log: Arc<Log>,
    /// Keeps alive what `pointer` points into.
    _controls: Arc<Controls>,
}

/// A call of a method of the pointer.
macro_rules! ask {
    ($self:ident.$method:ident($($argument:expr),*)) => {{
        // SAFETY: `Param` holds the controls that the pointer points into.
        #[expect(unsafe_code, reason = "the framework hands out raw pointers")]
        let answer = unsafe { $self.pointer.$method($($argument),*) };
        answer
    }};
}

/// A call of a method of the setter's host.
macro_rules! tell {
    ($setter:ident.$method:ident($($argument:expr),*)) => {{
        // SAFETY: `Param` holds the controls that the pointer points into.
        #[expect(unsafe_code, reason = "the framework hands out raw pointers")]
        unsafe {
            $setter.raw_context.$method($($argument),*);
        }
    }};
}

impl Param {
    /// All that have a line in the table, in the host's order; `log` hears of every gesture.
    pub(super) fn all(controls: &Arc<Controls>, log: &Arc<Log>) -> Vec<Self> {
        controls
            .param_map()
            .into_iter()
            .filter_map(|(id, pointer, group)| {
                let spec = specs().find(|spec| spec.id == id)?;
                Some(Self {
                    spec,
                    group,
                    pointer,
                    log: Arc::clone(log),
                    _controls: Arc::clone(controls),
                })
            })
            .collect()
    }

    /// Where it stands, 0…1, without modulation.
    pub(super) fn value(&self) -> f32 {
        ask!(self.unmodulated_normalized_value())
    }

    /// The same in its unit.
    pub(super) fn plain(&self) -> f32 {
        ask!(self.unmodulated_plain_value())
    }

    /// Where it stands in a new instance.
    pub(super) fn default(&self) -> f32 {
        ask!(self.default_normalized_value())
    }

    /// Steps from the first value to the last; none if it glides.
    pub(super) fn steps(&self) -> Option<usize> {
        ask!(self.step_count())
    }

    /// What stands at `value` 0…1, for people.
    pub(super) fn text_at(&self, value: f32) -> String {
        ask!(self.normalized_value_to_string(value, true))
    }

    /// What it is now, for people.
    pub(super) fn text(&self) -> String {
        self.text_at(self.value())
    }

    /// Where `text` stands, 0…1, if it says anything.
    pub(super) fn read(&self, text: &str) -> Option<f32> {
        ask!(self.string_to_normalized_value(text))
    }

    /// Where `plain`, in its unit, stands.
    pub(super) fn place(&self, plain: f32) -> f32 {
        ask!(self.preview_normalized(plain))
    }

    /// Begins a gesture.
    pub(super) fn begin(&self, setter: &ParamSetter<'_>) {
        self.log.begin(self.spec.id, self.value());
        tell!(setter.raw_begin_set_parameter(self.pointer));
    }

    /// Within a gesture: goes to `value` 0…1.
    pub(super) fn set(&self, setter: &ParamSetter<'_>, value: f32) {
        let value = value.clamp(0.0, 1.0);
        self.log.set(self.spec.id, value);
        tell!(setter.raw_set_parameter_normalized(self.pointer, value));
    }

    /// Ends a gesture.
    pub(super) fn end(&self, setter: &ParamSetter<'_>) {
        self.log.end(self.spec.id);
        tell!(setter.raw_end_set_parameter(self.pointer));
    }

    /// A whole gesture: goes to `value` 0…1.
    pub(super) fn put(&self, setter: &ParamSetter<'_>, value: f32) {
        self.begin(setter);
        self.set(setter, value);
        self.end(setter);
    }

    /// A whole gesture that is not written down, as part of a greater step.
    pub(super) fn jump(&self, setter: &ParamSetter<'_>, value: f32) {
        tell!(setter.raw_begin_set_parameter(self.pointer));
        tell!(setter.raw_set_parameter_normalized(self.pointer, value.clamp(0.0, 1.0)));
        tell!(setter.raw_end_set_parameter(self.pointer));
    }
}
