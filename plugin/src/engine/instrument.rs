//! A body for each key, and their mix.

use super::body::{Body, Span};
use super::contact::{Contact, Prepare, slot_for_next};
use super::damper::{Damper, bit};
use super::glides::Glides;
use super::level::full_scales;
use super::losses::Drain;
use super::mallet::{Mallet, contact_modulus_pa};
use super::motor::Motor;
use super::oscillators::{Buses, Kernel};
use super::touch::{Touch, chance};
use super::{GRID, Settings};
use modes::{Bank, Damping, Stencil};

/// No sample is ever beyond this, whatever is played: 36 dB over full scale. Below it the output is
/// the sum of the modes, bit for bit.
pub const OUTPUT_BOUND: f32 = 64.0;

/// Mallets that can be on bodies at the same time.
const CONTACTS: usize = 128;

/// Sample rates there are coefficients for, in Hz.
const RATES_HZ: (f64, f64) = (1e3, 768e3);

/// An instrument that rings: strikes in, sound out.
///
/// Nothing but [`Engine::new`] allocates, and the output does not depend on how calls of
/// [`Engine::process`] cut the time.
pub struct Engine {
    bodies: Vec<Option<Body>>,
    /// What the material of the bodies takes by itself.
    own: Damping,
    /// E/(1 − ν²) of that material, in Pa.
    modulus_pa: f64,
    contacts: Vec<Contact>,
    on_bodies: usize,
    awake: u128,
    damper: Damper,
    settings: Settings,
    glides: Glides,
    motor: Motor,
    /// Gains of the stereo buses and of the plain one, at the last grid point and at the next.
    mix: [[f64; 2]; 2],
    kernel: Kernel,
    step_s: f64,
    position: u64,
}

/// The keys whose bits are set, from the lowest.
fn keys(mut bits: u128) -> impl Iterator<Item = u8> {
    std::iter::from_fn(move || {
        let key = u8::try_from(bits.trailing_zeros())
            .ok()
            .filter(|k| *k < 128)?;
        bits &= bits - 1;
        Some(key)
    })
}

/// A sample as the host gets it: bounded, and never a denormal.
fn finish(sample: f64) -> f32 {
    let bound = f64::from(OUTPUT_BOUND);
    // `max` and `min` rather than `clamp`, because they turn NaN into a bound.
    let sample = sample.max(-bound).min(bound);
    if sample.abs() < 1e-30 {
        return 0.0;
    }
    sample as f32
}

impl Engine {
    /// An instrument from a bank, at rest, with default settings.
    ///
    /// A rate outside 1 kHz…768 kHz is taken as the nearer of the two. Bodies without a strike line
    /// of at least [`Stencil::POINTS`] points, or for no MIDI key, are left out.
    #[must_use]
    pub fn new(bank: &Bank, sample_rate_hz: f64) -> Self {
        let step_s = 1.0 / sample_rate_hz.max(RATES_HZ.0).min(RATES_HZ.1);
        let mut bodies: Vec<Option<Body>> = vec![None; 128];
        let usable: Vec<&modes::Body> = bank
            .bodies
            .iter()
            .filter(|body| {
                body.key < 128
                    && body.line.len() >= Stencil::POINTS
                    && body.line.normals.len() == body.line.len()
                    && body.mass_kg > 0.0
            })
            .collect();
        for (body, scale) in usable.iter().zip(full_scales(bank, &usable)) {
            bodies[usize::from(body.key)] = Some(Body::new(body, step_s, scale));
        }
        let most = bodies.iter().flatten().map(Body::modes).max().unwrap_or(0);
        let settings = Settings::default();
        let glides = Glides::new(&settings, step_s);
        Self {
            bodies,
            own: bank.damping,
            modulus_pa: contact_modulus_pa(&bank.material),
            contacts: vec![Contact::new(most); CONTACTS],
            on_bodies: 0,
            awake: 0,
            damper: Damper::default(),
            mix: [glides.mix(); 2],
            motor: Motor::new(),
            glides,
            settings,
            kernel: Kernel::detect(),
            step_s,
            position: 0,
        }
    }

    /// Back to silence and to the start of the song; settings stay.
    pub fn reset(&mut self) {
        for body in self.bodies.iter_mut().flatten() {
            body.hush();
        }
        for contact in &mut self.contacts {
            contact.key = None;
        }
        self.on_bodies = 0;
        self.awake = 0;
        self.damper = Damper::default();
        self.position = 0;
        self.motor = Motor::new();
        self.arrive();
    }

    /// New targets. What acts on strikes counts from the next one, the rest moves there in 15 ms.
    pub fn set(&mut self, settings: &Settings) {
        let settings = settings.sane();
        if settings != self.settings {
            self.settings = settings;
            self.glides.aim(&self.settings);
        }
    }

    /// Strikes a key's body with a velocity of 0…1, now. Whether there is such a body.
    pub fn strike(&mut self, key: u8, velocity: f32) -> bool {
        if self.body(key).is_none() {
            return false;
        }
        if self.awake == 0 {
            self.arrive();
        }
        self.damper.press(key);
        let touch = Touch::new(&self.settings, velocity, chance(key, self.position));
        let mallet = Mallet::new(self.settings.hardness_pa, self.modulus_pa);
        let slot = self.vacate_slot();
        let Some(body) = self.bodies[usize::from(key)].as_mut() else {
            return false;
        };
        if self.awake & bit(key) == 0 {
            self.awake |= bit(key);
            body.tune(
                self.kernel,
                self.glides.drain(&self.own, self.motor.taken()),
            );
        }
        let contact = &mut self.contacts[slot];
        contact.begin(key, mallet.pulse(body.mass_kg, touch.speed_m_s));
        body.strike(touch.position, contact);
        self.on_bodies += 1;
        true
    }

