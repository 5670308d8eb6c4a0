//! What is looked at on the grid, and the sound of a cell.

use super::{Engine, LOOKS, finish, keys};
use crate::engine::GRID;
use crate::engine::body::{Moved, Tuned};
use crate::engine::damper::{Dampers, bit};
use crate::engine::losses::Drain;
use crate::engine::source::Hearing;

impl Engine {
    /// Parameters that nobody hears move are there at once.
    pub(super) fn arrive(&mut self) {
        if self.glides.snap() {
            self.moved();
        }
        self.gain = [self.glides.gain(); 2];
    }

    /// Works out what follows from parameters that have moved.
    fn moved(&mut self) {
        let listener = self.glides.listener();
        self.ways = listener.ways(&self.ears_m);
        self.width = listener.width;
        self.pitch = self.glides.tweak().pitch();
        self.stale = u128::MAX;
    }

    /// What the modes of a key's body are tuned to now.
    pub(super) fn tuned(&self, key: u8) -> Tuned {
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
        let (doppler, _) = self.swings[slot].heard(self.glides.swing(), self.distance_m);
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
    pub(super) fn hearing(&self, key: u8) -> Hearing {
        let slot = usize::from(key);
        let hold = &self.hands[slot].hold;
        let (_, nearer) = self.swings[slot].heard(self.glides.swing(), self.distance_m);
        let level = hold.level * nearer;
        let pans = [1.0 - hold.pan, 1.0 + hold.pan].map(|share| level * share.min(1.0));
        let mut ways = self.ways;
        for (way, pan) in ways.iter_mut().zip(pans) {
            way.gain *= pan;
        }
        Hearing {
            open: self.motor.open(),
            width: self.width,
            ways,
        }
    }

    /// What is looked at on the grid only; then what rings freely sounds for a cell.
    pub(super) fn look(&mut self) {
        if self.awake | self.bowed == 0 {
            self.arrive();
            self.motor.advance(&self.glides.discs(), self.step_s);
            return;
        }
        if self.glides.advance() {
            self.moved();
        }
        if self.motor.advance(&self.glides.discs(), self.step_s) {
            self.stale = u128::MAX;
        }
        self.gain = [self.gain[1], self.glides.gain()];
        for key in keys(self.swinging) {
            if !self.swings[usize::from(key)].advance(&self.swing_step) {
                self.swinging &= !bit(key);
            }
            self.stale |= bit(key);
        }
        self.rest();
        self.rub();
        self.sympathise();
        self.ring();
    }

    /// What the common support does to all bodies.
    fn sympathise(&mut self) {
        let sympathy = self.glides.sympathy();
        if sympathy == 0.0 {
            return;
        }
        for key in 0..128 {
            let slot = usize::from(key);
            let Some(body) = self.bodies[slot].as_mut() else {
                continue;
            };
            if body.take_answer(&mut self.packs) && self.awake & bit(key) == 0 {
                self.awake |= bit(key);
                body.fading = Moved::NONE;
                self.stale |= bit(key);
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
            let (tuned, hearing) = (self.tuned(key), self.hearing(key));
            let Some(body) = self.bodies[usize::from(key)].as_mut() else {
                continue;
            };
            if self.awake & bit(key) == 0 {
                body.tune(self.kernel, &mut self.packs, tuned, &hearing, self.step_s);
            }
            body.answer(self.kernel, &all, share as f32);
        }
    }

    /// A cell of what rings freely.
    fn ring(&mut self) {
        self.cell.begin();
        let stale = self.awake & self.stale;
        for key in keys(stale & !self.driven) {
            let hearing = self.hearing(key);
            if let Some(body) = &self.bodies[usize::from(key)] {
                self.cell.leave(body, body.moved(&hearing));
            }
        }
        self.cell.ring_left(self.kernel, &mut self.packs);
        // What stays stale is off by a hair until nothing moves it any more.
        self.stale &= !stale;
        for key in keys(stale) {
            let (tuned, hearing) = (self.tuned(key), self.hearing(key));
            let Some(body) = self.bodies[usize::from(key)].as_mut() else {
                continue;
            };
            let moved = body.moved(&hearing);
            if body.tune(self.kernel, &mut self.packs, tuned, &hearing, self.step_s) {
                self.stale |= bit(key);
            }
            body.fading = moved;
        }
        for key in keys(self.awake) {
            let Some(body) = self.bodies[usize::from(key)].as_mut() else {
                continue;
            };
            if stale & bit(key) == 0 {
                body.fading = Moved::NONE;
            }
            if !body.driven {
                self.cell.enter(body, body.fading);
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
    pub(super) fn render(&mut self, phase: usize, left: &mut [f32], right: &mut [f32]) {
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
