//! Where the commands get banks, matrices and comparisons from.

use anyhow::{Result, bail};
use modes::Bank;
use std::path::PathBuf;

/// How far a computation is.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Progress {
    /// Bodies that are done.
    pub(crate) done: usize,
    /// Bodies in all.
    pub(crate) total: usize,
}

/// A bank that lies ready.
#[derive(Debug)]
pub(crate) struct Built {
    /// The bank.
    pub(crate) bank: Bank,
    /// Its file.
    pub(crate) path: PathBuf,
    /// What it took to compute, in s; `None` if it lay ready already.
    pub(crate) seconds: Option<f64>,
}

/// A body's matrices, lower triangles.
#[derive(Debug)]
pub(crate) struct Matrices {
    /// Rows, which is degrees of freedom.
    pub(crate) rows: usize,
    /// Row, column ≤ row and value of the stiffness matrix, in N/m.
    pub(crate) stiffness: Vec<(usize, usize, f64)>,
    /// Row, column ≤ row and value of the mass matrix, in kg.
    pub(crate) mass: Vec<(usize, usize, f64)>,
}

/// Names of the banks that come with the plug-in.
pub(crate) fn names() -> Vec<String> {
    vec!["chimes".to_owned()]
}

/// Computes a bank unless it lies ready, computed from the same recipe by the same code.
pub(crate) fn precompute(
    name: &str,
    _force: bool,
    _progress: &(dyn Fn(Progress) + Sync),
) -> Result<Built> {
    bail!("no bank `{name}`; allowed: {}", names().join(", "))
}

/// A body's stiffness and mass matrices.
pub(crate) fn matrices(name: &str, key: u8) -> Result<Matrices> {
    bail!("no bank `{name}` with key {key}")
}

/// Computes what the plug-in embeds and does not lie ready.
pub(crate) fn precompute_missing() -> Result<()> {
    Ok(())
}
