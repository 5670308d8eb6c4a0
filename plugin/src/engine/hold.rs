//! What a player's hands do to one body while it sounds.

/// Bend, level, place, dampers and bow of one key.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Hold {
    /// Pitch beside the body's own, in semitones.
    pub bend_semitones: f64,
    /// Gain, 0…4.
    pub level: f64,
    /// −1 left, 1 right: takes the other ear away.
    pub pan: f64,
    /// The damper on the body over its weight as built, 0…4; counts if note-off damps.
    pub felt: f64,
    /// Decay rate that a hand adds, in 1/s; below 0 it takes at most what Alpha 2 adds.
    pub hand_per_s: f64,
    /// How firmly a bow or a stick rubs, 0…1.
    pub bow_pressure: f64,
    /// How fast it moves beside the usual speed, in octaves.
    pub bow_speed_octaves: f64,
}

impl Default for Hold {
    fn default() -> Self {
        Self::FREE
    }
}

impl Hold {
    /// Hands off.
    pub const FREE: Self = Self {
        bend_semitones: 0.0,
        level: 1.0,
        pan: 0.0,
        felt: 0.0,
        hand_per_s: 0.0,
        bow_pressure: 0.0,
        bow_speed_octaves: 0.0,
    };

    /// The same with every value in its range, and what is not a number as when hands are off.
    #[must_use]
    pub fn sane(self) -> Self {
        let within = |value: f64, low: f64, high: f64, free: f64| {
            if value.is_nan() {
                free
            } else {
                value.clamp(low, high)
            }
        };
        Self {
            bend_semitones: within(self.bend_semitones, -120.0, 120.0, 0.0),
            level: within(self.level, 0.0, 4.0, 1.0),
            pan: within(self.pan, -1.0, 1.0, 0.0),
            felt: within(self.felt, 0.0, 4.0, 0.0),
            hand_per_s: within(self.hand_per_s, -1e4, 1e4, 0.0),
            bow_pressure: within(self.bow_pressure, 0.0, 1.0, 0.0),
            bow_speed_octaves: within(self.bow_speed_octaves, -4.0, 4.0, 0.0),
        }
    }
}

/// A blow as hands and controllers make it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Hit {
    /// 0…1.
    pub velocity: f64,
    /// How far from the set position, in parts of the line.
    pub position: f64,
    /// How far from the set place across, in parts of the width or of the way around.
    pub across: f64,
    /// How much harder than the set mallet, in powers of ten.
    pub hardness_decades: f64,
    /// How much heavier than the set mallet, in powers of two.
    pub mass_octaves: f64,
    /// The MIDI channel it comes on, 0…15.
    pub channel: u8,
}

impl Hit {
    /// A blow with the mallet as it is set.
    #[must_use]
    pub const fn plain(velocity: f64) -> Self {
        Self {
            velocity,
            position: 0.0,
            across: 0.0,
            hardness_decades: 0.0,
            mass_octaves: 0.0,
            channel: 0,
        }
    }

    /// The same with every value in its range, and what is not a number as in a plain blow.
    #[must_use]
    pub fn sane(self) -> Self {
        let within = |value: f64, most: f64| {
            if value.is_nan() {
                0.0
            } else {
                value.clamp(-most, most)
            }
        };
        Self {
            velocity: within(self.velocity, 1.0).max(0.0),
            position: within(self.position, 1.0),
            across: within(self.across, 1.0),
            hardness_decades: within(self.hardness_decades, 5.0),
            mass_octaves: within(self.mass_octaves, 8.0),
            channel: self.channel.min(15),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::{Hit, Hold};

    #[test]
    fn nonsense_is_tamed() {
        let wild = Hold {
            bend_semitones: f64::NAN,
            level: -1.0,
            hand_per_s: f64::INFINITY,
            ..Hold::FREE
        };
        let sane = wild.sane();
        assert_eq!((sane.bend_semitones, sane.level), (0.0, 0.0));
        assert_eq!(sane.hand_per_s, 1e4);
        assert_eq!(Hold::FREE.sane(), Hold::FREE);
        let hit = Hit {
            position: f64::NEG_INFINITY,
            ..Hit::plain(f64::NAN)
        };
        assert_eq!(hit.sane().velocity, 0.0);
        assert_eq!(hit.sane().position, -1.0);
    }
}
