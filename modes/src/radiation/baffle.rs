//! The power that a flat body radiates out of a wall that it is let into.

use super::{AIR_KG_M3, SOUND_M_S};
use crate::analytic::gauss;
use std::f64::consts::{PI, TAU};

/// Gauss's points from the horizon to the zenith, and directions around.
const HEIGHTS: usize = 6;
const AROUND: usize = 20;

/// Amplitude decay rate in 1/s that radiation causes in a mode of `hz` that moves flat patches, each
/// (x, y) in m and its area times its φ in m² kg^(−1/2), in a rigid wall with air on one side.
///
/// Far away the pressure is ω²ρ/2πr |∫φ e^{ik·x} dS| (Rayleigh 1896, §278); its intensity over a half
/// sphere, over ω², is the rate.
#[must_use]
pub fn baffled_decay_per_s(hz: f64, patches: impl Iterator<Item = ([f64; 2], f64)> + Clone) -> f64 {
    let omega = TAU * hz;
    let k = omega / SOUND_M_S;
    let mut sum = 0.0;
    // Equal steps of the cosine are equal shares of the sphere.
    for (cos, weight) in gauss(HEIGHTS) {
        let along = k * (1.0 - cos * cos).sqrt();
        // A real motion sounds alike in opposite directions.
        for j in 0..AROUND / 2 {
            let (sin, cos) = (TAU * (j as f64 + 0.5) / AROUND as f64).sin_cos();
            let (mut re, mut im) = (0.0, 0.0);
            for ([x, y], moved) in patches.clone() {
                let (s, c) = (along * (x * cos + y * sin)).sin_cos();
                re += moved * c;
                im += moved * s;
            }
            sum += 2.0 * weight * (re * re + im * im);
        }
    }
    let solid_angle = TAU / AROUND as f64;
    beamed_decay_per_s(hz, |_| solid_angle * sum)
}

/// The same for a mode of which ∫ |∫ φ e^{ik·x} dS|² dΩ over the half sphere, in m⁴/kg, is what `beamed`
/// says for the air's wave number k in 1/m.
#[must_use]
pub fn beamed_decay_per_s(hz: f64, beamed: impl Fn(f64) -> f64) -> f64 {
    let omega = TAU * hz;
    omega * omega * AIR_KG_M3 / (8.0 * PI * PI * SOUND_M_S) * beamed(omega / SOUND_M_S)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A disc of `radius_m` in small patches that all move by 1.
    fn piston(radius_m: f64) -> Vec<([f64; 2], f64)> {
        let n = 60;
        let step = 2.0 * radius_m / f64::from(n);
        let at = |i: i32| (f64::from(i) + 0.5) * step - radius_m;
        let grid = (0..n).flat_map(|i| (0..n).map(move |j| [at(i), at(j)]));
        let inside = grid.filter(|[x, y]| x.hypot(*y) < radius_m);
        inside.map(|p| (p, step * step)).collect()
    }

    /// The resistance of a piston, ρcS (1 − J₁(2ka)/ka) (Rayleigh 1896, §302).
    #[test]
    fn a_piston_is_rayleigh_s() {
        let radius_m = 0.1;
        let disc = piston(radius_m);
        let area: f64 = disc.iter().map(|(_, area)| area).sum();
        for hz in [50.0, 400.0, 1000.0, 2000.0] {
            let x = 2.0 * TAU * hz / SOUND_M_S * radius_m;
            let share = 1.0 - 2.0 * libm::j1(x) / x;
            let expected = 0.5 * AIR_KG_M3 * SOUND_M_S * area * share;
            let found = baffled_decay_per_s(hz, disc.iter().copied());
            assert!(
                (found / expected - 1.0).abs() < 0.01,
                "{hz}: {found} {expected}"
            );
        }
    }
}
