//! A body for each key, and their mix.

use super::body::{Body, Moved, Strike, Tuned};
use super::cell::Cell;
use super::damper::{Dampers, bit};
use super::glides::Glides;
use super::level::full_scales;
use super::limiter::Limiter;
use super::losses::Drain;
use super::mallet::{Mallet, contact_modulus_pa};
use super::motor::Motor;
use super::oscillators::{Kernel, Pack, Vectors};
use super::source::{Hearing, Way};
use super::swing::Swing;
use super::touch::{Touch, chance, grain};
use super::{GRID, Hit, Hold, Settings};
use modes::{Bank, Damping, Stencil};

/// No sample is ever beyond this, whatever is played: 36 dB over full scale, with the limiter off. Below
/// it (with the limiter, below full scale) the output is the sum of the modes, bit for bit.
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
    /// Where the bank has the listener's ears, in m.
    ears_m: [[f64; 3]; 2],
    awake: u128,
    /// Bodies that something pushes.
    driven: u128,
    /// Bodies that a hand silences.
    choked: u128,
    /// What hands do to each key's body.
    hands: [Hand; 128],
    /// Bodies on which a bow is, or is to be.
    bowed: u128,
    swings: [Swing; 128],
    settings: Settings,
    glides: Glides,
    motor: Motor,
    /// Ways to the ears at the end of this cell, and frequencies over those as built.
    ways: [Way; 2],
    pitch: f64,
    /// What rings freely in this cell of the grid.
    cell: Cell,
    /// Output gain at the start of the cell and at its end.
    gain: [f64; 2],
    limiter: Limiter,
    kernel: Kernel,
    step_s: f64,
    position: u64,
}

/// Hands on one body.
#[derive(Clone, Copy)]
struct Hand {
    hold: Hold,
    /// 2 to the power of the bend in octaves.
    bend: f64,
    /// Pressure of a bow whose key is held down.
    rubs: f64,
}

impl Hand {
    const FREE: Self = Self {
        hold: Hold::FREE,
        bend: 1.0,
        rubs: 0.0,
    };
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
            ears_m: bank.ears_m,
            awake: 0,
            driven: 0,
            choked: 0,
            hands: [Hand::FREE; 128],
            bowed: 0,
            swings: [Swing::default(); 128],
            gain: [glides.gain(); 2],
            motor: Motor::new(),
            ways: settings.listener.ways(&bank.ears_m),
            pitch: 1.0,
            cell: Cell::new(packs),
            limiter: Limiter::new(step_s),
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
        self.choked = 0;
        self.hands = [Hand::FREE; 128];
        self.bowed = 0;
        self.swings = [Swing::default(); 128];
        self.limiter.reset();
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

    /// Strikes a key's body with a velocity of 0…1, now, and lifts its damper. Whether there is such a
    /// body.
    pub fn strike(&mut self, key: u8, velocity: f32) -> bool {
        self.hit(key, &Hit::plain(f64::from(velocity)))
    }

    /// The same with all that hands and controllers do to a blow. With a bow in the settings that rubs,
    /// the body is rubbed until [`Engine::release`].
    pub fn hit(&mut self, key: u8, hit: &Hit) -> bool {
        if self.body(key).is_none() {
            return false;
        }
        if self.awake == 0 {
            self.arrive();
        }
        let hit = hit.sane();
        self.choked &= !bit(key);
        let hand = &mut self.hands[usize::from(key)];
        hand.hold.felt = 0.0;
        if self.settings.bow.rubs {
            hand.rubs = hit.velocity;
            self.bowed |= bit(key);
            return true;
        }
        let tweak = self.glides.tweak();
        let set = self.settings.mallet;
        let mallet = Mallet {
            hardness_pa: set.hardness_pa * 10f64.powf(hit.hardness_decades),
            mass_kg: set.mass_kg * hit.mass_octaves.exp2(),
            ..set
        };
        let strike = Strike {
            mallet: mallet.sane(),
            body_pa: self.modulus_pa * tweak.stiffness,
            heavier: tweak.mass(),
            touch: Touch::new(&self.settings, &hit, chance(key, self.position)),
            seed: grain(key, self.position),
        };
        self.wake(key);
        if let Some(body) = self.bodies[usize::from(key)].as_mut() {
            body.strike(self.kernel, &strike, self.step_s);
            let share = mallet.mass_kg / (mallet.mass_kg + strike.heavier * body.mass_kg);
            self.swings[usize::from(key)].push(2.0 * share * strike.touch.speed_m_s);
        }
        self.driven |= bit(key);
        true
    }

