//! What a strike gives each mode (van den Doel & Pai 1998, §2.2).

use super::ClosedMode;
use std::f64::consts::TAU;

/// A mode after a strike.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Struck {
    /// Natural frequency, in Hz.
    pub hz: f64,
    /// Amplitude of a mode of unit mass after an impulse of 1 N·s, in m kg^(1/2): signed.
    pub amplitude: f64,
}

/// Eq. 10, aₙ = Ψₙ(p)/αₙωₙ, for a strike at `at_m`: with mass-normalised shapes αₙ is 1.
#[must_use]
pub fn impact<M: ClosedMode>(modes: &[M], at_m: [f64; 2]) -> Vec<Struck> {
    modes
        .iter()
        .map(|mode| Struck {
            hz: mode.hz(),
            amplitude: mode.displacement(at_m) / (TAU * mode.hz()),
        })
        .collect()
}

/// The square membrane of 1998, Figs. 4 to 7: the sides are 1, the lowest mode is that of 500 Hz, and
/// 400 modes are taken.
pub mod square_1998 {
    use super::{Struck, impact};
    use crate::analytic::RectangularMembrane;

    /// Where it is struck in Figs. 5, 6 and 7.
    pub const STRIKES_M: [[f64; 2]; 3] = [[0.1, 0.1], [0.1, 0.4], [0.5, 0.4]];

    /// Frequency of the lowest mode, in Hz.
    pub const LOWEST_HZ: f64 = 500.0;

    /// Modes that are taken.
    pub const MODES: usize = 400;

    /// Above the 400th mode, in frequencies of the lowest: a quarter circle of that radius has more.
    const ENOUGH: f64 = 20.0;

    /// The membrane, of unit tension over mass.
    #[must_use]
    pub fn membrane() -> RectangularMembrane {
        // f₁ = √(T/2σ): the tension that it takes on 1 kg/m².
        RectangularMembrane {
            sides_m: [1.0; 2],
            tension_n_m: 2.0 * LOWEST_HZ * LOWEST_HZ,
            mass_kg_m2: 1.0,
        }
    }

    /// The amplitudes after a strike at `at_m`, by rising frequency.
    #[must_use]
    pub fn struck(at_m: [f64; 2]) -> Vec<Struck> {
        let mut modes = membrane().modes(ENOUGH * LOWEST_HZ);
        modes.truncate(MODES);
        impact(&modes, at_m)
    }
}

#[cfg(test)]
mod tests {
    use super::square_1998::{LOWEST_HZ, MODES, STRIKES_M, struck};
    use super::*;

    #[test]
    fn four_hundred_modes_from_500_hz() {
        for at_m in STRIKES_M {
            let found = struck(at_m);
            assert_eq!(found.len(), MODES);
            assert!((found[0].hz / LOWEST_HZ - 1.0).abs() < 1e-12);
        }
    }

    /// Ψ is sin(mπx) sin(nπy); the second and third modes are (1, 2) and (2, 1), √(5/2) higher.
    #[test]
    fn amplitudes_are_shapes_over_frequency() {
        use std::f64::consts::PI;
        for [x, y] in STRIKES_M {
            let found = struck([x, y]);
            let of = |m: f64, n: f64| (m * PI * x).sin() * (n * PI * y).sin();
            let pair = found[1].amplitude + found[2].amplitude;
            let expected = (of(1.0, 2.0) + of(2.0, 1.0)) / (of(1.0, 1.0) * 2.5f64.sqrt());
            assert!((pair / found[0].amplitude - expected).abs() < 1e-12);
        }
    }

    /// "The membrane sounds dull when struck near the center, and bright … near the rim" (§2.2).
    #[test]
    fn near_the_rim_it_is_brighter() {
        let centroid_hz = |at_m| {
            let found = struck(at_m);
            let of = |weight: fn(&Struck) -> f64| found.iter().map(weight).sum::<f64>();
            of(|s| s.hz * s.amplitude.powi(2)) / of(|s| s.amplitude.powi(2))
        };
        let [corner, side, middle] = STRIKES_M.map(centroid_hz);
        assert!(
            corner > 1.05 * side && side > 1.05 * middle,
            "{corner} {side} {middle}"
        );
    }
}
