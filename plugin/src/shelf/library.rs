//! The user's folder of banks, and what is taken out of it.

use super::entry::{Card, Entry, Stamp};
use super::{Own, OwnError, Shelf};
use std::fs;
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};
use std::thread::Thread;

/// Files that are listed at most.
const MOST_FILES: usize = 500;
/// How a bank's file ends.
const EXTENSION: &str = "bank";
/// How a mesh's file ends.
const MESH: &str = "obj";

/// What lies in a folder, and the bank that is wanted from it or from elsewhere.
///
/// Whoever draws asks and looks; [`Library::refresh`] and [`Library::serve`] do the work, on another thread.
#[derive(Debug)]
pub struct Library {
    folder: Option<PathBuf>,
    entries: Mutex<Arc<[Entry]>>,
    meshes: Mutex<Arc<[PathBuf]>>,
    wanted: Mutex<Option<PathBuf>>,
    /// What the folder is to have too.
    pub(super) offered: Mutex<Vec<PathBuf>>,
    /// Who does the work.
    worker: Mutex<Option<Thread>>,
    /// The file of the folder that was taken last, and how it was then.
    taken: Mutex<Option<(PathBuf, Stamp)>>,
    /// A wanted bank lies on the shelf, and nobody has been told.
    arrived: AtomicBool,
}

impl Library {
    /// Over a folder, which need not be there.
    #[must_use]
    pub fn new(folder: Option<PathBuf>) -> Self {
        Self {
            folder,
            entries: Mutex::new(Arc::new([])),
            meshes: Mutex::new(Arc::new([])),
            wanted: Mutex::default(),
            offered: Mutex::default(),
            worker: Mutex::default(),
            taken: Mutex::default(),
            arrived: AtomicBool::new(false),
        }
    }

    /// The folder.
    #[must_use]
    pub fn folder(&self) -> Option<&Path> {
        self.folder.as_deref()
    }

    /// The files that end in `.bank`, by name, as they were when last looked at.
    #[must_use]
    pub fn entries(&self) -> Arc<[Entry]> {
        lock(&self.entries).clone()
    }

    /// The files that end in `.obj`, by name, as they were when last looked at.
    #[must_use]
    pub fn meshes(&self) -> Arc<[PathBuf]> {
        lock(&self.meshes).clone()
    }

    /// The file of the folder with the bank of that name.
    #[must_use]
    pub fn named(&self, name: &str) -> Option<PathBuf> {
        let entries = self.entries();
        let found = entries.iter().find(
            |entry| matches!(&entry.card, Ok(card) if card.name == name || card.title == name),
        );
        found.map(|entry| entry.path.clone())
    }

    /// Asks for the bank in a file, instead of the one asked for before.
    pub fn ask(&self, path: PathBuf) {
        *lock(&self.wanted) = Some(path);
        self.wake();
    }

    /// Has what was asked for done.
    pub(super) fn wake(&self) {
        if let Some(worker) = &*lock(&self.worker) {
            worker.unpark();
        }
    }

    /// Whom to wake when a bank is asked for.
    #[cfg(feature = "gui")]
    pub(super) fn employ(&self, worker: Thread) {
        *lock(&self.worker) = Some(worker);
    }

    /// Whether a bank that was asked for has come, once.
    pub fn arrived(&self) -> bool {
        self.arrived.swap(false, Ordering::AcqRel)
    }

    /// A bank that somebody made has been put on the shelf.
    #[cfg(feature = "gui")]
    pub(crate) fn arrive(&self) {
        self.arrived.store(true, Ordering::Release);
    }

    /// Looks at what has changed in the folder; whether anything has.
    pub fn refresh(&self) -> bool {
        let meshes = self.paths(MESH);
        let other_meshes = *meshes != *self.meshes();
        *lock(&self.meshes) = meshes.into();
        let before = self.entries();
        let look = |path| Entry::look(path, &before);
        let now: Vec<Entry> = self.paths(EXTENSION).into_iter().filter_map(look).collect();
        let paths = |entries: &[Entry]| -> Vec<PathBuf> {
            entries.iter().map(|entry| entry.path.clone()).collect()
        };
        let cards = |entries: &[Entry]| -> Vec<_> {
            entries.iter().map(|entry| entry.card.clone()).collect()
        };
        if paths(&before) == paths(&now) && cards(&before) == cards(&now) {
            // Stamps may differ all the same.
            *lock(&self.entries) = now.into();
            return other_meshes;
        }
        *lock(&self.entries) = now.into();
        true
    }

