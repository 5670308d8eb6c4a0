//! Which host notes wait to hear that their body has come to rest.

use nice_plug::midi::{Channel, Key, VoiceID};

/// A note as the host named it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Note {
    pub(crate) voice_id: VoiceID,
    pub(crate) channel: Channel,
    pub(crate) key: u8,
}

/// The last note of each key, until its body rests.
#[derive(Debug)]
pub(crate) struct Notes {
    slots: [Option<Note>; 128],
    waiting: u128,
}

impl Notes {
    pub(crate) fn new() -> Self {
        Self {
            slots: [None; 128],
            waiting: 0,
        }
    }

    /// A note takes over its key 0…127; the one that had it before, if any.
    pub(crate) fn begin(&mut self, note: Note) -> Option<Note> {
        self.waiting |= 1 << (note.key & 127);
        self.slots[usize::from(note.key & 127)].replace(note)
    }

    /// A note that waits though its key's bit in `sounding` is not set; it waits no longer.
    pub(crate) fn end_one(&mut self, sounding: u128) -> Option<Note> {
        let ended = self.waiting & !sounding;
        if ended == 0 {
            return None;
        }
        let key = ended.trailing_zeros();
        self.waiting &= !(1 << key);
        self.slots[key as usize].take()
    }

    /// The keys whose notes wait, as bits.
    pub(crate) fn waiting(&self) -> u128 {
        self.waiting
    }

    /// The channel of a key's last note, if it waits.
    pub(crate) fn channel(&self, key: u8) -> Option<Channel> {
        self.slots[usize::from(key & 127)].map(|note| note.channel)
    }

    /// The keys that an event with this address is about, as bits.
    ///
    /// A note-off for a note whose key another note has taken over is about none.
    pub(crate) fn addressed(&self, voice_id: VoiceID, channel: Channel, key: Key) -> u128 {
        let all = match key {
            Key::Number(key) => 1u128.checked_shl(key.into()).unwrap_or(0),
            Key::Wildcard => u128::MAX,
        };
        let meant = |slot: &Option<Note>| {
            slot.is_none_or(|note| {
                let same_voice = match (voice_id, note.voice_id) {
                    (VoiceID::ID(a), VoiceID::ID(b)) => a == b,
                    _ => true,
                };
                let same_channel = match (channel, note.channel) {
                    (Channel::Number(a), Channel::Number(b)) => a == b,
                    _ => true,
                };
                same_voice && same_channel
            })
        };
        self.slots
            .iter()
            .enumerate()
            .filter(|(_, slot)| meant(slot))
            .fold(0, |keys, (key, _)| keys | 1 << key)
            & all
    }
}

/// The keys whose bits are set, from the lowest.
pub(crate) fn each(mut keys: u128) -> impl Iterator<Item = u8> {
    std::iter::from_fn(move || {
        let key = u8::try_from(keys.trailing_zeros()).ok()?;
        keys &= keys.wrapping_sub(1);
        (key < 128).then_some(key)
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn note(id: i32, key: u8) -> Note {
        Note {
            voice_id: VoiceID::ID(id),
            channel: Channel::Number(0),
            key,
        }
    }

    #[test]
    fn notes_end_when_their_bodies_rest() {
        let mut notes = Notes::new();
        assert_eq!(notes.begin(note(1, 60)), None);
        assert_eq!(notes.begin(note(2, 72)), None);
        assert_eq!(notes.begin(note(3, 60)), Some(note(1, 60)));
        assert_eq!(notes.end_one(u128::MAX), None);
        assert_eq!(notes.end_one(1 << 60), Some(note(2, 72)));
        assert_eq!(notes.end_one(0), Some(note(3, 60)));
        assert_eq!(notes.end_one(0), None);
    }

    #[test]
    fn a_note_that_lost_its_key_is_not_addressed() {
        let mut notes = Notes::new();
        notes.begin(note(1, 60));
        notes.begin(note(2, 60));
        let channel = Channel::Number(0);
        let key = Key::Number(60);
        assert_eq!(notes.addressed(VoiceID::ID(1), channel, key), 0);
        assert_eq!(notes.addressed(VoiceID::ID(2), channel, key), 1 << 60);
        assert_eq!(notes.addressed(VoiceID::Wildcard, channel, key), 1 << 60);
        assert_eq!(
            notes.addressed(VoiceID::Wildcard, Channel::Wildcard, Key::Wildcard),
            u128::MAX
        );
        assert_eq!(
            notes.addressed(VoiceID::Wildcard, Channel::Number(5), key),
            0
        );
    }
}
