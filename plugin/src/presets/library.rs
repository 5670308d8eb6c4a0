//! All presets: the factory's, and the user's with those that are broken.

use super::broken::Broken;
use super::entry::{Entry, Origin};
use super::factory::factory;
use super::favourites::Favourites;
use super::files;
use super::folder::{Folder, export};
use super::preset::Preset;
use std::path::{Path, PathBuf};
use std::sync::Arc;

/// File of the favourites, in the user's folder.
const FAVOURITES: &str = "favourites.txt";
/// Folder of the presets, in the user's folder.
const PRESETS: &str = "Presets";
/// Folder of the exports, in the user's folder.
const EXPORTS: &str = "Exports";

/// What there is, as it was last looked at.
#[derive(Debug)]
pub struct Library {
    home: Option<PathBuf>,
    entries: Vec<Entry>,
    favourites: Favourites,
}

impl Library {
    /// With the presets in the folder of a user, if the system names one.
    #[must_use]
    pub fn open(home: Option<PathBuf>) -> Self {
        let mut library = Self {
            home,
            entries: Vec::new(),
            favourites: Favourites::default(),
        };
        library.look();
        library
    }

    /// Looks again at what is in the folder.
    pub fn look(&mut self) {
        if let Some(home) = &self.home {
            self.favourites = Favourites::read(&home.join(FAVOURITES));
        }
        let mine = self.folder().into_iter().flat_map(|folder| {
            let read = |file: String| {
                let preset = folder.read(&file).map(Arc::new);
                let preset = preset.map_err(|broken| broken.to_string());
                (Origin::User(file), preset)
            };
            folder.files().into_iter().map(read).collect::<Vec<_>>()
        });
        let theirs = factory().iter().map(|preset| {
            let origin = Origin::Factory(preset.card.name.clone());
            (origin, Ok(Arc::clone(preset)))
        });
        self.entries = mine
            .chain(theirs)
            .map(|(origin, preset)| Entry {
                favourite: self.favourites.has(&origin),
                origin,
                preset,
            })
            .collect();
    }

    /// The user's first, then the factory's.
    #[must_use]
    pub fn entries(&self) -> &[Entry] {
        &self.entries
    }

    /// The one of that origin.
    #[must_use]
    pub fn find(&self, origin: &Origin) -> Option<&Entry> {
        self.entries.iter().find(|entry| entry.origin == *origin)
    }

    /// The user's presets of that name.
    #[must_use]
    pub fn mine(&self, name: &str) -> Option<&Entry> {
        let mut mine = self.entries.iter().filter(|entry| entry.is_user_s());
        mine.find(|entry| entry.preset.is_ok() && entry.name() == name.trim())
    }

    /// The folder of the user's presets.
    #[must_use]
    pub fn folder(&self) -> Option<Folder> {
        let home = self.home.as_ref()?;
        Some(Folder::new(home.join(PRESETS)))
    }

    fn need(&self) -> Result<Folder, Broken> {
        self.folder().ok_or(Broken::Homeless)
    }

    /// Keeps a preset, in place of the user's own of that name if there is one.
    ///
    /// # Errors
    ///
    /// As [`Folder::save`].
    pub fn save(&mut self, preset: &Preset) -> Result<Origin, Broken> {
        let over = self.mine(&preset.card.name).map(|entry| &entry.origin);
        let file = match over {
            Some(Origin::User(file)) => Some(file.as_str()),
            _ => None,
        };
        let file = self.need()?.save(preset, file)?;
        self.look();
        Ok(Origin::User(file))
    }

    /// Gives one of the user's another name.
    ///
    /// # Errors
    ///
    /// As [`Folder::rename`].
    pub fn rename(&mut self, file: &str, to: &str) -> Result<Origin, Broken> {
        let old = Origin::User(file.to_owned());
        let new = Origin::User(self.need()?.rename(file, to)?);
        let marked = self.favourites.has(&old);
        if marked && new != old {
            self.mark(&old, false)?;
            self.mark(&new, true)?;
        }
        self.look();
        Ok(new)
    }

