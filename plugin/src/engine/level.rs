//! How loud: from Pa to full scale, key by key, once for an instrument.

use super::GRID;
use super::body::{Span, heard};
use super::contact::Contact;
use super::mallet::{Mallet, contact_modulus_pa};
use super::oscillators::Kernel;
use super::pulse::Pulse;
use super::touch::Touch;
use super::{Losses, Settings};
use modes::{Bank, Body, Mode, Motion, Stencil};
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
const LOOK_SAMPLES: usize = 960;

/// A mode after a blow.
struct Ringing {
    hz: f64,
    decay_per_s: f64,
    /// Σ|p|² over both ears, in Pa².
    power: f64,
}

/// Factors from Pa to full scale for `bodies` of `bank`.
///
/// Every body is struck once with default settings; its modes' closed form gives its loudness and
/// the engine its peak. All are made equally loud but for those whose hardest blow would then peak
/// above [`PEAK_DB`]: these are turned down to it. 1 for a body that does not sound.
pub(crate) fn full_scales(bank: &Bank, bodies: &[&Body]) -> Vec<f64> {
    let [target, limit] = [LOUDNESS_DB, PEAK_DB].map(|db| 10f64.powf(db / 20.0));
    bodies
        .iter()
        .map(|body| {
            let loud = target / loudness_pa(&struck(bank, body));
            let scale = loud.min(limit / peak_pa(bank, body));
            if scale > 0.0 && scale.is_finite() {
                scale
            } else {
                1.0
            }
        })
        .collect()
}

/// Where a blow of `velocity` 0…1 with default settings lands, and its force.
fn blow(bank: &Bank, body: &Body, velocity: f32) -> (f64, Pulse) {
    let settings = Settings::default();
    let touch = Touch::new(&settings, velocity, 0.0);
    let mallet = Mallet::new(settings.hardness_pa, contact_modulus_pa(&bank.material));
    (touch.position, mallet.pulse(body.mass_kg, touch.speed_m_s))
}

/// The modes of `body` after a blow of [`VELOCITY`].
fn struck(bank: &Bank, body: &Body) -> Vec<Ringing> {
    let (position, pulse) = blow(bank, body, VELOCITY);
    let stencil = Stencil::at(position, body.line.len());
    let fits = |mode: &&Mode| mode.shape.len() == body.line.len();
    body.modes
        .iter()
        .filter(fits)
        .filter_map(|mode| {
            let decay_per_s = mode.decay_per_s(&bank.damping);
            let Motion::Ringing { hz, decay_per_s } = Motion::of(mode.hz, decay_per_s) else {
                return None;
            };
            let normal = body.line.normal_motion(&mode.shape, &stencil);
            let amplitude = normal * pulse.spectrum_n_s(TAU * hz) / (TAU * hz);
            Some(Ringing {
                hz,
                decay_per_s,
                power: heard(mode)
                    .iter()
                    .flatten()
                    .map(|x| (amplitude * f64::from(*x)).powi(2))
                    .sum(),
            })
        })
        .collect()
}

/// A-weighted level in Pa: root of the mean square of both ears over the window, beats left out.
fn loudness_pa(modes: &[Ringing]) -> f64 {
    let square: f64 = modes
        .iter()
        .map(|mode| {
            let fall = 2.0 * mode.decay_per_s * WINDOW_S;
            // Mean of e^(−2dt) over the window; sin² is a half.
            let mean = if fall > 1e-9 {
                -(-fall).exp_m1() / fall
            } else {
                1.0
            };
            0.5 * 0.5 * mode.power * mean * a_weight(mode.hz).powi(2)
        })
        .sum();
    square.sqrt()
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

/// Greatest pressure at an ear in the first hundredth of a second after the hardest blow, in Pa.
fn peak_pa(bank: &Bank, body: &Body) -> f64 {
    let (kernel, step_s) = (Kernel::detect(), 1.0 / LOOK_HZ);
    let mut ringing = super::body::Body::new(body, step_s, 1.0);
    ringing.tune(kernel, Losses::AS_BUILT.drain(&bank.damping));
    let (position, pulse) = blow(bank, body, 1.0);
    let mut contacts = [Contact::new(ringing.modes())];
    contacts[0].begin(body.key, pulse);
    ringing.strike(position, &mut contacts[0]);
    let mut peak = 0.0f64;
    for _ in 0..LOOK_SAMPLES / GRID {
        let mut buses = [[0.0; GRID]; 3];
        contacts[0].prepare(GRID, step_s);
        let span = Span {
            samples: GRID,
            step_s,
            open: [1.0, 0.0],
        };
        ringing.ring(kernel, &mut contacts, body.key, span, &mut buses);
        let [left, right, _] = buses;
        peak = left
            .iter()
            .chain(&right)
            .fold(peak, |peak, x| peak.max(x.abs()));
    }
    peak
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
