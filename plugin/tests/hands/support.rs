//! Ways to play.

use idiophone::hands::{Address, Assignment, Hands, Note, SLOTS, Settings, Source, Target};

/// A key of a channel goes down at mezzo-forte.
pub(crate) fn strike(hands: &mut Hands, channel: u8, key: u8) {
    let note = Note {
        channel,
        key,
        id: None,
    };
    hands.note_on(note, 0.5, 0.0);
}

/// It comes up.
pub(crate) fn release(hands: &mut Hands, channel: u8, key: u8) -> u128 {
    hands.note_off(Address::key(channel, key), 64.0 / 127.0)
}

/// Controllers with their bytes.
pub(crate) fn send(hands: &mut Hands, channel: u8, messages: &[(u8, u8)]) {
    for (cc, byte) in messages {
        hands.controller(channel, *cc, f64::from(*byte) / 127.0);
    }
}

/// An MPE configuration message.
pub(crate) fn configure(hands: &mut Hands, channel: u8, members: u8) {
    send(hands, channel, &[(101, 0), (100, 6), (6, members)]);
}

/// The bend of a key, in semitones.
pub(crate) fn bend(hands: &Hands, key: u8) -> f64 {
    hands.key(key).bend_semitones
}

/// Hands with nothing assigned but this, straight and at full depth.
pub(crate) fn assigned(wires: &[(Source, Target)]) -> Hands {
    let mut assignments = [Assignment::FREE; SLOTS];
    for (slot, (source, target)) in assignments.iter_mut().zip(wires) {
        *slot = Assignment {
            source: *source,
            target: *target,
            depth: 1.0,
            curve: 0.0,
        };
    }
    let mut hands = Hands::new();
    hands.set(&Settings {
        assignments,
        ..Settings::default()
    });
    hands
}

/// The keys in a bit set.
pub(crate) fn bits(keys: &[u8]) -> u128 {
    keys.iter().fold(0, |bits, key| bits | 1 << key)
}
