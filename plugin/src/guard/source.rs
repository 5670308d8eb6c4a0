//! A host's list of events.

#![expect(unsafe_code, reason = "a host's list is a pair of functions")]

use super::{Event, Fate};
use clap_sys::events::{clap_event_header, clap_input_events};

/// A list of events as a host hands it over.
#[derive(Clone, Copy)]
pub(super) struct Source<'a>(Option<&'a clap_input_events>);

impl Source<'_> {
    /// The list there; one without events if there is none.
    ///
    /// # Safety
    ///
    /// It is null, or a list whose functions may be called for as long as this is used, and whose
    /// events each are null or have as many bytes as their headers say, the header's own included.
    pub(super) unsafe fn new(list: *const clap_input_events) -> Self {
        let list = list.is_aligned().then_some(list);
        // SAFETY: the caller's.
        Self(list.and_then(|list| unsafe { list.as_ref() }))
    }

    /// How many events there are.
    pub(super) fn len(self) -> u32 {
        self.0
            // SAFETY: the functions may be called.
            .and_then(|list| list.size.map(|size| unsafe { size(list) }))
            .unwrap_or(0)
    }

    fn at(self, index: u32) -> *const clap_event_header {
        self.0
            // SAFETY: the functions may be called.
            .and_then(|list| list.get.map(|get| unsafe { get(list, index) }))
            .unwrap_or(std::ptr::null())
    }

    /// The event of that index, within a block of so many frames; `None` if the framework cannot or
    /// does not read it.
    pub(super) fn event(self, index: u32, frames: u32) -> Option<Event> {
        // SAFETY: events have as many bytes as they say.
        let mut event = unsafe { Event::read(self.at(index)) }?;
        if event.mend() == Fate::Dropped || matches!(event, Event::Other(_)) {
            return None;
        }
        let header = event.header_mut();
        header.time = header.time.min(frames.saturating_sub(1));
        Some(event)
    }

    /// Whether the framework can take the list as it is for a block of so many frames.
    pub(super) fn is_sound(self, frames: u32) -> bool {
        let mut earliest = 0;
        // The framework calls both functions.
        let there = self
            .0
            .is_some_and(|list| list.size.is_some() && list.get.is_some());
        there
            && (0..self.len()).all(|index| {
                let header = self.at(index);
                // SAFETY: events have as many bytes as they say.
                let Some(mut event) = (unsafe { Event::read(header) }) else {
                    return false;
                };
                let time = event.header_mut().time;
                let due = (earliest..frames).contains(&time);
                earliest = time;
                // The framework looks at events through references.
                due && header.addr().is_multiple_of(event.alignment())
                    && event.mend() == Fate::Sound
            })
    }
}

#[cfg(test)]
pub(super) mod tests {
    use super::super::List;
    use super::*;
    use clap_sys::events::{
        CLAP_EVENT_MIDI, CLAP_EVENT_MIDI_SYSEX, CLAP_EVENT_NOTE_EXPRESSION, CLAP_EVENT_NOTE_ON,
        CLAP_EVENT_PARAM_VALUE, CLAP_EVENT_TRANSPORT, CLAP_TRANSPORT_HAS_TEMPO, clap_event_midi,
        clap_event_midi_sysex, clap_event_note, clap_event_note_expression, clap_event_param_value,
        clap_event_transport,
    };

    fn header<T>(time: u32, type_: u16) -> clap_event_header {
        clap_event_header {
            size: size_of::<T>() as u32,
            time,
            space_id: 0,
            type_,
            flags: 0,
        }
    }

    pub(crate) fn note(time: u32, channel: i16, key: i16, velocity: f64) -> Event {
        Event::Note(clap_event_note {
            header: header::<clap_event_note>(time, CLAP_EVENT_NOTE_ON),
            note_id: 1,
            port_index: 0,
            channel,
            key,
            velocity,
        })
    }

    pub(crate) fn expression(time: u32, expression_id: i32, value: f64) -> Event {
        Event::Expression(clap_event_note_expression {
            header: header::<clap_event_note_expression>(time, CLAP_EVENT_NOTE_EXPRESSION),
            expression_id,
            note_id: 1,
            port_index: 0,
            channel: 0,
            key: 60,
            value,
        })
    }

    pub(crate) fn value(time: u32, value: f64) -> Event {
        Event::Value(clap_event_param_value {
            header: header::<clap_event_param_value>(time, CLAP_EVENT_PARAM_VALUE),
            param_id: 1,
            cookie: std::ptr::null_mut(),
            note_id: -1,
            port_index: -1,
            channel: -1,
            key: -1,
            value,
        })
    }

    pub(crate) fn midi(time: u32, data: [u8; 3]) -> Event {
        Event::Midi(clap_event_midi {
            header: header::<clap_event_midi>(time, CLAP_EVENT_MIDI),
            port_index: 0,
            data,
        })
    }

