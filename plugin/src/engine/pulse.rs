//! The force of a Hertz contact over time.

use super::bessel::ORDERS;
use std::f64::consts::{FRAC_PI_2, PI};

/// A force that rises and falls once: F(t) ∝ sin^(3/2)(πt/τ).
///
/// The indentation of an elastic impact is nearly half a sine (Hunter, J. Mech. Phys. Solids 5,
/// 1957) and the force goes with its power 3/2 (Hertz).
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Pulse {
    /// ∫F dt, in N·s.
    pub(crate) impulse_n_s: f64,
    /// Contact time τ, in s.
    pub(crate) duration_s: f64,
}

/// τ / ∫₀^τ sin^(3/2)(πt/τ) dt = √π Γ(7/4) / Γ(5/4), with Γ from Abramowitz & Stegun, table 6.1.
const CREST: f64 = 1.772_453_850_905_516 * 0.919_062_526_848_883 / 0.906_402_477_055_477;

/// Points of the quadrature over a sample.
const POINTS: usize = 8;

/// Gauss-Legendre abscissae for 8 points (Abramowitz & Stegun, table 25.4).
const NODES: [f64; POINTS] = [
    -0.960_289_856_497_536,
    -0.796_666_477_413_627,
    -0.525_532_409_916_329,
    -0.183_434_642_495_650,
    0.183_434_642_495_650,
    0.525_532_409_916_329,
    0.796_666_477_413_627,
    0.960_289_856_497_536,
];

/// Their weights.
const WEIGHTS: [f64; POINTS] = [
    0.101_228_536_290_376,
    0.222_381_034_453_374,
    0.313_706_645_877_887,
    0.362_683_783_378_362,
    0.362_683_783_378_362,
    0.313_706_645_877_887,
    0.222_381_034_453_374,
    0.101_228_536_290_376,
];

/// cos θ for |θ| ≤ π/2 to 10⁻¹²: no call out of the audio loop, and the same on every platform.
#[inline(always)]
fn cosine(theta: f64) -> f64 {
    let t = theta * theta;
    let mut sum = 1.0;
    for k in [16.0, 14.0, 12.0, 10.0, 8.0, 6.0, 4.0, 2.0_f64] {
        sum = 1.0 - t / (k * (k - 1.0)) * sum;
    }
    sum
}

impl Pulse {
    /// Force in N at `time_s` after first touch; 0 before and after the contact.
    #[inline(always)]
    pub(crate) fn force_n(&self, time_s: f64) -> f64 {
        let phase = (time_s / self.duration_s).clamp(0.0, 1.0);
        let sine = cosine(PI * phase - FRAC_PI_2).max(0.0);
        CREST * self.impulse_n_s / self.duration_s * sine * sine.sqrt()
    }

    /// Legendre moments Mₖ = ∫ F(s) Pₖ(2(s−start)/step − 1) ds over one sample, in N·s.
    #[inline(always)]
    pub(crate) fn moments(&self, start_s: f64, step_s: f64) -> [f64; ORDERS] {
        let end = (start_s + step_s).min(self.duration_s);
        let half = (0.5 * (end - start_s)).max(0.0);
        let mut shares = [[0.0; POINTS]; ORDERS];
        for i in 0..POINTS {
            let within = half * (1.0 + NODES[i]);
            let share = WEIGHTS[i] * half * self.force_n(start_s + within);
            let u = 2.0 * within / step_s - 1.0;
            shares[0][i] = share;
            shares[1][i] = share * u;
            shares[2][i] = share * (0.5 * (3.0 * u * u - 1.0));
            shares[3][i] = share * (0.5 * u * (5.0 * u * u - 3.0));
        }
        shares.map(|order| order.iter().sum())
    }

    /// |∫F exp(−iωt) dt| in N·s at `omega` in rad/s; the phase is that of a blow at τ/2.
    pub(crate) fn spectrum_n_s(&self, omega: f64) -> f64 {
        const PIECES: u32 = 16;
        let piece = self.duration_s / f64::from(PIECES);
        let half = 0.5 * piece;
        let mut sum = 0.0;
        for i in 0..PIECES {
            let middle = piece * f64::from(i) + half;
            for (node, weight) in NODES.into_iter().zip(WEIGHTS) {
                let t = middle + half * node;
                sum +=
                    weight * half * self.force_n(t) * (omega * (t - 0.5 * self.duration_s)).cos();
            }
        }
        sum.abs()
    }
}

#[cfg(test)]
mod tests {
    use super::{CREST, PI, Pulse, cosine};

    #[test]
    fn cosine_is_the_cosine() {
        for i in -100..=100 {
            let theta = f64::from(i) / 100.0 * std::f64::consts::FRAC_PI_2;
            assert!((cosine(theta) - theta.cos()).abs() < 1e-12);
        }
    }

    #[test]
    fn moments_over_all_samples_add_up_to_the_impulse() {
        for (tau, bound) in [(3e-3, 1e-9), (3.3e-4, 1e-7), (4.7e-5, 4e-6), (2e-5, 5e-5)] {
            let pulse = Pulse {
                impulse_n_s: 0.2,
                duration_s: tau,
            };
            let step = 1.0 / 48_000.0;
            let sum: f64 = (0..2000)
                .map(|n| pulse.moments(f64::from(n) * step, step)[0])
                .sum();
            assert!(
                (sum / 0.2 - 1.0).abs() < bound,
                "τ = {tau}: {}",
                sum / 0.2 - 1.0
            );
        }
    }

    #[test]
    fn spectrum_at_rest_is_the_impulse_and_falls_with_frequency() {
        let pulse = Pulse {
            impulse_n_s: 0.2,
            duration_s: 1e-3,
        };
        assert!((pulse.spectrum_n_s(0.0) / 0.2 - 1.0).abs() < 1e-7);
        // Far above 1/τ the two ends count, each t^(3/2): 2 Γ(5/2) π^(3/2) / (ωτ)^(5/2) of the crest.
        let omega = std::f64::consts::TAU * 1e4;
        let ends = 2.0 * 1.329_340_388 * PI.powf(1.5) / (omega * 1e-3).powf(2.5);
        assert!(pulse.spectrum_n_s(omega) < 1.05 * CREST * ends * 0.2);
        assert!(pulse.spectrum_n_s(2.0 * omega) < 0.19 * CREST * ends * 0.2);
    }
}
