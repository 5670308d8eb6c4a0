//! CLAP events, copied out of memory that may not hold what it says.

#![expect(unsafe_code, reason = "a host hands events over as pointers")]

use clap_sys::events::{
    CLAP_CORE_EVENT_SPACE_ID, CLAP_EVENT_MIDI, CLAP_EVENT_MIDI_SYSEX, CLAP_EVENT_NOTE_CHOKE,
    CLAP_EVENT_NOTE_EXPRESSION, CLAP_EVENT_NOTE_OFF, CLAP_EVENT_NOTE_ON, CLAP_EVENT_PARAM_MOD,
    CLAP_EVENT_PARAM_VALUE, CLAP_EVENT_TRANSPORT, clap_event_header, clap_event_midi,
    clap_event_midi_sysex, clap_event_note, clap_event_note_expression, clap_event_param_mod,
    clap_event_param_value, clap_event_transport,
};
use std::ptr;

/// An event.
#[derive(Clone, Copy, Debug)]
pub(super) enum Event {
    /// A note begins, ends or is choked.
    Note(clap_event_note),
    /// A note expression.
    Expression(clap_event_note_expression),
    /// A parameter takes a value.
    Value(clap_event_param_value),
    /// A parameter, or one note's, is modulated.
    Modulation(clap_event_param_mod),
    /// The song moves.
    Transport(clap_event_transport),
    /// Three bytes of MIDI.
    Midi(clap_event_midi),
    /// A system exclusive message, whose bytes stay the host's.
    Sysex(clap_event_midi_sysex),
    /// Any other; the framework reads no more of it than the header.
    Other(clap_event_header),
}

impl Event {
    /// A copy of the event at `header`; `None` without one, or if it is shorter than its type.
    ///
    /// # Safety
    ///
    /// `header` is null, or as many bytes can be read there as the header itself has and as it says.
    pub(super) unsafe fn read(header: *const clap_event_header) -> Option<Self> {
        if header.is_null() {
            return None;
        }
        // SAFETY: a header can be read at all.
        let head = unsafe { header.read_unaligned() };
        // SAFETY: the caller's.
        unsafe {
            let core = head.space_id == CLAP_CORE_EVENT_SPACE_ID;
            match head.type_ {
                CLAP_EVENT_NOTE_ON | CLAP_EVENT_NOTE_OFF | CLAP_EVENT_NOTE_CHOKE if core => {
                    whole(header, head.size).map(Self::Note)
                }
                CLAP_EVENT_NOTE_EXPRESSION if core => {
                    whole(header, head.size).map(Self::Expression)
                }
                CLAP_EVENT_PARAM_VALUE if core => whole(header, head.size).map(Self::Value),
                CLAP_EVENT_PARAM_MOD if core => whole(header, head.size).map(Self::Modulation),
                CLAP_EVENT_TRANSPORT if core => whole(header, head.size).map(Self::Transport),
                CLAP_EVENT_MIDI if core => whole(header, head.size).map(Self::Midi),
                CLAP_EVENT_MIDI_SYSEX if core => whole(header, head.size).map(Self::Sysex),
                _ => whole(header, head.size).map(Self::Other),
            }
        }
    }

    /// An event that says nothing.
    pub(super) const fn nothing(time: u32) -> Self {
        Self::Other(clap_event_header {
            size: size_of::<clap_event_header>() as u32,
            time,
            // CLAP's number for no space at all.
            space_id: u16::MAX,
            type_: 0,
            flags: 0,
        })
    }

    /// What all events begin with.
    pub(super) const fn header_mut(&mut self) -> &mut clap_event_header {
        match self {
            Self::Note(event) => &mut event.header,
            Self::Expression(event) => &mut event.header,
            Self::Value(event) => &mut event.header,
            Self::Modulation(event) => &mut event.header,
            Self::Transport(event) => &mut event.header,
            Self::Midi(event) => &mut event.header,
            Self::Sysex(event) => &mut event.header,
            Self::Other(header) => header,
        }
    }

    /// The whole event as CLAP passes it, good until it is moved or changed.
    pub(super) const fn as_ptr(&self) -> *const clap_event_header {
        match self {
            Self::Note(event) => ptr::from_ref(event).cast(),
            Self::Expression(event) => ptr::from_ref(event).cast(),
            Self::Value(event) => ptr::from_ref(event).cast(),
            Self::Modulation(event) => ptr::from_ref(event).cast(),
            Self::Transport(event) => ptr::from_ref(event).cast(),
            Self::Midi(event) => ptr::from_ref(event).cast(),
            Self::Sysex(event) => ptr::from_ref(event).cast(),
            Self::Other(header) => header,
        }
    }

    /// Its address is a multiple of this, in bytes.
    pub(super) const fn alignment(&self) -> usize {
        match self {
            Self::Midi(_) | Self::Other(_) => align_of::<clap_event_header>(),
            _ => align_of::<clap_event_transport>(),
        }
    }

    /// Whether the framework would lose it in a block of no frames.
    ///
    /// Parameters it sets all the same, and the next block brings its own transport.
    pub(super) const fn waits(&self) -> bool {
        match self {
            Self::Note(_) | Self::Expression(_) | Self::Midi(_) => true,
            Self::Modulation(event) => event.note_id >= 0,
            // The bytes of a message are not ours to keep.
            Self::Sysex(_) | Self::Value(_) | Self::Transport(_) | Self::Other(_) => false,
        }
    }
}

/// A `T` at `header`, unless `size` bytes do not hold one.
///
/// # Safety
///
/// `size` bytes can be read at `header` and `T` is plain data.
unsafe fn whole<T: Copy>(header: *const clap_event_header, size: u32) -> Option<T> {
    // SAFETY: there are that many bytes.
    (size as usize >= size_of::<T>()).then(|| unsafe { header.cast::<T>().read_unaligned() })
}
