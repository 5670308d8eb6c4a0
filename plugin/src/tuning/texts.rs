//! The tuning that travels with a song: the texts of a scale and of a keyboard map.

use crossbeam_queue::ArrayQueue;
use modes::tuning::{KeyboardMap, ScalaError, Scale, Tuning};
use nice_plug::params::persist::PersistentField;
use std::path::Path;
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};

/// A scale and a keyboard map, as texts, and the tuning that they make.
///
/// Texts are read where they are set, which is never the audio thread; that fetches a tuning when there
/// is a new one, without waiting. What cannot be read leaves the tuning as it was, and stays in the song.
#[derive(Debug)]
pub struct TuningTexts {
    inner: Mutex<Inner>,
    news: ArrayQueue<Tuning>,
}

#[derive(Debug, Default)]
struct Inner {
    scale: String,
    keyboard: String,
    /// What counts while both texts are empty.
    home: Tuning,
    tuning: Tuning,
    fault: Option<String>,
    home_fault: Option<String>,
}

impl Default for TuningTexts {
    fn default() -> Self {
        Self {
            inner: Mutex::default(),
            news: ArrayQueue::new(1),
        }
    }
}

impl TuningTexts {
    /// The text of the `.scl` file; empty for twelve equal steps to the octave.
    #[must_use]
    pub fn scale(&self) -> String {
        self.lock().scale.clone()
    }

    /// The text of the `.kbm` file; empty for one degree to a key.
    #[must_use]
    pub fn keyboard(&self) -> String {
        self.lock().keyboard.clone()
    }

    /// Another scale.
    pub fn set_scale(&self, text: String) {
        self.change(|inner| inner.scale = text);
    }

    /// Another keyboard map.
    pub fn set_keyboard(&self, text: String) {
        self.change(|inner| inner.keyboard = text);
    }

    /// What is wrong with the texts, or with the user's own files while there are none, in one line;
    /// `None` if nothing is.
    #[must_use]
    pub fn fault(&self) -> Option<String> {
        let inner = self.lock();
        let home = || inner.is_empty().then(|| inner.home_fault.clone()).flatten();
        inner.fault.clone().or_else(home)
    }

    /// The tuning that the texts make, or made before they could no longer be read.
    #[must_use]
    pub fn tuning(&self) -> Tuning {
        self.lock().tuning
    }

    /// Takes `tuning/default.scl` and `tuning/default.kbm` in the user's folder, as far as they are
    /// there, for songs that have no tuning of their own.
    pub fn visit(&self, folder: &Path) {
        let file =
            |name: &str| Some(folder.join("tuning").join(name)).filter(|path| path.is_file());
        let (scl, kbm) = (file("default.scl"), file("default.kbm"));
        let home = Tuning::load(scl.as_deref(), kbm.as_deref());
        self.change(|inner| match home {
            Ok(home) => (inner.home, inner.home_fault) = (home, None),
            Err(error) => inner.home_fault = Some(error.to_string()),
        });
    }

    /// The tuning if it has changed since last asked. For the audio thread: neither allocates nor waits.
    pub(crate) fn fetch(&self) -> Option<Tuning> {
        self.news.pop()
    }

    fn change(&self, change: impl FnOnce(&mut Inner)) {
        let mut inner = self.lock();
        change(&mut inner);
        if let Some(tuning) = inner.read() {
            let _ = self.news.force_push(tuning);
        }
    }

    fn lock(&self) -> MutexGuard<'_, Inner> {
        self.inner.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

impl Inner {
    fn is_empty(&self) -> bool {
        self.scale.is_empty() && self.keyboard.is_empty()
    }

    /// Reads the texts; the tuning if there is another.
    fn read(&mut self) -> Option<Tuning> {
        let made = if self.is_empty() {
            Ok(self.home)
        } else {
            self.parse()
        };
        match made {
            Ok(tuning) => {
                self.fault = None;
                let old = std::mem::replace(&mut self.tuning, tuning);
                (old != tuning).then_some(tuning)
            }
            Err(fault) => {
                self.fault = Some(fault);
                None
            }
        }
    }

