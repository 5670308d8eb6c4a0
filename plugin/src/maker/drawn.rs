//! The bank that was made last, for those who show what sounds.

use crate::shelf::Shelved;
use modes::Bank;
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};

/// An instrument in its present drawing; never for the audio thread.
#[derive(Debug, Default)]
pub struct Drawn(Mutex<Option<(usize, Arc<Bank>)>>);

impl Drawn {
    /// That of the instrument of a number, if it has been drawn.
    #[must_use]
    pub fn of(&self, number: usize) -> Option<Shelved> {
        let drawn = self.lock();
        let (_, bank) = drawn.as_ref().filter(|(of, _)| *of == number)?;
        Some(Shelved::Drawn(Arc::clone(bank)))
    }

    /// Another instead.
    pub(super) fn put(&self, number: usize, bank: &Arc<Bank>) {
        *self.lock() = Some((number, Arc::clone(bank)));
    }

    /// The instrument sounds as the shelf has it.
    pub(super) fn clear(&self) {
        *self.lock() = None;
    }

    fn lock(&self) -> MutexGuard<'_, Option<(usize, Arc<Bank>)>> {
        self.0.lock().unwrap_or_else(PoisonError::into_inner)
    }
}
