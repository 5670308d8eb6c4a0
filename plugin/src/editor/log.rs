//! What gestures have done to parameters since it was last read.

use std::sync::{Mutex, MutexGuard, PoisonError};

/// A parameter's way, 0…1.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Change {
    pub(super) id: &'static str,
    pub(super) from: f32,
    pub(super) to: f32,
}

/// Shared by all parameters of an editor.
#[derive(Default)]
pub(super) struct Log {
    inner: Mutex<Inner>,
}

#[derive(Default)]
struct Inner {
    open: Vec<Change>,
    ended: Vec<Change>,
}

impl Log {
    fn lock(&self) -> MutexGuard<'_, Inner> {
        self.inner.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// A gesture begins at `value`.
    pub(super) fn begin(&self, id: &'static str, value: f32) {
        self.lock().open.push(Change {
            id,
            from: value,
            to: value,
        });
    }

    /// It goes to `value`.
    pub(super) fn set(&self, id: &'static str, value: f32) {
        let mut inner = self.lock();
        if let Some(change) = inner.open.iter_mut().find(|change| change.id == id) {
            change.to = value;
        }
    }

    /// It ends; it counts if it has moved anything.
    pub(super) fn end(&self, id: &'static str) {
        let mut inner = self.lock();
        let Some(at) = inner.open.iter().position(|change| change.id == id) else {
            return;
        };
        let change = inner.open.remove(at);
        if change.from != change.to {
            inner.ended.push(change);
        }
    }

    /// The gestures that have ended since it was last asked.
    pub(super) fn ended(&self) -> Vec<Change> {
        std::mem::take(&mut self.lock().ended)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_gesture_counts_from_its_beginning_to_its_end_if_it_moves() {
        let log = Log::default();
        log.begin("a", 0.1);
        log.begin("b", 0.5);
        log.set("a", 0.2);
        log.set("a", 0.3);
        assert_eq!(log.ended(), []);
        log.end("a");
        log.end("b");
        log.end("c");
        let change = Change {
            id: "a",
            from: 0.1,
            to: 0.3,
        };
        assert_eq!(log.ended(), [change]);
        assert_eq!(log.ended(), []);
    }
}
