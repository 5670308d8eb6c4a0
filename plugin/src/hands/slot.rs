//! One key: its last note, and what is said of that note alone.

use super::Note;
use super::strip::Finger;
use super::tame::{bipolar, unipolar, within};

/// What can be said of a note besides that it begins and ends (CLAP and VST3 note expressions, and
/// MIDI's polyphonic pressure).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Expression {
    /// Semitones off its key, −120…120.
    Tuning,
    /// How hard the finger presses, 0…1.
    Pressure,
    /// 0…1, with the middle at a half.
    Brightness,
    /// Factor on its loudness, 0…4, at rest 1.
    Volume,
    /// −1 (left) …1 (right).
    Pan,
    /// 0…1.
    Vibrato,
    /// Share of its loudness, 0…1, at rest 1.
    Expression,
}

/// A parameter that a host may move for one note alone.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[repr(u8)]
pub enum Modulated {
    /// Where the strike lands.
    StrikePosition = 0,
    /// How hard the mallet is.
    Hardness = 1,
    /// How fast the body's sound dies away.
    Damping = 2,
}

impl Modulated {
    /// All, by number.
    pub const ALL: [Self; 3] = [Self::StrikePosition, Self::Hardness, Self::Damping];
}

/// Greatest tuning, in semitones.
pub(super) const TUNING_MOST: f64 = 120.0;

/// A key.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Slot {
    /// The note that struck it last.
    pub(super) note: Option<Note>,
    /// After the curve, 0…1.
    pub(super) velocity: f64,
    /// −1…1.
    pub(super) release: f64,
    /// −1…1.
    pub(super) chance: f64,
    pub(super) tuning_semitones: f64,
    pub(super) pressure: f64,
    /// −1…1.
    pub(super) brightness: f64,
    pub(super) volume: f64,
    pub(super) pan: f64,
    pub(super) vibrato: f64,
    pub(super) expression: f64,
    /// By [`Modulated`], in the host's units of the parameter.
    pub(super) modulation: [f64; Modulated::ALL.len()],
    /// What the finger last did, once it has left the key and its MPE channel is free for another.
    pub(super) left: Option<Finger>,
}

impl Slot {
    /// Never struck.
    pub(super) const REST: Self = Self {
        note: None,
        velocity: 0.0,
        release: 0.0,
        chance: 0.0,
        tuning_semitones: 0.0,
        pressure: 0.0,
        brightness: 0.0,
        volume: 1.0,
        pan: 0.0,
        vibrato: 0.0,
        expression: 1.0,
        modulation: [0.0; Modulated::ALL.len()],
        left: None,
    };

    /// A new note takes over: what was said of the one before is forgotten.
    pub(super) fn begin(&mut self, note: Note, velocity: f64, chance: f64) {
        *self = Self {
            note: Some(note),
            velocity,
            chance: bipolar(chance),
            ..Self::REST
        };
    }

    /// Takes in an expression.
    pub(super) fn express(&mut self, kind: Expression, value: f64) {
        match kind {
            Expression::Tuning => {
                self.tuning_semitones = within(value, -TUNING_MOST, TUNING_MOST, 0.0);
            }
            Expression::Pressure => self.pressure = unipolar(value),
            Expression::Brightness => self.brightness = 2.0 * within(value, 0.0, 1.0, 0.5) - 1.0,
            Expression::Volume => self.volume = within(value, 0.0, 4.0, 1.0),
            Expression::Pan => self.pan = bipolar(value),
            Expression::Vibrato => self.vibrato = unipolar(value),
            Expression::Expression => self.expression = within(value, 0.0, 1.0, 1.0),
        }
    }
}
