//! What strikes: its mass, its head and how long it stays on the body.

use super::pulse::Pulse;
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
#[derive(Clone, Copy, Debug)]
pub(crate) struct Mallet {
    /// Mass, in kg.
    pub(crate) mass_kg: f64,
    /// Radius of the head where it touches, in m.
    pub(crate) head_radius_m: f64,
    /// Effective contact modulus E* of head and body, in Pa.
    pub(crate) modulus_pa: f64,
}

/// Shortest and longest contact, in s: outside, the elastic model says nothing.
const CONTACT_S: (f64, f64) = (20e-6, 50e-3);

impl Mallet {
    /// A 30 g hammer with a head of 15 mm radius and modulus `head_pa` on a body of modulus `body_pa`,
    /// both E/(1 − ν²): what is softer gives way (Johnson 1985, Eq. 4.18).
    pub(crate) fn new(head_pa: f64, body_pa: f64) -> Self {
        Self {
            mass_kg: 0.030,
            head_radius_m: 0.015,
            modulus_pa: 1.0 / (1.0 / head_pa + 1.0 / body_pa),
        }
    }

    /// The force on a free body of `body_mass_kg` struck at `speed_m_s` (Johnson, Contact
    /// Mechanics, 1985, §11.4: elastic, one way, τ = 2.87 (m²/(R E*² v))^(1/5)).
    pub(crate) fn pulse(&self, body_mass_kg: f64, speed_m_s: f64) -> Pulse {
        let mass = self.mass_kg * body_mass_kg / (self.mass_kg + body_mass_kg);
        let stiffness = self.head_radius_m * self.modulus_pa * self.modulus_pa * speed_m_s;
        let duration_s = 2.87 * (mass * mass / stiffness).powf(0.2);
        Pulse {
            impulse_n_s: 2.0 * mass * speed_m_s,
            duration_s: duration_s.max(CONTACT_S.0).min(CONTACT_S.1),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::Mallet;

    /// Integrates m δ̈ = −(4/3) E* √R δ^(3/2) from the first touch to the last.
    fn collide(mallet: &Mallet, mass: f64, speed: f64) -> f64 {
        let stiffness = 4.0 / 3.0 * mallet.modulus_pa * mallet.head_radius_m.sqrt();
        let (mut depth, mut velocity, mut time) = (0.0_f64, speed, 0.0);
        let step = 1e-8;
        while depth >= 0.0 {
            velocity -= 0.5 * step * stiffness * depth.powf(1.5) / mass;
            depth += step * velocity;
            velocity -= 0.5 * step * stiffness * depth.max(0.0).powf(1.5) / mass;
            time += step;
        }
        assert!((velocity / speed + 1.0).abs() < 1e-3, "rebounds as fast");
        time
    }

    #[test]
    fn contact_lasts_as_long_as_hertz_force_takes() {
        let mallet = Mallet::new(1e9, 7e10);
        for speed in [0.05, 1.0, 5.0] {
            let pulse = mallet.pulse(1e9, speed);
            let time = collide(&mallet, mallet.mass_kg, speed);
            assert!((pulse.duration_s / time - 1.0).abs() < 2e-3, "at {speed}");
            assert!((pulse.impulse_n_s / (2.0 * mallet.mass_kg * speed) - 1.0).abs() < 1e-9);
        }
    }

    #[test]
    fn the_softer_of_the_two_gives_way() {
        assert!((Mallet::new(1e6, 7e10).modulus_pa / 1e6 - 1.0).abs() < 1e-4);
        assert!((Mallet::new(7e10, 3e8).modulus_pa / 3e8 - 1.0).abs() < 5e-3);
        assert!((Mallet::new(2e9, 2e9).modulus_pa / 1e9 - 1.0).abs() < 1e-12);
    }

    #[test]
    fn contact_time_falls_with_speed_to_the_fifth_root() {
        let mallet = Mallet::new(1e8, 7e10);
        let ratio = mallet.pulse(0.5, 0.1).duration_s / mallet.pulse(0.5, 3.2).duration_s;
        assert!((ratio - 2.0).abs() < 1e-9);
    }
}
