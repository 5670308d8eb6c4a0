//! What a hand can do that moves something.

/// Where an assignment takes its value from.
///
/// A source at rest is 0, so that an untouched controller leaves the instrument as its parameters
/// have it. The numbers never change, or songs lose their assignments.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[repr(u8)]
pub enum Source {
    /// Nothing: the assignment is free.
    #[default]
    Off = 0,
    /// How hard the key was last struck, 0…1, after the velocity curve.
    Velocity = 1,
    /// How fast the key was last let go, −1…1 about the middle (byte 64); 0 while it is down.
    ReleaseVelocity = 2,
    /// CC 1 or the note's vibrato, whichever is more, 0…1.
    ModWheel = 3,
    /// CC 2, 0…1.
    Breath = 4,
    /// CC 4, 0…1.
    Foot = 5,
    /// CC 11 times the note's expression, −1…0: at rest it is full up, and can only take away.
    Expression = 6,
    /// CC 74 and the note's brightness, −1…1 about the middle.
    Brightness = 7,
    /// Pressure of the channel, of the key or of the note, whichever is most, 0…1.
    Pressure = 8,
    /// CC 67, 0…1.
    SoftPedal = 9,
    /// Place on the keyboard, −1…1: 0 at middle C, the ends four octaves from it.
    Key = 10,
    /// Chance, −1…1, drawn at the strike.
    Random = 11,
}

impl Source {
    /// All, by number.
    pub const ALL: [Self; 12] = [
        Self::Off,
        Self::Velocity,
        Self::ReleaseVelocity,
        Self::ModWheel,
        Self::Breath,
        Self::Foot,
        Self::Expression,
        Self::Brightness,
        Self::Pressure,
        Self::SoftPedal,
        Self::Key,
        Self::Random,
    ];

    /// Its number.
    #[must_use]
    pub fn index(self) -> usize {
        self as usize
    }

    /// The source of that number; [`Self::Off`] if there is none.
    #[must_use]
    pub fn from_index(index: usize) -> Self {
        Self::ALL.get(index).copied().unwrap_or_default()
    }

    /// Its name in the host.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Off => "off",
            Self::Velocity => "velocity",
            Self::ReleaseVelocity => "release velocity",
            Self::ModWheel => "mod wheel (CC 1)",
            Self::Breath => "breath (CC 2)",
            Self::Foot => "foot pedal (CC 4)",
            Self::Expression => "expression (CC 11)",
            Self::Brightness => "brightness (CC 74)",
            Self::Pressure => "pressure",
            Self::SoftPedal => "soft pedal (CC 67)",
            Self::Key => "key",
            Self::Random => "random",
        }
    }
}

/// The value of every source, for one key.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct Values([f64; Source::ALL.len()]);

impl Values {
    pub(super) fn set(&mut self, source: Source, value: f64) {
        self.0[source.index()] = value;
    }

    pub(super) fn get(&self, source: Source) -> f64 {
        self.0[source.index()]
    }
}

#[cfg(test)]
mod tests {
    use super::Source;
    use std::collections::HashSet;

    #[test]
    fn numbers_and_names_are_one_to_one() {
        for (index, source) in Source::ALL.into_iter().enumerate() {
            assert_eq!(source.index(), index);
            assert_eq!(Source::from_index(index), source);
        }
        assert_eq!(Source::from_index(99), Source::Off);
        let names: HashSet<_> = Source::ALL.map(Source::name).into_iter().collect();
        assert_eq!(names.len(), Source::ALL.len());
    }
}
