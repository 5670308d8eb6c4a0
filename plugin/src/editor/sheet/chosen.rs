//! What is chosen elsewhere, on its way to the sheet.

use std::sync::{Arc, Mutex, PoisonError};

/// What to do with a mesh's file.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(in crate::editor) enum Place {
    /// A new sheet.
    New,
    /// A further body on the one that is open.
    Further,
}

/// The last that was chosen, until it is taken.
#[derive(Clone)]
pub(in crate::editor) struct Chosen<T>(Arc<Mutex<Option<T>>>);

impl<T> Default for Chosen<T> {
    fn default() -> Self {
        Self(Arc::new(Mutex::new(None)))
    }
}

impl<T> Chosen<T> {
    pub(in crate::editor) fn put(&self, it: T) {
        *self.0.lock().unwrap_or_else(PoisonError::into_inner) = Some(it);
    }

    pub(super) fn take(&self) -> Option<T> {
        self.0.lock().unwrap_or_else(PoisonError::into_inner).take()
    }
}
