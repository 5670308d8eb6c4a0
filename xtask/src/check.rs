//! The physics beside what theory and the literature say.

use anyhow::Result;
use serde::Serialize;

/// One comparison.
#[derive(Clone, Debug, Serialize)]
pub(crate) struct Row {
    /// What is compared.
    pub(crate) name: String,
    /// What it should be.
    pub(crate) reference: f64,
    /// What it is.
    pub(crate) value: f64,
    /// Unit of both.
    pub(crate) unit: String,
    /// How far it is off, in the measure of `bound`.
    pub(crate) error: f64,
    /// How far it may be off.
    pub(crate) bound: f64,
    /// Whether it is within the bound.
    pub(crate) ok: bool,
    /// Where the reference comes from.
    pub(crate) source: String,
}

/// All comparisons.
pub(crate) fn rows() -> Result<Vec<Row>> {
    Ok(Vec::new())
}