    pub(crate) fn sysex(time: u32, buffer: *const u8) -> Event {
        Event::Sysex(clap_event_midi_sysex {
            header: header::<clap_event_midi_sysex>(time, CLAP_EVENT_MIDI_SYSEX),
            port_index: 0,
            buffer,
            size: 2,
        })
    }

    pub(crate) fn tempo(time: u32, tempo: f64) -> Event {
        Event::Transport(clap_event_transport {
            header: header::<clap_event_transport>(time, CLAP_EVENT_TRANSPORT),
            flags: CLAP_TRANSPORT_HAS_TEMPO,
            song_pos_beats: 0,
            song_pos_seconds: 0,
            tempo,
            tempo_inc: 0.0,
            loop_start_beats: 0,
            loop_end_beats: 0,
            loop_start_seconds: 0,
            loop_end_seconds: 0,
            bar_start: 0,
            bar_number: 0,
            tsig_num: 4,
            tsig_denom: 4,
        })
    }

    /// A host with a list of events.
    pub(crate) struct Host {
        events: Vec<Event>,
        list: clap_input_events,
    }

    impl Host {
        pub(crate) fn new(events: Vec<Event>) -> Box<Self> {
            let list = clap_input_events {
                ctx: std::ptr::null_mut(),
                size: Some(size),
                get: Some(get),
            };
            let mut host = Box::new(Self { events, list });
            host.list.ctx = std::ptr::from_mut(&mut *host).cast();
            host
        }

        pub(crate) fn source(&self) -> Source<'_> {
            Source(Some(&self.list))
        }
    }

    unsafe extern "C" fn size(list: *const clap_input_events) -> u32 {
        // SAFETY: the context is a host.
        let host = unsafe { &*(*list).ctx.cast::<Host>() };
        host.events.len() as u32
    }

    unsafe extern "C" fn get(
        list: *const clap_input_events,
        index: u32,
    ) -> *const clap_event_header {
        // SAFETY: the context is a host.
        let host = unsafe { &*(*list).ctx.cast::<Host>() };
        host.events
            .get(index as usize)
            .map_or(std::ptr::null(), Event::as_ptr)
    }

    /// Times and keys of what the framework reads in a list; a parameter has key −1.
    pub(crate) fn seen(list: &mut List<'_>) -> Vec<(u32, i16)> {
        let list = list.as_clap();
        // SAFETY: the list is good.
        let source = unsafe { Source::new(&raw const list) };
        (0..source.len())
            .filter_map(|index| {
                let mut event = source.event(index, u32::MAX)?;
                let time = event.header_mut().time;
                match event {
                    Event::Note(note) => Some((time, note.key)),
                    _ => Some((time, -1)),
                }
            })
            .collect()
    }

    fn is_sound(events: Vec<Event>, frames: u32) -> bool {
        Host::new(events).source().is_sound(frames)
    }

    #[test]
    fn a_list_in_order_passes() {
        let events = vec![
            note(0, 0, 60, 0.5),
            value(0, 0.5),
            Event::nothing(5),
            midi(63, [0x80, 60, 0]),
        ];
        assert!(is_sound(events.clone(), 64));
        assert!(!is_sound(events, 63));
        assert!(is_sound(vec![], 0));
        assert!(!is_sound(vec![note(0, 0, 60, 0.5)], 0));
        assert!(!is_sound(vec![value(5, 0.5), Event::nothing(4)], 64));
        assert!(!is_sound(vec![note(0, 0, 60, f64::NAN)], 64));
        assert!(!is_sound(vec![note(0, 0, 128, 0.5)], 64));
    }

    #[test]
    fn an_event_shorter_than_its_type_is_none() {
        let whole = [
            note(0, 0, 60, 0.5),
            expression(0, 1, 0.5),
            value(0, 0.5),
            midi(0, [0x90, 60, 100]),
            sysex(0, [0xF0, 0xF7].as_ptr()),
            tempo(0, 120.0),
            Event::nothing(0),
        ];
        for mut event in whole {
            let size = event.header_mut().size;
            assert!(is_sound(vec![event], 1));
            for size in [0, 15, size - 1] {
                event.header_mut().size = size;
                let host = Host::new(vec![event]);
                assert!(!host.source().is_sound(1), "{event:?}");
                assert!(host.source().event(0, 0).is_none(), "{event:?}");
            }
        }
    }

    #[test]
    fn no_list_is_an_empty_one() {
        // SAFETY: it is null.
        let none = unsafe { Source::new(std::ptr::null()) };
        assert_eq!(none.len(), 0);
        assert!(none.event(0, 0).is_none());
        assert!(!none.is_sound(64), "the framework is to have one");
    }
}
