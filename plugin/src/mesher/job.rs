//! One build: a preview, then the whole, each put on the shelf as soon as it is there.

use super::state::Shared;
use super::{Phase, Places, Quality};
use crate::notices::{Cure, Notice, Subject};
use crate::shelf::Own;
use modes::factory::Progress;
use modes::freeform::{Made, make};
use modes::{FreeFineness, MeshOrder};
use rayon::ThreadPoolBuilder;
use std::ops::ControlFlow;
use std::sync::Arc;
use std::thread;

/// Nodes and modes of a preview.
const PREVIEW: (u32, u32) = (2500, 40);
/// Threads that a build takes at most; one processor is left to the host.
const MOST_THREADS: usize = 4;

pub(super) struct Job {
    pub(super) order: MeshOrder,
    pub(super) quality: Quality,
    pub(super) places: Places,
    pub(super) shared: Arc<Shared>,
    pub(super) news: Box<dyn Fn() + Send + Sync>,
}

impl Job {
    pub(super) fn run(&self) {
        let processors = thread::available_parallelism().map_or(1, usize::from);
        let threads = (processors - 1).clamp(1, MOST_THREADS);
        let name = |_| "idiophone mesher".to_owned();
        let pool = ThreadPoolBuilder::new()
            .num_threads(threads)
            .thread_name(name);
        let ended = match pool.build() {
            Ok(pool) => pool.install(|| self.build()),
            Err(error) => Err(error.to_string()),
        };
        self.shared.end(match ended {
            Ok(file) => self.keep(&file),
            Err(reason) => self.failed(reason),
        });
        (self.news)();
    }

    /// Puts the bank's file into the user's folder too.
    fn keep(&self, file: &[u8]) -> Phase {
        match self.places.library.keep(&self.order.name(), file) {
            Ok(()) => Phase::Done,
            Err(error) => Phase::Refused(format!(
                "The song has it, but its file cannot be written: {error}"
            )),
        }
    }

    /// What has become of what did not come to its end. A preview that plays is kept: it is what the user hears.
    fn failed(&self, reason: String) -> Phase {
        let previewed = self.shared.state().phase == Phase::Full;
        let cancelled = self.shared.is_cancelled();
        if previewed {
            let why = if cancelled {
                "full quality was given up"
            } else {
                &reason
            };
            self.places.notices.post(Notice {
                subject: Subject::Bank,
                text: format!("{} plays as a preview: {why}.", self.order.name()),
                cure: cancelled.then(|| Cure::Finish(Box::new(self.order.clone()))),
            });
        }
        match (cancelled, previewed) {
            (true, true) => Phase::Stopped,
            (true, false) => Phase::Cancelled,
            (false, _) => Phase::Refused(reason),
        }
    }

    /// Builds what is asked for; the last bank as a file.
    fn build(&self) -> Result<Vec<u8>, String> {
        let FreeFineness {
            nodes, most_modes, ..
        } = FreeFineness::default();
        let mut bytes = self.make(PREVIEW)?;
        if self.quality == Quality::Full {
            self.shared.begin(Phase::Full);
            (self.news)();
            bytes = self.make((nodes as u32, most_modes as u32))?;
        }
        Ok(bytes)
    }

    /// Builds at a fineness and puts it on the shelf; the bank as a file.
    fn make(&self, (nodes, most_modes): (u32, u32)) -> Result<Vec<u8>, String> {
        let order = MeshOrder {
            nodes,
            most_modes,
            ..self.order.clone()
        };
        let said = |error: &dyn std::error::Error| error.to_string();
        let recipe = order.recipe("the mesh").map_err(|error| said(&error))?;
        let Made { bank, notes } = make(&recipe, self).map_err(|error| said(&error))?;
        self.shared
            .found(notes.iter().map(ToString::to_string).collect());
        if self.shared.is_cancelled() {
            return Err("cancelled".to_owned());
        }
        let bytes = bank.write();
        self.places
            .shelf
            .put(Own::new(bank).map_err(|error| said(&error))?);
        self.places.library.arrive();
        (self.news)();
        Ok(bytes)
    }
}

impl Progress for Job {
    fn advance(&self, done: usize, total: usize) -> ControlFlow<()> {
        let on = self.shared.advance(done, total);
        (self.news)();
        on
    }
}
