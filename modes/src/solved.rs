//! A body whose modes are known, but not yet how they sound.

use crate::radiation::Surface;
use crate::{ModeLabel, StrikeLine};

/// A body's modes with all that air, supports and felt see of them.
#[derive(Clone, Debug, PartialEq)]
pub struct SolvedBody {
    /// Length, in m.
    pub length_m: f64,
    /// Mass, in kg.
    pub mass_kg: f64,
    /// Where it is struck.
    pub line: StrikeLine,
    /// What of it touches the air.
    pub surface: Surface,
    /// Its modes, by rising frequency.
    pub modes: Vec<SolvedMode>,
    /// Largest entry of |ΦᵀMΦ − I| over modes that symmetry does not keep apart.
    pub orthonormality: f64,
}

/// One mode, mass-normalised.
#[derive(Clone, Debug, PartialEq)]
pub struct SolvedMode {
    /// Undamped natural frequency, in Hz.
    pub hz: f64,
    /// ‖Kφ − λMφ‖ / ‖Kφ‖.
    pub residual: f64,
    /// The mode's name.
    pub label: ModeLabel,
    /// φ at each point of the strike line, in kg^(−1/2).
    pub shape: Vec<[f32; 3]>,
    /// φ·n on each patch of the surface, in kg^(−1/2).
    pub motion: Vec<f32>,
    /// Σ|φ|² over the places where the body is held, in 1/kg.
    pub held: f64,
    /// Σ|φ|² over the places where the damper's felt touches, in 1/kg.
    pub felt: f64,
    /// Amplitude decay rate that the body's own radiation causes, in 1/s.
    pub radiation_per_s: f64,
}
