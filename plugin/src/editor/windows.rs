//! What is known of an instance's windows.

use std::sync::Arc;
use std::sync::atomic::{AtomicBool, AtomicU32, AtomicUsize, Ordering};

/// Shared by an instance and its windows.
pub(crate) struct Windows {
    open: AtomicUsize,
    /// There is something new to draw.
    news: AtomicBool,
    /// Pixels to a point when a window was last seen.
    scale: AtomicU32,
}

impl Default for Windows {
    fn default() -> Self {
        Self {
            open: AtomicUsize::new(0),
            news: AtomicBool::new(false),
            scale: AtomicU32::new(1f32.to_bits()),
        }
    }
}

impl Windows {
    /// Whether there is any.
    pub(crate) fn is_open(&self) -> bool {
        self.open.load(Ordering::Relaxed) != 0
    }

    /// There is something new to draw; for any thread.
    pub(crate) fn repaint(&self) {
        self.news.store(true, Ordering::Relaxed);
    }

    /// Whether there has been something new to draw since last asked.
    pub(super) fn news(&self) -> bool {
        self.news.swap(false, Ordering::Relaxed)
    }

    /// There are so many pixels to a point.
    pub(super) fn see(&self, scale: f64) {
        self.scale
            .store((scale as f32).to_bits(), Ordering::Relaxed);
    }

    /// Pixels to a point when a window was last seen.
    pub(super) fn scale(&self) -> f64 {
        f32::from_bits(self.scale.load(Ordering::Relaxed)).into()
    }
}

/// Counts a window for as long as it is there.
pub(super) struct Open(Arc<Windows>);

impl Open {
    pub(super) fn new(windows: Arc<Windows>) -> Self {
        windows.open.fetch_add(1, Ordering::Relaxed);
        Self(windows)
    }

    /// There are so many pixels to a point here.
    pub(super) fn see(&self, scale: f64) {
        self.0.see(scale);
    }
}

impl Drop for Open {
    fn drop(&mut self) {
        self.0.open.fetch_sub(1, Ordering::Relaxed);
    }
}
