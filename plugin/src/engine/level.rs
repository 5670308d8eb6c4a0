//! How loud: from Pa to full scale, key by key, once for an instrument.

use super::body::{Body, Strike, Tuned};
use super::oscillators::{Kernel, Pack, Vectors};
use super::source::Hearing;
use super::touch::Touch;
use super::{GRID, Hit, Losses, Settings};
use modes::Bank;
use std::f64::consts::TAU;

/// Velocity of the strike by which bodies are made equally loud.
const VELOCITY: f32 = 100.0 / 127.0;

/// Level that this strike gives every body: A-weighted, mean of the ears, over the first 0.4 s (the
/// momentary window of EBU R 128), in dB below a full-scale square.
const LOUDNESS_DB: f64 = -44.0;

/// The window, in s.
const WINDOW_S: f64 = 0.4;

/// Greatest peak of the hardest strike on any body, in dB: blows at the same instant add up nearly in
/// step, and five and a half of them fit.
const PEAK_DB: f64 = -15.0;

/// How finely and how long a blow is looked at for its peak: at no host's rate, so that the level
/// does not depend on it.
const LOOK_HZ: f64 = 96_000.0;
const LOOK_CELLS: usize = 30;

/// Cells within which a mallet has left, if it ever does.
const CONTACT_CELLS: usize = 300;

/// Factors from Pa to full scale for `bodies` of `bank`.
///
/// Every body is struck with default settings, once by [`VELOCITY`] for its loudness and once as hard as
/// can be for its peak. All are made equally loud but for those whose hardest blow would then peak
/// above [`PEAK_DB`]: these are turned down to it. 1 for a body that does not sound.
pub(crate) fn full_scales(bank: &Bank, bodies: &[&modes::Body]) -> Vec<f64> {
    let [target, limit] = [LOUDNESS_DB, PEAK_DB].map(|db| 10f64.powf(db / 20.0));
    let mut before = None;
    bodies
        .iter()
        .map(|body| {
            let trial = Trial::new(bank, body, before.take());
            let trial = before.insert(trial);
            let loud = target / trial.loudness_pa();
            let scale = loud.min(limit / trial.peak_pa());
            if scale > 0.0 && scale.is_finite() {
                scale
            } else {
                1.0
            }
        })
        .collect()
}

/// One body, struck to hear how loud it is.
struct Trial {
    kernel: Kernel,
    body: Body,
    packs: Vec<Pack>,
    tuned: Tuned,
}

impl Trial {
    /// Of `body`, which may share what it has in common with that of the trial `before`.
    fn new(bank: &Bank, body: &modes::Body, before: Option<Self>) -> Self {
        let matter = bank.matter_of(body);
        let before = before.map(|trial| trial.body);
        let body = Body::new((body, &matter), 1.0, 0, before.as_ref());
        Self {
            kernel: Kernel::new(Vectors::Widest),
            packs: vec![Pack::STILL; body.place.len()],
            body,
            tuned: Tuned {
                trims: 0,
                drain: Losses::AS_BUILT.drain(&matter.damping),
                ratio: 1.0,
            },
        }
    }

    /// A blow of `velocity` 0…1 on the body at rest.
    fn strike(&mut self, velocity: f32) {
        let (settings, step_s) = (Settings::default(), 1.0 / LOOK_HZ);
        self.body.hush(&mut self.packs);
        let moved = self.body.listen(&Hearing::AS_BUILT);
        let packs = &mut self.packs;
        self.body
            .tune(self.kernel, packs, (self.tuned, moved), step_s);
        let strike = Strike {
            mallet: settings.mallet,
            body_pa: self.body.modulus_pa,
            heavier: 1.0,
            touch: Touch::new(&settings, &Hit::plain(f64::from(velocity)), [0.0; 2]),
            seed: 1,
        };
        self.body.strike(self.kernel, &strike, step_s);
    }

    /// Greatest pressure in a cell of the grid, in Pa.
    fn cell_pa(&mut self) -> f64 {
        let mut buses = [[0.0; GRID]; 2];
        let [left, right] = &mut buses;
        self.body.drive(
            self.kernel,
            &mut self.packs,
            0,
            1.0 / LOOK_HZ,
            [left, right],
        );
        buses
            .iter()
            .flatten()
            .fold(0.0, |peak, x| peak.max(x.abs()))
    }

    /// Greatest pressure at an ear in the first hundredth of a second after the hardest blow, in Pa.
    fn peak_pa(&mut self) -> f64 {
        self.strike(1.0);
        (0..LOOK_CELLS).fold(0.0, |peak, _| self.cell_pa().max(peak))
    }

    /// A-weighted level in Pa after a blow of [`VELOCITY`]: root of the mean square of both ears over
    /// the window, beats left out.
    fn loudness_pa(&mut self) -> f64 {
        self.strike(VELOCITY);
        for _ in 0..CONTACT_CELLS {
            self.cell_pa();
            if self.body.part(&self.packs) {
                break;
            }
        }
        let square: f64 = self
            .body
            .sounds(&self.packs)
            .map(|sound| {
                let fall = 2.0 * sound.decay_per_s * WINDOW_S;
                // Mean of e^(−2dt) over the window; sin² is a half.
                let mean = if fall > 1e-9 {
                    -(-fall).exp_m1() / fall
                } else {
                    1.0
                };
                0.5 * 0.5 * sound.power * mean * a_weight(sound.omega / TAU).powi(2)
            })
            .sum();
        square.sqrt()
    }
}

/// The A curve of IEC 61672-1 as a factor, 1 at 1 kHz.
fn a_weight(hz: f64) -> f64 {
    let response = |hz: f64| {
        let square = hz * hz;
        let low = (square + 20.6f64.powi(2))
            * ((square + 107.7f64.powi(2)) * (square + 737.9f64.powi(2))).sqrt();
        12_194f64.powi(2) * square * square / (low * (square + 12_194f64.powi(2)))
    };
    response(hz) / response(1000.0)
}

#[cfg(test)]
mod tests {
    use super::a_weight;

    /// IEC 61672-1, table 3, nominal frequencies.
    #[test]
    fn the_a_curve_is_that_of_the_standard() {
        for (hz, db) in [
            (31.623, -39.4),
            (100.0, -19.1),
            (1000.0, 0.0),
            (2500.0, 1.3),
            (10_000.0, -2.5),
        ] {
            let found = 20.0 * a_weight(hz).log10();
            assert!((found - db).abs() < 0.11, "{hz}: {found}");
        }
    }
}
