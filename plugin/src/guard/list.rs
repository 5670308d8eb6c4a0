//! A list of events as the framework sees it.

#![expect(unsafe_code, reason = "CLAP's lists are functions over pointers")]

use super::{Event, Source};
use clap_sys::events::{clap_event_header, clap_input_events};
use std::ops::Range;
use std::ptr;

/// Events in the order of their times.
pub(super) struct List<'a> {
    events: &'a [Event],
    /// Times and indices of `events`, in order.
    due: &'a [(u32, u32)],
    source: Source<'a>,
    /// Indices of the source's events that are not among `events`; they come last.
    beyond: Range<u32>,
    /// Where one of those is put.
    spare: Event,
    /// The time before which none of those may come.
    earliest: u32,
    frames: u32,
}

impl<'a> List<'a> {
    /// `events` as they are `due`, then those of `source` with indices `beyond`, in a block of
    /// so many frames.
    pub(super) fn new(
        events: &'a [Event],
        due: &'a [(u32, u32)],
        source: Source<'a>,
        beyond: Range<u32>,
        frames: u32,
    ) -> Self {
        Self {
            events,
            due,
            source,
            beyond,
            spare: Event::nothing(0),
            earliest: due.last().map_or(0, |(time, _)| *time),
            frames,
        }
    }

    /// As CLAP has it, for as long as nothing else is done with it.
    pub(super) fn as_clap(&mut self) -> clap_input_events {
        clap_input_events {
            ctx: ptr::from_mut(self).cast(),
            size: Some(size),
            get: Some(get),
        }
    }

    fn get(&mut self, index: usize) -> *const clap_event_header {
        if let Some((_, index)) = self.due.get(index) {
            return self.events[*index as usize].as_ptr();
        }
        let index = u32::try_from(index - self.due.len()).unwrap_or(u32::MAX);
        let index = self.beyond.start.saturating_add(index);
        self.spare = match self.source.event(index, self.frames) {
            Some(mut event) if self.fits(&event) => {
                let header = event.header_mut();
                header.time = header.time.max(self.earliest);
                self.earliest = header.time;
                event
            }
            _ => Event::nothing(self.earliest),
        };
        self.spare.as_ptr()
    }

    /// Whether the framework can have it from the spare place.
    const fn fits(&self, event: &Event) -> bool {
        match event {
            // It keeps one for longer.
            Event::Transport(_) => false,
            _ => self.frames > 0 || !event.waits(),
        }
    }
}

unsafe extern "C" fn size(list: *const clap_input_events) -> u32 {
    // SAFETY: the context is a list.
    let list = unsafe { &*(*list).ctx.cast::<List<'_>>() };
    let due = u32::try_from(list.due.len()).unwrap_or(u32::MAX);
    due.saturating_add(list.beyond.end - list.beyond.start)
}

unsafe extern "C" fn get(list: *const clap_input_events, index: u32) -> *const clap_event_header {
    // SAFETY: the context is a list that nobody else uses.
    let list = unsafe { &mut *(*list).ctx.cast::<List<'_>>() };
    list.get(index as usize)
}
