//! What is looked at on the grid, and what rings freely in a cell.

use super::ready::PREPARED;
use super::routing::outputs;
use super::{Engine, keys};
use crate::engine::GRID;
use crate::engine::body::{Moved, Tuned};
use crate::engine::damper::{Dampers, bit};
use crate::engine::losses::Drain;
use crate::engine::source::Hearing;
use modes::Damping;

/// Every thirty-second key.
const PARTS: u128 = 0x0000_0001_0000_0001_0000_0001_0000_0001;

/// The keys that have their turn in this cell to be looked at for sleep.
fn looked_at(cell: u64) -> u128 {
    PARTS << (cell % 32)
}

impl Engine {
    /// Parameters that nobody hears move are there at once.
    pub(super) fn arrive(&mut self) {
        if self.glides.snap() {
            self.moved();
        }
        self.gain = [self.glides.gain(); 2];
    }

    /// Works out what follows from parameters that have moved.
    pub(super) fn moved(&mut self) {
        let listener = self.glides.listener();
        let (ways, width) = (listener.ways(&self.ears_m), listener.width);
        if (ways, width) != (self.ways, self.width) {
            (self.ways, self.width) = (ways, width);
            self.unheard = u128::MAX;
        }
        self.pitch = self.glides.tweak().pitch();
        self.stale = u128::MAX;
    }

    /// What drains a key's body now, whatever hands and dampers do.
    fn drain(&self, key: u8) -> Drain {
        let own = self.body(key).map_or(Damping::default(), |body| body.own);
        self.glides.drain(&own, self.motor.taken())
    }

    /// What the modes of a key's body are tuned to now.
    pub(super) fn tuned(&self, key: u8) -> Tuned {
        let hand = &self.hands[usize::from(key)];
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
        self.tuned_under(&on, key)
    }

    /// The same under other dampers than those that are on it.
    pub(super) fn tuned_under(&self, on: &Dampers, key: u8) -> Tuned {
        let drain = self.drain(key);
        let hand = &self.hands[usize::from(key)];
        let doppler = self.swung(key).0;
        Tuned {
            drain: Drain {
                felt: on.felt,
                hand_per_s: on.hand_per_s + hand.hold.hand_per_s.max(-0.5 * drain.alpha2_per_s),
                ..drain
            },
            ratio: self.pitch * hand.bend * doppler,
            trims: self.trims_number,
        }
    }

    /// Pitch and level of a key's body over those at rest, as it swings.
    fn swung(&self, key: u8) -> (f64, f64) {
        if self.swinging & bit(key) == 0 {
            return (1.0, 1.0);
        }
        self.swings[usize::from(key)].heard(self.glides.swing(), self.distance_m)
    }

    /// How a key's body is heard at the end of this cell.
    pub(super) fn hearing(&self, key: u8) -> Hearing {
        let slot = usize::from(key);
        let hold = &self.hands[slot].hold;
        let level = hold.level * self.swung(key).1;
        let pans = [1.0 - hold.pan, 1.0 + hold.pan].map(|share| level * share.min(1.0));
        let mut ways = self.ways;
        for (way, pan) in ways.iter_mut().zip(pans) {
            way.gain *= pan;
        }
        Hearing {
            open: self.motor.open(),
            width: self.width,
            ways,
            trims: self.trims_number,
        }
    }

    /// What is looked at on the grid only; then what rings freely sounds for a cell.
    pub(super) fn look(&mut self) {
        if self.awake | self.bowed == 0 {
            self.arrive();
            self.motor.advance(&self.glides.discs(), self.step_s);
            self.prepare(PREPARED);
            return;
        }
        let glides = self.glides.advance();
        if glides {
            self.moved();
        }
        let turns = self.motor.advance(&self.glides.discs(), self.step_s);
        if turns {
            (self.stale, self.unheard) = (u128::MAX, u128::MAX);
        }
        self.gain = [self.gain[1], self.glides.gain()];
        if self.glides.swing() > 0.0 {
            self.stale |= self.swinging;
            self.unheard |= self.swinging;
        }
        for key in keys(self.swinging) {
            if !self.swings[usize::from(key)].advance(&self.swing_step) {
                self.swinging &= !bit(key);
            }
        }
        self.rest();
        self.rub();
        self.sympathise();
        // What moves on would have it all to do again in the next cell.
        if !glides && !turns {
            self.prepare(PREPARED);
        }
        self.deal();
        self.ring();
    }

