//! The thin bar of Euler and Bernoulli (van den Doel & Pai 1998, §6.2, Eq. 14).

use super::ClosedMode;
use crate::shape::BarEnds;
use crate::{Family, Member, ModeLabel};
use std::f64::consts::{PI, TAU};

/// A uniform bar so thin that neither shear nor rotary inertia matter.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RigidBar {
    /// Length, in m.
    pub length_m: f64,
    /// Bending stiffness E I, in N m².
    pub bending_n_m2: f64,
    /// Mass per length, in kg/m.
    pub mass_kg_m: f64,
    /// How its ends are held.
    pub ends: BarEnds,
}

/// A mode of a bar.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BarMode {
    bar: RigidBar,
    index: u16,
    /// βL, a root of the equation of its ends.
    root: f64,
}

impl BarEnds {
    /// βL of the `index`th mode, counted from 1: cos βL cosh βL = 1, or −1 for a cantilever (Blevins
    /// 1979, table 8-1).
    #[must_use]
    pub fn root(self, index: u16) -> f64 {
        let (sign, halves) = match self {
            Self::Clamped | Self::Free => (-1.0, 2 * u32::from(index) + 1),
            Self::Cantilever => (1.0, 2 * u32::from(index) - 1),
        };
        // cos βL ∓ sech βL by Newton's rule, from where the cosine vanishes.
        let mut root = 0.5 * PI * f64::from(halves);
        for _ in 0..12 {
            let sech = 1.0 / root.cosh();
            root += (root.cos() + sign * sech) / (root.sin() + sign * sech * root.tanh());
        }
        root
    }
}

impl RigidBar {
    /// A bar of a rectangular section, bending in the direction in which it is `depth_m` thick.
    #[must_use]
    pub fn from_rectangle(
        [length_m, depth_m, width_m]: [f64; 3],
        density_kg_m3: f64,
        young_pa: f64,
        ends: BarEnds,
    ) -> Self {
        Self {
            length_m,
            bending_n_m2: young_pa * width_m * depth_m.powi(3) / 12.0,
            mass_kg_m: density_kg_m3 * width_m * depth_m,
            ends,
        }
    }

    /// Frequency in Hz of the `index`th mode, counted from 1.
    #[must_use]
    pub fn hz(&self, index: u16) -> f64 {
        self.hz_at(self.ends.root(index))
    }

    fn hz_at(&self, root: f64) -> f64 {
        (root / self.length_m).powi(2) * (self.bending_n_m2 / self.mass_kg_m).sqrt() / TAU
    }

    /// The modes up to `highest_hz`, rising.
    #[must_use]
    pub fn modes(&self, highest_hz: f64) -> Vec<BarMode> {
        (1..u16::MAX)
            .map(|index| BarMode {
                bar: *self,
                index,
                root: self.ends.root(index),
            })
            .take_while(|mode| mode.hz() <= highest_hz)
            .collect()
    }

    /// Mass, in kg.
    #[must_use]
    pub fn mass_kg(&self) -> f64 {
        self.mass_kg_m * self.length_m
    }
}

impl BarMode {
    /// Force in N with which a unit displacement of the mode pushes what clamps the first end: E I φ‴
    /// there, 2σβ³ E I/√m, in size; 0 if that end is free.
    #[must_use]
    pub fn end_force_n(&self) -> f64 {
        if self.bar.ends == BarEnds::Free {
            return 0.0;
        }
        let beta_per_m = self.root / self.bar.length_m;
        let (sigma, _) = self.sigma();
        2.0 * sigma * beta_per_m.powi(3) * self.bar.bending_n_m2 / self.bar.mass_kg().sqrt()
    }

    /// σ = (cosh βL ± cos βL)/(sinh βL ± sin βL), and (1 − σ) e^(βL).
    fn sigma(&self) -> (f64, f64) {
        let sign = match self.bar.ends {
            BarEnds::Clamped | BarEnds::Free => -1.0,
            BarEnds::Cantilever => 1.0,
        };
        let (sin, cos) = self.root.sin_cos();
        let fall = (-self.root).exp();
        // e^(−βL) (sinh βL ± sin βL).
        let below = 0.5 * (1.0 - fall * fall) + sign * sin * fall;
        let rest = (sign * (sin - cos) - fall) / below;
        (1.0 - rest * fall, rest)
    }
}

impl ClosedMode for BarMode {
    fn hz(&self) -> f64 {
        self.bar.hz_at(self.root)
    }

