//! What the audio thread wants of the maker and what it gets, without locks.

use super::Drawing;
use crate::workshop::Ready;
use crossbeam_queue::ArrayQueue;
use std::sync::OnceLock;
use std::sync::atomic::{AtomicBool, AtomicU32, AtomicU64, AtomicUsize, Ordering};
use std::thread::{self, Thread};
use std::time::{Duration, Instant};

/// Longer than any drawing takes to be solved.
const PATIENCE: Duration = Duration::from_secs(300);
/// Between two looks of one who waits.
const LOOK: Duration = Duration::from_millis(1);

/// The last drawing wanted; only one thread wants.
pub(crate) struct Order {
    /// Counts the changes of what follows, which is written before.
    turn: AtomicU64,
    number: AtomicUsize,
    drawing: [AtomicU32; 5],
    /// Keys whose bodies sound, as bits: low, high.
    awake: [AtomicU64; 2],
    ready: ArrayQueue<Ready>,
    /// The turns of which all drafts were delivered last, and all there is to deliver.
    drafted: AtomicU64,
    settled: AtomicU64,
    /// Whether drafts alone are wanted for now.
    drafts: AtomicBool,
    closing: AtomicBool,
    worker: OnceLock<Thread>,
}

/// An order as it was looked at.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Wanted {
    pub(super) turn: u64,
    /// Number of the instrument.
    pub(super) number: usize,
    pub(super) drawing: Drawing,
}

impl Order {
    /// Of an instrument as its recipe draws it.
    pub(super) fn new(number: usize) -> Self {
        Self {
            turn: AtomicU64::new(0),
            number: AtomicUsize::new(number),
            drawing: bits(&Drawing::OWN).map(AtomicU32::new),
            awake: [const { AtomicU64::new(0) }; 2],
            ready: ArrayQueue::new(1),
            drafted: AtomicU64::new(0),
            settled: AtomicU64::new(0),
            drafts: AtomicBool::new(false),
            closing: AtomicBool::new(false),
            worker: OnceLock::new(),
        }
    }

    /// Wants the instrument of a number in a drawing; the bodies that are `awake`, as bits, first.
    pub(crate) fn want(&self, number: usize, drawing: &Drawing, awake: u128) {
        self.awake[0].store(awake as u64, Ordering::Relaxed);
        self.awake[1].store((awake >> 64) as u64, Ordering::Relaxed);
        let mut changed = self.number.swap(number, Ordering::Relaxed) != number;
        for (kept, new) in self.drawing.iter().zip(bits(drawing)) {
            changed |= kept.swap(new, Ordering::Relaxed) != new;
        }
        if changed {
            self.turn.fetch_add(1, Ordering::Release);
            self.wake();
        }
    }

    fn wake(&self) {
        if let Some(worker) = self.worker.get() {
            worker.unpark();
        }
    }

    /// Wants the whole of what is wanted next, or drafts of it alone until the whole is.
    pub(crate) fn pace(&self, whole: bool) {
        self.drafts.store(!whole, Ordering::Release);
    }

    /// Blocks until all that is wanted is ready at the last pace; whether that did not take too long. Not
    /// for a real-time thread.
    pub(crate) fn wait(&self) -> bool {
        let wanted = self.turn.load(Ordering::Relaxed);
        let drafts = self.drafts.load(Ordering::Relaxed);
        let start = Instant::now();
        while start.elapsed() < PATIENCE {
            let is_settled = self.settled.load(Ordering::Acquire) >= wanted;
            let is_drafted = drafts && self.drafted.load(Ordering::Acquire) >= wanted;
            if is_settled || is_drafted || self.is_closing() {
                return true;
            }
            thread::sleep(LOOK);
        }
        false
    }

    /// Drafts of all that was wanted at a turn are delivered; blocks while they alone are wanted.
    pub(super) fn drafted(&self, turn: u64) {
        self.drafted.store(turn, Ordering::Release);
        while self.drafts.load(Ordering::Acquire) && !self.is_past(turn) {
            thread::park_timeout(LOOK);
        }
    }

    /// All that there is of what was wanted at a turn is delivered.
    pub(super) fn settled(&self, turn: u64) {
        self.settled.store(turn, Ordering::Release);
    }

    /// The last instrument made, once.
    pub(crate) fn fetch(&self) -> Option<Ready> {
        self.ready.pop()
    }

    /// What is wanted now.
    pub(super) fn wanted(&self) -> Wanted {
        // What is written in the meantime comes with another turn, and is looked at again.
        let turn = self.turn.load(Ordering::Acquire);
        let [length, wall, width, profile, poisson] =
            [0, 1, 2, 3, 4].map(|i: usize| f32::from_bits(self.drawing[i].load(Ordering::Relaxed)));
        Wanted {
            turn,
            number: self.number.load(Ordering::Relaxed),
            drawing: Drawing {
                length,
                wall,
                width,
                profile,
                poisson,
            },
        }
    }

    /// The keys whose bodies sound, as bits.
    pub(super) fn awake(&self) -> u128 {
        let [low, high] = [0, 1].map(|i: usize| u128::from(self.awake[i].load(Ordering::Relaxed)));
        high << 64 | low
    }

    /// Whether something else is wanted than at a turn, or nothing any longer.
    pub(super) fn is_past(&self, turn: u64) -> bool {
        self.is_closing() || self.turn.load(Ordering::Acquire) != turn
    }

    /// Delivers; what was not fetched is taken apart here.
    pub(super) fn deliver(&self, made: Ready) {
        drop(self.ready.force_push(made));
    }

    pub(super) fn employ(&self, worker: Thread) {
        let _ = self.worker.set(worker);
    }

    pub(super) fn close(&self) {
        self.closing.store(true, Ordering::Release);
        self.wake();
    }

    pub(super) fn is_closing(&self) -> bool {
        self.closing.load(Ordering::Acquire)
    }
}

fn bits(drawing: &Drawing) -> [u32; 5] {
    let Drawing {
        length,
        wall,
        width,
        profile,
        poisson,
    } = *drawing;
    [length, wall, width, profile, poisson].map(f32::to_bits)
}
