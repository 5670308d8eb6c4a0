//! The framework's plug-in with a guard before it.

#![expect(unsafe_code, reason = "CLAP's plug-ins are functions over pointers")]

use super::block::{Blocks, hearing};
use super::{List, Source, extensions};
use atomic_refcell::AtomicRefCell;
use clap_sys::events::{clap_input_events, clap_output_events};
use clap_sys::ext::params::{CLAP_EXT_PARAMS, clap_plugin_params};
use clap_sys::plugin::clap_plugin;
use clap_sys::process::{CLAP_PROCESS_ERROR, clap_process, clap_process_status};
use std::ffi::{CStr, c_char, c_void};
use std::ops::RangeInclusive;
use std::ptr;

/// Rates that are any, in samples per s: the framework takes whatever it is told.
const RATES_HZ: RangeInclusive<f64> = 1.0..=1e7;

/// A plug-in as the host holds it.
///
/// Its data pointer is the framework's, which finds itself by nothing else: what is not guarded, and
/// every extension of the framework's, works with the guarded plug-in as with its own.
#[repr(C)]
pub(super) struct Guard {
    /// Comes first, so that a pointer to it is one to the guard.
    outer: clap_plugin,
    inner: *const clap_plugin,
    /// The framework's parameters with a guarded flush.
    pub(super) params: Option<clap_plugin_params>,
    /// While active. A host that keeps to CLAP's threads never finds it in use.
    blocks: AtomicRefCell<Option<Blocks>>,
}

impl Guard {
    /// The framework's plug-in, guarded; null if it is.
    ///
    /// # Safety
    ///
    /// `inner` is null or a plug-in of the framework that is used by nobody else.
    pub(super) unsafe fn before(inner: *const clap_plugin) -> *const clap_plugin {
        // SAFETY: the caller's.
        let Some(plugin) = (unsafe { inner.as_ref() }) else {
            return ptr::null();
        };
        let guard = Self {
            outer: clap_plugin {
                destroy: Some(destroy),
                activate: Some(activate),
                deactivate: Some(deactivate),
                start_processing: Some(start_processing),
                reset: Some(reset),
                process: Some(process),
                get_extension: Some(get_extension),
                ..*plugin
            },
            inner,
            // SAFETY: the extension of this name is of this type and lives as long as the plug-in.
            params: unsafe {
                extension(inner, CLAP_EXT_PARAMS)
                    .cast::<clap_plugin_params>()
                    .as_ref()
            }
            .map(|params| clap_plugin_params {
                flush: Some(flush),
                ..*params
            }),
            blocks: AtomicRefCell::new(None),
        };
        Box::into_raw(Box::new(guard)).cast()
    }

    /// The guard of a plug-in that the host holds.
    ///
    /// # Safety
    ///
    /// `outer` is null or came from [`Guard::before`] and is not yet destroyed.
    unsafe fn of<'a>(outer: *const clap_plugin) -> Option<&'a Self> {
        // SAFETY: the plug-in is the guard's first field.
        unsafe { outer.cast::<Self>().as_ref() }
    }

    /// The framework's plug-in.
    const fn inner(&self) -> &clap_plugin {
        // SAFETY: it lives until the guard does not.
        unsafe { &*self.inner }
    }

    fn forget(&self) {
        if let Ok(mut blocks) = self.blocks.try_borrow_mut()
            && let Some(blocks) = &mut *blocks
        {
            blocks.forget();
        }
    }

    /// Has the framework process a block.
    ///
    /// # Safety
    ///
    /// That of [`Blocks::process`].
    unsafe fn process(&self, block: clap_process) -> clap_process_status {
        let mut blocks = self.blocks.try_borrow_mut().ok();
        let blocks = blocks.as_deref_mut().and_then(Option::as_mut);
        blocks.map_or(CLAP_PROCESS_ERROR, |blocks| {
            // SAFETY: the caller's.
            unsafe { blocks.process(self.inner, block) }
        })
    }
}

/// The framework's extension of that name, or null.
///
/// # Safety
///
/// `inner` is a plug-in of the framework.
unsafe fn extension(inner: *const clap_plugin, id: &CStr) -> *const c_void {
    // SAFETY: the caller's.
    unsafe {
        (*inner)
            .get_extension
            .map_or(ptr::null(), |get| get(inner, id.as_ptr()))
    }
}

