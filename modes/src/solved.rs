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
    /// ∫|φ·n| dS over the surface, in m² kg^(−1/2): "summing the amount of normal displacement …
    /// over the surface" (O'Brien 2002 §3.4).
    pub rectified_area: f64,
    /// Σ|φ|² over the places where the body is held, in 1/kg.
    pub held: f64,
    /// Σ|φ|² over the places where the damper's felt touches, in 1/kg.
    pub felt: f64,
    /// Amplitude decay rate that the body's own radiation causes, in 1/s.
    pub radiation_per_s: f64,
}

impl SolvedBody {
    /// The same body with all lengths times `factor`: ω → ω/γ, φ → γ^(−3/2) φ, and d/ω of radiation
    /// as it is, because the waves in air shrink alike. Modes above `highest_hz` are left out.
    #[must_use]
    pub fn scaled(&self, factor: f64, highest_hz: f64) -> Self {
        let shape = factor.powf(-1.5);
        let narrow = |x: &f32| (shape * f64::from(*x)) as f32;
        Self {
            length_m: factor * self.length_m,
            mass_kg: factor.powi(3) * self.mass_kg,
            line: self.line.scaled(factor),
            surface: self.surface.scaled(factor),
            modes: self
                .modes
                .iter()
                .filter(|mode| mode.hz / factor <= highest_hz)
                .map(|mode| SolvedMode {
                    hz: mode.hz / factor,
                    shape: mode
                        .shape
                        .iter()
                        .map(|u| [0, 1, 2].map(|a| narrow(&u[a])))
                        .collect(),
                    motion: mode.motion.iter().map(narrow).collect(),
                    rectified_area: factor * factor * shape * mode.rectified_area,
                    held: shape * shape * mode.held,
                    felt: shape * shape * mode.felt,
                    radiation_per_s: mode.radiation_per_s / factor,
                    ..*mode
                })
                .collect(),
            orthonormality: self.orthonormality,
        }
    }
}
