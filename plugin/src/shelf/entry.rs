//! A file in the user's folder of banks.

use super::OwnError;
use super::own::{MOST_FILE, title};
use modes::Bank;
use std::fs::Metadata;
use std::path::{Path, PathBuf};
use std::time::SystemTime;

/// What can be said of a bank without loading it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Card {
    /// Name of the instrument, fit for a file.
    pub name: String,
    /// Name of the instrument for people; the other one if it has none.
    pub title: String,
}

/// One file.
#[derive(Clone, Debug)]
pub struct Entry {
    /// Where it lies.
    pub path: PathBuf,
    /// What is in it, or why it cannot be played.
    pub card: Result<Card, String>,
    pub(super) stamp: Stamp,
}

/// What changes when a file does.
pub(super) type Stamp = (u64, Option<SystemTime>);

fn stamp(of: &Metadata) -> Stamp {
    (of.len(), of.modified().ok())
}

impl Entry {
    /// Looks into the file at `path`, or takes `before` if that is the same file unchanged; none if there
    /// is no file.
    pub(super) fn look(path: PathBuf, before: &[Self]) -> Option<Self> {
        let metadata = path.metadata().ok().filter(Metadata::is_file)?;
        let stamp = stamp(&metadata);
        let same = |entry: &&Self| entry.path == path && entry.stamp == stamp;
        if let Some(same) = before.iter().find(same) {
            return Some(same.clone());
        }
        let card = read(&path, metadata.len()).map_err(|error| error.to_string());
        Some(Self { path, card, stamp })
    }

    /// Its name for people; the file's if the bank cannot be read.
    #[must_use]
    pub fn title(&self) -> String {
        match &self.card {
            Ok(card) => card.title.clone(),
            Err(_) => file_name(&self.path),
        }
    }
}

/// What is in a file of `len` bytes; one that no song carries is not read.
fn read(path: &Path, len: u64) -> Result<Card, OwnError> {
    let len = usize::try_from(len).unwrap_or(usize::MAX);
    if len > MOST_FILE {
        return Err(OwnError::Large {
            title: file_name(path),
            found_mib: len >> 20,
            most_mib: MOST_FILE >> 20,
        });
    }
    let bank = Bank::load(path)?;
    Ok(Card {
        title: title(&bank),
        name: bank.name,
    })
}

/// The last part of a path.
fn file_name(path: &Path) -> String {
    let name = path.file_name().unwrap_or_default();
    name.to_string_lossy().into_owned()
}
