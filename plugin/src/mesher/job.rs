//! One build: a preview, then the whole, each put on the shelf as soon as it is there.

use super::state::Shared;
use super::{Phase, Quality};
use crate::shelf::{Library, Own, Shelf};
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
    pub(super) library: Arc<Library>,
    pub(super) shelf: Arc<Shelf>,
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
            Ok(()) => Phase::Done,
            Err(_) if self.shared.is_cancelled() => Phase::Cancelled,
            Err(reason) => Phase::Refused(reason),
        });
        (self.news)();
    }

    fn build(&self) -> Result<(), String> {
        let FreeFineness {
            nodes, most_modes, ..
        } = FreeFineness::default();
        let mut bytes = self.make(PREVIEW)?;
        if self.quality == Quality::Full {
            self.shared.begin(Phase::Full);
            (self.news)();
            bytes = self.make((nodes as u32, most_modes as u32))?;
        }
        let stem = self.order.name();
        self.library
            .keep(&stem, &bytes)
            .map_err(|error| format!("The song has it, but its file cannot be written: {error}"))
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
        self.shelf
            .put(Own::new(bank).map_err(|error| said(&error))?);
        self.library.arrive();
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
