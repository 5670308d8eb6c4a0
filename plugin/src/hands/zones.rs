//! MPE zones: which channels carry one note each, and which speak for them all.
//!
//! MIDI Polyphonic Expression 1.0, MMA/AMEI RP-053 (2018); 1.1 is M1-100-UM.

/// When MPE is understood.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[repr(u8)]
pub enum Mpe {
    /// Never: every channel is an ordinary one.
    Off = 0,
    /// From the first MPE configuration message on (RPN 6 on channel 1 or 16), as it says.
    #[default]
    Auto = 1,
    /// Always: channel 1 speaks for all, channels 2 to 16 carry one note each.
    Lower = 2,
}

impl Mpe {
    /// All, by number.
    pub const ALL: [Self; 3] = [Self::Off, Self::Auto, Self::Lower];

    /// The choice of that number; [`Self::Auto`] if there is none.
    #[must_use]
    pub fn from_index(index: usize) -> Self {
        Self::ALL.get(index).copied().unwrap_or_default()
    }

    /// Its number.
    #[must_use]
    pub fn index(self) -> usize {
        self as usize
    }

    /// Its name in the host.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Off => "off",
            Self::Auto => "when announced",
            Self::Lower => "always",
        }
    }
}

/// One of the two zones.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Zone {
    /// Manager on channel 1 (0 here), members from 2 upwards.
    Lower,
    /// Manager on channel 16 (15 here), members from 15 downwards.
    Upper,
}

impl Zone {
    /// The channel that speaks for all of it.
    pub(super) fn manager(self) -> u8 {
        match self {
            Self::Lower => 0,
            Self::Upper => 15,
        }
    }

    /// The zone that a configuration message on `channel` is about, if it may come there.
    pub(super) fn managed_by(channel: u8) -> Option<Self> {
        match channel {
            0 => Some(Self::Lower),
            15 => Some(Self::Upper),
            _ => None,
        }
    }
}

/// What a channel is for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Role {
    /// An ordinary channel, on its own.
    Plain,
    /// Speaks for a zone, and may have notes too.
    Manager(Zone),
    /// Carries one note at a time of a zone, if it can.
    Member(Zone),
}

/// Number of member channels of both zones.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(super) struct Zones {
    lower: u8,
    upper: u8,
}

impl Zones {
    /// How an instance with this setting begins.
    pub(super) fn new(mpe: Mpe) -> Self {
        let lower = if mpe == Mpe::Lower { 15 } else { 0 };
        Self { lower, upper: 0 }
    }

    /// Gives a zone `members` 0…15 channels; none shuts it. The last word counts: the other zone loses
    /// the channels that this one takes (§2.1.1).
    pub(super) fn with(self, zone: Zone, members: u8) -> Self {
        let left = |other: u8| match members {
            0 => other,
            _ => other.min(14_u8.saturating_sub(members)),
        };
        match zone {
            Zone::Lower => Self {
                lower: members,
                upper: left(self.upper),
            },
            Zone::Upper => Self {
                lower: left(self.lower),
                upper: members,
            },
        }
    }

    /// What `channel` 0…15 is for.
    pub(super) fn role(self, channel: u8) -> Role {
        let lower = self.lower > 0;
        let upper = self.upper > 0;
        match channel {
            0 if lower => Role::Manager(Zone::Lower),
            15 if upper => Role::Manager(Zone::Upper),
            _ if lower && channel <= self.lower => Role::Member(Zone::Lower),
            _ if upper && channel >= 15 - self.upper => Role::Member(Zone::Upper),
            _ => Role::Plain,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// One letter a channel: M and m for the lower zone's, W and w for the upper's.
    fn picture(zones: Zones) -> String {
        (0..16)
            .map(|channel| match zones.role(channel) {
                Role::Plain => '.',
                Role::Manager(Zone::Lower) => 'M',
                Role::Member(Zone::Lower) => 'm',
                Role::Manager(Zone::Upper) => 'W',
                Role::Member(Zone::Upper) => 'w',
            })
            .collect()
    }

    #[test]
    fn the_last_message_wins_the_channels() {
        let none = Zones::new(Mpe::Auto);
        let both = none.with(Zone::Lower, 7).with(Zone::Upper, 7);
        for (zones, roles) in [
            (none, "................"),
            (Zones::new(Mpe::Off), "................"),
            (Zones::new(Mpe::Lower), "Mmmmmmmmmmmmmmmm"),
            (none.with(Zone::Lower, 1), "Mm.............."),
            (none.with(Zone::Upper, 3), "............wwwW"),
            (none.with(Zone::Upper, 15), "wwwwwwwwwwwwwwwW"),
            (both, "MmmmmmmmwwwwwwwW"),
            (both.with(Zone::Lower, 10), "MmmmmmmmmmmwwwwW"),
            (both.with(Zone::Upper, 12), "MmmwwwwwwwwwwwwW"),
            (both.with(Zone::Lower, 3), "Mmmm....wwwwwwwW"),
            (both.with(Zone::Lower, 14), "Mmmmmmmmmmmmmmm."),
            (both.with(Zone::Lower, 15), "Mmmmmmmmmmmmmmmm"),
            (both.with(Zone::Upper, 14), ".wwwwwwwwwwwwwwW"),
            (both.with(Zone::Lower, 0), "........wwwwwwwW"),
            (
                both.with(Zone::Lower, 0).with(Zone::Upper, 0),
                "................",
            ),
        ] {
            assert_eq!(picture(zones), roles);
        }
    }

    #[test]
    fn only_the_outer_channels_configure() {
        assert_eq!(Zone::managed_by(0), Some(Zone::Lower));
        assert_eq!(Zone::managed_by(15), Some(Zone::Upper));
        assert!((1..15).all(|channel| Zone::managed_by(channel).is_none()));
    }

    #[test]
    fn numbers_are_those_of_the_list() {
        for (index, mpe) in Mpe::ALL.into_iter().enumerate() {
            assert_eq!((mpe.index(), Mpe::from_index(index)), (index, mpe));
        }
        assert_eq!(Mpe::from_index(3), Mpe::Auto);
    }
}
