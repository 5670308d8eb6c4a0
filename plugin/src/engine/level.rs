//! How loud: from m³/s to full scale.

use super::Settings;
use super::mallet::Mallet;
use super::touch::Touch;
use modes::{Bank, Motion, Stencil};
use std::f64::consts::TAU;

/// Peak of the loudest key struck hardest, in dB below full scale.
const HEADROOM_DB: f64 = 12.0;

/// How finely and how long the sum of modes is looked at: no engine's rate, so that the level does
/// not depend on it.
const LOOK_HZ: f64 = 96_000.0;
const LOOK_SAMPLES: usize = 1920;

/// Factor from rectified volume velocity in m³/s to full scale for one bank.
///
/// Every body is struck once with full velocity and default settings; the closed form of its ringing
/// after the blow, Σ cᵢ φᵢ·n̂ |F̂(Ωᵢ)|/Ωᵢ e^(−dᵢt) sin Ωᵢt, is summed over the first 20 ms, and the
/// greatest peak among the bodies is put at −12 dB. 1 if nothing sounds.
pub(crate) fn full_scale(bank: &Bank) -> f64 {
    let peak = bank
        .bodies
        .iter()
        .map(|body| peak_m3_s(bank, body))
        .filter(|peak| peak.is_finite())
        .fold(0.0, f64::max);
    if peak > 0.0 {
        10f64.powf(-HEADROOM_DB / 20.0) / peak
    } else {
        1.0
    }
}

/// Peak volume velocity of one body after the hardest blow, in m³/s.
fn peak_m3_s(bank: &Bank, body: &modes::Body) -> f64 {
    let points = body.line.len();
    if points < Stencil::POINTS {
        return 0.0;
    }
    let settings = Settings::default();
    let touch = Touch::new(&settings, 1.0, 0.0);
    let pulse = Mallet::of_hardness(settings.hardness_pa).pulse(body.mass_kg, touch.speed_m_s);
    let stencil = Stencil::at(touch.position, points);
    let mut sum = vec![0.0; LOOK_SAMPLES];
    for mode in &body.modes {
        let Motion::Ringing { hz, decay_per_s } = bank.damping.motion(mode.hz) else {
            continue;
        };
        if mode.shape.len() != points {
            continue;
        }
        let normal: f64 = (0..Stencil::POINTS)
            .map(|k| {
                let point = stencil.first + k;
                let along = (0..3)
                    .map(|axis| f64::from(mode.shape[point][axis]) * body.line.normals[point][axis])
                    .sum::<f64>();
                stencil.weights[k] * along
            })
            .sum();
        let omega = TAU * hz;
        let amplitude = mode.coupling * normal * pulse.spectrum_n_s(omega) / omega;
        let radius = (-decay_per_s / LOOK_HZ).exp();
        let (sin, cos) = (omega / LOOK_HZ).sin_cos();
        let (mut x, mut y) = (amplitude, 0.0);
        for sample in &mut sum {
            *sample += y;
            (x, y) = (radius * (cos * x - sin * y), radius * (cos * y + sin * x));
        }
    }
    sum.iter()
        .fold(0.0, |peak: f64, value| peak.max(value.abs()))
}
