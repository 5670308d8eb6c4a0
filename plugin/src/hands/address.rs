//! Which note an event is about.

/// A note as the host names it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Note {
    /// MIDI channel, 0…15.
    pub channel: u8,
    /// Key, 0…127.
    pub key: u8,
    /// The host's own name for it, if it has one.
    pub id: Option<i32>,
}

/// The notes an event is about; what is none stands for any.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Address {
    /// MIDI channel, 0…15.
    pub channel: Option<u8>,
    /// Key, 0…127.
    pub key: Option<u8>,
    /// The host's own name for the note.
    pub id: Option<i32>,
}

impl Address {
    /// Every note.
    pub const ALL: Self = Self {
        channel: None,
        key: None,
        id: None,
    };

    /// The notes of a key that were struck on a channel.
    #[must_use]
    pub fn key(channel: u8, key: u8) -> Self {
        Self {
            channel: Some(channel),
            key: Some(key),
            id: None,
        }
    }

    /// The note of that name.
    #[must_use]
    pub fn id(id: i32) -> Self {
        Self {
            id: Some(id),
            ..Self::ALL
        }
    }

    /// Whether `note` is one of these; a note without a name answers to any, and channels count modulo
    /// 16.
    #[must_use]
    pub fn means(&self, note: &Note) -> bool {
        let same_id = self.id.is_none() || note.id.is_none() || self.id == note.id;
        same_id
            && self
                .channel
                .is_none_or(|channel| channel & 15 == note.channel & 15)
            && self.key.is_none_or(|key| key == note.key)
    }
}

impl From<Note> for Address {
    fn from(note: Note) -> Self {
        Self {
            channel: Some(note.channel),
            key: Some(note.key),
            id: note.id,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::{Address, Note};

    #[test]
    fn wildcards_stand_for_any() {
        let note = Note {
            channel: 3,
            key: 60,
            id: Some(7),
        };
        let nameless = Note { id: None, ..note };
        for (address, named, unnamed) in [
            (Address::ALL, true, true),
            (Address::from(note), true, true),
            (Address::key(3, 60), true, true),
            (Address::key(19, 60), true, true),
            (Address::key(2, 60), false, false),
            (Address::key(3, 61), false, false),
            (Address::id(7), true, true),
            (Address::id(8), false, true),
        ] {
            assert_eq!(address.means(&note), named, "{address:?}");
            assert_eq!(address.means(&nameless), unnamed, "{address:?}");
        }
    }
}
