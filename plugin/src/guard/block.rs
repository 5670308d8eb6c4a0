//! Blocks, put in order before the framework processes them.

#![expect(unsafe_code, reason = "CLAP's blocks are pointers")]

use super::channels::Channels;
use super::{Desk, Fate, Source, mend};
use clap_sys::events::{clap_event_header, clap_event_transport, clap_output_events};
use clap_sys::plugin::clap_plugin;
use clap_sys::process::{
    CLAP_PROCESS_CONTINUE, CLAP_PROCESS_ERROR, clap_process, clap_process_status,
};
use std::ptr;

/// For hosts that take no events.
static DEAF: clap_output_events = clap_output_events {
    ctx: ptr::null_mut(),
    try_push: Some(refuse),
};

/// What it takes to put blocks in order.
///
/// Only [`Blocks::new`] allocates.
pub(super) struct Blocks {
    desk: Desk,
    channels: Channels,
}

impl Blocks {
    /// For blocks of up to `max_frames`.
    pub(super) fn new(max_frames: u32) -> Self {
        Self {
            desk: Desk::new(),
            channels: Channels::new(max_frames),
        }
    }

    /// Forgets the notes that wait.
    pub(super) fn forget(&mut self) {
        self.desk.clear();
    }

    /// Has the framework's plug-in process a block.
    ///
    /// # Safety
    ///
    /// That of CLAP's `process`, but for pointers that are null and outputs and channels that are too few.
    pub(super) unsafe fn process(
        &mut self,
        inner: *const clap_plugin,
        block: clap_process,
    ) -> clap_process_status {
        // SAFETY: the plug-in lives.
        let Some(process) = (unsafe { (*inner).process }) else {
            return CLAP_PROCESS_ERROR;
        };
        let (Self { desk, channels }, frames) = (self, block.frames_count);
        // SAFETY: the host's outputs, its list and its transport are good for the length of the call.
        let (outputs, events, transport) = unsafe {
            let given = (block.audio_outputs, block.audio_outputs_count);
            (
                without_allocating(|| channels.complete(given.0, given.1, frames)),
                Source::new(block.in_events),
                mended(block.transport),
            )
        };
        let Some(outputs) = outputs else {
            return CLAP_PROCESS_ERROR;
        };
        let block = clap_process {
            transport: transport.as_ref().map_or(block.transport, ptr::from_ref),
            // The plug-in has none.
            audio_inputs: ptr::null(),
            audio_inputs_count: 0,
            audio_outputs: outputs.as_mut_ptr(),
            audio_outputs_count: outputs.len() as u32,
            // SAFETY: the host's list is good for the length of the call.
            out_events: unsafe { hearing(block.out_events) },
            ..block
        };
        let sound = without_allocating(|| events.is_sound(frames));
        if sound && desk.is_clear() {
            // SAFETY: all is in order.
            return unsafe { process(inner, &raw const block) };
        }
        let mut list = without_allocating(|| desk.sort(events, frames));
        let in_events = list.as_clap();
        let block = clap_process {
            in_events: &raw const in_events,
            ..block
        };
        // SAFETY: the list and all else live until the call ends.
        let status = unsafe { process(inner, &raw const block) };
        let waits = without_allocating(|| desk.tidy(frames));
        if waits && status != CLAP_PROCESS_ERROR {
            // The host is not to put to sleep what has notes to play.
            CLAP_PROCESS_CONTINUE
        } else {
            status
        }
    }
}

/// A transport in order, if that there is not.
///
/// # Safety
///
/// There is one, or a null pointer.
unsafe fn mended(there: *const clap_event_transport) -> Option<clap_event_transport> {
    if there.is_null() {
        return None;
    }
    // SAFETY: the caller's.
    let mut transport = unsafe { there.read_unaligned() };
    let sound = mend::transport(&mut transport) == Fate::Sound && there.is_aligned();
    (!sound).then_some(transport)
}

/// The host's list, or one that takes nothing where that cannot be told anything.
///
/// # Safety
///
/// It is null or good for as long as it is used.
pub(super) unsafe fn hearing(list: *const clap_output_events) -> *const clap_output_events {
    // SAFETY: the caller's.
    let hears = list.is_aligned() && unsafe { list.as_ref() }.is_some_and(|l| l.try_push.is_some());
    if hears { list } else { &raw const DEAF }
}

unsafe extern "C" fn refuse(_: *const clap_output_events, _: *const clap_event_header) -> bool {
    false
}

/// Does `work`, which aborts on an allocation wherever the framework's own does.
fn without_allocating<T>(work: impl FnOnce() -> T) -> T {
    #[cfg(all(debug_assertions, feature = "assert_process_allocs"))]
    return nice_assert_no_alloc::assert_no_alloc(work);
    #[cfg(not(all(debug_assertions, feature = "assert_process_allocs")))]
    work()
}
