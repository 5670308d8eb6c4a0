//! From a table's row to what the host holds.

use super::Spec;
use nice_plug::prelude::{BoolParam, FloatParam, FloatRange, IntParam, IntRange};
use std::sync::Arc;

/// A number.
pub(super) fn float(spec: &'static Spec) -> FloatParam {
    let (min, max) = (spec.min, spec.max);
    let range = if spec.skew == 1.0 {
        FloatRange::Linear { min, max }
    } else {
        FloatRange::Skewed {
            min,
            max,
            factor: spec.skew,
        }
    };
    FloatParam::new(spec.name, spec.default, range)
        .with_value_to_string(Arc::new(|value| spec.format(value)))
        .with_string_to_value(Arc::new(|text| spec.parse(text)))
}

/// One of some names.
pub(super) fn choice(spec: &'static Spec) -> IntParam {
    let range = IntRange::Linear {
        min: 0,
        max: spec.max as i32,
    };
    IntParam::new(spec.name, spec.default as i32, range)
        .with_value_to_string(Arc::new(|value| spec.format(value as f32)))
        .with_string_to_value(Arc::new(|text| spec.parse(text).map(|value| value as i32)))
}

/// One of two words.
pub(super) fn switch(spec: &'static Spec) -> BoolParam {
    BoolParam::new(spec.name, spec.default >= 0.5)
        .with_value_to_string(Arc::new(|on| spec.format(f32::from(u8::from(on)))))
        .with_string_to_value(Arc::new(|text| spec.parse(text).map(|value| value >= 0.5)))
}

/// The number that is set.
pub(super) fn plain(control: &FloatParam) -> f64 {
    f64::from(control.value())
}

/// The number that is set in percent, as a share.
pub(super) fn share(control: &FloatParam) -> f64 {
    plain(control) / 100.0
}

/// The number of what is chosen.
pub(super) fn index(control: &IntParam) -> usize {
    usize::try_from(control.value()).unwrap_or(0)
}
