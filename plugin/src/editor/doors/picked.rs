//! Files that were chosen in a dialog.

use std::path::PathBuf;
use std::sync::{Arc, Mutex, PoisonError};

/// On their way from a dialog's thread to the window.
#[derive(Clone, Default)]
pub(in super::super) struct Picked(Arc<Mutex<Vec<PathBuf>>>);

impl Picked {
    /// Hands some in.
    pub(in super::super) fn put(&self, paths: impl IntoIterator<Item = PathBuf>) {
        let mut waiting = self.0.lock().unwrap_or_else(PoisonError::into_inner);
        waiting.extend(paths);
    }

    /// Those that have been handed in, once.
    pub(super) fn take(&self) -> Vec<PathBuf> {
        let mut waiting = self.0.lock().unwrap_or_else(PoisonError::into_inner);
        std::mem::take(&mut *waiting)
    }
}
