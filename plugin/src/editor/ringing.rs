//! How long a partial rings, and what of its decay each cause takes.

use super::theme::Cause;
use crate::engine::{Held, Losses, Partial};
use modes::{Damping, t60_s};
use std::f64::consts::TAU;

/// The decay of one partial.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ringing {
    /// Frequency as played, in Hz.
    pub hz: f64,
    /// Decay rates in 1/s in the order of [`Cause::ALL`].
    pub per_s: [f64; 6],
}

impl Ringing {
    /// That of a partial of a material that damps by itself as `own`, with these losses and this hold.
    #[must_use]
    pub fn of(partial: &Partial, losses: &Losses, own: &Damping, held: &Held) -> Self {
        let drain = losses.drain(own);
        let hz = partial.hz * held.ratio;
        let omega = TAU * hz;
        let per_s = Cause::ALL.map(|cause| match cause {
            Cause::Alpha1 => 0.5 * drain.alpha1_s * omega * omega,
            Cause::Alpha2 => 0.5 * drain.alpha2_per_s,
            Cause::LossFactor => 0.5 * drain.loss_factor * omega,
            Cause::Radiation => {
                drain.radiation * partial.radiation_per_s + held.open * partial.resonator_per_s
            }
            Cause::Supports => drain.supports * partial.supports_per_s,
            Cause::Damper => held.felt * partial.felt_per_s + held.hand_per_s,
        });
        Self { hz, per_s }
    }

    /// The same for a mode that is made to ring so many times as long: hands and felt take what they took.
    #[must_use]
    pub fn trimmed(mut self, ringing: f64) -> Self {
        for (cause, rate) in Cause::ALL.into_iter().zip(&mut self.per_s) {
            if cause != Cause::Damper {
                *rate /= ringing;
            }
        }
        self
    }

    /// Time in s to fall by 60 dB; infinite if nothing damps.
    #[must_use]
    pub fn t60_s(&self) -> f64 {
        t60_s(self.per_s.iter().sum())
    }

    /// Share 0…1 of each cause.
    #[must_use]
    pub fn shares(&self) -> [f64; 6] {
        let sum: f64 = self.per_s.iter().sum();
        self.per_s
            .map(|part| if sum > 0.0 { part / sum } else { 0.0 })
    }
}

/// A time for people.
pub(super) fn seconds(time_s: f64) -> String {
    if !time_s.is_finite() || time_s > 999.0 {
        "for ever".to_owned()
    } else if time_s >= 9.95 {
        format!("{time_s:.0} s")
    } else if time_s >= 0.995 {
        format!("{time_s:.1} s")
    } else {
        format!("{:.0} ms", 1e3 * time_s)
    }
}

/// A frequency for people.
pub(super) fn hertz(hz: f64) -> String {
    if hz < 1000.0 {
        format!("{hz:.1} Hz")
    } else {
        format!("{:.2} kHz", hz / 1e3)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::factory;

    #[test]
    fn causes_add_up_to_the_bank_s_own_decay() {
        for index in 0..factory::BANKS.len() {
            let bank = factory::bank(index);
            let body = &bank.bodies[20];
            for partial in Partial::all(body) {
                let ringing =
                    Ringing::of(&partial, &Losses::AS_BUILT, &bank.damping, &Held::default());
                let mode = body
                    .modes
                    .iter()
                    .find(|mode| mode.hz == partial.hz)
                    .unwrap();
                let expected = mode.decay_per_s(&bank.damping);
                let sum: f64 = ringing.per_s.iter().sum();
                assert!((sum / expected - 1.0).abs() < 1e-6, "{}", partial.label);
                assert!((ringing.shares().iter().sum::<f64>() - 1.0).abs() < 1e-9);
                assert!((ringing.t60_s() - 1000f64.ln() / expected).abs() < 1e-5 * ringing.t60_s());
            }
        }
    }

    #[test]
    fn a_hand_damps() {
        let bank = factory::bank(0);
        let partial = &Partial::all(&bank.bodies[20])[0];
        let held = Held {
            hand_per_s: 100.0,
            ..Held::default()
        };
        let ringing = Ringing::of(partial, &Losses::AS_BUILT, &bank.damping, &held);
        assert_eq!(ringing.per_s[5], 100.0);
        assert!(ringing.t60_s() < 0.07);
    }

    #[test]
    fn times_and_frequencies_are_short() {
        let texts = [0.0125, 0.9949, 1.0, 9.94, 12.4, f64::INFINITY].map(seconds);
        assert_eq!(
            texts,
            ["12 ms", "995 ms", "1.0 s", "9.9 s", "12 s", "for ever"]
        );
        assert_eq!([261.63, 5273.0].map(hertz), ["261.6 Hz", "5.27 kHz"]);
    }
}
