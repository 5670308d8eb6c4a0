//! A mode that a formula gives.

use crate::ModeLabel;

/// A mode of a thin body in the plane z = 0 that moves along z.
pub trait ClosedMode {
    /// Natural frequency, in Hz.
    fn hz(&self) -> f64;

    /// Mass-normalised displacement φ in kg^(−1/2) at (x, y), in m; a string and a bar lie along x and
    /// have no y.
    fn displacement(&self, at_m: [f64; 2]) -> f64;

    /// The mode's name.
    fn label(&self) -> ModeLabel;
}
