//! A mesh's file on its way from a dialog to the sheet.

use std::path::PathBuf;
use std::sync::{Arc, Mutex, PoisonError};

/// What to do with a file that was chosen.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(in crate::editor) enum Place {
    /// A new sheet.
    New,
    /// A further body on the one that is open.
    Further,
}

/// A file that was chosen.
#[derive(Clone, Default)]
pub(in crate::editor) struct Chosen(Arc<Mutex<Option<(PathBuf, Place)>>>);

impl Chosen {
    pub(in crate::editor) fn put(&self, path: PathBuf, place: Place) {
        *self.0.lock().unwrap_or_else(PoisonError::into_inner) = Some((path, place));
    }

    pub(super) fn take(&self) -> Option<(PathBuf, Place)> {
        self.0.lock().unwrap_or_else(PoisonError::into_inner).take()
    }
}