    /// A key comes up; its body rings on unless the settings say that it is damped.
    pub fn release(&mut self, key: u8) {
        self.damper.release(key);
    }

    /// The sustain pedal holds released bodies undamped.
    pub fn pedal(&mut self, down: bool) {
        self.damper.pedal(down);
    }

    /// Silences a key's body within 0.2 s, without a click.
    pub fn choke(&mut self, key: u8) {
        self.damper.choke(bit(key));
    }

    /// Silences everything within 0.2 s, without a click.
    pub fn choke_all(&mut self) {
        self.damper.choke(u128::MAX);
    }

    /// The keys whose bodies sound, bit 0 for key 0.
    #[must_use]
    pub fn awake(&self) -> u128 {
        self.awake
    }

    /// Renders as many samples as the shorter of the two slices holds.
    pub fn process(&mut self, left: &mut [f32], right: &mut [f32]) {
        let frames = left.len().min(right.len());
        let mut done = 0;
        while done < frames {
            let phase = (self.position % GRID as u64) as usize;
            if phase == 0 {
                self.look();
            }
            let run = (GRID - phase).min(frames - done);
            self.render(
                phase,
                &mut left[done..done + run],
                &mut right[done..done + run],
            );
            self.position += run as u64;
            done += run;
        }
    }

    fn body(&self, key: u8) -> Option<&Body> {
        self.bodies.get(usize::from(key))?.as_ref()
    }

    /// Parameters that nobody hears move are there at once.
    fn arrive(&mut self) {
        for glide in self.glides.each() {
            glide.snap();
        }
        self.mix = [self.glides.mix(); 2];
    }

    /// A slot for a contact; if there is none, a mallet gives the rest of its impulse at once.
    fn vacate_slot(&mut self) -> usize {
        let slot = slot_for_next(&self.contacts);
        let contact = &mut self.contacts[slot];
        if let Some(key) = contact.key.take()
            && let Some(body) = self.bodies[usize::from(key)].as_mut()
        {
            body.kick(&contact.gain, contact.left_n_s());
            body.left();
            self.on_bodies -= 1;
        }
        slot
    }

    /// What is looked at on the grid only.
    fn look(&mut self) {
        if self.awake == 0 {
            self.arrive();
            self.motor.advance(&self.glides.discs(), self.step_s);
            return;
        }
        for glide in self.glides.each() {
            glide.advance();
        }
        self.motor.advance(&self.glides.discs(), self.step_s);
        self.mix = [self.mix[1], self.glides.mix()];
        self.lift_mallets();
        let drain = self.glides.drain(&self.own, self.motor.taken());
        for key in keys(self.awake) {
            let slot = usize::from(key);
            let Some(body) = self.bodies[slot].as_mut() else {
                continue;
            };
            let dampers = self
                .damper
                .on(key, self.settings.note_off_damps, body.has_felt);
            body.tune(
                self.kernel,
                Drain {
                    felt: dampers.felt,
                    hand_per_s: dampers.hand_per_s,
                    ..drain
                },
            );
            if !body.settle() {
                body.hush();
                self.awake &= !bit(key);
            }
        }
    }

    /// Frees the contacts that are over.
    fn lift_mallets(&mut self) {
        if self.on_bodies == 0 {
            return;
        }
        for contact in &mut self.contacts {
            if !contact.is_over(self.step_s) {
                continue;
            }
            if let Some(key) = contact.key.take()
                && let Some(body) = self.bodies[usize::from(key)].as_mut()
            {
                body.left();
                self.on_bodies -= 1;
            }
        }
    }

    /// Renders a run within one cell of the grid, `phase` samples from its start.
    fn render(&mut self, phase: usize, left: &mut [f32], right: &mut [f32]) {
        if self.awake == 0 {
            left.fill(0.0);
            right.fill(0.0);
            return;
        }
        let run = left.len();
        if self.on_bodies > 0 {
            self.kernel.run(Prepare {
                contacts: &mut self.contacts,
                samples: run,
                step_s: self.step_s,
            });
        }
        let (mut all, mut one): (Buses, Buses) = ([[0.0; GRID]; 3], [[0.0; GRID]; 3]);
        for key in keys(self.awake) {
            let Some(body) = self.bodies[usize::from(key)].as_mut() else {
                continue;
            };
            let open = self.motor.open(phase);
            let span = Span {
                samples: run,
                step_s: self.step_s,
                open,
            };
            body.ring(self.kernel, &mut self.contacts, key, span, &mut one);
            for (all, one) in all.iter_mut().zip(&one) {
                for (sum, sample) in all[..run].iter_mut().zip(one) {
                    *sum += sample;
                }
            }
        }
        let [from, to] = self.mix;
        for n in 0..run {
            let share = (phase + n) as f64 / GRID as f64;
            let [wide, plain] = [0, 1].map(|k| from[k] + (to[k] - from[k]) * share);
            left[n] = finish(wide * all[0][n] + plain * all[2][n]);
            right[n] = finish(wide * all[1][n] + plain * all[2][n]);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn keys_come_from_low_to_high() {
        assert_eq!(keys(0).count(), 0);
        assert_eq!(
            keys(bit(3) | bit(127) | bit(0)).collect::<Vec<_>>(),
            [0, 3, 127]
        );
    }

    #[test]
    fn samples_are_bounded_and_never_denormal() {
        assert_eq!(finish(1e9), OUTPUT_BOUND);
        assert_eq!(finish(f64::NEG_INFINITY), -OUTPUT_BOUND);
        assert!(finish(f64::NAN).is_finite());
        assert_eq!(finish(1e-39), 0.0);
        assert_eq!(finish(0.25), 0.25);
    }
}