    /// The folder's paths that end so, sorted.
    fn paths(&self, end: &str) -> Vec<PathBuf> {
        let folder = self
            .folder
            .as_ref()
            .and_then(|folder| fs::read_dir(folder).ok());
        let mut paths: Vec<PathBuf> = folder
            .into_iter()
            .flatten()
            .filter_map(|file| Some(file.ok()?.path()))
            .filter(|path| {
                path.extension()
                    .is_some_and(|found| found.eq_ignore_ascii_case(end))
            })
            .collect();
        paths.sort();
        paths.truncate(MOST_FILES);
        paths
    }

    /// Puts the bank that is wanted on the shelf, and a copy into the folder if it comes from elsewhere;
    /// `None` if none is wanted.
    ///
    /// # Errors
    ///
    /// If the bank cannot be had; the shelf is as it was. A copy that cannot be made takes nothing away.
    pub fn serve(&self, shelf: &Shelf) -> Option<Result<(), OwnError>> {
        let path = lock(&self.wanted).take()?;
        let look = Entry::look(path.clone(), &[]);
        *lock(&self.taken) = look.map(|entry| (path.clone(), entry.stamp));
        Some(Own::load(&path).map(|own| {
            shelf.put(own);
            // The song has it, whatever becomes of the copy.
            let _ = self.copy(&path);
            self.arrived.store(true, Ordering::Release);
        }))
    }

    /// What is in the file that was taken last, if that has changed since it was last looked at and can be
    /// played.
    pub fn renewed(&self) -> Option<Card> {
        let mut taken = lock(&self.taken);
        let (path, stamp) = taken.as_mut()?;
        let entries = self.entries();
        let entry = entries.iter().find(|entry| entry.path == *path)?;
        let card = entry.card.as_ref().ok()?;
        let old = std::mem::replace(stamp, entry.stamp);
        (old != entry.stamp).then(|| card.clone())
    }

    /// Whether a file is a bank by its name.
    pub(super) fn is_bank(path: &Path) -> bool {
        path.extension()
            .is_some_and(|end| end.eq_ignore_ascii_case(EXTENSION))
    }

    /// Copies a file into the folder, under a name that is free there.
    pub(super) fn copy(&self, path: &Path) -> std::io::Result<()> {
        if self.folder.is_none() || path.parent() == self.folder() {
            return Ok(());
        }
        let [stem, end] = [path.file_stem(), path.extension()]
            .map(|part| part.unwrap_or_default().to_string_lossy().into_owned());
        self.keep_as(&stem, &end, &fs::read(path)?)
    }

    /// Puts a bank's file into the folder, under a name that is free there; nowhere, without a folder.
    ///
    /// # Errors
    ///
    /// If the system refuses.
    pub fn keep(&self, stem: &str, content: &[u8]) -> std::io::Result<()> {
        self.keep_as(stem, EXTENSION, content)
    }

    fn keep_as(&self, stem: &str, end: &str, content: &[u8]) -> std::io::Result<()> {
        let Some(folder) = &self.folder else {
            return Ok(());
        };
        fs::create_dir_all(folder)?;
        let names = std::iter::once(format!("{stem}.{end}"))
            .chain((2..1000).map(|number| format!("{stem}-{number}.{end}")));
        for name in names {
            let there = folder.join(name);
            match fs::read(&there) {
                Ok(old) if old == content => return Ok(()),
                Ok(_) => {}
                Err(_) => return fs::write(there, content),
            }
        }
        Ok(())
    }
}

pub(super) fn lock<T>(mutex: &Mutex<T>) -> MutexGuard<'_, T> {
    mutex.lock().unwrap_or_else(PoisonError::into_inner)
}

#[cfg(test)]
mod tests {
    use super::super::own::small_bank;
    use super::*;

    struct Folder(PathBuf);

