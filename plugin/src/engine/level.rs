//! How loud: from Pa to full scale, key by key, once for an instrument.

use super::body::heard;
use super::mallet::Mallet;
use super::touch::Touch;
use super::{Losses, Settings};
use modes::{Body, Damping, Mode, Motion, Stencil};
use std::f64::consts::TAU;

/// Velocity of the strike by which bodies are made equally loud.
const VELOCITY: f32 = 100.0 / 127.0;

/// Level that this strike gives every body: A-weighted, mean of the ears, over the first 0.4 s (the
/// momentary window of EBU R 128), in dB below a full-scale square.
const LOUDNESS_DB: f64 = -36.0;

/// The window, in s.
const WINDOW_S: f64 = 0.4;

/// Greatest peak of the hardest strike on any body, in dB: ten of them at once add up to 20 dB more
/// at the very worst, and 10 dB as a rule.
const PEAK_DB: f64 = -18.0;

/// How finely and how long the sum of modes is looked at for its peak: no engine's rate, so that the
/// level does not depend on it.
const LOOK_HZ: f64 = 96_000.0;
const LOOK_SAMPLES: usize = 960;

/// A mode after a blow.
struct Ringing {
    hz: f64,
    decay_per_s: f64,
    /// Pressure at the left and right ear as (of y, of x), in Pa.
    ears: [[f64; 2]; 2],
}

/// Factors from Pa to full scale for `bodies`, whose material takes `own`.
///
/// Every body is struck once with default settings; its modes' closed form gives its loudness and
/// its peak. All are made equally loud, and where that would bring the hardest blow's peak above
/// [`PEAK_DB`], the whole instrument is turned down. 1 for a body that does not sound.
pub(crate) fn full_scales(own: &Damping, bodies: &[&Body]) -> Vec<f64> {
    let target = 10f64.powf(LOUDNESS_DB / 20.0);
    let mut scales: Vec<f64> = bodies
        .iter()
        .map(|body| {
            let loudness = loudness_pa(&struck(own, body, VELOCITY));
            if loudness > 0.0 && loudness.is_finite() {
                target / loudness
            } else {
                1.0
            }
        })
        .collect();
    let peak = bodies
        .iter()
        .zip(&scales)
        .map(|(body, scale)| scale * peak_pa(&struck(own, body, 1.0)))
        .filter(|peak| peak.is_finite())
        .fold(0.0, f64::max);
    let limit = 10f64.powf(PEAK_DB / 20.0);
    if peak > limit {
        for scale in &mut scales {
            *scale *= limit / peak;
        }
    }
    scales
}

/// The modes of `body` after a blow of `velocity` 0…1 with default settings.
fn struck(own: &Damping, body: &Body, velocity: f32) -> Vec<Ringing> {
    let settings = Settings::default();
    let touch = Touch::new(&settings, velocity, 0.0);
    let pulse = Mallet::of_hardness(settings.hardness_pa).pulse(body.mass_kg, touch.speed_m_s);
    let stencil = Stencil::at(touch.position, body.line.len());
    let drain = Losses::AS_BUILT.drain(own);
    let fits = |mode: &&Mode| mode.shape.len() == body.line.len();
    body.modes
        .iter()
        .filter(fits)
        .filter_map(|mode| {
            let omega = TAU * mode.hz;
            let inside = 0.5
                * (drain.alpha1_s * omega * omega + drain.loss_factor * omega + drain.alpha2_per_s);
            let outside = mode.radiation_per_s + mode.pipe_per_s + mode.support_per_s;
            let Motion::Ringing { hz, decay_per_s } =
                Motion::of(mode.hz, inside + f64::from(outside))
            else {
                return None;
            };
            let normal: f64 = (0..Stencil::POINTS)
                .map(|k| {
                    let point = stencil.first + k;
                    let (shape, normal) = (mode.shape[point], body.line.normals[point]);
                    let along = (0..3).map(|axis| f64::from(shape[axis]) * normal[axis]);
                    stencil.weights[k] * along.sum::<f64>()
                })
                .sum();
            let amplitude = normal * pulse.spectrum_n_s(TAU * hz) / (TAU * hz);
            Some(Ringing {
                hz,
                decay_per_s,
                ears: heard(mode).map(|ear| ear.map(|x| amplitude * f64::from(x))),
            })
        })
        .collect()
}

/// A-weighted level in Pa: root of the mean square of both ears over the window, beats left out.
fn loudness_pa(modes: &[Ringing]) -> f64 {
    let square: f64 = modes
        .iter()
        .map(|mode| {
            let power: f64 = mode.ears.iter().flatten().map(|x| x * x).sum();
            let fall = 2.0 * mode.decay_per_s * WINDOW_S;
            // Mean of e^(−2dt) over the window; sin² is a half.
            let mean = if fall > 1e-9 {
                -(-fall).exp_m1() / fall
            } else {
                1.0
            };
            0.5 * 0.5 * power * mean * a_weight(mode.hz).powi(2)
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

/// Greatest pressure at an ear in the first hundredth of a second, in Pa.
fn peak_pa(modes: &[Ringing]) -> f64 {
    let mut sums = [[0.0; LOOK_SAMPLES]; 2];
    for mode in modes {
        let radius = (-mode.decay_per_s / LOOK_HZ).exp();
        let (sin, cos) = (TAU * mode.hz / LOOK_HZ).sin_cos();
        let (mut x, mut y) = (1.0, 0.0);
        let [left, right] = &mut sums;
        for (left, right) in left.iter_mut().zip(right) {
            *left += mode.ears[0][0] * y + mode.ears[0][1] * x;
            *right += mode.ears[1][0] * y + mode.ears[1][1] * x;
            (x, y) = (radius * (cos * x - sin * y), radius * (cos * y + sin * x));
        }
    }
    sums.iter()
        .flatten()
        .fold(0.0, |peak: f64, value| peak.max(value.abs()))
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
