//! Which preset a sound began as.

use crate::presets::Origin;
use std::path::Path;

/// The preset that was chosen last.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Chosen {
    /// See [`Origin::key`]; empty for none.
    pub key: String,
    /// Whether the sound is no longer the preset's.
    pub changed: bool,
    /// Whether it brought the tuning, which then goes with it.
    pub tuned: bool,
}

impl Chosen {
    /// Where the preset is, if there is one.
    #[must_use]
    pub fn origin(&self) -> Option<Origin> {
        Origin::from_key(&self.key)
    }

    /// Its name as far as the key tells.
    #[must_use]
    pub fn name(&self) -> String {
        match self.origin() {
            None => "Init".to_owned(),
            Some(Origin::Factory(name)) => name,
            Some(Origin::User(file)) => {
                let stem = Path::new(&file).file_stem().unwrap_or_default();
                stem.to_string_lossy().into_owned()
            }
        }
    }
}
