//! Where instruments are made ready and taken apart, away from the audio thread.
//!
//! A thread of our own: the framework's worker ends when a task reaches it after its instance has
//! gone, and then aborts the host.

use crate::engine::Engine;
use crate::shelf::Shelf;
use crossbeam_queue::ArrayQueue;
use std::ops::Deref;
use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};
use std::sync::{Arc, OnceLock};
use std::thread::{self, JoinHandle, Thread};
use std::time::{Duration, Instant};

/// Instruments that may wait to be taken apart.
const SPENT: usize = 8;

/// A hundred times what an instrument takes.
const PATIENCE: Duration = Duration::from_secs(10);

/// No instrument is asked for.
const NONE: usize = usize::MAX;

/// An engine and the number of its bank.
pub(crate) type Ready = (usize, Box<Engine>);

/// What the audio thread and the workshop hand each other, without locks.
pub(crate) struct Bench {
    asked: AtomicUsize,
    ready: ArrayQueue<Ready>,
    spent: ArrayQueue<Box<Engine>>,
    closing: AtomicBool,
    worker: OnceLock<Thread>,
    shelf: Arc<Shelf>,
    rate_hz: f64,
}

impl Bench {
    /// For instruments from a shelf at `rate_hz`; without a thread, [`Bench::work`] does the work.
    pub(crate) fn new(shelf: Arc<Shelf>, rate_hz: f64) -> Self {
        Self {
            asked: AtomicUsize::new(NONE),
            ready: ArrayQueue::new(1),
            spent: ArrayQueue::new(SPENT),
            closing: AtomicBool::new(false),
            worker: OnceLock::new(),
            shelf,
            rate_hz,
        }
    }

    /// Asks for the instrument of that number, instead of the one asked for before.
    pub(crate) fn ask(&self, number: usize) {
        self.asked.store(number, Ordering::Release);
        self.wake();
    }

    /// The last instrument that was made ready, once.
    pub(crate) fn fetch(&self) -> Option<Ready> {
        self.ready.pop()
    }

    /// Blocks until the instrument of that number, which was asked for, is ready; `None` if that
    /// takes too long. Any other, made before the last change of mind, is taken apart.
    pub(crate) fn wait(&self, wanted: usize) -> Option<Ready> {
        patiently(|| match self.fetch() {
            Some((number, engine)) if number != wanted => {
                // Without a thread to take it, it is dropped here.
                let _ = self.discard_surely(engine);
                None
            }
            ready => ready,
        })
    }

    /// Hands over an instrument to be taken apart; back, if there is no room.
    pub(crate) fn discard(&self, engine: Box<Engine>) -> Result<(), Box<Engine>> {
        self.spent.push(engine)?;
        self.wake();
        Ok(())
    }

    /// The same, but blocks until there is room; back, if that takes too long.
    pub(crate) fn discard_surely(&self, engine: Box<Engine>) -> Result<(), Box<Engine>> {
        let mut engine = Some(engine);
        patiently(|| {
            engine = self.discard(engine.take()?).err();
            engine.is_none().then_some(())
        });
        engine.map_or(Ok(()), Err)
    }

    fn wake(&self) {
        if let Some(worker) = self.worker.get() {
            worker.unpark();
        }
    }

    /// Does what there is to do; whether there was anything.
    pub(crate) fn work(&self) -> bool {
        let mut busy = false;
        while self.spent.pop().is_some() {
            busy = true;
        }
        let number = self.asked.swap(NONE, Ordering::AcqRel);
        if number != NONE {
            let engine = Box::new(Engine::new(&self.shelf.bank(number), self.rate_hz));
            // One that was not fetched is no longer wanted.
            drop(self.ready.force_push((number, engine)));
            busy = true;
        }
        busy
    }
}

/// Tries again and again, until there is a result or patience ends.
fn patiently<T>(mut attempt: impl FnMut() -> Option<T>) -> Option<T> {
    let start = Instant::now();
    while start.elapsed() < PATIENCE {
        if let result @ Some(_) = attempt() {
            return result;
        }
        thread::sleep(Duration::from_millis(1));
    }
    None
}

/// A bench with a thread that works at it.
pub(crate) struct Workshop {
    bench: Arc<Bench>,
    thread: Option<JoinHandle<()>>,
}

impl Workshop {
    /// For instruments from a shelf at `rate_hz`. Without a thread to be had, instruments do not change.
    pub(crate) fn open(shelf: Arc<Shelf>, rate_hz: f64) -> Self {
        let bench = Arc::new(Bench::new(shelf, rate_hz));
        let there = Arc::clone(&bench);
        let thread = thread::Builder::new()
            .name("idiophone workshop".to_owned())
            .spawn(move || {
                while !there.closing.load(Ordering::Acquire) {
                    if !there.work() {
                        thread::park();
                    }
                }
            })
            .ok();
        if let Some(thread) = &thread {
            let _ = bench.worker.set(thread.thread().clone());
        }
        Self { bench, thread }
    }
}

impl Deref for Workshop {
    type Target = Arc<Bench>;

    fn deref(&self) -> &Arc<Bench> {
        &self.bench
    }
}

impl Drop for Workshop {
    fn drop(&mut self) {
        self.bench.closing.store(true, Ordering::Release);
        if let Some(thread) = self.thread.take() {
            thread.thread().unpark();
            let _ = thread.join();
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_open_workshop_delivers_and_closes() {
        let workshop = Workshop::open(Arc::default(), 48_000.0);
        workshop.ask(2);
        workshop.ask(1);
        let start = Instant::now();
        let index = loop {
            match workshop.fetch() {
                Some((1, _)) => break 1,
                _ if start.elapsed() > Duration::from_secs(60) => break 0,
                _ => std::thread::sleep(Duration::from_millis(1)),
            }
        };
        assert_eq!(index, 1);
    }
}
