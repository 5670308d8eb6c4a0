//! What is made of single modes, as it travels with the song.

use crate::engine::{Trim, Trims};
use crossbeam_queue::ArrayQueue;
use modes::ModeLabel;
use nice_plug::params::persist::PersistentField;
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};

/// The table of trims of an instance.
///
/// Editors and hosts read and write the whole of it from any thread but the audio thread, which fetches it
/// when it has changed, without waiting.
#[derive(Debug)]
pub struct TrimTable {
    table: Mutex<Trims>,
    news: ArrayQueue<Trims>,
}

impl Default for TrimTable {
    fn default() -> Self {
        Self {
            table: Mutex::default(),
            news: ArrayQueue::new(1),
        }
    }
}

impl TrimTable {
    /// The whole table.
    #[must_use]
    pub fn get(&self) -> Trims {
        *self.lock()
    }

    /// Another table, as undoing does.
    pub fn set(&self, trims: Trims) {
        let mut table = self.lock();
        if *table != trims {
            *table = trims;
            let _ = self.news.force_push(trims);
        }
    }

    /// Changes the table.
    pub fn change(&self, change: impl FnOnce(&mut Trims)) {
        let mut trims = self.get();
        change(&mut trims);
        self.set(trims);
    }

    /// The table if it has changed since last asked. For the audio thread: neither allocates nor waits.
    pub(crate) fn fetch(&self) -> Option<Trims> {
        self.news.pop()
    }

    fn lock(&self) -> MutexGuard<'_, Trims> {
        self.table.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

/// A name, level in dB and how long it rings over how long it would.
pub(super) type Words = Vec<(ModeLabel, f32, f32)>;

/// [`TrimTable`] as a field of the state; which mode is alone is not kept.
pub struct TrimField(pub(crate) Arc<TrimTable>);

impl PersistentField<'_, Words> for TrimField {
    fn set(&self, words: Words) {
        let mut trims = Trims::NONE;
        for (label, level_db, ringing) in words {
            // What is beyond the table was not made by it.
            let _ = trims.set(&label, Trim { level_db, ringing });
        }
        self.0.set(trims);
    }

    fn map<F, R>(&self, f: F) -> R
    where
        F: Fn(&Words) -> R,
    {
        let words = self
            .0
            .get()
            .all()
            .map(|(label, trim)| (label, trim.level_db, trim.ringing))
            .collect();
        f(&words)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use modes::{Family, Member};

    const LABEL: ModeLabel = ModeLabel {
        family: Family::Torsion,
        order: 0,
        index: 3,
        member: Member::Single,
    };

    #[test]
    fn what_is_kept_comes_back_without_the_mode_that_was_alone() {
        let (one, other) = (
            Arc::new(TrimTable::default()),
            Arc::new(TrimTable::default()),
        );
        let trim = Trim {
            level_db: -6.0,
            ringing: 2.0,
        };
        one.change(|trims| {
            trims.set(&LABEL, trim);
            trims.set_solo(Some(LABEL));
        });
        let words = TrimField(Arc::clone(&one)).map(Clone::clone);
        TrimField(Arc::clone(&other)).set(words);
        assert_eq!(other.get().get(&LABEL), trim);
        assert_eq!(other.get().solo(), None);
        assert_eq!(other.fetch(), Some(other.get()), "told");
        assert_eq!(other.fetch(), None, "once");
        other.set(other.get());
        assert_eq!(other.fetch(), None, "nothing new");
    }
}
