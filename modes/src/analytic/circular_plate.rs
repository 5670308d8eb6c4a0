//! The circular plate, clamped at its rim (van den Doel & Pai 1998, §6.5).

use super::beam::{Hankel, disc};
use super::bessel::{bessel_i, bessel_j};
use super::roots::roots;
use super::round::{Round, round_modes};
use super::{ClosedMode, ProductMode};
use crate::{Family, Material, ModeLabel};
use std::f64::consts::{PI, TAU};

/// A thin plate about the origin whose rim neither moves nor turns.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ClampedPlate {
    /// Radius, in m.
    pub radius_m: f64,
    /// Bending stiffness D = E h³/12(1 − ν²), in N m.
    pub bending_n_m: f64,
    /// Mass per area, in kg/m².
    pub mass_kg_m2: f64,
}

/// A mode of a clamped plate.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PlateMode {
    plate: ClampedPlate,
    round: Round,
    /// Height of the shape's Bessel function J, in kg^(−1/2).
    height: f64,
}

/// Wave numbers times radius of a clamped plate's modes of `order` nodal diameters up to `highest`,
/// rising: Jₘ(λ) Iₘ₊₁(λ) + Iₘ(λ) Jₘ₊₁(λ) = 0 (Leissa 1969, Eq. 2.3).
#[must_use]
pub fn clamped_plate_roots(order: u16, highest: f64) -> Vec<f64> {
    // They lie between the zeros of Jₘ and Jₘ₊₁.
    let low = f64::from(order) + 0.5;
    let high = highest.max(low);
    #[expect(clippy::cast_sign_loss, reason = "not below 0")]
    let steps = 1 + (2.0 * (high - low)) as usize;
    let order = usize::from(order);
    let rim = |x: f64| {
        let (j, i) = (bessel_j(0.0, x, order + 2), bessel_i(x, order + 2));
        j[order] * i[order + 1] / i[order] + j[order + 1]
    };
    roots(rim, [low, high], steps)
}

impl ClampedPlate {
    /// A plate of `material`, `thickness_m` thick.
    #[must_use]
    pub fn of(material: &Material, radius_m: f64, thickness_m: f64) -> Self {
        let poisson = material.poisson();
        let bending = material.young_pa() * thickness_m.powi(3);
        Self {
            radius_m,
            bending_n_m: bending / (12.0 * (1.0 - poisson * poisson)),
            mass_kg_m2: material.density_kg_m3 * thickness_m,
        }
    }

    /// Frequency in Hz of the mode whose wave number times the radius is `root`.
    #[must_use]
    pub fn hz(&self, root: f64) -> f64 {
        let wave_per_m = root / self.radius_m;
        wave_per_m * wave_per_m * (self.bending_n_m / self.mass_kg_m2).sqrt() / TAU
    }