    /// Puts one of the user's aside; where it lies now.
    ///
    /// # Errors
    ///
    /// As [`Folder::delete`].
    pub fn delete(&mut self, file: &str) -> Result<PathBuf, Broken> {
        let to = self.need()?.delete(file)?;
        self.look();
        Ok(to)
    }

    /// Takes in a file from elsewhere.
    ///
    /// # Errors
    ///
    /// As [`Folder::import`].
    pub fn import(&mut self, from: &Path) -> Result<Origin, Broken> {
        let file = self.need()?.import(from)?;
        self.look();
        Ok(Origin::User(file))
    }

    /// Where a preset of that name would be exported to, unless told otherwise.
    #[must_use]
    pub fn export_path(&self, name: &str) -> Option<PathBuf> {
        let stem = files::stem(name).ok()?;
        let folder = self.home.as_ref()?.join(EXPORTS);
        Some(files::free(&folder, &stem, "toml"))
    }

    /// Writes a preset to a file elsewhere.
    ///
    /// # Errors
    ///
    /// What the system refuses.
    pub fn export(&self, preset: &Preset, to: &Path) -> Result<(), Broken> {
        export(preset, to)
    }

    /// Marks a preset as a favourite, or no longer.
    ///
    /// # Errors
    ///
    /// What the system refuses; it is marked until the next look all the same.
    pub fn mark(&mut self, origin: &Origin, on: bool) -> Result<(), Broken> {
        self.favourites.set(origin, on);
        if let Some(entry) = self
            .entries
            .iter_mut()
            .find(|entry| entry.origin == *origin)
        {
            entry.favourite = on;
        }
        let home = self.home.as_ref().ok_or(Broken::Homeless)?;
        self.favourites.write(&home.join(FAVOURITES))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::presets::{Card, Sound};
    use std::fs;

    fn named(name: &str) -> Preset {
        let card = Card {
            name: name.to_owned(),
            ..Card::default()
        };
        Preset::new(card, Sound::default())
    }

    #[test]
    fn a_name_is_kept_once_and_broken_ones_are_listed() {
        let home = tempfile::tempdir().unwrap();
        let mut library = Library::open(Some(home.path().to_owned()));
        let first = library.save(&named("Mine")).unwrap();
        assert_eq!(library.save(&named("Mine")).unwrap(), first);
        fs::write(home.path().join("Presets/odd.toml"), "name").unwrap();
        library.look();
        let broken = library.find(&Origin::User("odd.toml".to_owned())).unwrap();
        let reason = broken.preset.as_ref().unwrap_err();
        assert!(reason.starts_with("odd.toml, line 1: "), "{reason}");
        assert_eq!(library.entries().len(), 2 + factory().len());
        library.delete("odd.toml").unwrap();
        assert!(home.path().join("Presets/Deleted/odd.toml").is_file());
        assert_eq!(library.entries().len(), 1 + factory().len());
    }

    #[test]
    fn favourites_outlive_a_renaming_and_the_library() {
        let home = tempfile::tempdir().unwrap();
        let mut library = Library::open(Some(home.path().to_owned()));
        let origin = library.save(&named("Mine")).unwrap();
        library.mark(&origin, true).unwrap();
        let theirs = Origin::Factory(factory()[0].card.name.clone());
        library.mark(&theirs, true).unwrap();
        let renamed = library.rename("Mine.toml", "Yours").unwrap();
        library.mark(&theirs, false).unwrap();
        let library = Library::open(Some(home.path().to_owned()));
        let marked = library.entries().iter().filter(|entry| entry.favourite);
        let marked: Vec<_> = marked.map(|entry| entry.origin.clone()).collect();
        assert_eq!(marked, [renamed]);
    }

    #[test]
    fn without_a_home_the_factory_s_are_there_and_saving_says_why_not() {
        let mut library = Library::open(None);
        assert_eq!(library.entries().len(), factory().len());
        assert!(library.save(&named("Mine")).is_err());
    }
}
