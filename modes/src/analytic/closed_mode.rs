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

/// A mode whose shape is a function of one coordinate times one of another: on a rectangle of x and y as
/// shares of its sides; on a disc of the distance from the middle as a share of the radius, below 0 on the
/// far side of it, and of the turn about the middle, 0…1.
pub trait ProductMode: ClosedMode {
    /// What tells the functions along and across from those of the body's other modes.
    fn functions(&self) -> [[u16; 2]; 2];

    /// The function of the first coordinate.
    fn along(&self, share: f64) -> f64;

    /// The function of the second coordinate.
    fn across(&self, share: f64) -> f64;

    /// What both are multiplied by to be φ, in kg^(−1/2).
    fn height(&self) -> f64;

    /// ∫ |∫ φ e^{ik·x} dS|² dΩ over the directions of a half sphere above the plane, in m⁴/kg, for waves in
    /// the air of `wave_per_m` radians to a metre.
    fn beamed(&self, wave_per_m: f64) -> f64;
}
