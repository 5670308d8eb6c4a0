//! One comparison.

use serde::Serialize;

/// A figure beside what it should be.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Row {
    /// What is compared.
    pub name: String,
    /// What it should be.
    pub reference: f64,
    /// What it is.
    pub value: f64,
    /// Unit of both.
    pub unit: &'static str,
    /// How far it is off: a fraction of the reference, or in the unit where the row says so.
    pub error: f64,
    /// How far it may be off.
    pub bound: f64,
    /// Whether it is within the bound.
    pub ok: bool,
    /// Where the reference comes from.
    pub source: &'static str,
}

impl Row {
    /// A figure that may be off by the fraction `bound` of `reference`.
    pub(super) fn relative(
        name: impl Into<String>,
        (reference, value, unit): (f64, f64, &'static str),
        bound: f64,
        source: &'static str,
    ) -> Self {
        let error = (value / reference - 1.0).abs();
        Self::within(name, (reference, value, unit), (error, bound), source)
    }

    /// A figure that may be off by `bound` in its own unit.
    pub(super) fn absolute(
        name: impl Into<String>,
        (reference, value, unit): (f64, f64, &'static str),
        bound: f64,
        source: &'static str,
    ) -> Self {
        let error = (value - reference).abs();
        Self::within(name, (reference, value, unit), (error, bound), source)
    }

    /// A figure that is off by `error`, and may be by `bound`, by a measure that the name tells.
    pub(super) fn within(
        name: impl Into<String>,
        (reference, value, unit): (f64, f64, &'static str),
        (error, bound): (f64, f64),
        source: &'static str,
    ) -> Self {
        Self {
            name: name.into(),
            reference,
            value,
            unit,
            error,
            bound,
            // A NaN is out of bounds.
            ok: error <= bound,
            source,
        }
    }
}
