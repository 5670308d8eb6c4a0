//! Word of a long solution to whoever waits for it.

use std::ops::ControlFlow;

/// Told how far a solution is, from the thread that computes it; may end it.
pub trait Watch {
    /// `converged` of `wanted` modes are known, rigid motions included; `wanted` is 0 until they have
    /// been counted. Called after each factorisation and every eight vectors. `Break` ends the work
    /// with [`SolveError::Cancelled`](super::SolveError::Cancelled).
    fn converged(&self, converged: usize, wanted: usize) -> ControlFlow<()>;
}

/// Watches nothing.
impl Watch for () {
    fn converged(&self, _: usize, _: usize) -> ControlFlow<()> {
        ControlFlow::Continue(())
    }
}

impl<F: Fn(usize, usize) -> ControlFlow<()>> Watch for F {
    fn converged(&self, converged: usize, wanted: usize) -> ControlFlow<()> {
        self(converged, wanted)
    }
}
