//! Who looks after the library while a window is open.

use super::{Card, Library, OwnError, Shelf};
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::thread::{self, JoinHandle};
use std::time::Duration;

/// Time between two looks at the folder.
const PAUSE: Duration = Duration::from_secs(1);

/// What a librarian has to say.
pub(crate) enum Said<'a> {
    /// Why a bank that was asked for, or a copy, does not come.
    Refused(&'a OwnError),
    /// The file of the bank that was taken last holds another now.
    Renewed(&'a Card),
}

/// A thread that loads what is asked for and watches the folder, until this is dropped.
pub(crate) struct Librarian {
    closing: Arc<AtomicBool>,
    thread: Option<JoinHandle<()>>,
}

impl Librarian {
    /// Begins; `say` is told what the user should know, `news` that there is something new to draw. Without
    /// a thread to be had, the list stays empty.
    pub(crate) fn hire(
        library: Arc<Library>,
        shelf: Arc<Shelf>,
        say: impl Fn(&Said<'_>) + Send + 'static,
        news: impl Fn() + Send + 'static,
    ) -> Self {
        let closing = Arc::new(AtomicBool::new(false));
        let closed = Arc::clone(&closing);
        let employer = Arc::clone(&library);
        let work = move || {
            while !closed.load(Ordering::Acquire) {
                let served = library.serve(&shelf);
                if let Some(Err(error)) = &served {
                    say(&Said::Refused(error));
                }
                let taken_in = library.take_in();
                for error in taken_in.iter().flatten() {
                    say(&Said::Refused(error));
                }
                let changed = library.refresh();
                let renewed = library.renewed();
                if let Some(card) = &renewed {
                    say(&Said::Renewed(card));
                }
                if changed || renewed.is_some() || served.is_some() || taken_in.is_some() {
                    news();
                }
                thread::park_timeout(PAUSE);
            }
        };
        let thread = thread::Builder::new()
            .name("idiophone librarian".to_owned())
            .spawn(work)
            .ok();
        if let Some(thread) = &thread {
            employer.employ(thread.thread().clone());
        }
        Self { closing, thread }
    }
}

impl Drop for Librarian {
    fn drop(&mut self) {
        self.closing.store(true, Ordering::Release);
        if let Some(thread) = self.thread.take() {
            thread.thread().unpark();
            let _ = thread.join();
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::own::small_bank;
    use super::*;
    use std::sync::mpsc;

    #[test]
    fn a_librarian_serves_and_goes_home() {
        let folder = std::env::temp_dir().join(format!("idiophone-desk-{}", std::process::id()));
        std::fs::create_dir_all(&folder).unwrap();
        let file = folder.join("bell.bank");
        small_bank("bell").save(&file).unwrap();
        let (library, shelf) = (Arc::new(Library::new(None)), Arc::<Shelf>::default());
        let (refusals, refused) = mpsc::channel();
        let (news, new) = mpsc::channel();
        let say = move |said: &Said<'_>| {
            if let Said::Refused(error) = said {
                let _ = refusals.send(error.to_string());
            }
        };
        let news = move || {
            let _ = news.send(());
        };
        let librarian = Librarian::hire(Arc::clone(&library), Arc::clone(&shelf), say, news);
        let patience = Duration::from_secs(60);
        library.ask(folder.join("nothing.bank"));
        assert!(
            refused
                .recv_timeout(patience)
                .unwrap()
                .contains("nothing.bank")
        );
        new.recv_timeout(patience).unwrap();
        library.ask(file);
        new.recv_timeout(patience).unwrap();
        assert!(library.arrived());
        assert_eq!(shelf.own().unwrap().title(), "The bell");
        drop(librarian);
        assert_eq!(Arc::strong_count(&shelf), 1);
        std::fs::remove_dir_all(folder).unwrap();
    }
}
