//! Files that the user's folder is to have, without their being played.

use super::library::lock;
use super::{Library, Own, OwnError};
use std::path::{Path, PathBuf};

impl Library {
    /// Asks for copies of banks and meshes in the folder.
    pub fn offer(&self, paths: impl IntoIterator<Item = PathBuf>) {
        lock(&self.offered).extend(paths);
        self.wake();
    }

    /// Copies what has been offered; `None` if nothing has, else what is not copied and why.
    pub fn take_in(&self) -> Option<Vec<OwnError>> {
        let offered = std::mem::take(&mut *lock(&self.offered));
        if offered.is_empty() {
            return None;
        }
        let copied = offered.iter().map(|path| self.take_in_one(path));
        Some(copied.filter_map(Result::err).collect())
    }

    /// A bank that cannot be played is not copied; a mesh is read when it is opened.
    fn take_in_one(&self, path: &Path) -> Result<(), OwnError> {
        if Self::is_bank(path) {
            Own::load(path)?;
        }
        self.copy(path).map_err(|error| OwnError::Copy {
            path: path.to_path_buf(),
            error,
        })
    }
}

#[cfg(test)]
mod tests {
    use super::super::own::small_bank;
    use super::*;
    use std::fs;

    #[test]
    fn what_is_offered_is_copied_unless_it_cannot_be_played() {
        let folder = tempfile::tempdir().unwrap();
        let at = |name: &str| folder.path().join(name);
        let banks = at("Banks");
        let library = Library::new(Some(banks.clone()));
        assert!(library.take_in().is_none());
        small_bank("bell").save(at("bell.bank")).unwrap();
        fs::write(at("broken.bank"), "RIFF").unwrap();
        fs::write(at("star.obj"), "v 0 0 0\n").unwrap();
        let names = ["bell.bank", "broken.bank", "star.obj", "gone.obj"];
        library.offer(names.map(at));
        let refused = library.take_in().unwrap();
        let refused: Vec<_> = refused.iter().map(ToString::to_string).collect();
        assert_eq!(refused.len(), 2, "{refused:?}");
        assert!(refused[0].contains("not an Idiophone bank"), "{refused:?}");
        assert!(refused[1].contains("gone.obj"), "{refused:?}");
        assert!(library.take_in().is_none());
        assert!(library.refresh());
        assert_eq!(library.entries()[0].title(), "The bell");
        assert_eq!(library.meshes().to_vec(), [banks.join("star.obj")]);
        assert!(!library.arrived(), "nothing of it plays");
    }
}
