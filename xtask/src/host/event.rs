//! What a host sends a plug-in, and when.

use super::ParamId;
use clack_host::events::event_types::{
    MidiEvent, NoteChokeEvent, NoteOffEvent, NoteOnEvent, ParamValueEvent,
};
use clack_host::prelude::{EventBuffer, Pckn};

/// Something that happens to an instrument.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Event {
    /// A key goes down.
    NoteOn {
        /// MIDI channel, 0…15.
        channel: u8,
        /// MIDI key, 0…127.
        key: u8,
        /// Tells this note from others of the same key.
        note_id: u32,
        /// 0…1.
        velocity: f64,
    },
    /// A key comes up.
    NoteOff {
        /// MIDI channel, 0…15.
        channel: u8,
        /// MIDI key, 0…127.
        key: u8,
        /// The note's identity.
        note_id: u32,
        /// Release velocity, 0…1.
        velocity: f64,
    },
    /// A key is silenced at once.
    Choke {
        /// MIDI channel, 0…15.
        channel: u8,
        /// MIDI key, 0…127.
        key: u8,
    },
    /// A raw MIDI message: controllers, pitch bend, pressure.
    Midi([u8; 3]),
    /// A parameter takes a value, on the plug-in's own scale.
    Param {
        /// Which parameter.
        id: ParamId,
        /// The new value.
        value: f64,
    },
}

/// An event and its frame, counted from the start of the block or of the take.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TimedEvent {
    /// Frame at which it happens.
    pub frame: u64,
    /// What happens.
    pub event: Event,
}

impl Event {
    /// This event at `frame`.
    #[must_use]
    pub fn at(self, frame: u64) -> TimedEvent {
        TimedEvent { frame, event: self }
    }

    /// A controller message on the first channel.
    #[must_use]
    pub fn controller(number: u8, value: u8) -> Self {
        Self::Midi([0xB0, number, value])
    }

    pub(super) fn push(&self, time: u32, buffer: &mut EventBuffer) {
        let one = |channel: u8, key: u8, note_id: u32| {
            Pckn::new(0u16, u16::from(channel), u16::from(key), note_id)
        };
        match *self {
            Self::NoteOn {
                channel,
                key,
                note_id,
                velocity,
            } => buffer.push(&NoteOnEvent::new(
                time,
                one(channel, key, note_id),
                velocity,
            )),
            Self::NoteOff {
                channel,
                key,
                note_id,
                velocity,
            } => buffer.push(&NoteOffEvent::new(
                time,
                one(channel, key, note_id),
                velocity,
            )),
            Self::Choke { channel, key } => buffer.push(&NoteChokeEvent::new(
                time,
                Pckn::new(
                    0u16,
                    u16::from(channel),
                    u16::from(key),
                    clack_host::events::Match::All,
                ),
            )),
            Self::Midi(bytes) => buffer.push(&MidiEvent::new(time, 0, bytes)),
            Self::Param { id, value } => {
                buffer.push(&ParamValueEvent::new(time, id.0, Pckn::match_all(), value));
            }
        }
    }
}
