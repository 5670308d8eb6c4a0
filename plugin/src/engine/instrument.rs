//! A body for each key, and their mix.

use super::body::{Body, Moved, Strike, Tuned};
use super::cell::Cell;
use super::damper::{Damper, bit};
use super::glides::Glides;
use super::level::full_scales;
use super::losses::Drain;
use super::mallet::contact_modulus_pa;
use super::motor::Motor;
use super::oscillators::{Kernel, Pack, Vectors};
use super::source::Hearing;
use super::touch::{Touch, chance, grain};
use super::{GRID, Settings};
use modes::{Bank, Damping, Stencil};

/// No sample is ever beyond this, whatever is played: 36 dB over full scale. Below it the output is
/// the sum of the modes, bit for bit.
pub const OUTPUT_BOUND: f32 = 64.0;

/// Cells of the grid between two looks at whether a body still sounds.
const LOOKS: u64 = 8;

/// Sample rates there are coefficients for, in Hz.
const RATES_HZ: (f64, f64) = (1e3, 768e3);

/// An instrument that rings: strikes in, sound out.
///
/// Nothing but [`Engine::new`] allocates, and the output does not depend on how calls of
/// [`Engine::process`] cut the time.
pub struct Engine {
    bodies: Vec<Option<Body>>,
    /// The modes of all bodies.
    packs: Vec<Pack>,
    /// What the material of the bodies takes by itself.
    own: Damping,
    /// E/(1 − ν²) of that material, in Pa.
    modulus_pa: f64,
    awake: u128,
    /// Bodies that something pushes.
    driven: u128,
    damper: Damper,
    settings: Settings,
    glides: Glides,
    motor: Motor,
    /// What rings freely in this cell of the grid.
    cell: Cell,
    /// Output gain at the start of the cell and at its end.
    gain: [f64; 2],
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
        Self::with_vectors(bank, sample_rate_hz, Vectors::Widest)
    }

    /// The same, computed with no wider vectors than `vectors`.
    #[must_use]
    pub fn with_vectors(bank: &Bank, sample_rate_hz: f64, vectors: Vectors) -> Self {
        let step_s = 1.0 / sample_rate_hz.max(RATES_HZ.0).min(RATES_HZ.1);
        let kernel = Kernel::new(vectors);
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
        let mut packs = 0;
        for (body, scale) in usable.iter().zip(full_scales(bank, &usable)) {
            let made = Body::new(body, scale, packs);
            packs = made.place.end;
            bodies[usize::from(body.key)] = Some(made);
        }
        let settings = Settings::default();
        let glides = Glides::new(&settings, step_s);
        Self {
            bodies,
            packs: vec![Pack::STILL; packs],
            own: bank.damping,
            modulus_pa: contact_modulus_pa(&bank.material),
            awake: 0,
            driven: 0,
            damper: Damper::default(),
            gain: [glides.gain(); 2],
            motor: Motor::new(),
            cell: Cell::new(packs),
            glides,
            settings,
            kernel,
            step_s,
            position: 0,
        }
    }

    /// Back to silence and to the start of the song; settings stay.
    pub fn reset(&mut self) {
        for body in self.bodies.iter_mut().flatten() {
            body.hush(&mut self.packs);
        }
        self.awake = 0;
        self.driven = 0;
        self.damper = Damper::default();
        self.position = 0;
        self.motor = Motor::new();
        self.cell.close();
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
        let strike = Strike {
            mallet: self.settings.mallet,
            body_pa: self.modulus_pa,
            touch: Touch::new(&self.settings, velocity, chance(key, self.position)),
            seed: grain(key, self.position),
        };
        self.wake(key);
        if let Some(body) = self.bodies[usize::from(key)].as_mut() {
            body.strike(self.kernel, &strike, self.step_s);
        }
        self.driven |= bit(key);
        true
    }

    /// Makes a body ready to be pushed from here on.
    fn wake(&mut self, key: u8) {
        let (tuned, hearing) = (self.tuned(key), self.hearing());
        let Some(body) = self.bodies[usize::from(key)].as_mut() else {
            return;
        };
        if self.awake & bit(key) == 0 {
            self.awake |= bit(key);
            body.fading = false;
            body.tune(self.kernel, &mut self.packs, tuned, &hearing, self.step_s);
        } else if self.driven & bit(key) == 0 {
            let phase = (self.position % GRID as u64) as usize;
            self.cell
                .take_out(self.kernel, body, &mut self.packs, phase, self.step_s);
        }
    }

    /// A key comes up; its body rings on unless the settings say that it is damped.
    pub fn release(&mut self, key: u8) {
        self.damper.release(key);
        if let Some(body) = self
            .bodies
            .get_mut(usize::from(key))
            .and_then(Option::as_mut)
        {
            body.let_go();
        }
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
            if phase + run == GRID {
                self.cell.close();
            }
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
        self.gain = [self.glides.gain(); 2];
    }

    /// What the modes of a key's body are tuned to now.
    fn tuned(&self, key: u8) -> Tuned {
        let drain = self.glides.drain(&self.own, self.motor.taken());
        let has_felt = self.body(key).is_some_and(|body| body.has_felt);
        let on = self.damper.on(key, self.settings.note_off_damps, has_felt);
        Tuned {
            drain: Drain {
                felt: on.felt,
                hand_per_s: on.hand_per_s,
                ..drain
            },
            ratio: 1.0,
        }
    }

    /// How bodies are heard at the end of this cell.
    fn hearing(&self) -> Hearing {
        Hearing {
            open: self.motor.open(),
            width: self.glides.width(),
            ..Hearing::AS_BUILT
        }
    }

    /// What is looked at on the grid only; then what rings freely sounds for a cell.
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
        self.gain = [self.gain[1], self.glides.gain()];
        self.rest();
        self.cell.begin();
        let hearing = self.hearing();
        for key in keys(self.awake & !self.driven) {
            if let Some(body) = &self.bodies[usize::from(key)] {
                self.cell.leave(body, body.moved(&hearing));
            }
        }
        self.cell.ring_left(self.kernel, &mut self.packs);
        for key in keys(self.awake) {
            let tuned = self.tuned(key);
            let Some(body) = self.bodies[usize::from(key)].as_mut() else {
                continue;
            };
            let moved = body.moved(&hearing);
            body.tune(self.kernel, &mut self.packs, tuned, &hearing, self.step_s);
            body.fading = moved != Moved::NONE;
            if !body.driven {
                self.cell.enter(body, moved);
            }
        }
        self.cell.ring_entered(self.kernel, &mut self.packs);
    }

    /// Takes mallets away that have left, and lets bodies sleep that no longer sound.
    fn rest(&mut self) {
        let look = self.position / GRID as u64;
        for key in keys(self.awake) {
            let Some(body) = self.bodies[usize::from(key)].as_mut() else {
                continue;
            };
            if body.part(&self.packs) {
                self.driven &= !bit(key);
            }
            if (look + u64::from(key)).is_multiple_of(LOOKS) && !body.settle(&mut self.packs) {
                body.hush(&mut self.packs);
                self.awake &= !bit(key);
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
        let mut buses = self.cell.heard(phase, run);
        for key in keys(self.driven) {
            let Some(body) = self.bodies[usize::from(key)].as_mut() else {
                continue;
            };
            let [left, right] = &mut buses;
            let out = [&mut left[..run], &mut right[..run]];
            body.drive(self.kernel, &mut self.packs, phase, self.step_s, out);
        }
        let [from, to] = self.gain;
        for n in 0..run {
            let share = (phase + n) as f64 / GRID as f64;
            let gain = from + (to - from) * share;
            left[n] = finish(gain * buses[0][n]);
            right[n] = finish(gain * buses[1][n]);
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
