//! Bending of a free beam with shear and rotary inertia (Timoshenko 1921).

use super::roots::bisect;
use crate::Material;
use crate::shape::Tube;
use std::f64::consts::{PI, TAU};

/// A uniform beam, free at both ends.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TimoshenkoBeam {
    /// Length, in m.
    pub length_m: f64,
    /// Bending stiffness E I, in N m².
    pub bending_n_m2: f64,
    /// Shear stiffness κ G A, in N.
    pub shear_n: f64,
    /// Mass per length ρ A, in kg/m.
    pub mass_kg_m: f64,
    /// Rotary inertia per length ρ I, in kg m.
    pub rotary_kg_m: f64,
}

/// Shear coefficient κ of a tube's section (Hutchinson 2001, Journal of Applied Mechanics 68, p. 87,
/// hollow circle), for radii in the same unit.
#[must_use]
pub fn hutchinson_shear_coefficient(outer: f64, inner: f64, poisson: f64) -> f64 {
    let (a2, b2, v) = (outer * outer, inner * inner, poisson);
    let (a4, ab, b4) = (a2 * a2, a2 * b2, b2 * b2);
    6.0 * (a2 + b2).powi(2) * (1.0 + v).powi(2)
        / (7.0 * a4
            + 34.0 * ab
            + 7.0 * b4
            + v * (12.0 * a4 + 48.0 * ab + 12.0 * b4)
            + v * v * (4.0 * a4 + 16.0 * ab + 4.0 * b4))
}

/// Shear coefficient κ of a narrow rectangle, 5(1 + ν)/(6 + 5ν): the limit of no width of Hutchinson
/// 2001 (rectangle), whose full form has a pole for flat sections.
#[must_use]
pub fn rectangle_shear_coefficient(poisson: f64) -> f64 {
    5.0 * (1.0 + poisson) / (6.0 + 5.0 * poisson)
}

impl TimoshenkoBeam {
    /// The beam that a uniform bar of `material` is, bending in the direction in which it is
    /// `depth_m` thick, `width_m` wide across it.
    #[must_use]
    pub fn from_rectangle(length_m: f64, depth_m: f64, width_m: f64, material: &Material) -> Self {
        let area_m2 = depth_m * width_m;
        let second_moment_m4 = area_m2 * depth_m * depth_m / 12.0;
        let shear_coefficient = rectangle_shear_coefficient(material.poisson());
        Self {
            length_m,
            bending_n_m2: material.young_pa() * second_moment_m4,
            shear_n: shear_coefficient * material.mu_pa * area_m2,
            mass_kg_m: material.density_kg_m3 * area_m2,
            rotary_kg_m: material.density_kg_m3 * second_moment_m4,
        }
    }

    /// The beam that a tube of `material` is.
    #[must_use]
    pub fn from_tube(tube: &Tube, material: &Material) -> Self {
        let shear_coefficient = hutchinson_shear_coefficient(
            tube.outer_radius_m,
            tube.inner_radius_m(),
            material.poisson(),
        );
        Self {
            length_m: tube.length_m,
            bending_n_m2: material.young_pa() * tube.second_moment_m4(),
            shear_n: shear_coefficient * material.mu_pa * tube.section_area_m2(),
            mass_kg_m: material.density_kg_m3 * tube.section_area_m2(),
            rotary_kg_m: material.density_kg_m3 * tube.second_moment_m4(),
        }
    }

    /// Frequencies in Hz of the first `count` bending modes, below the onset of the beam's second
    /// spectrum.
    ///
    /// Deflection and rotation go as cosh/sinh αx and cos/sin βx; with the middle of the beam as
    /// origin, symmetric and antisymmetric modes each leave one real equation.
    ///
    /// # Panics
    ///
    /// If a mode lies above the cut-on of the second spectrum, √(κGA/ρI)/2π.
    #[must_use]
    pub fn free_free_hz(&self, count: usize) -> Vec<f64> {
        let second_spectrum_hz = (self.shear_n / self.rotary_kg_m).sqrt() / TAU;
        (1..=count)
            .map(|mode| {
                // Shear and rotary inertia only lower a mode: Euler's frequency bounds it from above.
                let high = self
                    .euler_bernoulli_hz(mode + 1)
                    .min(0.999_999 * second_spectrum_hz);
                let antisymmetric = mode % 2 == 0;
                let equation = |hz: f64| self.end_condition(hz, antisymmetric);
                let roots = roots(equation, high, 4000);
                let index = (mode - 1) / 2;
                assert!(
                    index < roots.len(),
                    "mode {mode} is above the second spectrum"
                );
                roots[index]
            })
            .collect()
    }

