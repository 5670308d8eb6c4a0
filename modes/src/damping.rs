//! Decay-rate laws: how fast a mode of a given frequency dies away.

use serde::{Deserialize, Serialize};

/// Rayleigh damping C = α1 K + α2 M (O'Brien 2002, Eq. 3).
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Rayleigh {
    /// Stiffness-proportional part, in s: damps high modes with f².
    pub alpha1_s: f64,
    /// Mass-proportional part, in 1/s: damps all modes alike.
    pub alpha2_per_s: f64,
}

/// What a material takes out of every mode that moves it.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Damping {
    /// Rayleigh's part.
    pub rayleigh: Rayleigh,
    /// tan φ of internal friction, the same at all frequencies (van den Doel & Pai 1998, Eq. 12).
    pub loss_factor: f64,
}

impl Damping {
    /// Amplitude decay rate in 1/s of the mode whose undamped frequency is `hz`.
    #[must_use]
    pub fn decay_per_s(&self, hz: f64) -> f64 {
        self.rayleigh.decay_per_s(hz) + std::f64::consts::PI * hz * self.loss_factor
    }
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
    /// Damping whose loss factor η = 2d/ω is `eta` at the frequencies `low_hz` and `high_hz`.
    ///
    /// η = α1 ω + α2/ω; it is less than `eta` between the two and more outside.
    #[must_use]
    pub const fn with_loss_factor(eta: f64, low_hz: f64, high_hz: f64) -> Self {
        let low = std::f64::consts::TAU * low_hz;
        let high = std::f64::consts::TAU * high_hz;
        Self {
            alpha1_s: eta / (low + high),
            alpha2_per_s: eta * low * high / (low + high),
        }
    }

    /// Amplitude decay rate in 1/s of the mode whose undamped frequency is `hz`.
    #[must_use]
    pub fn decay_per_s(&self, hz: f64) -> f64 {
        let omega = std::f64::consts::TAU * hz;
        0.5 * (self.alpha1_s * omega * omega + self.alpha2_per_s)
    }

    /// Damped frequency and decay rate of the mode whose undamped frequency is `hz`.
    #[must_use]
    pub fn motion(&self, hz: f64) -> Motion {
        Motion::of(hz, self.decay_per_s(hz))
    }
}

impl Motion {
    /// The motion of a mode of undamped frequency `hz` that loses `decay_per_s` of its amplitude
    /// per second.
    #[must_use]
    pub fn of(hz: f64, decay_per_s: f64) -> Self {
        let omega = std::f64::consts::TAU * hz;
        if decay_per_s >= omega {
            return Self::Overdamped;
        }
        let damped = ((omega - decay_per_s) * (omega + decay_per_s)).sqrt();
        Self::Ringing {
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

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::PI;

    /// d = π f η (van den Doel & Pai 1998, Eq. 12, with η for tan φ).
    #[test]
    fn a_loss_factor_is_met_at_both_frequencies() {
        let damping = Rayleigh::with_loss_factor(4.5e-3, 200.0, 2000.0);
        for hz in [200.0, 2000.0] {
            let decay = damping.decay_per_s(hz);
            assert!((decay / (PI * hz * 4.5e-3) - 1.0).abs() < 1e-14, "{decay}");
        }
        assert!(damping.decay_per_s(632.0) < PI * 632.0 * 4.5e-3);
        assert!(damping.decay_per_s(5000.0) > PI * 5000.0 * 4.5e-3);
    }
}
