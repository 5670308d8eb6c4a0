//! The rectangular membrane (van den Doel & Pai 1998, §2.1 and §6.3).

use super::beam::rectangle;
use super::{ClosedMode, ProductMode};
use crate::{Family, Member, ModeLabel};
use std::f64::consts::PI;

/// A membrane held along the edges of a rectangle, with a corner at the origin.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RectangularMembrane {
    /// Lengths of the sides along x and y, in m.
    pub sides_m: [f64; 2],
    /// Tension, in N/m.
    pub tension_n_m: f64,
    /// Mass per area, in kg/m².
    pub mass_kg_m2: f64,
}

/// A mode of a rectangular membrane.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RectangularMode {
    membrane: RectangularMembrane,
    /// Half-waves along x and y.
    half_waves: [u16; 2],
}

impl RectangularMembrane {
    /// Frequency in Hz of the mode of so many half-waves along x and y:
    /// ½ √(T/σ) √((m/Lx)² + (n/Ly)²).
    #[must_use]
    pub fn hz(&self, half_waves: [u16; 2]) -> f64 {
        let [x, y] = [0, 1].map(|axis| f64::from(half_waves[axis]) / self.sides_m[axis]);
        0.5 * (self.tension_n_m / self.mass_kg_m2).sqrt() * x.hypot(y)
    }

    /// The modes up to `highest_hz`, rising.
    #[must_use]
    pub fn modes(&self, highest_hz: f64) -> Vec<RectangularMode> {
        let within = |half_waves: &[u16; 2]| self.hz(*half_waves) <= highest_hz;
        let columns = (1..u16::MAX).take_while(|&m| within(&[m, 1]));
        let mut modes: Vec<RectangularMode> = columns
            .flat_map(|m| (1..u16::MAX).map(move |n| [m, n]).take_while(within))
            .map(|half_waves| RectangularMode {
                membrane: *self,
                half_waves,
            })
            .collect();
        modes.sort_by(|p, q| p.hz().total_cmp(&q.hz()));
        modes
    }

    /// Mass, in kg.
    #[must_use]
    pub fn mass_kg(&self) -> f64 {
        self.mass_kg_m2 * self.sides_m[0] * self.sides_m[1]
    }
}

impl ClosedMode for RectangularMode {
    fn hz(&self) -> f64 {
        self.membrane.hz(self.half_waves)
    }

    fn displacement(&self, at_m: [f64; 2]) -> f64 {
        let [x, y] = [0, 1].map(|axis| {
            let phase = PI * f64::from(self.half_waves[axis]) * at_m[axis];
            (phase / self.membrane.sides_m[axis]).sin()
        });
        2.0 / self.membrane.mass_kg().sqrt() * x * y
    }

    fn label(&self) -> ModeLabel {
        let [order, index] = self.half_waves;
        ModeLabel {
            family: Family::Membrane,
            order,
            index,
            member: Member::Single,
        }
    }
}

impl ProductMode for RectangularMode {
    fn functions(&self) -> [[u16; 2]; 2] {
        self.half_waves.map(|count| [count, 0])
    }

    fn along(&self, share: f64) -> f64 {
        (PI * f64::from(self.half_waves[0]) * share).sin()
    }

    fn across(&self, share: f64) -> f64 {
        (PI * f64::from(self.half_waves[1]) * share).sin()
    }

    fn height(&self) -> f64 {
        2.0 / self.membrane.mass_kg().sqrt()
    }

    fn beamed(&self, wave_per_m: f64) -> f64 {
        let height = self.height();
        height * height * rectangle(wave_per_m, self.half_waves, self.membrane.sides_m)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::analytic::overlaps::worst_overlap;

    fn membrane() -> RectangularMembrane {
        RectangularMembrane {
            sides_m: [0.5, 0.3],
            tension_n_m: 2000.0,
            mass_kg_m2: 0.26,
        }
    }

    /// A square of side a: √2 c/2a, then √5 c/2a twice (Blevins 1979, table 11-1).
    #[test]
    fn the_square_s_frequencies() {
        let square = RectangularMembrane {
            sides_m: [0.4, 0.4],
            ..membrane()
        };
        let unit_hz = (2000.0f64 / 0.26).sqrt() / 0.8;
        let modes = square.modes(3.7 * unit_hz);
        let expected = [2, 5, 5, 8, 10, 10, 13, 13].map(|n| f64::from(n).sqrt() * unit_hz);
        assert_eq!(modes.len(), expected.len());
        for (mode, expected) in modes.iter().zip(expected) {
            assert!((mode.hz() / expected - 1.0).abs() < 1e-14);
        }
    }

    #[test]
    fn modes_are_orthonormal() {
        let membrane = membrane();
        let modes = membrane.modes(1000.0);
        assert!(modes.len() > 15, "{}", modes.len());
        let [x_m, y_m] = membrane.sides_m;
        let worst = worst_overlap(&modes, 40, |u, v| ([u * x_m, v * y_m], membrane.mass_kg()));
        assert!(worst < 1e-12, "{worst:e}");
    }
}
