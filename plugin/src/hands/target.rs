//! What a hand can move.

/// What an assignment moves, and how far at full depth: its span.
///
/// The numbers never change, or songs lose their assignments.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[repr(u8)]
pub enum Target {
    /// Loudness of what rings, by General MIDI 2's law for CC 11 (§3.3.6, 40 dB a decade): −1 is
    /// silence, −½ is −12 dB, +1 is +12 dB. Several multiply.
    #[default]
    Level = 0,
    /// Pitch of what rings: an octave, the width of a hand.
    Bend = 1,
    /// Place between left and right, the whole way.
    Pan = 2,
    /// A hand on the body, quadratic in how firm: full takes 60 dB in 60 ms, as a choke does, a half in
    /// a quarter of a second, as a hand laid on, a tenth in 6 s. Below 0 there is no hand.
    HandDamping = 3,
    /// Weight of the felt that falls on a released key: a quarter to four times.
    DamperFirmness = 4,
    /// Where the next strike lands: half the line, from the middle to either end.
    StrikePosition = 5,
    /// Modulus of the next mallet's head: two of the five decades from yarn to brass.
    Hardness = 6,
    /// Mass of the next mallet: two octaves, from 30 g to 7.5 g or 120 g.
    MalletMass = 7,
    /// How hard the bow presses: the whole of its range.
    BowPressure = 8,
    /// How fast the bow goes: two octaves.
    BowSpeed = 9,
    /// How fast the motor turns: the whole of its range.
    MotorSpeed = 10,
    /// How much of the tubes' mouths the motor's discs cover: all of it.
    MotorDepth = 11,
    /// How far away the listener is: two octaves, 12 dB.
    ListenerDistance = 12,
}

/// Semitones of [`Target::Bend`].
pub(super) const BEND_SEMITONES: f64 = 12.0;
/// Decay rate of [`Target::HandDamping`], in 1/s: 60 dB in 60 ms.
pub(super) const HAND_PER_S: f64 = 115.129_254_649_702_28;
/// Octaves of [`Target::DamperFirmness`].
pub(super) const FIRMNESS_OCTAVES: f64 = 2.0;
/// Share of the line of [`Target::StrikePosition`].
pub(super) const POSITION: f64 = 0.5;
/// Decades of [`Target::Hardness`].
pub(super) const HARDNESS_DECADES: f64 = 2.0;
/// Octaves of [`Target::MalletMass`].
pub(super) const MASS_OCTAVES: f64 = 2.0;
/// Octaves of [`Target::BowSpeed`].
pub(super) const BOW_OCTAVES: f64 = 2.0;
/// Hz of [`Target::MotorSpeed`].
pub(super) const MOTOR_HZ: f64 = 12.0;
/// Octaves of [`Target::ListenerDistance`].
pub(super) const DISTANCE_OCTAVES: f64 = 2.0;

impl Target {
    /// All, by number.
    pub const ALL: [Self; 13] = [
        Self::Level,
        Self::Bend,
        Self::Pan,
        Self::HandDamping,
        Self::DamperFirmness,
        Self::StrikePosition,
        Self::Hardness,
        Self::MalletMass,
        Self::BowPressure,
        Self::BowSpeed,
        Self::MotorSpeed,
        Self::MotorDepth,
        Self::ListenerDistance,
    ];

    /// Its number.
    #[must_use]
    pub fn index(self) -> usize {
        self as usize
    }

    /// The target of that number; [`Self::Level`] if there is none.
    #[must_use]
    pub fn from_index(index: usize) -> Self {
        Self::ALL.get(index).copied().unwrap_or_default()
    }

    /// Its name in the host.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Level => "level",
            Self::Bend => "bend",
            Self::Pan => "pan",
            Self::HandDamping => "hand damping",
            Self::DamperFirmness => "damper firmness",
            Self::StrikePosition => "strike position",
            Self::Hardness => "mallet hardness",
            Self::MalletMass => "mallet mass",
            Self::BowPressure => "bow pressure",
            Self::BowSpeed => "bow speed",
            Self::MotorSpeed => "motor speed",
            Self::MotorDepth => "motor depth",
            Self::ListenerDistance => "listener distance",
        }
    }

    /// What full depth does, in words: `+-12 semitones`.
    #[must_use]
    pub fn span(self) -> &'static str {
        match self {
            Self::Level => "silence to +12 dB",
            Self::Bend => "+-12 semitones",
            Self::Pan => "left to right",
            Self::HandDamping => "up to 60 dB in 60 ms",
            Self::DamperFirmness | Self::MalletMass | Self::BowSpeed | Self::ListenerDistance => {
                "a quarter to four times"
            }
            Self::StrikePosition => "+-50 % of the length",
            Self::Hardness => "a hundredth to a hundred times",
            Self::BowPressure | Self::MotorDepth => "+-100 %",
            Self::MotorSpeed => "+-12 Hz",
        }
    }
}

#[cfg(test)]
mod tests {
    use super::{HAND_PER_S, Target};
    use std::collections::HashSet;

    #[test]
    fn numbers_and_names_are_one_to_one() {
        for (index, target) in Target::ALL.into_iter().enumerate() {
            assert_eq!(target.index(), index);
            assert_eq!(Target::from_index(index), target);
            assert!(!target.span().is_empty());
        }
        assert_eq!(Target::from_index(13), Target::Level);
        let names: HashSet<_> = Target::ALL.map(Target::name).into_iter().collect();
        assert_eq!(names.len(), Target::ALL.len());
    }

    #[test]
    fn a_hand_takes_the_stated_times() {
        let t60_s = |firm: f64| modes::t60_s(HAND_PER_S * firm * firm);
        assert!((t60_s(1.0) - 0.06).abs() < 1e-12);
        assert!((t60_s(0.5) - 0.24).abs() < 1e-12);
        assert!((t60_s(0.1) - 6.0).abs() < 1e-9);
    }
}
