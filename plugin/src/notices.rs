//! What a user should know, from whoever finds out to the editor.

use modes::MeshOrder;
use std::sync::{Mutex, MutexGuard, PoisonError};

/// What a notice is about; there is one for each at most.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Subject {
    /// The song's instrument.
    Instrument,
    /// The user's own bank in the song.
    Bank,
    /// What else of the song is not known.
    Song,
    /// What the knobs of the drawing ask for and no body can be.
    Drawing,
    /// A bank that was asked for.
    File,
    /// Files that were dropped on the window.
    Dropped,
    /// The window.
    Window,
}

/// What a button beside a notice can do about it.
#[derive(Clone, Debug, PartialEq)]
pub enum Cure {
    /// Choose for good what plays in the song's stead.
    Stay,
    /// Load the bank of this name from the user's folder, or show the folder if it is not there.
    Load(String),
    /// Build in full quality what plays as a preview.
    Finish(Box<MeshOrder>),
}

/// One thing to know.
#[derive(Clone, Debug, PartialEq)]
pub struct Notice {
    /// What it is about.
    pub subject: Subject,
    /// What is the matter and how to mend it, in one line.
    pub text: String,
    /// What a button can do.
    pub cure: Option<Cure>,
}

/// The notices of an instance; never for the audio thread.
#[derive(Debug, Default)]
pub struct Notices(Mutex<Vec<Notice>>);

impl Notices {
    /// Another notice, instead of the one about the same.
    pub fn post(&self, notice: Notice) {
        self.clear(notice.subject);
        self.lock().push(notice);
    }

    /// There is nothing more to know about this.
    pub fn clear(&self, subject: Subject) {
        self.lock().retain(|notice| notice.subject != subject);
    }

    /// The oldest notice.
    #[must_use]
    pub fn first(&self) -> Option<Notice> {
        self.lock().first().cloned()
    }

    /// All of them, the oldest first.
    #[must_use]
    pub fn all(&self) -> Vec<Notice> {
        self.lock().clone()
    }

    fn lock(&self) -> MutexGuard<'_, Vec<Notice>> {
        self.0.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn there_is_one_notice_to_a_subject_and_the_oldest_comes_first() {
        let notices = Notices::default();
        let notice = |subject, text: &str| Notice {
            subject,
            text: text.to_owned(),
            cure: None,
        };
        assert_eq!(notices.first(), None);
        notices.post(notice(Subject::Bank, "a"));
        notices.post(notice(Subject::File, "b"));
        notices.post(notice(Subject::Bank, "c"));
        let texts: Vec<_> = notices.all().into_iter().map(|one| one.text).collect();
        assert_eq!(texts, ["b", "c"]);
        notices.clear(Subject::File);
        assert_eq!(notices.first().unwrap().text, "c");
    }
}
