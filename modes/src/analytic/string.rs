//! The taut string with stiffness (van den Doel & Pai 1998, §6.1).

use super::ClosedMode;
use crate::{Family, Member, ModeLabel};
use std::f64::consts::PI;

/// A uniform string between two supports that hold its ends but let them turn.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TautString {
    /// Length that swings, in m.
    pub length_m: f64,
    /// Tension, in N.
    pub tension_n: f64,
    /// Bending stiffness E I, in N m²; 0 for a perfectly flexible string.
    pub bending_n_m2: f64,
    /// Mass per length, in kg/m.
    pub mass_kg_m: f64,
}

/// A mode of a string.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct StringMode {
    string: TautString,
    /// Half-waves along the string.
    half_waves: u16,
}

impl TautString {
    /// A round wire of `radius_m`, density and Young's modulus, `length_m` long and under `tension_n`.
    #[must_use]
    pub fn from_wire(
        [length_m, radius_m]: [f64; 2],
        density_kg_m3: f64,
        young_pa: f64,
        tension_n: f64,
    ) -> Self {
        let section_m2 = PI * radius_m * radius_m;
        Self {
            length_m,
            tension_n,
            bending_n_m2: 0.25 * young_pa * section_m2 * radius_m * radius_m,
            mass_kg_m: density_kg_m3 * section_m2,
        }
    }

    /// Inharmonicity B = π² E I / T L² (Fletcher 1964, Journal of the Acoustical Society of America 36,
    /// p. 203).
    #[must_use]
    pub fn inharmonicity(&self) -> f64 {
        PI * PI * self.bending_n_m2 / (self.tension_n * self.length_m * self.length_m)
    }

    /// Frequency in Hz of the mode of `half_waves`: n/2L √(T/μ) √(1 + B n²), exact for ends that may
    /// turn.
    #[must_use]
    pub fn hz(&self, half_waves: u16) -> f64 {
        let n = f64::from(half_waves);
        let flexible_hz = n / (2.0 * self.length_m) * (self.tension_n / self.mass_kg_m).sqrt();
        flexible_hz * (1.0 + self.inharmonicity() * n * n).sqrt()
    }

    /// The modes up to `highest_hz`, rising.
    #[must_use]
    pub fn modes(&self, highest_hz: f64) -> Vec<StringMode> {
        (1..u16::MAX)
            .take_while(|&half_waves| self.hz(half_waves) <= highest_hz)
            .map(|half_waves| StringMode {
                string: *self,
                half_waves,
            })
            .collect()
    }

    /// Mass, in kg.
    #[must_use]
    pub fn mass_kg(&self) -> f64 {
        self.mass_kg_m * self.length_m
    }
}

impl StringMode {
    /// Transverse force in N with which a unit displacement of the mode pulls at the far end:
    /// −T φ′ + E I φ‴ there, in size.
    #[must_use]
    pub fn end_force_n(&self) -> f64 {
        let string = &self.string;
        let wave_per_m = PI * f64::from(self.half_waves) / string.length_m;
        let slope = wave_per_m * (2.0 / string.mass_kg()).sqrt();
        slope * (string.tension_n + string.bending_n_m2 * wave_per_m * wave_per_m)
    }
}

impl ClosedMode for StringMode {
    fn hz(&self) -> f64 {
        self.string.hz(self.half_waves)
    }

    fn displacement(&self, [x_m, _]: [f64; 2]) -> f64 {
        let phase = PI * f64::from(self.half_waves) * x_m / self.string.length_m;
        (2.0 / self.string.mass_kg()).sqrt() * phase.sin()
    }

    fn label(&self) -> ModeLabel {
        ModeLabel {
            family: Family::Bending,
            order: 0,
            index: self.half_waves,
            member: Member::Single,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::analytic::quadrature::gauss;

    /// A piano's C4: 0.66 m of 1 mm steel wire.
    fn string() -> TautString {
        TautString::from_wire([0.66, 0.0005], 7850.0, 2e11, 736.0)
    }

    #[test]
    fn a_flexible_string_is_harmonic() {
        let string = TautString {
            bending_n_m2: 0.0,
            ..string()
        };
        let first_hz = (736.0 / string.mass_kg_m).sqrt() / 1.32;
        for n in 1..40 {
            assert!((string.hz(n) / (f64::from(n) * first_hz) - 1.0).abs() < 1e-14);
        }
        assert_eq!(string.modes(10.5 * first_hz).len(), 10);
    }

    /// Without tension a string is a bar whose ends may turn, f = n² π/2L² √(EI/μ) (Blevins 1979,
    /// table 8-1); with both, the squares add.
    #[test]
    fn a_slack_string_is_a_bar() {
        let string = string();
        for n in 1..30 {
            let n2 = f64::from(n) * f64::from(n);
            let bar_hz = n2 * PI / (2.0 * string.length_m.powi(2))
                * (string.bending_n_m2 / string.mass_kg_m).sqrt();
            let flexible = TautString {
                bending_n_m2: 0.0,
                ..string
            };
            let both = bar_hz.hypot(flexible.hz(n));
            assert!((string.hz(n) / both - 1.0).abs() < 1e-13);
        }
    }

    #[test]
    fn modes_are_orthonormal() {
        let string = string();
        let modes = string.modes(3500.0);
        assert!(modes.len() > 10);
        for (i, p) in modes.iter().enumerate() {
            for (j, q) in modes.iter().enumerate() {
                let sum: f64 = gauss(40)
                    .iter()
                    .map(|(x, weight)| {
                        let at = [x * string.length_m, 0.0];
                        weight * p.displacement(at) * q.displacement(at)
                    })
                    .sum();
                let identity = if i == j { 1.0 } else { 0.0 };
                assert!((string.mass_kg() * sum - identity).abs() < 1e-12);
            }
        }
    }

    /// What pulls at both ends balances the inertia of an odd mode: 2F = ω² μ ∫φ dx.
    #[test]
    fn end_forces_balance_inertia() {
        let string = string();
        let mode = string.modes(3500.0)[2];
        let omega = std::f64::consts::TAU * mode.hz();
        let moved = 2.0 / (3.0 * PI) * (2.0 / string.mass_kg()).sqrt() * string.mass_kg();
        assert!((2.0 * mode.end_force_n() / (omega * omega * moved) - 1.0).abs() < 1e-12);
    }
}
