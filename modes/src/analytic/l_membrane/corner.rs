//! Waves about the inner corner, which solve the wave equation and rest on both edges that meet there.

use crate::analytic::bessel::bessel_j;
use std::f64::consts::{FRAC_PI_2, PI, SQRT_2, TAU};

/// Waves of one symmetry about the diagonal: J_{2k/3}(κr) sin(2kθ/3), k no multiple of 3.
///
/// θ runs over the 3π/2 of the corner. The k that are multiples of 3 make up the modes of the single
/// squares, which are known: to the rest, f(θ) − f(π − θ) + f(π + θ) = 0. With the symmetry that makes
/// the middle square's motion a sum of the outer ones', so that a combination that rests on the two
/// far sides of one outer square rests on the whole edge.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Waves {
    /// k of each wave.
    numbers: Vec<u32>,
}

/// Orders by which the highest wave exceeds what reaches the farthest corner as a wave: with the terms
/// beyond left out, modes rest on the edge to 10⁻¹⁰ of their size.
const EVANESCENT: f64 = 36.0;

impl Waves {
    /// As many as a mode of wave number `root` needs that is symmetric about the diagonal (or
    /// antisymmetric).
    pub(super) fn new(symmetric: bool, root: f64) -> Self {
        let highest = SQRT_2 * root + EVANESCENT;
        let numbers = (1u32..)
            .take_while(|&k| order(k) <= highest)
            .filter(|k| k % 3 != 0 && (k % 2 == 1) == symmetric)
            .collect();
        Self { numbers }
    }

    /// Each wave's value at a point (r, θ) about the corner, for the wave number `root`.
    pub(super) fn values(&self, root: f64, [r, angle]: [f64; 2]) -> Vec<f64> {
        let ladders = self.ladders(root * r);
        let waves = self.numbers.iter();
        waves
            .map(|&k| radial(&ladders, k) * (order(k) * angle).sin())
            .collect()
    }

    /// Each wave's gradient (along s, the direction θ = 0, and t, θ = π/2) at a point.
    pub(super) fn gradients(&self, root: f64, [r, angle]: [f64; 2]) -> Vec<[f64; 2]> {
        let ladders = self.ladders(root * r);
        let (sin, cos) = angle.sin_cos();
        let waves = self.numbers.iter();
        waves
            .map(|&k| {
                let (v, j) = (order(k), radial(&ladders, k));
                // J′ = (v/x) J − J_{v+1} (DLMF 10.6.2).
                let slope = v / r * j - root * above(&ladders, k);
                let (wave_sin, wave_cos) = (v * angle).sin_cos();
                let (outwards, around) = (slope * wave_sin, v / r * j * wave_cos);
                [cos * outwards - sin * around, sin * outwards + cos * around]
            })
            .collect()
    }

    /// J of orders 1/3, 4/3, … and 2/3, 5/3, …, one beyond the highest wave's.
    fn ladders(&self, x: f64) -> [Vec<f64>; 2] {
        let last = self.numbers.last().map_or(0, |&k| 2 * k / 3);
        [1.0, 2.0].map(|thirds| bessel_j(thirds / 3.0, x, last as usize + 2))
    }
}

/// Order of wave `k`.
fn order(k: u32) -> f64 {
    f64::from(2 * k) / 3.0
}

fn radial(ladders: &[Vec<f64>; 2], k: u32) -> f64 {
    ladders[(2 * k % 3) as usize - 1][(2 * k / 3) as usize]
}

fn above(ladders: &[Vec<f64>; 2], k: u32) -> f64 {
    ladders[(2 * k % 3) as usize - 1][(2 * k / 3) as usize + 1]
}

/// (r, θ) about the inner corner of a point of the L of unit squares.
pub(super) fn about_corner([x, y]: [f64; 2]) -> [f64; 2] {
    let (dx, dy) = (x - 1.0, y - 1.0);
    let angle = (dy.atan2(dx) - FRAC_PI_2).rem_euclid(TAU);
    // Rounding may turn what lies on the first edge to a full turn.
    let angle = if angle > 1.75 * PI { 0.0 } else { angle };
    [dx.hypot(dy), angle]
}
