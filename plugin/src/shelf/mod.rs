//! The instruments within reach: the factory's, and one of the user's own.
//!
//! An own bank comes from a file or from the song that keeps it; [`Own`] has its text for the song ready,
//! so that saving packs nothing.

mod entry;
mod error;
#[cfg(feature = "gui")]
mod librarian;
mod library;
mod offer;
mod own;
mod packed;
mod shelved;

pub use entry::{Card, Entry};
pub use error::OwnError;
#[cfg(feature = "gui")]
pub(crate) use librarian::{Librarian, Said};
pub use library::Library;
#[cfg(test)]
pub(crate) use own::small;
pub(crate) use own::spread_out;
pub use own::{MOST_BYTES, Own};
pub use shelved::Shelved;

use crate::factory;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};

/// Number of the user's own instrument in the `Instrument` parameter: after the factory's.
pub const OWN: usize = factory::BANKS.len();
/// Its name there.
pub const OWN_TITLE: &str = "Your own";
/// Its name in songs.
pub const OWN_NAME: &str = "own";

/// What an instance can play.
///
/// An instrument's number is the factory's index, or [`OWN`] and what it takes to tell banks apart that
/// have been the user's own one after the other.
#[derive(Debug, Default)]
pub struct Shelf {
    inner: Mutex<Inner>,
    /// Number of the own bank; 0 without one, which is the first instrument's.
    number: AtomicUsize,
}

#[derive(Debug, Default)]
struct Inner {
    own: Option<Arc<Own>>,
    /// What the song had and this version cannot read: it goes back as it came.
    unread: Option<String>,
    /// Banks that have been the user's own.
    turns: usize,
}

impl Shelf {
    /// Number of the instrument at `index` of the parameter; the first without a bank of one's own. For the
    /// audio thread too.
    #[must_use]
    pub fn number(&self, index: usize) -> usize {
        if index < OWN {
            index
        } else {
            self.number.load(Ordering::Acquire)
        }
    }

    /// The instrument of a number; for the number of an own bank that has gone since, what has taken its
    /// place. Not for the audio thread.
    #[must_use]
    pub fn bank(&self, number: usize) -> Shelved {
        if number < OWN {
            return Shelved::factory(number);
        }
        self.own().map_or_else(|| Shelved::factory(0), Shelved::Own)
    }

    /// The user's own instrument, if one is loaded.
    #[must_use]
    pub fn own(&self) -> Option<Arc<Own>> {
        self.lock().own.clone()
    }

    /// Another own instrument; the same again changes nothing.
    pub fn put(&self, own: Own) {
        let mut inner = self.lock();
        inner.unread = None;
        if inner.own.as_ref().is_some_and(|old| old.is(&own)) {
            return;
        }
        inner.own = Some(Arc::new(own));
        inner.turns += 1;
        self.number.store(OWN + inner.turns, Ordering::Release);
    }

    /// What a song keeps of the own instrument, word for word as it came from one.
    #[must_use]
    pub fn text(&self) -> Option<String> {
        let inner = self.lock();
        let own = || inner.own.as_ref().map(|own| own.text().to_owned());
        inner.unread.clone().or_else(own)
    }

    /// Takes what a song keeps; a song without takes the own instrument away.
    ///
    /// # Errors
    ///
    /// If this version cannot read it. It stays for saving, and what was there before sounds on.
    pub fn restore(&self, text: Option<&str>) -> Result<(), OwnError> {
        let Some(text) = text else {
            let mut inner = self.lock();
            (inner.own, inner.unread) = (None, None);
            self.number.store(0, Ordering::Release);
            return Ok(());
        };
        let same = |own: &Arc<Own>| own.text() == text;
        if self.own().as_ref().is_some_and(same) {
            self.lock().unread = None;
            return Ok(());
        }
        match Own::read(text) {
            Ok(own) => {
                self.put(own);
                Ok(())
            }
            Err(error) => {
                self.lock().unread = Some(text.to_owned());
                Err(error)
            }
        }
    }

    fn lock(&self) -> MutexGuard<'_, Inner> {
        self.inner.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn without_a_bank_of_one_s_own_the_first_plays() {
        let shelf = Shelf::default();
        assert_eq!((shelf.number(3), shelf.number(OWN)), (3, 0));
        assert_eq!(shelf.bank(shelf.number(OWN)).name, "chimes");
        assert_eq!(shelf.bank(OWN + 5).name, "chimes");
        assert_eq!(shelf.text(), None);
    }

    #[test]
    fn each_own_bank_has_a_number_and_the_same_keeps_it() {
        let shelf = Shelf::default();
        shelf.put(small("bell"));
        let first = shelf.number(OWN);
        assert!(first > OWN);
        shelf.put(small("bell"));
        assert_eq!(shelf.number(OWN), first);
        shelf.put(small("gong"));
        let second = shelf.number(OWN);
        assert_ne!(second, first);
        assert_eq!(shelf.bank(second).name, "gong");
        assert_eq!(shelf.bank(first).name, "gong");
        assert!(shelf.restore(None).is_ok());
        assert_eq!((shelf.number(OWN), shelf.text()), (0, None));
        shelf.put(small("bell"));
        assert!(![first, second].contains(&shelf.number(OWN)));
    }

    #[test]
    fn what_cannot_be_read_is_kept_word_for_word_and_the_last_sounds_on() {
        let shelf = Shelf::default();
        let bell = small("bell");
        assert!(shelf.restore(Some(bell.text())).is_ok());
        let number = shelf.number(OWN);
        let broken = "{\"layout\": 9, \"what\": [1, 2]}";
        assert!(shelf.restore(Some(broken)).is_err());
        assert_eq!(shelf.text().as_deref(), Some(broken));
        assert_eq!(shelf.number(OWN), number);
        assert!(shelf.restore(Some(bell.text())).is_ok());
        assert_eq!(shelf.text().as_deref(), Some(bell.text()));
        assert_eq!(shelf.number(OWN), number);
        assert!(shelf.restore(Some(broken)).is_err());
        shelf.put(small("gong"));
        assert_eq!(shelf.text().as_deref(), Some(small("gong").text()));
    }
}
