//! The hands: controllers in, and what controllers announce.

use super::rpn::Entry;
use super::settings::BEND_RANGE_MOST;
use super::state::{Hands, each};
use super::strip::Finger;
use super::tame::{bipolar, unipolar};
use super::zones::{Role, Zone, Zones};
use super::{Mpe, Settings};

impl Hands {
    /// A controller of a channel moves to `value`, a share of 127.
    ///
    /// An MPE member channel has bend, pressure and CC 74 only: its wheels, pedals and resets are not
    /// heard (RP-053, §2.3).
    pub fn controller(&mut self, channel: u8, cc: u8, value: f64) {
        let channel = channel & 15;
        let member = matches!(self.zones.role(channel), Role::Member(_));
        match cc {
            6 | 38 | 98..=101 => {
                if let Some(entry) = self.strips[usize::from(channel)].rpn.hear(cc, value) {
                    self.enter(channel, entry);
                }
            }
            _ if member && cc != 74 => {}
            121 => self.reset_controllers(channel),
            _ => self.move_controller(channel, cc, value),
        }
    }

    fn move_controller(&mut self, channel: u8, cc: u8, value: f64) {
        let keys = self.following(channel);
        let strip = &mut self.strips[usize::from(channel)];
        if strip.move_controller(cc, value, self.held & keys) {
            self.changed |= keys;
            if cc == 64 {
                self.changed |= self.unstruck();
            }
        }
    }

    fn reset_controllers(&mut self, channel: u8) {
        let keys = self.following(channel);
        self.strips[usize::from(channel)].reset_controllers();
        if let Role::Manager(zone) = self.zones.role(channel) {
            for member in 0..16 {
                if self.zones.role(member) == Role::Member(zone) {
                    self.strips[usize::from(member)].reset_controllers();
                }
            }
        }
        for key in each(keys) {
            self.slots[usize::from(key)].pressure = 0.0;
        }
        self.changed |= keys | self.unstruck();
    }

    /// A channel bends by `bend` −1…1 of its range: (n − 8192)/8192 for the 14-bit number n.
    pub fn pitch_bend(&mut self, channel: u8, bend: f64) {
        let channel = channel & 15;
        self.strips[usize::from(channel)].finger.bend = bipolar(bend);
        self.changed |= self.following(channel);
    }

    /// A channel presses, 0…1.
    pub fn channel_pressure(&mut self, channel: u8, pressure: f64) {
        let channel = channel & 15;
        self.strips[usize::from(channel)].finger.pressure = unipolar(pressure);
        self.changed |= self.following(channel);
    }

    /// A data entry of RPN 0 or 6.
    fn enter(&mut self, channel: u8, entry: Entry) {
        let range = match self.zones.role(channel) {
            // All members of a zone have one range, and the last word counts (§2.4).
            Role::Member(zone) => &mut self.member_ranges_semitones[zone as usize],
            Role::Manager(_) | Role::Plain => {
                &mut self.strips[usize::from(channel)].bend_range_semitones
            }
        };
        match entry {
            Entry::BendSemitones(semitones) => *range = f64::from(semitones).min(BEND_RANGE_MOST),
            Entry::BendCents(cents) => {
                let cents = f64::from(cents.min(99));
                *range = (range.trunc() + cents / 100.0).min(BEND_RANGE_MOST);
            }
            Entry::Zone(members) => {
                if let Some(zone) = Zone::managed_by(channel)
                    && members < 16
                    && self.settings.mpe == Mpe::Auto
                {
                    self.configure(zone, members);
                }
            }
        }
        self.changed = u128::MAX;
    }

    /// An MPE configuration message (§2.1), which brings its zone's default bend ranges with it (§2.4).
    fn configure(&mut self, zone: Zone, members: u8) {
        self.arrange(self.zones.with(zone, members));
        if members > 0 {
            let manager = usize::from(zone.manager());
            self.strips[manager].bend_range_semitones = Settings::DEFAULT.bend_range_semitones;
            self.member_ranges_semitones[zone as usize] =
                Settings::DEFAULT.member_bend_range_semitones;
        }
    }

    /// Channels that enter or leave MPE let go of their keys and go to rest (§2.1.4).
    pub(super) fn arrange(&mut self, zones: Zones) {
        for channel in 0..16 {
            if zones.role(channel) != self.zones.role(channel) {
                let strip = &mut self.strips[usize::from(channel)];
                strip.reset_all(self.settings.bend_range_semitones);
                let keys = strip.keys;
                self.let_go(keys & self.held, 0.0);
                for key in each(keys) {
                    self.slots[usize::from(key)].left = Some(Finger::REST);
                }
            }
        }
        self.zones = zones;
        self.changed = u128::MAX;
    }

    /// The keys that a channel speaks for.
    fn following(&self, channel: u8) -> u128 {
        let own = self.strips[usize::from(channel)].keys;
        let Role::Manager(zone) = self.zones.role(channel) else {
            return own;
        };
        (0..16)
            .filter(|member| self.zones.role(*member) == Role::Member(zone))
            .fold(own, |keys, member| {
                keys | self.strips[usize::from(member)].keys
            })
    }

    /// The keys that no note has struck.
    fn unstruck(&self) -> u128 {
        !self.strips.iter().fold(0, |keys, strip| keys | strip.keys)
    }
}
