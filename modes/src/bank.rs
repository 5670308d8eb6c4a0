//! What passes from the solver to the instrument: tuned bodies and their modes.

mod check;
mod check_spread;
mod check_surface;
mod check_tables;
mod error;
mod file;
mod format;
#[cfg(test)]
mod kit_tests;
mod matter;
mod mirror;
mod read;
#[cfg(test)]
mod sample;
mod sheet;
#[cfg(test)]
mod sheet_tests;
mod spread;
#[cfg(test)]
mod spread_tests;
mod surface;
#[cfg(test)]
mod surface_tests;
#[cfg(test)]
mod tests;
mod write;

pub use error::{BankError, BankFileError};
pub use matter::Matter;
pub use spread::{Enough, Spread, SpreadRule, Zone};
pub use surface::{Surface, SurfaceMotion};

use crate::{Damping, Material, ModeLabel, ModeShape, StrikeLine};
use serde::{Deserialize, Serialize};
use std::sync::Arc;

/// One instrument: a body for each key.
#[derive(Clone, Debug, PartialEq)]
pub struct Bank {
    /// Name of the instrument, fit for a file.
    pub name: String,
    /// Name of the instrument for people.
    pub title: String,
    /// What the bodies are made of, but for those that say otherwise ([`Body::matter`]).
    pub material: Material,
    /// Inner damping of the material; what the air, the supports and the felt take is said mode by
    /// mode.
    pub damping: Damping,
    /// Where the listener's left and right ears are, in m, beside a row of bodies that stands along
    /// x with its middle at the origin, z up.
    pub ears_m: [[f64; 3]; 2],
    /// How the bank came about.
    pub provenance: Provenance,
    /// The bodies, by rising key.
    pub bodies: Vec<Body>,
    /// How the bodies are given to keys; without, each is for its own. Engines play what
    /// [`Bank::spread_out`] makes of it.
    pub spread: Option<Spread>,
}

/// How a bank came about.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Provenance {
    /// The recipe, word for word.
    pub recipe: String,
    /// Version and source hash of the code that built the bank.
    pub code: String,
    /// Mesh and element in words.
    pub mesh: String,
    /// Eigen solver in words.
    pub solver: String,
    /// Farthest that a body's pitch may lie from its key, in cents.
    pub tolerance_cents: f64,
    /// Greatest relative residual of all modes.
    pub max_residual: f64,
    /// Greatest |φᵢᵀMφⱼ − δᵢⱼ| of all pairs of a body's modes.
    pub max_orthonormality_error: f64,
}

/// One key's body.
#[derive(Clone, Debug, PartialEq)]
pub struct Body {
    /// MIDI key number that strikes it.
    pub key: u8,
    /// Pitch the body is tuned to, in Hz.
    pub pitch_hz: f64,
    /// Length, in m.
    pub length_m: f64,
    /// Mass, in kg.
    pub mass_kg: f64,
    /// What it is made of; without, what the bank says.
    pub matter: Option<Matter>,
    /// Where it is struck.
    pub line: StrikeLine,
    /// What it looks like, and how it moves; shared with the other keys of one drawing.
    pub surface: Option<Arc<Surface>>,
    /// Its modes, by rising frequency.
    pub modes: Vec<Mode>,
}

/// What a unit modal displacement e^{iωt} sends to each ear: complex sound pressure (real,
/// imaginary) at the left and the right one, in Pa·kg^(−1/2)/m.
pub type Ears = [[f32; 2]; 2];

/// One mode of vibration.
#[derive(Clone, Debug, PartialEq)]
pub struct Mode {
    /// Undamped natural frequency, in Hz.
    pub hz: f64,
    /// ∫|φ·n| dS over the whole surface times 2π `hz`, in m²·kg^(−1/2)/s: the rectified volume
    /// velocity that a unit modal displacement at this frequency sends out (O'Brien 2002 §3.4).
    pub coupling: f64,
    /// Sound pressure at the ears (O'Brien, Cook & Essl 2001, Eqs. 2, 5, 10, at the mode's
    /// frequency), scaled to the power that the mode radiates.
    pub ears: Ears,
    /// What the open resonator below the body adds to it; zero without one.
    pub pipe_ears: Ears,
    /// Amplitude decay rate that radiation into the air adds, in 1/s.
    pub radiation_per_s: f32,
    /// Amplitude decay rate that the supports add, in 1/s.
    pub support_per_s: f32,
    /// Amplitude decay rate that the damper's felt adds when it lies on the body, in 1/s.
    pub felt_per_s: f32,
    /// Amplitude decay rate that the open resonator adds, in 1/s; zero without one.
    pub pipe_per_s: f32,
    /// ‖Kφ − λMφ‖ / ‖Kφ‖ as solved.
    pub residual: f64,
    /// The mode's name.
    pub label: ModeLabel,
    /// Mass-normalised displacement φ over the strike line, in kg^(−1/2): of all modes of a body at its
    /// points, or of all as products of the same tables.
    pub shape: ModeShape,
}

impl Body {
    /// What the points of [`Body::surface`] are to be multiplied by to be of this body's size.
    #[must_use]
    pub fn surface_scale(&self) -> f64 {
        let drawn = self.surface.as_ref().map(|surface| surface.length_m);
        drawn.map_or(1.0, |length_m| self.length_m / length_m)
    }
}

impl Mode {
    /// Amplitude decay rate in 1/s of the mode as built, felt off: what a material of this `damping`,
    /// radiation, supports and resonator take.
    #[must_use]
    pub fn decay_per_s(&self, damping: &Damping) -> f64 {
        let outside = self.radiation_per_s + self.support_per_s + self.pipe_per_s;
        damping.decay_per_s(self.hz) + f64::from(outside)
    }
}