    /// What the common support does to all bodies.
    fn sympathise(&mut self) {
        let sympathy = self.glides.sympathy();
        if sympathy == 0.0 {
            return;
        }
        self.arranged = None;
        for key in 0..128 {
            let slot = usize::from(key);
            let Some(body) = self.bodies[slot].as_mut() else {
                continue;
            };
            if body.take_answer(&mut self.packs) && self.awake & bit(key) == 0 {
                self.awake |= bit(key);
                self.routes.put(key, self.settings.split);
                body.fading = Moved::NONE;
                self.stale |= bit(key);
                self.unheard |= bit(key);
            }
        }
        let mut all = [0.0; GRID];
        for key in keys(self.awake) {
            if let Some(body) = self.bodies[usize::from(key)].as_mut() {
                body.feel(self.kernel, &self.packs, &mut all);
            }
        }
        let joined = self.bodies.iter().flatten().count().max(1) as f64;
        let share = sympathy * self.glides.supports().min(1.0) * self.step_s / joined;
        for key in 0..128 {
            if self.awake & bit(key) == 0 {
                self.fit(key);
            }
            let Some(body) = self.bodies[usize::from(key)].as_mut() else {
                continue;
            };
            body.answer(self.kernel, &all, share as f32);
        }
    }

    /// A cell of what rings freely.
    fn ring(&mut self) {
        let stale = self.awake & self.stale;
        let sounding = (self.awake, self.driven);
        if stale == 0 && self.arranged == Some(sounding) {
            for output in outputs(self.used) {
                self.cells[output].again();
            }
        } else {
            for output in outputs(self.used) {
                self.cells[output].begin();
            }
            self.retune(stale);
            self.arrange();
            self.arranged = (stale == 0).then_some(sounding);
        }
        for output in outputs(self.used) {
            self.cells[output].ring_entered(self.kernel, &mut self.bench, &mut self.packs);
        }
    }

    /// Tunes those of the bodies whose bits are set; what is heard of them otherwise from now on sounds
    /// once more as before.
    fn retune(&mut self, stale: u128) {
        let unheard = stale & self.unheard;
        for key in keys(unheard & !self.driven) {
            let hearing = self.hearing(key);
            if let Some(body) = &self.bodies[usize::from(key)] {
                self.cells[self.routes.output(key)].leave(body, body.moved(&hearing));
            }
        }
        for output in outputs(self.used) {
            self.cells[output].ring_left(self.kernel, &mut self.bench, &mut self.packs);
        }
        self.stale &= !stale;
        self.unheard &= !unheard;
        for key in keys(stale) {
            let tuned = self.tuned(key);
            let hearing = (unheard & bit(key) != 0).then(|| self.hearing(key));
            let Some(body) = self.bodies[usize::from(key)].as_mut() else {
                continue;
            };
            body.trim(&self.trims, self.trims_number);
            let moved = hearing.map_or(Moved::NONE, |hearing| body.listen(&hearing));
            if body.tune(self.kernel, &mut self.packs, (tuned, moved), self.step_s) {
                self.stale |= bit(key);
            }
            body.fading = moved;
        }
        for key in keys(self.awake & !stale) {
            if let Some(body) = self.bodies[usize::from(key)].as_mut() {
                body.fading = Moved::NONE;
            }
        }
    }

    /// Says what sounds in this cell.
    fn arrange(&mut self) {
        for key in keys(self.awake & !self.driven) {
            if let Some(body) = &self.bodies[usize::from(key)] {
                self.cells[self.routes.output(key)].enter(body, body.fading);
            }
        }
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
        for key in keys(self.driven & !self.routes.moving) {
            if let Some(body) = self.bodies[usize::from(key)].as_mut()
                && body.part(&self.packs)
            {
                self.driven &= !bit(key);
            }
        }
        for key in keys(self.awake & looked_at(self.position / GRID as u64)) {
            let Some(body) = self.bodies[usize::from(key)].as_mut() else {
                continue;
            };
            let before = body.live;
            if !body.settle(&mut self.packs) {
                body.hush(&mut self.packs);
                self.awake &= !bit(key);
                // The next blow finds no felt on it.
                self.stale |= bit(key);
            }
            if body.live != before {
                self.arranged = None;
            }
        }
    }
}
