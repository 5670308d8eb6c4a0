//! The power that a vibrating cylinder radiates, wave by wave along its axis.

use super::{AIR_KG_M3, SOUND_M_S};
use std::f64::consts::{FRAC_PI_2, TAU};

/// Least number of axial waves that are summed.
const FEWEST_WAVES: usize = 24;

/// Amplitude decay rate in 1/s that radiation causes in a mode of `hz` whose mass-normalised normal
/// motion on a cylinder of `radius_m` is `motion` (in kg^(−1/2), at steps of `step_m` along the
/// axis) times cos mθ with m = `order`.
///
/// The motion's spectrum along the axis, each wave with the radiation resistance of an infinite
/// cylinder (Junger & Feit 1986, §6.3): d = ε ωρ/2π ∫|φ̃(k_z)|² / (κ² |H′ₘ(κa)|²) dk_z over
/// |k_z| < ω/c with κ² = (ω/c)² − k_z², ε = 2 for m = 0 and 1 otherwise. The surface beyond the ends
/// counts as rigid.
#[must_use]
pub fn cylinder_decay_per_s(
    hz: f64,
    order: usize,
    radius_m: f64,
    step_m: f64,
    motion: &[f64],
) -> f64 {
    let omega = TAU * hz;
    let k = omega / SOUND_M_S;
    let length_m = step_m * motion.len() as f64;
    #[expect(clippy::cast_sign_loss, reason = "lengths are positive")]
    let waves = FEWEST_WAVES + (k * length_m) as usize;
    // k_z = k sin t makes the integrand smooth at both ends; |φ̃| is even for a real motion.
    let slice = FRAC_PI_2 / waves as f64;
    let sum: f64 = (0..waves)
        .map(|i| {
            let (sin, cos) = ((i as f64 + 0.5) * slice).sin_cos();
            let x = k * cos * radius_m;
            spectrum(motion, k * sin * step_m) / (k * cos * hankel_slope_squared(order, x))
        })
        .sum();
    let epsilon = if order == 0 { 2.0 } else { 1.0 };
    epsilon * omega * AIR_KG_M3 / TAU * 2.0 * sum * slice * step_m * step_m
}

/// |Σ motionⱼ e^{−i j angle}|².
fn spectrum(motion: &[f64], angle: f64) -> f64 {
    let (sin, cos) = angle.sin_cos();
    // Horner's rule, backwards.
    let (mut re, mut im) = (0.0, 0.0);
    for value in motion.iter().rev() {
        (re, im) = (cos * re + sin * im + value, cos * im - sin * re);
    }
    re * re + im * im
}

/// |H′ₘ(x)|² of the Hankel function.
fn hankel_slope_squared(m: usize, x: f64) -> f64 {
    let m = i32::try_from(m).unwrap_or(i32::MAX);
    let slope = |f: fn(i32, f64) -> f64| {
        if m == 0 {
            -f(1, x)
        } else {
            f(m - 1, x) - f64::from(m) / x * f(m, x)
        }
    };
    let square = slope(libm::jn).powi(2) + slope(libm::yn).powi(2);
    if square.is_finite() { square } else { f64::MAX }
}

/// Resistance of a cylinder of a high frequency's wave: ρc, to which tests compare.
#[cfg(test)]
fn plane_decay_per_s(radius_m: f64, length_m: f64, amplitude: f64) -> f64 {
    // W = ½ρc ω² ∫φ² dS with ∫cos² = π, d = W/ω².
    0.5 * AIR_KG_M3 * SOUND_M_S * amplitude * amplitude * std::f64::consts::PI * radius_m * length_m
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::PI;

    /// A long stiff tube shaken sideways: the dipole of a line, W/L = ρω³ π² a⁴ u²/(4·...) from the
    /// small-argument limit |H₁′(x)| → 2/(πx²).
    #[test]
    fn a_thin_cylinder_is_a_dipole() {
        let (hz, a, step, amplitude) = (200.0, 0.01, 0.01, 1.0);
        let motion = vec![amplitude; 4000];
        let decay = cylinder_decay_per_s(hz, 1, a, step, &motion);
        let omega = TAU * hz;
        let k = omega / SOUND_M_S;
        // All waves have k_z ≈ 0: ∫|φ̃|² dk_z = 2π L, and 1/(κ²|H′|²) = π² k² a⁴/4.
        let length = 40.0;
        let expected = omega * AIR_KG_M3 * length * PI * PI * k * k * a.powi(4) / 4.0;
        assert!((decay / expected - 1.0).abs() < 0.02, "{decay} {expected}");
    }

    #[test]
    fn a_thick_cylinder_radiates_plane_waves() {
        let (hz, a, step) = (20_000.0, 0.3, 0.002);
        let motion = vec![1.0; 500];
        let decay = cylinder_decay_per_s(hz, 1, a, step, &motion);
        let expected = plane_decay_per_s(a, 1.0, 1.0);
        assert!((decay / expected - 1.0).abs() < 0.02, "{decay} {expected}");
    }

    #[test]
    fn waves_slower_than_sound_hardly_radiate() {
        let wave = |length_m: f64| -> Vec<f64> {
            (0..800)
                .map(|i| (TAU * f64::from(i) * 0.002 / length_m).sin())
                .collect()
        };
        // Sound of 1 kHz is 0.343 m long.
        let slow = cylinder_decay_per_s(1000.0, 1, 0.02, 0.002, &wave(0.1));
        let fast = cylinder_decay_per_s(1000.0, 1, 0.02, 0.002, &wave(0.8));
        assert!(slow < 0.05 * fast, "{slow} {fast}");
    }
}
