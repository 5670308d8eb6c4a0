//! What a host sends a plug-in, and when.

use super::ParamId;
use clack_host::events::event_types::{
    MidiEvent, NoteChokeEvent, NoteExpressionEvent, NoteExpressionType, NoteOffEvent, NoteOnEvent,
    ParamModEvent, ParamValueEvent, TransportEvent, TransportFlags,
};
use clack_host::events::{EventFlags, EventHeader, Match, UnknownEvent};
use clack_host::prelude::{EventBuffer, Pckn};
use clack_host::utils::{BeatTime, SecondsTime};
use std::{ptr, slice};

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
    /// A key goes down, in an event that says it has `size` bytes, true or not.
    Misformed {
        /// MIDI key, 0…127.
        key: u8,
        /// In bytes.
        size: u32,
    },
    /// Something is said of one note.
    Expression {
        /// What.
        kind: NoteExpressionType,
        /// The note's identity.
        note_id: u32,
        /// In CLAP's unit of that kind.
        value: f64,
    },
    /// A parameter is modulated for one note.
    Modulation {
        /// Which parameter.
        id: ParamId,
        /// The note's identity.
        note_id: u32,
        /// How far, on the plug-in's own scale.
        amount: f64,
    },
    /// A raw MIDI message: controllers, pitch bend, pressure.
    Midi([u8; 3]),
    /// The song starts, stops or jumps.
    Transport {
        /// Whether it plays.
        playing: bool,
        /// Quarter notes to the minute.
        tempo_bpm: f64,
        /// Where it is, in s.
        seconds: f64,
    },
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
                Pckn::new(0u16, u16::from(channel), u16::from(key), Match::All),
            )),
            Self::Misformed { key, size } => {
                let event = NoteOnEvent::new(time, one(0, key, u32::from(key)), 1.0);
                misform(event, size, buffer);
            }
            Self::Expression {
                kind,
                note_id,
                value,
            } => buffer.push(&NoteExpressionEvent::new(time, of(note_id), kind, value)),
            Self::Modulation {
                id,
                note_id,
                amount,
            } => buffer.push(&ParamModEvent::new(time, id.0, of(note_id), amount)),
            Self::Midi(bytes) => buffer.push(&MidiEvent::new(time, 0, bytes)),
            Self::Transport {
                playing,
                tempo_bpm,
                seconds,
            } => buffer.push(&transport(time, playing, tempo_bpm, seconds)),
            Self::Param { id, value } => {
                buffer.push(&ParamValueEvent::new(time, id.0, Pckn::match_all(), value));
            }
        }
    }
}

/// The note of that identity, on whatever channel and key.
fn of(note_id: u32) -> Pckn {
    Pckn::new(Match::All, Match::All, Match::All, note_id)
}

fn misform(mut event: NoteOnEvent, size: u32, buffer: &mut EventBuffer) {
    // SAFETY: an event begins with its size, and all its bytes are there whatever that says.
    #[expect(unsafe_code, reason = "no safe call makes such an event")]
    unsafe {
        let length = size_of_val(&event);
        let bytes = slice::from_raw_parts_mut(ptr::from_mut(&mut event).cast::<u8>(), length);
        bytes[..4].copy_from_slice(&size.to_ne_bytes());
        buffer.push(UnknownEvent::from_bytes_unchecked(bytes));
    }
}

fn transport(time: u32, playing: bool, tempo_bpm: f64, seconds: f64) -> TransportEvent {
    let mut flags = TransportFlags::HAS_TEMPO
        | TransportFlags::HAS_BEATS_TIMELINE
        | TransportFlags::HAS_SECONDS_TIMELINE
        | TransportFlags::HAS_TIME_SIGNATURE;
    flags.set(TransportFlags::IS_PLAYING, playing);
    let beats = seconds * tempo_bpm / 60.0;
    TransportEvent {
        header: EventHeader::new_core(time, EventFlags::empty()),
        flags,
        song_pos_beats: BeatTime::from_float(beats),
        song_pos_seconds: SecondsTime::from_float(seconds),
        tempo: tempo_bpm,
        tempo_inc: 0.0,
        loop_start_beats: BeatTime::from_float(0.0),
        loop_end_beats: BeatTime::from_float(0.0),
        loop_start_seconds: SecondsTime::from_float(0.0),
        loop_end_seconds: SecondsTime::from_float(0.0),
        bar_start: BeatTime::from_float(4.0 * (beats / 4.0).floor()),
        bar_number: (beats / 4.0) as i32,
        time_signature_numerator: 4,
        time_signature_denominator: 4,
    }
}
