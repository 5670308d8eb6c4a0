//! The gesture that a pointer makes: begun once, ended once, whatever becomes of the widget.

use super::param::Param;
use nice_plug::prelude::ParamSetter;

/// At most one gesture, as there is one pointer.
#[derive(Default)]
pub(super) struct Hold {
    held: Option<Grip>,
}

struct Grip {
    param: Param,
    /// Where the pointer has brought it, 0…1: hosts may be late to say so.
    value: f32,
}

impl Hold {
    /// Takes hold of a parameter, if it is not held yet.
    pub(super) fn take(&mut self, param: &Param, setter: &ParamSetter<'_>) {
        if self.holds(param) {
            return;
        }
        self.let_go(setter);
        param.begin(setter);
        self.held = Some(Grip {
            param: param.clone(),
            value: param.value(),
        });
    }

    /// Whether this one is held.
    pub(super) fn holds(&self, param: &Param) -> bool {
        self.held
            .as_ref()
            .is_some_and(|grip| grip.param.spec.id == param.spec.id)
    }

    /// Moves what is held to `value` 0…1.
    pub(super) fn put(&mut self, value: f32, setter: &ParamSetter<'_>) {
        if let Some(grip) = &mut self.held {
            let value = value.clamp(0.0, 1.0);
            if value != grip.value {
                grip.value = value;
                grip.param.set(setter, value);
            }
        }
    }

    /// Moves what is held by `change`.
    pub(super) fn push(&mut self, change: f32, setter: &ParamSetter<'_>) {
        if let Some(grip) = &self.held {
            self.put(grip.value + change, setter);
        }
    }

    /// Ends the gesture, if there is one.
    pub(super) fn let_go(&mut self, setter: &ParamSetter<'_>) {
        if let Some(grip) = self.held.take() {
            grip.param.end(setter);
        }
    }
}
