//! The force of a blow, worked out apart from the sound.

use super::contact::{Blow, Contact};
use super::mallet::contact_modulus_pa;
use super::source::reached;
use super::touch::Touch;
use super::{Hit, Settings};
use modes::{Bank, Stencil};
use std::f64::consts::TAU;

/// Steps to the contact time of a rigid body.
const STEPS: u16 = 128;
/// Contact times that are followed: a mallet may touch more than once.
const FOLLOWED: u16 = 6;
/// Greatest ωT of a mode that takes part; faster ones have come to rest within a step.
const FASTEST: f64 = 1.0;

/// The force between mallet and body over time.
#[derive(Clone, Debug, PartialEq)]
pub struct Pulse {
    /// Time between two samples, in s.
    pub step_s: f64,
    /// The force in N from the first touch to the last.
    pub force_n: Vec<f64>,
}

impl Pulse {
    /// That of a blow of `velocity` 0…1 at `position` 0…1 on a body of that bank at rest.
    #[must_use]
    pub fn of(
        bank: &Bank,
        body: &modes::Body,
        settings: &Settings,
        velocity: f64,
        position: f64,
    ) -> Self {
        let (settings, tweak) = (settings.sane(), settings.tweak.sane());
        let touch = Touch::new(&settings, &Hit::plain(velocity).sane(), [0.0; 2]);
        let body_pa = contact_modulus_pa(&bank.matter_of(body).material) * tweak.stiffness;
        let body_kg = body.mass_kg * tweak.mass();
        let mallet = settings.mallet;
        let contact_s = mallet.contact_s(body_pa, body_kg, touch.speed_m_s);
        let step_s = contact_s / f64::from(STEPS);
        let place = [position, touch.across];
        let mut modes = swings(body, place, [tweak.pitch(), tweak.mass()], step_s);
        let mut contact = Contact::new(0);
        contact.begin(&Blow {
            mallet,
            hertz: mallet.hertz(body_pa).followed(f64::from(STEPS).recip()),
            body_kg,
            mobility: modes.iter().map(|mode| mode.reach * mode.reach).sum(),
            speed_m_s: touch.speed_m_s,
            seed: 0,
        });
        let steps = usize::from(FOLLOWED * STEPS);
        let mut force_n = Vec::with_capacity(steps);
        let mut last = 0;
        for step in 0..steps {
            let mut surface_m_s = 0.0;
            for mode in &mut modes {
                mode.turn();
                surface_m_s += mode.reach * mode.speed;
            }
            let impulse_n_s = contact.meet(surface_m_s, step_s);
            for mode in &mut modes {
                mode.speed += mode.reach * impulse_n_s;
            }
            force_n.push(impulse_n_s / step_s);
            if impulse_n_s > 0.0 {
                last = step + 1;
            }
        }
        force_n.truncate(last);
        Self { step_s, force_n }
    }

    /// ∫F dt, in N·s.
    #[must_use]
    pub fn impulse_n_s(&self) -> f64 {
        self.force_n.iter().sum::<f64>() * self.step_s
    }

    /// Greatest force, in N.
    #[must_use]
    pub fn peak_n(&self) -> f64 {
        self.force_n
            .iter()
            .fold(0.0, |most, force| most.max(*force))
    }

    /// From the first touch to the last, in s.
    #[must_use]
    pub fn length_s(&self) -> f64 {
        self.force_n.len() as f64 * self.step_s
    }

    /// How much of the force there is at a frequency, over that at 0 Hz: |∫F exp(−iωt) dt| / ∫F dt.
    #[must_use]
    pub fn share(&self, hz: f64) -> f64 {
        let turn = TAU * hz * self.step_s;
        let (mut re, mut im) = (0.0, 0.0);
        for (step, force) in self.force_n.iter().enumerate() {
            let (sin, cos) = (turn * step as f64).sin_cos();
            re += force * cos;
            im += force * sin;
        }
        let sum: f64 = self.force_n.iter().sum();
        if sum > 0.0 { re.hypot(im) / sum } else { 0.0 }
    }
}

/// A mode where the mallet meets it.
struct Swing {
    /// φ·n̂, in kg^(−1/2).
    reach: f64,
    /// Modal speed and ω times the displacement, in m·kg^(1/2)/s.
    speed: f64,
    displaced: f64,
    cos: f64,
    sin: f64,
}

impl Swing {
    fn turn(&mut self) {
        let (speed, displaced) = (self.speed, self.displaced);
        self.displaced = displaced * self.cos + speed * self.sin;
        self.speed = speed * self.cos - displaced * self.sin;
    }
}

fn swings(
    body: &modes::Body,
    place: [f64; 2],
    [pitch, heavier]: [f64; 2],
    step_s: f64,
) -> Vec<Swing> {
    if body.line.grid().columns < Stencil::POINTS {
        return Vec::new();
    }
    let swing = |mode: &super::source::Reached| {
        let turn = TAU * mode.hz * pitch * step_s;
        let normal = mode.shape.normal_motion(&body.line, place);
        (turn < FASTEST).then_some(Swing {
            reach: normal / heavier.sqrt(),
            speed: 0.0,
            displaced: 0.0,
            cos: turn.cos(),
            sin: turn.sin(),
        })
    };
    reached(body).iter().filter_map(swing).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::engine::{Mallet, contact_s};
    use crate::factory;

    fn settings() -> Settings {
        Settings {
            mallet: Mallet {
                loss_s_m: 0.0,
                ..Mallet::DEFAULT
            },
            ..Settings::default()
        }
    }

    /// A body that only moves as a whole gives the mallet back all its speed: J = 2 m v of both masses
    /// together, within Hertz's contact time (Johnson, Contact Mechanics, 1985, §11.4).
    #[test]
    fn a_rigid_body_gets_twice_the_momentum_in_hertz_s_time() {
        let bank = factory::bank(1);
        let mut body = bank.bodies[24].clone();
        body.modes.clear();
        let settings = settings();
        let pulse = Pulse::of(bank, &body, &settings, 1.0, 0.1);
        let mallet_kg = settings.mallet.mass_kg;
        let together_kg = mallet_kg * body.mass_kg / (mallet_kg + body.mass_kg);
        let speed_m_s = 5.0;
        assert!((pulse.impulse_n_s() / (2.0 * together_kg * speed_m_s) - 1.0).abs() < 1e-3);
        let told_s = contact_s(bank, &body, &settings, 1.0);
        assert!(
            (pulse.length_s() / told_s - 1.0).abs() < 0.02,
            "{}",
            pulse.length_s()
        );
        assert!((pulse.share(0.0) - 1.0).abs() < 1e-12);
        assert!(pulse.share(3.0 / told_s) < 0.1);
    }

    #[test]
    fn softer_heads_press_longer_and_less() {
        let bank = factory::bank(1);
        let body = &bank.bodies[24];
        let soft = Settings {
            mallet: Mallet {
                hardness_pa: 1e7,
                ..settings().mallet
            },
            ..settings()
        };
        let [hard, soft] = [settings(), soft].map(|s| Pulse::of(bank, body, &s, 0.8, 0.03));
        assert!(soft.length_s() > 3.0 * hard.length_s());
        assert!(soft.peak_n() < hard.peak_n());
        assert!(soft.share(2000.0) < hard.share(2000.0));
    }
}
