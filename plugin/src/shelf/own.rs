//! A bank of the user's own, with its text for the song.

use super::OwnError;
use super::packed::{pack, unpack};
use modes::Bank;
use std::path::Path;
use std::sync::Arc;

/// Longest text of a bank in a song, in bytes: a fraction of what hosts and the framework carry.
pub const MOST_BYTES: usize = 64 << 20;
/// Longest file that a song's text may inflate to, in bytes.
pub(super) const MOST_FILE: usize = 4 * MOST_BYTES;

/// An instrument that the user brought.
#[derive(Debug)]
pub struct Own {
    bank: Arc<Bank>,
    text: String,
}

impl Own {
    /// Packs a bank, once for all the times that it will be saved. What others hold of it is shared with
    /// them where it can be.
    ///
    /// # Errors
    ///
    /// If it has no bodies or is too large for a song.
    pub fn new(bank: impl Into<Arc<Bank>>) -> Result<Self, OwnError> {
        let bank = bank.into();
        let file = bank.write();
        if file.len() > MOST_FILE {
            return Err(OwnError::Large {
                title: title(&bank),
                found_mib: file.len() >> 20,
                most_mib: MOST_FILE >> 20,
            });
        }
        let text = pack(&bank.name, &title(&bank), &file)?;
        Self::checked(bank, text)
    }

    /// The bank in the file at `path`.
    ///
    /// # Errors
    ///
    /// If it cannot be read, or as for [`Self::new`].
    pub fn load(path: &Path) -> Result<Self, OwnError> {
        Self::new(Bank::load(path)?)
    }

    /// The bank that a song keeps as `text`.
    ///
    /// # Errors
    ///
    /// If the text or the bank in it is damaged or of a later version.
    pub fn read(text: &str) -> Result<Self, OwnError> {
        let (title, file) = unpack(text, MOST_FILE)?;
        let bank = Bank::read(&file).map_err(|error| OwnError::Bank { title, error })?;
        Self::checked(bank.into(), text.to_owned())
    }

    fn checked(bank: Arc<Bank>, text: String) -> Result<Self, OwnError> {
        if bank.bodies.iter().all(|body| body.modes.is_empty()) {
            return Err(OwnError::Silent {
                title: title(&bank),
            });
        }
        Ok(Self {
            bank: spread_out(bank),
            text,
        })
    }

    /// What sounds: a body for each key, where the file has one body for many.
    #[must_use]
    pub fn bank(&self) -> &Bank {
        &self.bank
    }

    /// The same, to be held on to.
    #[must_use]
    pub fn share(&self) -> Arc<Bank> {
        Arc::clone(&self.bank)
    }

    /// What a song keeps: JSON on one line.
    #[must_use]
    pub fn text(&self) -> &str {
        &self.text
    }

    /// Its name for people.
    #[must_use]
    pub fn title(&self) -> String {
        title(&self.bank)
    }

    /// Whether it is the same.
    pub(super) fn is(&self, other: &Self) -> bool {
        self.text == other.text
    }
}

/// The bank with a body for each key; the same if it has them.
pub(crate) fn spread_out(bank: Arc<Bank>) -> Arc<Bank> {
    if bank.spread.is_none() {
        return bank;
    }
    Arc::unwrap_or_clone(bank).spread_out().into()
}

/// The bank's name for people, or else the one for files.
pub(super) fn title(bank: &Bank) -> String {
    if bank.title.is_empty() {
        bank.name.clone()
    } else {
        bank.title.clone()
    }
}

/// One body of the chimes, under another name.
#[cfg(test)]
pub(crate) fn small(name: &str) -> Own {
    Own::new(small_bank(name)).unwrap()
}

/// See [`small`].
#[cfg(test)]
pub(crate) fn small_bank(name: &str) -> Bank {
    let chimes = crate::factory::bank(0);
    Bank {
        name: name.to_owned(),
        title: format!("The {name}"),
        bodies: vec![chimes.bodies[40].clone()],
        ..Bank {
            bodies: Vec::new(),
            ..chimes.clone()
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_bank_comes_back_from_its_text() {
        let own = small("bell");
        let back = Own::read(own.text()).unwrap();
        assert_eq!(back.bank(), own.bank());
        assert_eq!(back.text(), own.text());
        assert_eq!(back.title(), "The bell");
        assert!(!own.text().contains('\n'));
    }

    #[test]
    fn a_bank_without_a_body_is_refused() {
        let mut bank = small_bank("nothing");
        bank.bodies.clear();
        let error = Own::new(bank).unwrap_err();
        assert!(matches!(error, OwnError::Silent { .. }));
    }

    #[test]
    fn a_file_that_is_no_bank_is_told_by_its_path() {
        let path = std::env::temp_dir().join("idiophone-nowhere.bank");
        let error = Own::load(&path).unwrap_err().to_string();
        assert!(error.contains("nowhere.bank"), "{error}");
    }
}