    /// cosh βx ∓ cos βx − σ (sinh βx ∓ sin βx), whose mean square over the bar is 1 (Blevins 1979, table
    /// 8-1), over √m; the growing exponentials are taken together, so that none overflows.
    fn displacement(&self, [x_m, _]: [f64; 2]) -> f64 {
        let (root, share) = (self.root, x_m / self.bar.length_m);
        // Signs of cos and sin in the shape.
        let held = match self.bar.ends {
            BarEnds::Clamped | BarEnds::Cantilever => -1.0,
            BarEnds::Free => 1.0,
        };
        let (sigma, rest) = self.sigma();
        let growing = 0.5 * rest * (root * (share - 1.0)).exp();
        let dying = 0.5 * (1.0 + sigma) * (-root * share).exp();
        let (sin_x, cos_x) = (root * share).sin_cos();
        let wave = held * (cos_x - sigma * sin_x);
        (growing + dying + wave) / self.bar.mass_kg().sqrt()
    }

    fn label(&self) -> ModeLabel {
        ModeLabel {
            family: Family::Bending,
            order: 0,
            index: self.index,
            member: Member::Single,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::analytic::quadrature::gauss;

    fn bar(ends: BarEnds) -> RigidBar {
        RigidBar::from_rectangle([0.4, 0.005, 0.03], 2700.0, 7e10, ends)
    }

    const ALL: [BarEnds; 3] = [BarEnds::Clamped, BarEnds::Free, BarEnds::Cantilever];

    /// Blevins 1979, table 8-1, to its digits.
    #[test]
    fn roots_are_the_published_ones() {
        let both = [4.730_040_74, 7.853_204_62, 10.995_607_8, 14.137_165_5];
        let one = [1.875_104_07, 4.694_091_13, 7.854_757_44, 10.995_540_7];
        for i in 0..4 {
            let index = i as u16 + 1;
            assert!((BarEnds::Clamped.root(index) / both[i] - 1.0).abs() < 5e-9);
            assert!((BarEnds::Free.root(index) / both[i] - 1.0).abs() < 5e-9);
            assert!((BarEnds::Cantilever.root(index) / one[i] - 1.0).abs() < 5e-9);
        }
    }

    #[test]
    fn roots_solve_their_equations_to_rounding() {
        for ends in ALL {
            let sign = if ends == BarEnds::Cantilever {
                1.0
            } else {
                -1.0
            };
            for index in 1..=50 {
                let root = ends.root(index);
                let change = |x: f64| x.cos() + sign / x.cosh();
                let (below, above) = (change(root - 1e-12 * root), change(root + 1e-12 * root));
                assert!(below * above < 0.0, "{ends:?} {index}");
            }
        }
    }

    #[test]
    fn modes_are_orthonormal_up_to_the_hundredth() {
        let rule = gauss(240);
        for ends in ALL {
            let bar = bar(ends);
            let modes = bar.modes(bar.hz(100));
            assert_eq!(modes.len(), 100);
            let chosen = [0, 1, 2, 3, 10, 49, 98, 99].map(|i| modes[i]);
            for (i, p) in chosen.iter().enumerate() {
                for (j, q) in chosen.iter().enumerate() {
                    let sum: f64 = rule
                        .iter()
                        .map(|(x, weight)| {
                            let at = [x * bar.length_m, 0.0];
                            weight * p.displacement(at) * q.displacement(at)
                        })
                        .sum();
                    let identity = if i == j { 1.0 } else { 0.0 };
                    assert!((bar.mass_kg() * sum - identity).abs() < 1e-11, "{ends:?}");
                }
            }
        }
    }

    #[test]
    fn held_ends_rest_and_free_ones_move_twice() {
        for ends in ALL {
            let bar = bar(ends);
            let full = 2.0 / bar.mass_kg().sqrt();
            let end = |held: bool| if held { 0.0 } else { full };
            let held = match ends {
                BarEnds::Clamped => [true, true],
                BarEnds::Free => [false, false],
                BarEnds::Cantilever => [true, false],
            };
            for mode in bar.modes(bar.hz(30)) {
                for (x_m, held) in [0.0, bar.length_m].into_iter().zip(held) {
                    let found = mode.displacement([x_m, 0.0]).abs();
                    assert!((found - end(held)).abs() < 1e-12 * full, "{ends:?}");
                }
            }
        }
    }

    /// What the clamps push balances the inertia of an even mode: 2F = ω² m/L ∫φ dx.
    #[test]
    fn end_forces_balance_inertia() {
        for (ends, clamps) in [(BarEnds::Clamped, 2.0), (BarEnds::Cantilever, 1.0)] {
            let bar = bar(ends);
            let mode = bar.modes(bar.hz(5))[2];
            let mean: f64 = gauss(60)
                .iter()
                .map(|(x, weight)| weight * mode.displacement([x * bar.length_m, 0.0]))
                .sum();
            let inertia = (TAU * mode.hz()).powi(2) * bar.mass_kg() * mean.abs();
            assert!(
                (clamps * mode.end_force_n() / inertia - 1.0).abs() < 1e-10,
                "{ends:?}"
            );
        }
    }
}