unsafe extern "C" fn destroy(plugin: *const clap_plugin) {
    // SAFETY: the host holds a guarded plug-in, for the last time.
    unsafe {
        if let Some(guard) = Guard::of(plugin) {
            if let Some(destroy) = guard.inner().destroy {
                destroy(guard.inner);
            }
            drop(Box::from_raw(plugin.cast_mut().cast::<Guard>()));
        }
    }
}

unsafe extern "C" fn activate(
    plugin: *const clap_plugin,
    rate_hz: f64,
    min_frames: u32,
    max_frames: u32,
) -> bool {
    // SAFETY: the host holds a guarded plug-in.
    unsafe {
        let Some(guard) = Guard::of(plugin) else {
            return false;
        };
        let active = RATES_HZ.contains(&rate_hz)
            && guard
                .inner()
                .activate
                .is_some_and(|activate| activate(guard.inner, rate_hz, min_frames, max_frames));
        let Ok(mut blocks) = guard.blocks.try_borrow_mut() else {
            return false;
        };
        *blocks = active.then(|| Blocks::new(max_frames));
        active
    }
}

unsafe extern "C" fn deactivate(plugin: *const clap_plugin) {
    // SAFETY: the host holds a guarded plug-in.
    unsafe {
        if let Some(guard) = Guard::of(plugin) {
            if let Ok(mut blocks) = guard.blocks.try_borrow_mut() {
                *blocks = None;
            }
            if let Some(deactivate) = guard.inner().deactivate {
                deactivate(guard.inner);
            }
        }
    }
}

unsafe extern "C" fn start_processing(plugin: *const clap_plugin) -> bool {
    // SAFETY: the host holds a guarded plug-in.
    unsafe {
        Guard::of(plugin).is_some_and(|guard| {
            guard.forget();
            let start = guard.inner().start_processing;
            start.is_some_and(|start| start(guard.inner))
        })
    }
}

unsafe extern "C" fn reset(plugin: *const clap_plugin) {
    // SAFETY: the host holds a guarded plug-in.
    unsafe {
        if let Some(guard) = Guard::of(plugin) {
            guard.forget();
            if let Some(reset) = guard.inner().reset {
                reset(guard.inner);
            }
        }
    }
}

unsafe extern "C" fn process(
    plugin: *const clap_plugin,
    block: *const clap_process,
) -> clap_process_status {
    // SAFETY: the host holds a guarded plug-in, and its block is good for the length of the call.
    unsafe {
        match Guard::of(plugin) {
            Some(guard) if !block.is_null() => guard.process(block.read_unaligned()),
            _ => CLAP_PROCESS_ERROR,
        }
    }
}

unsafe extern "C" fn get_extension(plugin: *const clap_plugin, id: *const c_char) -> *const c_void {
    // SAFETY: the host holds a guarded plug-in, and a name ends with a null byte.
    unsafe {
        match Guard::of(plugin) {
            Some(guard) if !id.is_null() => {
                let id = CStr::from_ptr(id);
                extensions::own(guard, id).unwrap_or_else(|| extension(guard.inner, id))
            }
            _ => ptr::null(),
        }
    }
}

/// Parameters change outside a block: there is no order to keep, and nothing else to read.
unsafe extern "C" fn flush(
    plugin: *const clap_plugin,
    in_events: *const clap_input_events,
    out_events: *const clap_output_events,
) {
    // SAFETY: the host holds a guarded plug-in, and its lists are good for the length of the call.
    unsafe {
        let Some(guard) = Guard::of(plugin) else {
            return;
        };
        let params = extension(guard.inner, CLAP_EXT_PARAMS).cast::<clap_plugin_params>();
        if let Some(flush) = params.as_ref().and_then(|params| params.flush) {
            let source = Source::new(in_events);
            let mut list = List::new(&[], &[], source, 0..source.len(), 0);
            let in_events = list.as_clap();
            flush(guard.inner, &raw const in_events, hearing(out_events));
        }
    }
}