    /// The modes up to `highest_hz`, rising; those with nodal diameters in pairs.
    #[must_use]
    pub fn modes(&self, highest_hz: f64) -> Vec<PlateMode> {
        let highest = (highest_hz / self.hz(1.0)).sqrt();
        round_modes(|order| clamped_plate_roots(order, highest))
            .into_iter()
            .map(|round| {
                let order = usize::from(round.order);
                // ∫W² ρ dρ over 0…1 is J² at the rim: where W and W′ vanish, the terms of J, I and
                // their product (DLMF 10.22.5, 10.43.29) leave just that.
                let rim = bessel_j(0.0, round.root, order + 1)[order];
                let mean_square = 2.0 * round.mean_square() * rim * rim;
                PlateMode {
                    plate: *self,
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

impl PlateMode {
    /// Its function of the distance, as a share of the radius.
    fn radial(&self, share: f64) -> f64 {
        let (order, root) = (usize::from(self.round.order), self.round.root);
        let j = |x: f64| bessel_j(0.0, x, order + 1)[order];
        let i = |x: f64| bessel_i(x, order + 1)[order];
        let modified = i(share * root) / i(root) * (root * (share - 1.0)).exp();
        j(share * root) - j(root) * modified
    }
}

impl ClosedMode for PlateMode {
    fn hz(&self) -> f64 {
        self.plate.hz(self.round.root)
    }

    fn displacement(&self, at_m: [f64; 2]) -> f64 {
        let Some((share, wave)) = self.round.place(at_m, self.plate.radius_m) else {
            return 0.0;
        };
        self.height * wave * self.radial(share)
    }

    fn label(&self) -> ModeLabel {
        self.round.label(Family::Plate)
    }
}

impl ProductMode for PlateMode {
    fn functions(&self) -> [[u16; 2]; 2] {
        self.round.functions()
    }

    fn along(&self, share: f64) -> f64 {
        self.round.parity(share) * self.radial(share.abs())
    }

    fn across(&self, share: f64) -> f64 {
        self.round.wave(share)
    }

    fn height(&self) -> f64 {
        self.height
    }

    fn beamed(&self, wave_per_m: f64) -> f64 {
        let (radius_m, square) = (self.plate.radius_m, self.round.root * self.round.root);
        let hankel = Hankel::new(self.round.order, self.round.root);
        // ∫ I(λρ) J(qρ) ρ dρ has the same numerator by the equation of the rim, over −(λ² + q²)
        // (DLMF 10.22.4, with λ for iλ): together 2λ²/(λ² + q²) times that of J.
        let transform = |q: f64| hankel.at(q) * 2.0 * square / (square + q * q);
        let unit = disc(wave_per_m * radius_m, self.round.mean_square(), transform);
        self.height * self.height * radius_m.powi(4) * unit
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::TABLE_1;
    use crate::analytic::overlaps::worst_overlap;

    /// λ² of Leissa 1969, table 2.1, whose figures are good to four digits.
    #[test]
    fn roots_are_the_published_ones() {
        let published = [
            (0, [10.2158, 39.771, 89.104]),
            (1, [21.26, 60.82, 120.08]),
            (2, [34.88, 84.58, 153.81]),
            (3, [51.04, 111.01, 190.30]),
        ];
        for (order, squares) in published {
            let found = clamped_plate_roots(order, 14.0);
            assert_eq!(found.len(), 3 + usize::from(order == 0));
            for (root, square) in found.into_iter().zip(squares) {
                let error = (root * root / square - 1.0).abs();
                assert!(error < 2e-4, "{order} {root} {square}");
            }
        }
    }

    /// Between a billionth below and above each root the equation changes its sign, with J of another
    /// library and I by its series (DLMF 10.25.2).
    #[test]
    fn roots_solve_the_equation_of_the_rim() {
        let modified = |order: i32, x: f64| {
            let mut term = (0.5 * x).powi(order) / libm::tgamma(f64::from(order) + 1.0);
            let mut sum = 0.0;
            for k in 1..80 {
                sum += term;
                term *= 0.25 * x * x / (f64::from(k) * f64::from(k + order));
            }
            sum
        };
        for whole in 0..6u16 {
            let order = i32::from(whole);
            let rim = |x: f64| {
                libm::jn(order, x) * modified(order + 1, x)
                    + modified(order, x) * libm::jn(order + 1, x)
            };
            for root in clamped_plate_roots(whole, 20.0) {
                assert!(rim(root * (1.0 - 1e-9)) * rim(root * (1.0 + 1e-9)) < 0.0);
            }
        }
    }

    fn plate() -> ClampedPlate {
        ClampedPlate::of(&TABLE_1[0].material, 0.15, 0.001)
    }

    #[test]
    fn modes_are_orthonormal() {
        let plate = plate();
        let modes = plate.modes(plate.hz(12.0));
        assert!(modes.len() > 15);
        let worst = worst_overlap(&modes, 44, |u, v| {
            let (sin, cos) = (TAU * v).sin_cos();
            let at_m = [u * plate.radius_m * cos, u * plate.radius_m * sin];
            (at_m, 2.0 * u * plate.mass_kg())
        });
        assert!(worst < 1e-11, "{worst:e}");
    }

    #[test]
    fn the_rim_neither_moves_nor_turns() {
        let plate = plate();
        for mode in plate.modes(plate.hz(20.0)) {
            let near = |share: f64| {
                let (sin, cos) = 0.3f64.sin_cos();
                let r_m = share * plate.radius_m;
                mode.displacement([r_m * cos, r_m * sin])
            };
            assert!(near(1.0 - 1e-15).abs() < 1e-9, "moves {}", near(1.0));
            // Without a slope, four times the distance moves sixteen times as far.
            let ratio = near(1.0 - 4e-5) / near(1.0 - 1e-5);
            assert!((ratio - 16.0).abs() < 0.05, "{ratio}");
        }
    }
}