    /// Makes a body ready to be pushed from here on.
    fn wake(&mut self, key: u8) {
        let (tuned, hearing) = (self.tuned(key), self.hearing(key));
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

    /// What hands do to a key's body from the next grid point on.
    pub fn hold(&mut self, key: u8, hold: &Hold) {
        let Some(hand) = self.hands.get_mut(usize::from(key)) else {
            return;
        };
        let hold = hold.sane();
        if hold.bend_semitones != hand.hold.bend_semitones {
            hand.bend = (hold.bend_semitones / 12.0).exp2();
        }
        hand.hold = hold;
        if hold.bow_pressure > 0.0 {
            self.bowed |= bit(key);
        }
    }

    /// The hand leaves a key: it no longer presses its mallet on nor moves its bow. The damper is
    /// [`Hold::felt`].
    pub fn release(&mut self, key: u8) {
        let slot = usize::from(key);
        if let Some(hand) = self.hands.get_mut(slot) {
            hand.rubs = 0.0;
        }
        if let Some(body) = self.bodies.get_mut(slot).and_then(Option::as_mut) {
            body.let_go();
        }
    }

    /// Silences a key's body within 0.2 s, without a click.
    pub fn choke(&mut self, key: u8) {
        self.silence(bit(key));
    }

    /// Silences everything within 0.2 s, without a click.
    pub fn choke_all(&mut self) {
        self.silence(u128::MAX);
    }

    fn silence(&mut self, keys_bits: u128) {
        self.choked |= keys_bits;
        for key in keys(keys_bits) {
            self.release(key);
            self.hands[usize::from(key)].hold.bow_pressure = 0.0;
        }
    }

    /// The keys whose bodies sound, bit 0 for key 0.
    #[must_use]
    pub fn awake(&self) -> u128 {
        self.awake
    }

    /// The keys that have bodies, bit 0 for key 0.
    #[must_use]
    pub fn bodies(&self) -> u128 {
        let there = |(key, body): (usize, &Option<Body>)| u128::from(body.is_some()) << key;
        self.bodies.iter().enumerate().map(there).sum()
    }

    /// Time after which nothing that sounds now is louder than −100 dB of full scale, in s, if nothing
    /// changes; infinite if something never tires.
    #[must_use]
    pub fn tail_s(&self) -> f64 {
        const FLOOR: f64 = 1e-5;
        let bodies = keys(self.awake).filter_map(|key| self.body(key));
        bodies
            .flat_map(|body| body.sounds(&self.packs))
            .filter(|sound| sound.power > FLOOR * FLOOR)
            .map(|sound| 0.5 * (sound.power.ln() - 2.0 * FLOOR.ln()) / sound.decay_per_s)
            .fold(0.0, f64::max)
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
        self.glides.snap();
        self.gain = [self.glides.gain(); 2];
        self.moved();
    }

    /// Works out what follows from parameters that have moved.
    fn moved(&mut self) {
        self.ways = self.glides.listener().ways(&self.ears_m);
        self.pitch = self.glides.tweak().pitch();
    }

    /// What the modes of a key's body are tuned to now.
    fn tuned(&self, key: u8) -> Tuned {
        let slot = usize::from(key);
        let hand = &self.hands[slot];
        let drain = self.glides.drain(&self.own, self.motor.taken());
        let has_felt = self.body(key).is_some_and(|body| body.has_felt);
        let felt = if self.settings.note_off_damps {
            hand.hold.felt
        } else {
            0.0
        };
        let on = if self.choked & bit(key) != 0 {
            Dampers::CHOKE
        } else {
            Dampers::new(felt, has_felt)
        };
        let (doppler, _) = self.swings[slot].heard(self.glides.swing(), self.distance_m());
        Tuned {
            drain: Drain {
                felt: on.felt,
                hand_per_s: on.hand_per_s + hand.hold.hand_per_s.max(-0.5 * drain.alpha2_per_s),
                ..drain
            },
            ratio: self.pitch * hand.bend * doppler,
        }
    }

    /// How a key's body is heard at the end of this cell.
    fn hearing(&self, key: u8) -> Hearing {
        let slot = usize::from(key);
        let hold = &self.hands[slot].hold;
        let (_, nearer) = self.swings[slot].heard(self.glides.swing(), self.distance_m());
        let level = hold.level * nearer;
        let pans = [1.0 - hold.pan, 1.0 + hold.pan].map(|share| level * share.min(1.0));
        let mut ways = self.ways;
        for (way, pan) in ways.iter_mut().zip(pans) {
            way.gain *= pan;
        }
        Hearing {
            open: self.motor.open(),
            width: self.glides.listener().width,
            ways,
        }
    }

    /// From the middle between the ears to the instrument, in m.
    fn distance_m(&self) -> f64 {
        let middle = |a: usize| 0.5 * (self.ears_m[0][a] + self.ears_m[1][a]);
        middle(0).hypot(middle(1)).hypot(middle(2)).max(0.1)
    }

    /// What is looked at on the grid only; then what rings freely sounds for a cell.
    fn look(&mut self) {
        if self.awake | self.bowed == 0 {
            self.arrive();
            self.motor.advance(&self.glides.discs(), self.step_s);
            return;
        }
        if self.glides.advance() {
            self.moved();
        }
        self.motor.advance(&self.glides.discs(), self.step_s);
        self.gain = [self.gain[1], self.glides.gain()];
        for key in keys(self.awake) {
            self.swings[usize::from(key)].advance(self.step_s * GRID as f64);
        }
        self.rest();
        self.rub();
        self.ring();
    }

    /// A cell of what rings freely.
    fn ring(&mut self) {
        self.cell.begin();
        for key in keys(self.awake & !self.driven) {
            let hearing = self.hearing(key);
            if let Some(body) = &self.bodies[usize::from(key)] {
                self.cell.leave(body, body.moved(&hearing));
            }
        }
        self.cell.ring_left(self.kernel, &mut self.packs);
        for key in keys(self.awake) {
            let (tuned, hearing) = (self.tuned(key), self.hearing(key));
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

    /// Moves bows on, and takes those away that are lifted.
    fn rub(&mut self) {
        for key in keys(self.bowed) {
            let hand = self.hands[usize::from(key)];
            let pressure = hand.hold.bow_pressure.max(hand.rubs);
            if self.awake & bit(key) == 0 && pressure > 0.0 {
                self.wake(key);
            }
            let bow = self.settings.bow;
            let speed_m_s = bow.speed_m_s * hand.hold.bow_speed_octaves.exp2();
            let Some(body) = self.bodies[usize::from(key)].as_mut() else {
                self.bowed &= !bit(key);
                continue;
            };
            if body.bow(self.kernel, pressure * bow.force_n, speed_m_s, self.step_s) {
                self.driven |= bit(key);
            } else if pressure == 0.0 {
                self.bowed &= !bit(key);
            }
        }
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
            let mut sample = [gain * buses[0][n], gain * buses[1][n]];
            if self.settings.limiter {
                sample = self.limiter.limit(sample);
            }
            [left[n], right[n]] = sample.map(finish);
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
