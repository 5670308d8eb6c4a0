//! Instruments out of meshes: a file looked into, then built on a thread of its own.

mod facts;
mod job;
mod state;

pub use facts::{Facts, Part, guessed_size_m};
pub use state::{Phase, Quality, State};

use crate::notices::{Notices, Subject};
use crate::shelf::{Library, Shelf};
use modes::MeshOrder;
use state::Shared;
use std::path::PathBuf;
use std::sync::Arc;
use std::thread::{self, JoinHandle};

/// Where what is built goes, and what is to be known of it.
#[derive(Clone)]
pub struct Places {
    /// Has the user's folder, for the last quality that was asked for.
    pub library: Arc<Library>,
    /// Has the instrument that plays, in each quality as it comes.
    pub shelf: Arc<Shelf>,
    /// Are told when a preview is all that came.
    pub notices: Arc<Notices>,
}

/// What builds one instrument at a time.
///
/// When this is dropped, what is being built is given up: the step at hand is waited for, because a host
/// may unload the plug-in right after.
#[derive(Default)]
pub struct Mesher {
    shared: Arc<Shared>,
    thread: Option<JoinHandle<()>>,
}

impl Mesher {
    /// Looks into the mesh's file at `path`; [`State::facts`] then tells of it.
    pub fn look(&mut self, path: PathBuf, news: impl Fn() + Send + Sync + 'static) {
        self.give_up();
        self.shared.begin(Phase::Looking);
        let shared = Arc::clone(&self.shared);
        self.work(move || {
            shared.looked(Facts::of(&path));
            news();
        });
    }

    /// Builds what is ordered. The preview sounds as soon as it is there; what comes of full quality
    /// replaces it. The last one goes into the library's folder too.
    ///
    /// If full quality is given up or cannot be had, the preview plays on and goes with the song, and a notice
    /// says so, which offers to go on.
    pub fn build(
        &mut self,
        order: MeshOrder,
        quality: Quality,
        places: &Places,
        news: impl Fn() + Send + Sync + 'static,
    ) {
        self.give_up();
        places.notices.clear(Subject::Bank);
        self.shared.begin(Phase::Preview);
        let job = job::Job {
            order,
            quality,
            places: places.clone(),
            shared: Arc::clone(&self.shared),
            news: Box::new(news),
        };
        self.work(move || job.run());
    }

    /// How it stands.
    #[must_use]
    pub fn state(&self) -> State {
        self.shared.state()
    }

    /// Asks what is being built to end; it does at its next step.
    pub fn cancel(&self) {
        self.shared.cancel();
    }

    fn work(&mut self, work: impl FnOnce() + Send + 'static) {
        let thread = thread::Builder::new()
            .name("idiophone mesher".to_owned())
            .spawn(work);
        match thread {
            Ok(thread) => self.thread = Some(thread),
            Err(error) => self
                .shared
                .refuse(format!("The system has no thread to spare: {error}")),
        }
    }

    fn give_up(&mut self) {
        self.shared.cancel();
        if let Some(thread) = self.thread.take() {
            let _ = thread.join();
        }
    }
}

impl Drop for Mesher {
    fn drop(&mut self) {
        self.give_up();
    }
}

#[cfg(test)]
mod tests;
