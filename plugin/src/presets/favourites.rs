//! What a user has marked: a small file, one preset a line.

use super::broken::Broken;
use super::entry::Origin;
use super::files;
use std::collections::BTreeSet;
use std::fs;
use std::path::Path;

/// Keys of [`Origin`], also of presets that are not here now.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(super) struct Favourites {
    keys: BTreeSet<String>,
}

impl Favourites {
    /// What is in a file; none if it cannot be read.
    pub(super) fn read(path: &Path) -> Self {
        let text = fs::read_to_string(path).unwrap_or_default();
        let lines = text.lines().map(str::trim).filter(|line| !line.is_empty());
        Self {
            keys: lines.map(str::to_owned).collect(),
        }
    }

    /// Whether it is marked.
    pub(super) fn has(&self, origin: &Origin) -> bool {
        self.keys.contains(&origin.key())
    }

    /// Marks it, or no longer.
    pub(super) fn set(&mut self, origin: &Origin, on: bool) {
        if on {
            self.keys.insert(origin.key());
        } else {
            self.keys.remove(&origin.key());
        }
    }

    /// Writes the file.
    pub(super) fn write(&self, path: &Path) -> Result<(), Broken> {
        let text: String = self.keys.iter().map(|key| format!("{key}\n")).collect();
        files::write(path, &text)
    }
}
