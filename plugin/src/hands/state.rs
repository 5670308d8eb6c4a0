//! The hands: settings and notes in.

use super::matrix::Matrix;
use super::slot::Slot;
use super::strip::{Finger, Strip};
use super::tame::{about_64, bipolar, unipolar};
use super::zones::{Role, Zones};
use super::{Address, Curve, Expression, Modulated, Note, Settings};

/// Everything the player's hands do, key by key.
///
/// Bodies ring on after their notes: a key stays with the channel that struck it last, and follows
/// its controllers until another strikes it. Only in MPE is a finger gone with its key: what it did
/// last stays, but for its pressure, and the zone's manager goes on speaking.
///
/// Nothing here allocates. Channels above 15 are taken modulo 16; keys above 127 are no keys.
#[derive(Clone, Debug)]
pub struct Hands {
    pub(super) settings: Settings,
    pub(super) matrix: Matrix,
    pub(super) curve: Curve,
    pub(super) zones: Zones,
    /// Full pitch bend of the lower and the upper zone's members, in semitones.
    pub(super) member_ranges_semitones: [f64; 2],
    pub(super) strips: [Strip; 16],
    pub(super) slots: [Slot; 128],
    pub(super) held: u128,
    pub(super) last: Option<u8>,
    pub(super) changed: u128,
}

impl Default for Hands {
    fn default() -> Self {
        Self::new()
    }
}

impl Hands {
    /// Untouched, with default settings.
    #[must_use]
    pub fn new() -> Self {
        let settings = Settings::DEFAULT;
        Self {
            matrix: Matrix::new(&settings.assignments),
            curve: Curve::new(settings.velocity_curve),
            zones: Zones::new(settings.mpe),
            member_ranges_semitones: [settings.member_bend_range_semitones; 2],
            strips: [Strip::REST; 16],
            slots: [Slot::REST; 128],
            held: 0,
            last: None,
            changed: u128::MAX,
            settings,
        }
    }

    /// Takes the hands off everything. Settings, zones and bend ranges stay: a controller announces
    /// them once, when it is plugged in.
    pub fn reset(&mut self) {
        for strip in &mut self.strips {
            strip.keys = 0;
            strip.reset_all(strip.bend_range_semitones);
        }
        self.slots = [Slot::REST; 128];
        self.held = 0;
        self.last = None;
        self.changed = u128::MAX;
    }

    /// New settings; cheap if they are the old ones.
    ///
    /// A bend range that changes replaces what channels were told by RPN 0.
    pub fn set(&mut self, settings: &Settings) {
        let new = settings.sane();
        let old = std::mem::replace(&mut self.settings, new);
        if new == old {
            return;
        }
        self.matrix = Matrix::new(&new.assignments);
        self.curve = Curve::new(new.velocity_curve);
        if new.mpe != old.mpe {
            self.arrange(Zones::new(new.mpe));
            self.member_ranges_semitones = [new.member_bend_range_semitones; 2];
        }
        if new.bend_range_semitones != old.bend_range_semitones {
            for strip in &mut self.strips {
                strip.bend_range_semitones = new.bend_range_semitones;
            }
        }
        if new.member_bend_range_semitones != old.member_bend_range_semitones {
            self.member_ranges_semitones = [new.member_bend_range_semitones; 2];
        }
        self.changed = u128::MAX;
    }

    /// A key is struck with `velocity` 0…1; `chance` −1…1 is what [`super::Source::Random`] will be.
    pub fn note_on(&mut self, note: Note, velocity: f64, chance: f64) {
        let key = note.key;
        if key > 127 {
            return;
        }
        let channel = note.channel & 15;
        for strip in &mut self.strips {
            strip.keys &= !bit(key);
        }
        self.strips[usize::from(channel)].keys |= bit(key);
        let velocity = self.curve.at(unipolar(velocity));
        self.slots[usize::from(key)].begin(Note { channel, ..note }, velocity, chance);
        self.held |= bit(key);
        self.last = Some(key);
        self.changed |= bit(key);
    }

    /// Keys come up with `velocity` 0…1; 0 is taken for the middle, being what keyboards send that do
    /// not measure it. The keys that were down and are meant, as bits.
    ///
    /// A note whose key another has taken over since is not meant.
    pub fn note_off(&mut self, address: Address, velocity: f64) -> u128 {
        let keys = self.meant(address) & self.held;
        let release = if velocity > 0.0 {
            about_64(velocity)
        } else {
            0.0
        };
        self.let_go(keys, release);
        keys
    }

    /// Keys come up; their fingers leave what they did last.
    pub(super) fn let_go(&mut self, keys: u128, release: f64) {
        self.held &= !keys;
        self.changed |= keys;
        for key in each(keys) {
            let slot = &mut self.slots[usize::from(key)];
            slot.release = release;
            slot.pressure = 0.0;
            let Some(note) = slot.note else { continue };
            if let Role::Member(_) = self.zones.role(note.channel) {
                slot.left = Some(Finger {
                    pressure: 0.0,
                    ..self.strips[usize::from(note.channel)].finger
                });
            }
        }
    }

    /// Something is said of notes alone; see [`Expression`] for units and ranges. It counts until
    /// their keys are struck again, pressure only while they are down.
    pub fn expression(&mut self, kind: Expression, address: Address, value: f64) {
        let mut keys = self.meant(address);
        if kind == Expression::Pressure {
            keys &= self.held;
        }
        for key in each(keys) {
            self.slots[usize::from(key)].express(kind, value);
        }
        self.changed |= keys;
    }

    /// The host moves a parameter by `amount` −1…1, in its units of that parameter, for notes alone.
    pub fn modulation(&mut self, what: Modulated, address: Address, amount: f64) {
        let keys = self.meant(address);
        for key in each(keys) {
            self.slots[usize::from(key)].modulation[what as usize] = bipolar(amount);
        }
        self.changed |= keys;
    }

    /// The keys whose [`super::KeyHands`] may have changed since this was last asked, as bits.
    pub fn changed(&mut self) -> u128 {
        std::mem::take(&mut self.changed)
    }

    /// The keys that are down, as bits.
    #[must_use]
    pub fn held(&self) -> u128 {
        self.held
    }

    /// The keys whose last note is meant.
    fn meant(&self, address: Address) -> u128 {
        let meant = |slot: &Slot| slot.note.is_some_and(|note| address.means(&note));
        if let Some(key) = address.key {
            let slot = self.slots.get(usize::from(key));
            return slot.map_or(0, |slot| u128::from(meant(slot)) << key);
        }
        self.slots
            .iter()
            .enumerate()
            .filter(|(_, slot)| meant(slot))
            .fold(0, |keys, (key, _)| keys | 1 << key)
    }
}

/// The bit of a key 0…127.
pub(super) fn bit(key: u8) -> u128 {
    1 << (key & 127)
}

/// The keys whose bits are set.
pub(super) fn each(mut keys: u128) -> impl Iterator<Item = u8> {
    std::iter::from_fn(move || {
        let key = u8::try_from(keys.trailing_zeros()).ok()?;
        keys &= keys.wrapping_sub(1);
        (key < 128).then_some(key)
    })
}
