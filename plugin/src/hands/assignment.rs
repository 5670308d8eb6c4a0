//! Who moves what: the table of assignments.

use super::tame::bipolar;
use super::{Source, Target};

/// Number of assignments.
pub const SLOTS: usize = 8;

/// One source that moves one target.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Assignment {
    /// What moves.
    pub source: Source,
    /// What is moved.
    pub target: Target,
    /// Share of the target's span that the source's full value moves it, −1…1.
    pub depth: f64,
    /// Bend of the [`super::Curve`] between, −1…1.
    pub curve: f64,
}

const fn straight(source: Source, target: Target, depth: f64) -> Assignment {
    Assignment {
        source,
        target,
        depth,
        curve: 0.0,
    }
}

impl Assignment {
    /// A free slot.
    pub const FREE: Self = straight(Source::Off, Target::Level, 0.0);

    /// What a new instance does. Nothing here is heard before its controller moves.
    ///
    /// - Expression → level is what every host and notation program means by CC 11.
    /// - Brightness → hardness by a decade either way: who slides a finger forward on an MPE surface or
    ///   turns the cutoff knob reaches for a harder mallet. It counts from the next strike.
    /// - Mod wheel → motor speed, 6 Hz at full: pushing the wheel turns the vibraphone's vibrato on and
    ///   up; General MIDI has vibrato there. Bodies without tubes do not change.
    /// - Pressure → bow pressure: the finger that holds a bowl's key is the hand that rubs it. Nothing
    ///   that is struck changes, so that a heavy hand on a keyboard with aftertouch does no harm; who
    ///   plays bars may rather want it on hand damping.
    /// - Mod wheel → bow pressure, for keyboards without aftertouch.
    /// - Soft pedal → hardness, a decade softer: what the piano's felt does.
    /// - Release velocity → damper firmness: a key let go fast drops its felt twice as heavy, one let
    ///   go slowly half as heavy. Keyboards that do not measure it leave it alone.
    pub const DEFAULT: [Self; SLOTS] = [
        straight(Source::Expression, Target::Level, 1.0),
        straight(Source::Brightness, Target::Hardness, 0.5),
        straight(Source::ModWheel, Target::MotorSpeed, 0.5),
        straight(Source::Pressure, Target::BowPressure, 1.0),
        straight(Source::ModWheel, Target::BowPressure, 1.0),
        straight(Source::SoftPedal, Target::Hardness, -0.5),
        straight(Source::ReleaseVelocity, Target::DamperFirmness, 0.5),
        Self::FREE,
    ];

    /// The same with numbers in their ranges, and what is no number at 0.
    #[must_use]
    pub fn sane(self) -> Self {
        Self {
            depth: bipolar(self.depth),
            curve: bipolar(self.curve),
            ..self
        }
    }
}
