//! What values may lie between, and what stands in for one that is no number.

use clap_sys::events::{
    CLAP_NOTE_EXPRESSION_BRIGHTNESS, CLAP_NOTE_EXPRESSION_EXPRESSION, CLAP_NOTE_EXPRESSION_PAN,
    CLAP_NOTE_EXPRESSION_TUNING, CLAP_NOTE_EXPRESSION_VOLUME, clap_note_expression,
};

/// A range of values.
#[derive(Clone, Copy, Debug)]
pub(super) struct Span {
    least: f64,
    greatest: f64,
    neutral: f64,
}

impl Span {
    /// Velocity, pressure, vibrato, controllers.
    pub(super) const UNIT: Self = Self::new(0.0, 1.0, 0.0);
    /// Gain as a factor.
    pub(super) const VOLUME: Self = Self::new(0.0, 4.0, 1.0);
    /// Pitch in semitones.
    pub(super) const TUNING: Self = Self::new(-120.0, 120.0, 0.0);
    /// Pan, left to right, and pitch bend.
    pub(super) const CENTRED: Self = Self::new(0.0, 1.0, 0.5);
    /// Pan as the framework has it.
    pub(super) const SIGNED: Self = Self::new(-1.0, 1.0, 0.0);
    /// Expression, which is full unless told otherwise (MIDI RP-015, controller 11).
    pub(super) const EXPRESSION: Self = Self::new(0.0, 1.0, 1.0);
    /// Brightness, which is half unless told otherwise (MIDI RP-021, controller 74).
    pub(super) const BRIGHTNESS: Self = Self::CENTRED;

    const fn new(least: f64, greatest: f64, neutral: f64) -> Self {
        Self {
            least,
            greatest,
            neutral,
        }
    }

    /// That of a CLAP note expression.
    pub(super) const fn of(expression: clap_note_expression) -> Self {
        match expression {
            CLAP_NOTE_EXPRESSION_VOLUME => Self::VOLUME,
            CLAP_NOTE_EXPRESSION_PAN => Self::CENTRED,
            CLAP_NOTE_EXPRESSION_TUNING => Self::TUNING,
            CLAP_NOTE_EXPRESSION_EXPRESSION => Self::EXPRESSION,
            CLAP_NOTE_EXPRESSION_BRIGHTNESS => Self::BRIGHTNESS,
            _ => Self::UNIT,
        }
    }

    /// The nearest value within.
    pub(super) const fn confine(self, value: f64) -> f64 {
        if value.is_nan() {
            self.neutral
        } else {
            value.clamp(self.least, self.greatest)
        }
    }
}
