//! Extensions that the guard answers itself.

use super::plugin::Guard;
use clap_sys::ext::params::CLAP_EXT_PARAMS;
use std::ffi::{CStr, c_void};
use std::ptr;

/// The extension of that name, if it is one of ours; the framework is asked for all others.
pub(super) fn own(guard: &Guard, id: &CStr) -> Option<*const c_void> {
    match id {
        _ if id == CLAP_EXT_PARAMS => guard
            .params
            .as_ref()
            .map(|params| ptr::from_ref(params).cast()),
        _ => None,
    }
}