    fn parse(&self) -> Result<Tuning, String> {
        fn one<T: Default>(
            what: &str,
            text: &str,
            parse: impl Fn(&[u8]) -> Result<T, ScalaError>,
        ) -> Result<T, String> {
            if text.is_empty() {
                return Ok(T::default());
            }
            parse(text.as_bytes()).map_err(|error| format!("{what}, {error}"))
        }
        let scale = one("scale", &self.scale, Scale::parse)?;
        let map = one("keyboard map", &self.keyboard, KeyboardMap::parse)?;
        Ok(Tuning::new(&scale, &map))
    }
}

/// The scale's text as a song keeps it.
#[derive(Debug)]
pub struct ScaleText(pub(crate) Arc<TuningTexts>);

impl<'a> PersistentField<'a, String> for ScaleText {
    fn set(&self, text: String) {
        self.0.set_scale(text);
    }

    fn map<F: Fn(&String) -> R, R>(&self, read: F) -> R {
        read(&self.0.lock().scale)
    }
}

/// The keyboard map's text as a song keeps it.
#[derive(Debug)]
pub struct KeyboardText(pub(crate) Arc<TuningTexts>);

impl<'a> PersistentField<'a, String> for KeyboardText {
    fn set(&self, text: String) {
        self.0.set_keyboard(text);
    }

    fn map<F: Fn(&String) -> R, R>(&self, read: F) -> R {
        read(&self.0.lock().keyboard)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const FIFTHS: &str = "fifths.scl\n2\n3/2\n2/1\n";

    #[test]
    fn texts_make_a_tuning_once() {
        let texts = TuningTexts::default();
        assert_eq!(texts.fetch(), None);
        texts.set_scale(FIFTHS.to_owned());
        let tuning = texts.fetch().unwrap();
        assert_eq!(texts.fetch(), None);
        assert_eq!(tuning, texts.tuning());
        assert_ne!(tuning, Tuning::default());
        texts.set_scale(FIFTHS.to_owned());
        assert_eq!(texts.fetch(), None, "the same");
        texts.set_scale(String::new());
        assert_eq!(texts.fetch(), Some(Tuning::default()));
    }

    #[test]
    fn what_cannot_be_read_is_told_and_kept_and_changes_nothing() {
        let texts = TuningTexts::default();
        texts.set_scale(FIFTHS.to_owned());
        let good = texts.fetch().unwrap();
        texts.set_scale("bad.scl\n2\n3/2\n5/0\n".to_owned());
        assert_eq!(texts.fetch(), None);
        assert_eq!(texts.tuning(), good);
        let fault = texts.fault().unwrap();
        assert!(fault.starts_with("scale, line 4: \"5/0\""), "{fault}");
        assert!(texts.scale().contains("5/0"));
        texts.set_keyboard("12\n0\n128\n".to_owned());
        texts.set_scale(FIFTHS.to_owned());
        let fault = texts.fault().unwrap();
        assert!(fault.starts_with("keyboard map, line 3"), "{fault}");
        texts.set_keyboard(String::new());
        assert_eq!(texts.fault(), None);
    }

    #[test]
    fn the_users_own_files_count_while_a_song_has_none() {
        let folder = std::env::temp_dir().join(format!("idiophone-{}", std::process::id()));
        let tuning = folder.join("tuning");
        std::fs::create_dir_all(&tuning).unwrap();
        let texts = TuningTexts::default();
        texts.visit(&folder);
        assert_eq!((texts.fetch(), texts.fault()), (None, None));
        std::fs::write(tuning.join("default.scl"), FIFTHS).unwrap();
        texts.visit(&folder);
        let home = texts.fetch().unwrap();
        assert_ne!(home, Tuning::default());
        texts.set_scale("octaves\n1\n2/1\n".to_owned());
        assert_ne!(texts.fetch(), Some(home));
        std::fs::write(tuning.join("default.scl"), "no scale").unwrap();
        texts.visit(&folder);
        assert_eq!(texts.fault(), None, "the song has its own");
        texts.set_scale(String::new());
        assert_eq!(texts.fetch(), Some(home));
        assert!(texts.fault().unwrap().contains("default.scl"));
        std::fs::remove_dir_all(&folder).unwrap();
    }
}