    impl Folder {
        fn new(name: &str) -> Self {
            let name = format!("idiophone-library-{name}-{}", std::process::id());
            let folder = std::env::temp_dir().join(name);
            fs::create_dir_all(&folder).unwrap();
            Self(folder)
        }
    }

    impl Drop for Folder {
        fn drop(&mut self) {
            let _ = fs::remove_dir_all(&self.0);
        }
    }

    #[test]
    fn banks_are_listed_and_broken_ones_with_their_reason() {
        let folder = Folder::new("list");
        let library = Library::new(Some(folder.0.join("Banks")));
        assert!(!library.refresh(), "there is no folder");
        fs::create_dir(folder.0.join("Banks")).unwrap();
        let at = |name: &str| folder.0.join("Banks").join(name);
        small_bank("gong").save(at("b.bank")).unwrap();
        fs::write(at("a.bank"), "RIFF").unwrap();
        fs::write(at("notes.txt"), "no bank").unwrap();
        fs::create_dir(at("c.bank")).unwrap();
        let huge = fs::File::create(at("d.bank")).unwrap();
        huge.set_len(300 << 20).unwrap();
        assert!(library.refresh());
        assert!(!library.refresh(), "nothing new");
        let entries = library.entries();
        let titles: Vec<_> = entries.iter().map(Entry::title).collect();
        assert_eq!(titles, ["a.bank", "The gong", "d.bank"]);
        let reason = entries[2].card.as_ref().unwrap_err();
        assert!(reason.contains("300 MiB"), "{reason}");
        let reason = entries[0].card.as_ref().unwrap_err();
        assert!(reason.contains("not an Idiophone bank"), "{reason}");
        assert_eq!(library.named("gong"), Some(at("b.bank")));
        assert_eq!(library.named("bell"), None);
        small_bank("bell").save(at("a.bank")).unwrap();
        assert!(library.refresh());
        assert_eq!(library.named("bell"), Some(at("a.bank")));
        fs::remove_file(at("a.bank")).unwrap();
        assert!(library.refresh());
        assert_eq!(library.entries().len(), 2);
    }

    #[test]
    fn a_file_that_was_taken_and_is_built_anew_is_told_once() {
        let folder = Folder::new("anew");
        let file = folder.0.join("bell.bank");
        small_bank("bell").save(&file).unwrap();
        let (library, shelf) = (Library::new(Some(folder.0.clone())), Shelf::default());
        library.refresh();
        assert_eq!(library.renewed(), None, "none was taken");
        library.ask(file.clone());
        assert!(library.serve(&shelf).unwrap().is_ok());
        library.refresh();
        assert_eq!(library.renewed(), None);
        fs::write(&file, "half of it").unwrap();
        library.refresh();
        assert_eq!(library.renewed(), None, "it cannot be played");
        small_bank("larger bell").save(&file).unwrap();
        library.refresh();
        assert_eq!(library.renewed().unwrap().name, "larger bell");
        assert_eq!(library.renewed(), None);
    }

    #[test]
    fn what_is_asked_for_arrives_and_is_copied_once() {
        let folder = Folder::new("serve");
        let banks = folder.0.join("Banks");
        let library = Library::new(Some(banks.clone()));
        let shelf = Shelf::default();
        assert!(library.serve(&shelf).is_none() && !library.arrived());
        let file = folder.0.join("bell.bank");
        small_bank("bell").save(&file).unwrap();
        for _ in 0..2 {
            library.ask(file.clone());
            assert!(library.serve(&shelf).unwrap().is_ok());
            assert!(library.arrived() && !library.arrived());
        }
        assert_eq!(shelf.own().unwrap().title(), "The bell");
        assert_eq!(fs::read_dir(&banks).unwrap().count(), 1);
        small_bank("another").save(&file).unwrap();
        library.ask(file.clone());
        assert!(library.serve(&shelf).unwrap().is_ok());
        assert!(banks.join("bell-2.bank").is_file());
        fs::write(&file, "RIFF").unwrap();
        library.ask(file);
        let before = shelf.text();
        assert!(library.serve(&shelf).unwrap().is_err());
        assert_eq!(shelf.text(), before);
        assert_eq!(fs::read_dir(&banks).unwrap().count(), 2);
    }
}
