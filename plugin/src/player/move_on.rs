//! From what hands have done at a sample to what instruments do from there on.

use super::Player;
use super::hear::number;
use crate::engine::{Hit, Hold, Settings};
use crate::hands::TouchHands;
use crate::notes::each;
use crate::params::bow::Keys;
use crate::tuner::Place;
use nice_plug::prelude::{Plugin, ProcessContext};

impl Player {
    /// Looks at the parameters and at the tuning of the song.
    pub(super) fn aim(&mut self) {
        if let Some(table) = self.controls.tuning().fetch() {
            self.tuner.set(table);
            self.stale |= self.tuner.follow();
        }
        if let Some(trims) = self.controls.trims().fetch() {
            self.stage.trim(&trims);
            self.look_at = 0;
        }
        self.hands.set(&self.controls.hands());
        let (settings, keys) = (self.controls.settings(), self.controls.bow.keys());
        if (settings, keys) == (self.settings, self.keys) {
            return;
        }
        // What is modulated counts from the value that is set.
        if keys != self.keys || self.modulated {
            self.stale = u128::MAX;
        }
        (self.settings, self.keys) = (settings, keys);
        self.look_at = 0;
        self.point();
    }

    /// Does what the events of this sample, frame `now` of the block, come to.
    pub(super) fn settle<P: Plugin>(&mut self, now: usize, context: &mut impl ProcessContext<P>) {
        let changed = self.hands.changed();
        if changed | self.stale == 0 {
            return;
        }
        self.point();
        self.strike_due(u128::MAX);
        let stale = std::mem::take(&mut self.stale);
        for key in each(changed | stale) {
            self.tell(key);
        }
        self.end_notes::<P>(now, context);
    }

    /// Makes those strikes that are due now on some keys.
    pub(super) fn strike_due(&mut self, keys: u128) {
        for key in each(keys & self.due) {
            self.strike(key);
        }
    }

    fn strike(&mut self, key: u8) {
        let bit = 1 << key;
        let up = self.up & bit != 0;
        self.due &= !bit;
        self.up &= !bit;
        let channel = self.notes.channel(key).map_or(0, number);
        let bodies = self.stage.bodies();
        let struck = self.tuner.strike(key, channel, bodies);
        let (Some(body), Some(place)) = (struck, self.tuner.place(key)) else {
            return;
        };
        // The body is to sound as it is held from its first sample on.
        self.stage.hold(body, &self.held(key, place));
        self.stage
            .hit(body, &self.hit(&self.hands.touch(key), channel));
        self.stale |= bit;
        if up {
            self.let_go(key);
        }
    }

    fn hit(&self, touch: &TouchHands, channel: u8) -> Hit {
        let (strike, mallet) = (&self.controls.strike, &self.controls.mallet);
        Hit {
            // A bow presses as it is held.
            velocity: if self.keys == Keys::Rub {
                0.0
            } else {
                touch.velocity
            },
            position: touch.position + strike.moved(touch.position_modulation),
            across: 0.0,
            hardness_decades: touch.hardness_decades + mallet.harder(touch.hardness_modulation),
            mass_octaves: touch.mass_octaves,
            channel,
        }
    }

    /// The hand leaves a key.
    pub(super) fn let_go(&mut self, key: u8) {
        if let Some(place) = self.tuner.place(key) {
            self.stage.each(|engine| engine.release(place.body));
        }
    }

    /// Tells instruments what hands do to a key's body, and to the one that is the key's own if no key
    /// has struck it.
    pub(super) fn tell(&mut self, key: u8) {
        if let Some(place) = self.tuner.place(key) {
            self.stage.hold(place.body, &self.held(key, place));
        }
        if self.tuner.owner(key).is_none() {
            let felt = self.hands.key(key).felt;
            self.stage.hold(key, &Hold { felt, ..Hold::FREE });
        }
    }

    fn held(&self, key: u8, place: Place) -> Hold {
        let hands = self.hands.key(key);
        let is_down = self.hands.held() >> key & 1 == 1;
        let velocity = || self.hands.touch(key).velocity;
        let damping = &self.controls.damping;
        Hold {
            bend_semitones: hands.bend_semitones + place.semitones,
            level: hands.level,
            pan: hands.pan,
            felt: hands.felt,
            hand_per_s: hands.hand_per_s + damping.faster_per_s(hands.damping_modulation),
            bow_pressure: match self.keys {
                Keys::Rub if is_down => (velocity() + hands.bow_pressure).clamp(0.0, 1.0),
                Keys::Both if is_down => hands.bow_pressure.max(0.0),
                _ => 0.0,
            },
            bow_speed_octaves: hands.bow_speed_octaves,
        }
    }

    /// Gives all instruments their targets: the parameters, with what hands do to the whole.
    fn point(&mut self) {
        let whole = self.hands.whole();
        let mut settings: Settings = self.settings;
        settings.motor.speed_hz += whole.motor_speed_hz;
        settings.motor.depth += whole.motor_depth;
        settings.listener.distance *= whole.distance_octaves.exp2();
        self.stage.set(&settings);
    }
}
