//! Decay-rate laws: how fast a mode of a given frequency dies away.

use serde::{Deserialize, Serialize};

/// Rayleigh damping C = α1 K + α2 M (O'Brien 2002, Eq. 3).
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Rayleigh {
    /// Stiffness-proportional part, in s: damps high modes with f².
    pub alpha1_s: f64,
    /// Mass-proportional part, in 1/s: damps all modes alike.
    pub alpha2_per_s: f64,
}

/// A mode's complex frequency, Eq. 9 of O'Brien 2002.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Motion {
    /// Rings at `hz` and dies away as exp(−`decay_per_s` t).
    Ringing {
        /// Damped frequency, in Hz.
        hz: f64,
        /// Amplitude decay rate, in 1/s.
        decay_per_s: f64,
    },
    /// At or past critical damping: creeps back without ringing.
    Overdamped,
}

impl Rayleigh {
    /// Amplitude decay rate in 1/s of the mode whose undamped frequency is `hz`.
    #[must_use]
    pub fn decay_per_s(&self, hz: f64) -> f64 {
        let omega = std::f64::consts::TAU * hz;
        0.5 * (self.alpha1_s * omega * omega + self.alpha2_per_s)
    }

    /// Damped frequency and decay rate of the mode whose undamped frequency is `hz`.
    #[must_use]
    pub fn motion(&self, hz: f64) -> Motion {
        let omega = std::f64::consts::TAU * hz;
        let decay_per_s = self.decay_per_s(hz);
        if decay_per_s >= omega {
            return Motion::Overdamped;
        }
        let damped = ((omega - decay_per_s) * (omega + decay_per_s)).sqrt();
        Motion::Ringing {
            hz: damped / std::f64::consts::TAU,
            decay_per_s,
        }
    }
}

/// Time in s in which an amplitude decaying at `decay_per_s` falls by 60 dB.
#[must_use]
pub fn t60_s(decay_per_s: f64) -> f64 {
    1000f64.ln() / decay_per_s
}
