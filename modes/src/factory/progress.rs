//! Word of long work to whoever waits for it.

use std::ops::ControlFlow;

/// Told how far a build is, from whatever thread does the work; may end it.
pub trait Progress: Sync {
    /// `done` of `total` bodies are finished. `Break` cancels the rest.
    fn advance(&self, done: usize, total: usize) -> ControlFlow<()>;
}

/// Tells nobody, never cancels.
#[derive(Clone, Copy, Debug, Default)]
pub struct Silent;

impl Progress for Silent {
    fn advance(&self, _: usize, _: usize) -> ControlFlow<()> {
        ControlFlow::Continue(())
    }
}
