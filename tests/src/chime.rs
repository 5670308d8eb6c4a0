//! What a body of the first instrument should sound like, and whether it does.

use crate::{Fit, Partial, fit};
use modes::{Mode, Motion};

/// The mallet has left a chime by then, in s.
pub const CONTACT_S: f64 = 0.005;

/// The partials of a key's chime retuned by `ratio`, of decay rates in 1/s as given for each mode and its
/// frequency in Hz; those are to be measured that no other overlaps.
///
/// # Panics
///
/// If there is no such chime.
#[must_use]
pub fn partials(key: u8, ratio: f64, decay_per_s: impl Fn(&Mode, f64) -> f64) -> Vec<Partial> {
    let bank = idiophone::factory::bank(0);
    let body = bank.bodies.iter().find(|body| body.key == key);
    let mut motions: Vec<_> = body
        .expect("a chime of that key")
        .modes
        .iter()
        .filter_map(|mode| {
            let hz = ratio * mode.hz;
            match Motion::of(hz, decay_per_s(mode, hz)) {
                Motion::Ringing { hz, decay_per_s } => Some((hz, decay_per_s)),
                Motion::Overdamped => None,
            }
        })
        .collect();
    // The two of a degenerate pair are one partial.
    motions.dedup_by(|a, b| (a.0 - b.0).abs() < 1e-6 * b.0);
    let apart = |i: usize, j: usize| {
        let (hz, decay_per_s) = motions[i];
        j >= motions.len() || i == j || (motions[j].0 - hz).abs() > 0.25 * decay_per_s
    };
    (0..motions.len())
        .map(|i| Partial {
            hz: motions[i].0,
            decay_per_s: motions[i].1,
            measured: apart(i, i.saturating_sub(1)) && apart(i, i + 1),
        })
        .collect()
}

/// The same with the damping of the bank, and a decay rate added to all, in 1/s.
#[must_use]
pub fn bent(key: u8, semitones: f64, added_per_s: f64) -> Vec<Partial> {
    let damping = idiophone::factory::bank(0).damping;
    partials(key, (semitones / 12.0).exp2(), |mode, hz| {
        let outside = mode.decay_per_s(&damping) - damping.decay_per_s(mode.hz);
        damping.decay_per_s(hz) + outside + added_per_s
    })
}

/// The partials of several bodies; those that another body's overlap are not to be measured.
#[must_use]
pub fn together(bodies: &[Vec<Partial>]) -> Vec<Partial> {
    let mut all: Vec<_> = bodies.concat();
    all.sort_by(|a, b| a.hz.total_cmp(&b.hz));
    let overlap: Vec<_> = all
        .windows(2)
        .map(|pair| {
            pair[1].hz - pair[0].hz < pair[0].decay_per_s.max(pair[1].decay_per_s).max(10.0)
        })
        .collect();
    for (at, overlap) in overlap.into_iter().enumerate() {
        if overlap {
            all[at].measured = false;
            all[at + 1].measured = false;
        }
    }
    all
}

/// How far sound is from what is expected.
#[derive(Clone, Debug, PartialEq)]
pub struct Off {
    /// Greatest error of a pitch, in cents.
    pub cents: f64,
    /// Greatest error of a decay rate, as a fraction.
    pub decay: f64,
    /// What is not explained beside the strongest partial, in dB.
    pub unexplained_db: f64,
    /// Partials that were measured.
    pub count: usize,
    /// All that was found.
    pub fit: Fit,
}

impl Off {
    /// Amplitude of the strongest partial.
    #[must_use]
    pub fn strongest(&self) -> f64 {
        let partials = self.fit.partials.iter();
        partials.fold(0.0, |most, partial| most.max(partial.amplitude))
    }
}

/// Fits the partials to the sound; those that are weaker than `faint` times the strongest are not
/// measured.
#[must_use]
pub fn off(sound: &[f32], rate_hz: f64, expected: &[Partial], faint: f64) -> Off {
    let mut off = Off {
        cents: 0.0,
        decay: 0.0,
        unexplained_db: 0.0,
        count: 0,
        fit: fit(sound, rate_hz, expected),
    };
    let most = off.strongest();
    for (partial, found) in expected.iter().zip(&off.fit.partials) {
        if partial.measured && found.amplitude > faint * most {
            off.cents = off.cents.max(found.cents_off.abs());
            off.decay = off.decay.max(found.decay_off.abs());
            off.count += 1;
        }
    }
    off.unexplained_db = 20.0 * (off.fit.residual / most).log10();
    off
}
