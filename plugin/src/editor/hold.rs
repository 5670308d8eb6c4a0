//! The gesture that a pointer makes: begun once, ended once, whatever becomes of the widget.

use super::param::Param;
use nice_plug::prelude::ParamSetter;

/// At most one gesture, as there is one pointer; a place on a surface moves a second parameter with it.
#[derive(Default)]
pub(super) struct Hold {
    held: Option<Grip>,
    beside: Option<Grip>,
}

struct Grip {
    param: Param,
    /// Where the pointer has brought it, 0…1: hosts may be late to say so.
    value: f32,
}

impl Grip {
    fn of(param: &Param) -> Self {
        Self {
            param: param.clone(),
            value: param.value(),
        }
    }

    fn go(&mut self, value: f32, setter: &ParamSetter<'_>) {
        let value = value.clamp(0.0, 1.0);
        if value != self.value {
            self.value = value;
            self.param.set(setter, value);
        }
    }
}

impl Hold {
    /// Takes hold of a parameter, if it is not held yet.
    pub(super) fn take(&mut self, param: &Param, setter: &ParamSetter<'_>) {
        if self.holds(param) {
            return;
        }
        self.let_go(setter);
        param.begin(setter);
        self.held = Some(Grip::of(param));
    }

    /// Takes hold of another parameter beside what is held, and moves it to `value` 0…1.
    pub(super) fn put_beside(&mut self, param: &Param, value: f32, setter: &ParamSetter<'_>) {
        let grip = self.beside.get_or_insert_with(|| {
            param.begin(setter);
            Grip::of(param)
        });
        grip.go(value, setter);
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
            grip.go(value, setter);
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
        for grip in [self.beside.take(), self.held.take()].into_iter().flatten() {
            grip.param.end(setter);
        }
    }
}
