//! Where shift-invert starts from, and when it ends.

use std::f64::consts::TAU;

/// σ in (rad/s)²: below the spectrum, as the −ω² of 1 kHz. Near the lowest modes, yet far enough from
/// the rigid motions for K − σM to be well conditioned and for them not to outweigh the rest.
pub(super) const SHIFT: f64 = -(TAU * 1000.0) * (TAU * 1000.0);

/// Largest residual of the inverse operator that counts as converged, relative to its eigenvalue.
pub(super) const TOLERANCE: f64 = 4e-9;

/// Vectors within which Lanczos finds `wanted` modes: four to a mode do where there are many, and a
/// few hundred more where those wanted crowd far below the shift, or lie far above it.
pub(super) fn largest_subspace(wanted: usize) -> usize {
    4 * wanted + 400
}