    /// Frequency in Hz of the `mode`th bending mode, counted from 1, of a thin beam.
    #[must_use]
    pub fn euler_bernoulli_hz(&self, mode: usize) -> f64 {
        // cos βL cosh βL = 1; beyond the first root, (2n + 1)π/2 is exact to 10⁻³ and better.
        let mut beta = (2 * mode + 1) as f64 * PI / 2.0;
        for _ in 0..20 {
            let sech = 1.0 / beta.cosh();
            beta -= (beta.cos() - sech) / (-beta.sin() + sech * beta.tanh());
        }
        (beta / self.length_m).powi(2) * (self.bending_n_m2 / self.mass_kg_m).sqrt() / TAU
    }

    /// What must vanish for moment and shear force to vanish at the ends.
    fn end_condition(&self, hz: f64, antisymmetric: bool) -> f64 {
        let w2 = (TAU * hz).powi(2);
        let (s, r) = (
            w2 * self.mass_kg_m / self.shear_n,
            w2 * self.rotary_kg_m / self.bending_n_m2,
        );
        // k⁴ − (s + r) k² + s r − ρAω²/EI = 0 for waves exp(ikx).
        let inertia = w2 * self.mass_kg_m / self.bending_n_m2;
        let root = (0.25 * (s - r).powi(2) + inertia).sqrt();
        let beta = (0.5 * (s + r) + root).sqrt();
        let alpha = (root - 0.5 * (s + r)).sqrt();
        // Deflections cosh αx, cos βx go with rotations p sinh αx, −q sin βx.
        let (p, q) = ((alpha * alpha + s) / alpha, (beta * beta - s) / beta);
        let half = 0.5 * self.length_m;
        let (sin, cos) = (beta * half).sin_cos();
        // Divided by cosh αL/2, which never vanishes, to keep the terms of one size.
        let tanh = (alpha * half).tanh();
        // Deflection A cosh αx + B cos βx (or sinh, sin): moment EI ψ', force κGA (w' − ψ).
        if antisymmetric {
            alpha * p * tanh * (beta - q) * cos + beta * q * sin * (alpha - p)
        } else {
            alpha * p * (q - beta) * sin + beta * q * cos * (alpha - p) * tanh
        }
    }
}

/// Rising roots of `f` in 0…`high`, each bracketed by one of `steps` steps.
fn roots(f: impl Fn(f64) -> f64, high: f64, steps: usize) -> Vec<f64> {
    let at = |i: usize| high * i as f64 / steps as f64;
    (1..steps)
        .filter(|&i| f(at(i)) * f(at(i + 1)) <= 0.0)
        .map(|i| bisect(&f, at(i), at(i + 1)))
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn beam(slenderness: f64) -> TimoshenkoBeam {
        let radius = 1.0 / slenderness;
        TimoshenkoBeam {
            length_m: 1.0,
            bending_n_m2: radius * radius,
            shear_n: 0.3,
            mass_kg_m: 1.0,
            rotary_kg_m: radius * radius,
        }
    }

    /// βL = 4.730041, 7.853205, 10.995608, 14.137165 (Blevins 1979, table 8-1).
    #[test]
    fn thin_beams_are_euler_s() {
        let thin = beam(1e5);
        let thin_hz = thin.free_free_hz(4);
        for (i, beta) in [4.730_041, 7.853_205, 10.995_608, 14.137_165f64]
            .into_iter()
            .enumerate()
        {
            let expected = beta * beta * 1e-5 / TAU;
            assert!((thin_hz[i] / expected - 1.0).abs() < 2e-6, "mode {}", i + 1);
            assert!((thin.euler_bernoulli_hz(i + 1) / expected - 1.0).abs() < 3e-7);
        }
    }

    /// First-order perturbation (Rayleigh): the drop is −½ ω² times rotary and shear corrections,
    /// which for short waves of number k is −½ k² I/A (1 + E/κG).
    #[test]
    fn shear_and_rotary_inertia_lower_short_waves_as_they_should() {
        let beam = beam(500.0);
        let mode = 20;
        let k = (2 * mode + 1) as f64 * PI / 2.0;
        let drop = 0.5 * k * k / 500f64.powi(2) * (1.0 + 1.0 / 0.3);
        let measured = 1.0 - beam.free_free_hz(mode)[mode - 1] / beam.euler_bernoulli_hz(mode);
        assert!((measured / drop - 1.0).abs() < 0.1, "{measured} {drop}");
    }

    #[test]
    fn thin_tube_shear_coefficient_is_about_a_half() {
        // (1 + ν)/(2 + ν) in the limit of no wall.
        let v: f64 = 0.33;
        let thin = hutchinson_shear_coefficient(1.0, 0.9999, v);
        assert!((thin - (1.0 + v) / (2.0 + v)).abs() < 1e-4, "{thin}");
    }
}
