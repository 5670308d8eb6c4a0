//! What is done to an instrument: blows, hands and silence.

use super::{Engine, keys};
use crate::engine::body::{Moved, Strike};
use crate::engine::damper::bit;
use crate::engine::mallet::Mallet;
use crate::engine::touch::{Touch, chance, grain};
use crate::engine::{GRID, Hit, Hold};

/// Hands on one body.
#[derive(Clone, Copy)]
pub(super) struct Hand {
    pub(super) hold: Hold,
    /// 2 to the power of the bend in octaves.
    pub(super) bend: f64,
    /// Pressure of a bow whose key is held down.
    pub(super) rubs: f64,
}

impl Hand {
    pub(super) const FREE: Self = Self {
        hold: Hold::FREE,
        bend: 1.0,
        rubs: 0.0,
    };
}

impl Engine {
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
        self.stale |= bit(key);
        self.routes.strike(key, hit.channel);
        let touch = Touch::new(&self.settings, &hit, chance(key, self.position));
        self.remember(key, &touch, hit.velocity);
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
            body_pa: self.body(key).map_or(f64::INFINITY, |body| body.modulus_pa) * tweak.stiffness,
            heavier: tweak.mass(),
            touch,
            seed: grain(key, self.position),
        };
        self.wake(key);
        if let Some(body) = self.bodies[usize::from(key)].as_mut() {
            body.strike(self.kernel, &strike, self.step_s);
            let share = mallet.mass_kg / (mallet.mass_kg + strike.heavier * body.mass_kg);
            self.swings[usize::from(key)].push(2.0 * share * strike.touch.speed_m_s);
            self.swinging |= bit(key);
        }
        self.driven |= bit(key);
        self.carry(key);
        true
    }

    /// Makes a body ready to be pushed from here on.
    pub(super) fn wake(&mut self, key: u8) {
        let sleeps = self.awake & bit(key) == 0;
        if sleeps {
            self.fit(key);
            self.routes.put(key, self.settings.split);
            self.used |= self.routes.used(bit(key));
        }
        let Some(body) = self.bodies[usize::from(key)].as_mut() else {
            return;
        };
        if sleeps {
            self.awake |= bit(key);
            body.fading = Moved::NONE;
        } else if self.driven & bit(key) == 0 {
            let phase = (self.position % GRID as u64) as usize;
            let moved = (body, self.packs.as_mut_slice());
            self.cells[self.routes.output(key)].take_out(
                self.kernel,
                &mut self.bench,
                moved,
                phase,
                self.step_s,
            );
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
        if hold == hand.hold {
            return;
        }
        hand.hold = hold;
        self.stale |= bit(key);
        self.unheard |= bit(key);
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
        self.stale |= keys_bits;
        for key in keys(keys_bits) {
            self.release(key);
            self.hands[usize::from(key)].hold.bow_pressure = 0.0;
        }
    }
}
