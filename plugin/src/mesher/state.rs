//! How a build stands, between its thread and the window.

use super::Facts;
use std::ops::ControlFlow;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Mutex, MutexGuard, PoisonError};
use std::time::Instant;

/// How finely a body is solved.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Quality {
    /// In seconds.
    Preview,
    /// As well as the shell's commands do by default.
    Full,
}

/// What is being done.
#[derive(Clone, Debug, Default, PartialEq)]
pub enum Phase {
    /// Nothing.
    #[default]
    Idle,
    /// The file is read.
    Looking,
    /// The preview is built.
    Preview,
    /// The preview sounds, and full quality is built.
    Full,
    /// What was built is there.
    Done,
    /// The user has had enough, and nothing has changed.
    Cancelled,
    /// The user has had enough of waiting for full quality: the preview plays on.
    Stopped,
    /// It cannot be, and why.
    Refused(String),
}

impl Phase {
    /// Whether a thread is at work.
    #[must_use]
    pub fn works(&self) -> bool {
        matches!(self, Self::Looking | Self::Preview | Self::Full)
    }
}

/// How a build stands.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct State {
    /// What is being done.
    pub phase: Phase,
    /// How much of it is done, 0…1.
    pub share: f32,
    /// What is left of it, in s; unknown at first.
    pub left_s: Option<f32>,
    /// The file that was looked into last.
    pub facts: Option<Facts>,
    /// What was found in the mesh and mended.
    pub notes: Vec<String>,
}

/// Share of a phase before which nothing is said of how long it takes.
const SURE: f32 = 0.08;

#[derive(Default)]
pub(super) struct Shared {
    state: Mutex<State>,
    began: Mutex<Option<Instant>>,
    cancelled: AtomicBool,
}

impl Shared {
    pub(super) fn state(&self) -> State {
        self.lock().clone()
    }

    /// A new phase, of which nothing is done.
    pub(super) fn begin(&self, phase: Phase) {
        if phase != Phase::Full {
            self.cancelled.store(false, Ordering::Release);
        }
        let mut state = self.lock();
        (state.phase, state.share, state.left_s) = (phase, 0.0, None);
        *self.began.lock().unwrap_or_else(PoisonError::into_inner) = Some(Instant::now());
    }

    pub(super) fn looked(&self, facts: Result<Facts, String>) {
        let mut state = self.lock();
        state.notes.clear();
        match facts {
            Ok(facts) => (state.phase, state.facts) = (Phase::Idle, Some(facts)),
            Err(reason) => (state.phase, state.facts) = (Phase::Refused(reason), None),
        }
    }

    /// `done` of `total` steps of the phase are.
    pub(super) fn advance(&self, done: usize, total: usize) -> ControlFlow<()> {
        let began = *self.began.lock().unwrap_or_else(PoisonError::into_inner);
        let mut state = self.lock();
        state.share = state.share.max(done as f32 / total.max(1) as f32).min(1.0);
        let passed_s = began.map(|began| began.elapsed().as_secs_f32());
        let share = state.share;
        state.left_s = passed_s
            .filter(|_| share > SURE)
            .map(|passed_s| passed_s * (1.0 - share) / share);
        if self.is_cancelled() {
            ControlFlow::Break(())
        } else {
            ControlFlow::Continue(())
        }
    }

    pub(super) fn found(&self, notes: Vec<String>) {
        self.lock().notes = notes;
    }

    pub(super) fn end(&self, phase: Phase) {
        self.lock().phase = phase;
    }

    pub(super) fn refuse(&self, reason: String) {
        self.end(Phase::Refused(reason));
    }

    pub(super) fn cancel(&self) {
        self.cancelled.store(true, Ordering::Release);
    }

    pub(super) fn is_cancelled(&self) -> bool {
        self.cancelled.load(Ordering::Acquire)
    }

    fn lock(&self) -> MutexGuard<'_, State> {
        self.state.lock().unwrap_or_else(PoisonError::into_inner)
    }
}
