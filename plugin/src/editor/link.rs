//! What the audio thread and the editor hand each other, without locks.

use super::frame::Frame;
use super::samples::Samples;
use crossbeam_queue::ArrayQueue;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::{Duration, Instant};

/// Touches that may wait for the next block.
const TOUCHES: usize = 256;

/// Frames that go to and fro.
const FRAMES: usize = 2;

/// A touch that has waited so long for a block comes too late to be heard.
const STALE: Duration = Duration::from_millis(500);

/// What the mouse or a computer key does to a body.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Touch {
    /// A blow.
    Strike {
        /// Whose body.
        key: u8,
        /// How hard, 0…1.
        velocity: f32,
        /// Where along it, 0…1.
        position: f32,
        /// Where across it, 0…1.
        across: f32,
    },
    /// The hand leaves the key.
    Release {
        /// Whose body.
        key: u8,
    },
}

/// Both ends hold it.
pub struct Link {
    touches: ArrayQueue<(Instant, Touch)>,
    wanted: AtomicBool,
    spare: ArrayQueue<Box<Frame>>,
    filled: ArrayQueue<Box<Frame>>,
    samples: Samples,
}

impl Default for Link {
    fn default() -> Self {
        let spare = ArrayQueue::new(FRAMES);
        for _ in 0..FRAMES {
            // There is room.
            let _ = spare.push(Box::default());
        }
        Self {
            touches: ArrayQueue::new(TOUCHES),
            wanted: AtomicBool::new(false),
            spare,
            filled: ArrayQueue::new(FRAMES),
            samples: Samples::default(),
        }
    }
}

impl Link {
    /// For the editor: touches a body from the next block on. What does not fit is lost.
    pub fn touch(&self, touch: Touch) {
        let _ = self.touches.push((Instant::now(), touch));
    }

    /// For the audio thread: the touches that have come since it last asked. Those that waited while
    /// no block was played are dropped, lest they all sound at once.
    pub fn touches(&self) -> impl Iterator<Item = Touch> {
        // No more than there were, lest an editor keep the audio thread here.
        (0..self.touches.len()).filter_map(|_| {
            let (since, touch) = self.touches.pop()?;
            let late = since.elapsed() > STALE && matches!(touch, Touch::Strike { .. });
            (!late).then_some(touch)
        })
    }

    /// For the editor: asks for a frame, and takes the last one that has come in exchange for `last`.
    pub fn look(&self, last: &mut Box<Frame>) -> bool {
        let mut came = false;
        while let Some(frame) = self.filled.pop() {
            let old = std::mem::replace(last, frame);
            // There is room: as many frames go round as it holds.
            let _ = self.spare.push(old);
            came = true;
        }
        self.wanted.store(true, Ordering::Release);
        came
    }

    /// For the audio thread: a block has been played.
    pub fn hear(&self, left: &[f32], right: &[f32]) {
        self.samples.write(left, right);
    }

    /// For the editor: appends what has been played since `read` samples had been read; how many before
    /// that are lost.
    pub(super) fn heard(&self, read: &mut u64, out: &mut Vec<f32>) -> u64 {
        self.samples.read(read, out)
    }

    /// For the audio thread: whether a frame is asked for.
    pub fn is_wanted(&self) -> bool {
        self.wanted.load(Ordering::Relaxed)
    }

    /// For the audio thread: hands over a frame that `fill` writes, if there is one to be had.
    pub fn show(&self, fill: impl FnOnce(&mut Frame)) {
        let Some(mut frame) = self.spare.pop() else {
            return;
        };
        fill(&mut frame);
        self.wanted.store(false, Ordering::Release);
        // There is room, as above.
        let _ = self.filled.push(frame);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn frames_go_round_and_none_is_lost() {
        let link = Link::default();
        let mut last = Box::default();
        assert!(!link.is_wanted());
        for turn in 0..10u16 {
            assert!(!link.look(&mut last), "none was filled");
            assert!(link.is_wanted());
            link.show(|frame| frame.peaks = [f32::from(turn); 2]);
            assert!(!link.is_wanted());
            assert!(link.look(&mut last));
            assert_eq!(last.peaks, [f32::from(turn); 2]);
        }
        for turn in 0..5u8 {
            link.show(|frame| frame.peaks = [f32::from(turn); 2]);
        }
        assert!(link.look(&mut last));
        assert_eq!(last.peaks, [1.0; 2], "beyond two there is none to fill");
    }

    #[test]
    fn touches_come_in_order_and_no_more_than_fit() {
        let link = Link::default();
        for key in 0..=255 {
            link.touch(Touch::Release { key: key & 127 });
            link.touch(Touch::Release { key: key & 127 });
        }
        let keys: Vec<_> = link.touches().collect();
        assert_eq!(keys.len(), TOUCHES);
        assert_eq!(keys[0], Touch::Release { key: 0 });
        assert_eq!(keys[255], Touch::Release { key: 127 });
        assert_eq!(link.touches().count(), 0);
    }
}
