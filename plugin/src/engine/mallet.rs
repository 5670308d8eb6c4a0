//! What strikes: its mass, its head and what it gives back.

use super::hertz::Hertz;
use super::range;
use super::settings::within;
use modes::Material;

/// E/(1 − ν²) in Pa of a body's material; that of a body that does not give way if it is none.
pub(crate) fn contact_modulus_pa(material: &Material) -> f64 {
    let modulus_pa = material.young_pa() / (1.0 - material.poisson().powi(2));
    if modulus_pa > 0.0 {
        modulus_pa
    } else {
        f64::INFINITY
    }
}

/// A mallet with a round head.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Mallet {
    /// Mass, in kg.
    pub mass_kg: f64,
    /// Radius of the head where it touches, in m.
    pub head_radius_m: f64,
    /// Modulus E/(1 − ν²) of the head, in Pa.
    pub hardness_pa: f64,
    /// Loss of the head, in s/m: it gives back about 1 − 2/3 of this times the impact speed.
    pub loss_s_m: f64,
    /// Greatest share of the force that the grain of head and surface adds or takes, 0…1.
    pub roughness: f64,
    /// Force of a hand that presses on after the blow, in N; 0 for one that lets it bounce.
    pub press_n: f64,
}

impl Mallet {
    /// A hammer of 30 g with a head of 15 mm radius, like hard rawhide.
    pub const DEFAULT: Self = Self {
        mass_kg: 0.030,
        head_radius_m: 0.015,
        hardness_pa: 2e9,
        loss_s_m: 0.05,
        roughness: 0.0,
        press_n: 0.0,
    };

    /// The same with every value in its range, and what is not a number as by default.
    pub(super) fn sane(self) -> Self {
        let normal = Self::DEFAULT;
        Self {
            mass_kg: within(self.mass_kg, range::MALLET_KG, normal.mass_kg),
            head_radius_m: within(
                self.head_radius_m,
                range::HEAD_RADIUS_M,
                normal.head_radius_m,
            ),
            hardness_pa: within(self.hardness_pa, range::HARDNESS_PA, normal.hardness_pa),
            loss_s_m: within(self.loss_s_m, range::HEAD_LOSS_S_M, normal.loss_s_m),
            roughness: within(self.roughness, range::ROUGHNESS, normal.roughness),
            press_n: within(self.press_n, range::PRESS_N, normal.press_n),
        }
    }

    /// E* in Pa with a body of E/(1 − ν²) = `body_pa`: what is softer gives way (Johnson, Contact
    /// Mechanics, 1985, Eq. 4.18).
    fn together_pa(&self, body_pa: f64) -> f64 {
        1.0 / (1.0 / self.hardness_pa + 1.0 / body_pa)
    }

    /// The force law of head and surface: K = 4/3 E* √R (Johnson 1985, Eq. 4.23).
    pub(crate) fn hertz(&self, body_pa: f64) -> Hertz {
        Hertz {
            stiffness: 4.0 / 3.0 * self.together_pa(body_pa) * self.head_radius_m.sqrt(),
            loss_s_m: self.loss_s_m,
        }
    }

    /// Contact time in s with a free body of `body_kg` met at `speed_m_s`, without losses or bending
    /// (Johnson 1985, §11.4): τ = 2.87 (m²/(R E*² v))^(1/5).
    pub(crate) fn contact_s(&self, body_pa: f64, body_kg: f64, speed_m_s: f64) -> f64 {
        let mass = self.mass_kg * body_kg / (self.mass_kg + body_kg);
        let stiffness = self.head_radius_m * self.together_pa(body_pa).powi(2) * speed_m_s;
        2.87 * (mass * mass / stiffness).powf(0.2)
    }
}

#[cfg(test)]
mod tests {
    use super::Mallet;

    #[test]
    fn the_softer_of_the_two_gives_way() {
        let together = |hardness_pa, body_pa| {
            Mallet {
                hardness_pa,
                ..Mallet::DEFAULT
            }
            .together_pa(body_pa)
        };
        assert!((together(1e6, 7e10) / 1e6 - 1.0).abs() < 1e-4);
        assert!((together(7e10, 3e8) / 3e8 - 1.0).abs() < 5e-3);
        assert!((together(2e9, 2e9) / 1e9 - 1.0).abs() < 1e-12);
        assert!((together(2e9, f64::INFINITY) / 2e9 - 1.0).abs() < 1e-12);
    }
}
