//! The circular membrane (van den Doel & Pai 1998, §6.4).

use super::beam::{Hankel, disc};
use super::bessel::bessel_j;
use super::roots::roots;
use super::round::{Round, round_modes};
use super::{ClosedMode, ProductMode};
use crate::ModeLabel;
use std::f64::consts::{PI, TAU};

/// A membrane held along a circle about the origin.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CircularMembrane {
    /// Radius, in m.
    pub radius_m: f64,
    /// Tension, in N/m.
    pub tension_n_m: f64,
    /// Mass per area, in kg/m².
    pub mass_kg_m2: f64,
}

/// A mode of a circular membrane.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CircularMode {
    membrane: CircularMembrane,
    round: Round,
    /// Height of the shape's Bessel function, in kg^(−1/2).
    height: f64,
}

/// Zeros of J of whole `order` up to `highest`, rising.
#[must_use]
pub fn bessel_zeros(order: u16, highest: f64) -> Vec<f64> {
    // The first lies above the order, and zeros are 3.1 apart or more (DLMF §10.21(iv)).
    let low = f64::from(order) + 0.5;
    let high = highest.max(low);
    #[expect(clippy::cast_sign_loss, reason = "not below 0")]
    let steps = 1 + (2.0 * (high - low)) as usize;
    let order = usize::from(order);
    roots(|x| bessel_j(0.0, x, order + 1)[order], [low, high], steps)
}

impl CircularMembrane {
    /// Frequency in Hz of the mode whose Bessel function vanishes at `zero` on the rim.
    #[must_use]
    pub fn hz(&self, zero: f64) -> f64 {
        zero * (self.tension_n_m / self.mass_kg_m2).sqrt() / (TAU * self.radius_m)
    }

    /// The modes up to `highest_hz`, rising; those with nodal diameters in pairs.
    #[must_use]
    pub fn modes(&self, highest_hz: f64) -> Vec<CircularMode> {
        let highest = highest_hz / self.hz(1.0);
        round_modes(|order| bessel_zeros(order, highest))
            .into_iter()
            .map(|round| {
                let order = usize::from(round.order);
                // ∫J² ρ dρ over 0…1 is J_{m+1}²/2 at a zero (DLMF 10.22.37).
                let rim = bessel_j(0.0, round.root, order + 2)[order + 1];
                let mean_square = round.mean_square() * rim * rim;
                CircularMode {
                    membrane: *self,
                    round,
                    height: 1.0 / (self.mass_kg() * mean_square).sqrt(),
                }
            })
            .collect()
    }

    /// Mass, in kg.
    #[must_use]
    pub fn mass_kg(&self) -> f64 {
        self.mass_kg_m2 * PI * self.radius_m * self.radius_m
    }
}

impl ClosedMode for CircularMode {
    fn hz(&self) -> f64 {
        self.membrane.hz(self.round.root)
    }

    fn displacement(&self, at_m: [f64; 2]) -> f64 {
        let Some((share, wave)) = self.round.place(at_m, self.membrane.radius_m) else {
            return 0.0;
        };
        let order = usize::from(self.round.order);
        self.height * wave * bessel_j(0.0, share * self.round.root, order + 1)[order]
    }

    fn label(&self) -> ModeLabel {
        self.round.label(crate::Family::Membrane)
    }
}

impl ProductMode for CircularMode {
    fn functions(&self) -> [[u16; 2]; 2] {
        self.round.functions()
    }

    fn along(&self, share: f64) -> f64 {
        let order = usize::from(self.round.order);
        let wave = bessel_j(0.0, share.abs() * self.round.root, order + 1)[order];
        self.round.parity(share) * wave
    }

    fn across(&self, share: f64) -> f64 {
        self.round.wave(share)
    }

    fn height(&self) -> f64 {
        self.height
    }

    fn beamed(&self, wave_per_m: f64) -> f64 {
        let radius_m = self.membrane.radius_m;
        let hankel = Hankel::new(self.round.order, self.round.root);
        let mean_square = self.round.mean_square();
        let unit = disc(wave_per_m * radius_m, mean_square, |q| hankel.at(q));
        self.height * self.height * radius_m.powi(4) * unit
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::analytic::overlaps::worst_overlap;

    /// DLMF table 10.21.
    #[test]
    fn zeros_are_the_published_ones() {
        let published = [
            (
                0,
                [
                    2.404_825_557_695_773,
                    5.520_078_110_286_311,
                    8.653_727_912_911_012,
                ],
            ),
            (
                1,
                [
                    3.831_705_970_207_512,
                    7.015_586_669_815_619,
                    10.173_468_135_062_722,
                ],
            ),
            (
                2,
                [
                    5.135_622_301_840_683,
                    8.417_244_140_399_865,
                    11.619_841_172_149_059,
                ],
            ),
        ];
        for (order, zeros) in published {
            let found = bessel_zeros(order, 11.7);
            assert_eq!(found.len(), 3);
            for (found, zero) in found.into_iter().zip(zeros) {
                assert!((found / zero - 1.0).abs() < 1e-14, "J{order}");
            }
        }
    }

    fn drum() -> CircularMembrane {
        CircularMembrane {
            radius_m: 0.16,
            tension_n_m: 3000.0,
            mass_kg_m2: 0.26,
        }
    }

    /// As many modes as Weyl's law counts: A k²/4π − L k/4π, within what it leaves open.
    #[test]
    fn no_mode_is_missing() {
        let drum = drum();
        let highest = 40.0;
        let count = drum.modes(drum.hz(highest)).len() as f64;
        let weyl = 0.25 * highest * highest - 0.5 * highest + 1.0 / 3.0;
        assert!((count - weyl).abs() < 6.0, "{count} {weyl}");
    }

    #[test]
    fn modes_are_orthonormal() {
        let drum = drum();
        let modes = drum.modes(drum.hz(12.0));
        assert!(modes.len() > 25);
        let worst = worst_overlap(&modes, 44, |u, v| {
            let (sin, cos) = (TAU * v).sin_cos();
            let at_m = [u * drum.radius_m * cos, u * drum.radius_m * sin];
            (at_m, 2.0 * u * drum.mass_kg())
        });
        assert!(worst < 1e-11, "{worst:e}");
    }
}
