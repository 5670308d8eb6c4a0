//! How hands are understood, as the player sets it.

use super::tame::{bipolar, within};
use super::{Assignment, Mpe, SLOTS};

/// Greatest range of a pitch bend, in semitones (RP-053, §1.2).
pub const BEND_RANGE_MOST: f64 = 96.0;

/// What does not come with notes and controllers.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Settings {
    /// Bend of the curve from a note's velocity to the one that strikes, −1…1; above 0 a light touch
    /// strikes harder.
    pub velocity_curve: f64,
    /// Which channels carry one note each.
    pub mpe: Mpe,
    /// Full pitch bend of a channel, in semitones, 0…[`BEND_RANGE_MOST`], until the channel is told
    /// another by RPN 0 or an MPE configuration message.
    pub bend_range_semitones: f64,
    /// Full pitch bend of an MPE member channel, in semitones, likewise.
    pub member_bend_range_semitones: f64,
    /// What moves what.
    pub assignments: [Assignment; SLOTS],
}

impl Default for Settings {
    fn default() -> Self {
        Self::DEFAULT
    }
}

impl Settings {
    /// Those of a new instance: 2 semitones as General MIDI has it, 48 as MPE does.
    pub const DEFAULT: Self = Self {
        velocity_curve: 0.0,
        mpe: Mpe::Auto,
        bend_range_semitones: 2.0,
        member_bend_range_semitones: 48.0,
        assignments: Assignment::DEFAULT,
    };

    /// The same with every number in its range, and what is no number as in a new instance.
    #[must_use]
    pub fn sane(self) -> Self {
        let range = |value, rest| within(value, 0.0, BEND_RANGE_MOST, rest);
        let normal = Self::DEFAULT;
        Self {
            velocity_curve: bipolar(self.velocity_curve),
            mpe: self.mpe,
            bend_range_semitones: range(self.bend_range_semitones, normal.bend_range_semitones),
            member_bend_range_semitones: range(
                self.member_bend_range_semitones,
                normal.member_bend_range_semitones,
            ),
            assignments: self.assignments.map(Assignment::sane),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::Settings;

    #[test]
    fn nonsense_becomes_allowed_values() {
        let normal = Settings::default();
        let mut wild = normal;
        wild.velocity_curve = f64::NEG_INFINITY;
        wild.bend_range_semitones = f64::NAN;
        wild.member_bend_range_semitones = 1e9;
        wild.assignments[2].depth = -3.0;
        let sane = wild.sane();
        assert_eq!(sane.velocity_curve, -1.0);
        assert_eq!(sane.bend_range_semitones, 2.0);
        assert_eq!(sane.member_bend_range_semitones, 96.0);
        assert_eq!(sane.assignments[2].depth, -1.0);
        assert_eq!(normal.sane(), normal);
    }
}
