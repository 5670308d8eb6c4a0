//! Bodies drawn anew while they sound: the solver behind the knobs of the drawing.
//!
//! The maker follows the last drawing that is wanted and lets go of all before it. What sounds is drawn
//! first and coarse, then the other keys, then all of them as the recipe asks.

mod drawing;
mod drawn;
mod order;
mod passes;
mod shortfall;
mod solved;
#[cfg(test)]
mod tests;

pub(crate) use drawing::wanted_text;
pub use drawing::{Drawing, recipe_of};
pub use drawn::Drawn;
pub(crate) use order::Order;
pub use solved::Solved;

use crate::notices::Notices;
use crate::shelf::Shelf;
use passes::Passes;
use std::ops::Deref;
use std::sync::Arc;
use std::thread::{self, JoinHandle};
use std::time::Duration;

/// Between looks, should nobody wake the maker because it was not there yet.
const PAUSE: Duration = Duration::from_millis(100);

/// What a maker takes from and gives to.
#[derive(Clone, Debug, Default)]
pub(crate) struct Stores {
    /// Where instruments come from.
    pub(crate) shelf: Arc<Shelf>,
    /// Where what is solved to the end goes.
    pub(crate) solved: Arc<Solved>,
    /// Where what is delivered can be seen.
    pub(crate) drawn: Arc<Drawn>,
    /// Where it is told what cannot be drawn.
    pub(crate) notices: Arc<Notices>,
}

/// An order with a thread that works at it.
pub(crate) struct Maker {
    order: Arc<Order>,
    thread: Option<JoinHandle<()>>,
}

impl Maker {
    /// For the instrument of a number and those after it, at `rate_hz`. Without a thread to be had, drawings
    /// do not change.
    pub(crate) fn open(stores: Stores, number: usize, rate_hz: f64) -> Self {
        let order = Arc::new(Order::new(number));
        let there = Arc::clone(&order);
        let work = move || {
            let mut passes = Passes::new(stores, rate_hz);
            let mut seen = 0;
            there.employ(thread::current());
            while !there.is_closing() {
                let wanted = there.wanted();
                if wanted.turn == seen {
                    thread::park_timeout(PAUSE);
                } else {
                    seen = wanted.turn;
                    passes.follow(&wanted, &there);
                    there.settled(seen);
                }
            }
        };
        let thread = thread::Builder::new()
            .name("idiophone maker".to_owned())
            .spawn(move || with_helpers(work))
            .ok();
        if thread.is_none() {
            // Nobody is to wait for it.
            order.close();
        }
        Self { order, thread }
    }
}

/// Runs `work`, whose parallel parts half the machine does, so that the rest is left to what plays. All
/// helpers have gone when it returns: a host may unload the plug-in then.
fn with_helpers(work: impl FnOnce() + Send) {
    let cores = thread::available_parallelism().map_or(1, usize::from);
    let pool = rayon::ThreadPoolBuilder::new()
        .num_threads((cores / 2).max(1))
        .thread_name(|_| "idiophone solver".to_owned());
    // Without threads to be had there is no work either: drawings stay as they are.
    let _ = pool.build_scoped(rayon::ThreadBuilder::run, |pool| pool.install(work));
}

impl Deref for Maker {
    type Target = Arc<Order>;

    fn deref(&self) -> &Arc<Order> {
        &self.order
    }
}

impl Drop for Maker {
    fn drop(&mut self) {
        self.order.close();
        if let Some(thread) = self.thread.take() {
            let _ = thread.join();
        }
    }
}
