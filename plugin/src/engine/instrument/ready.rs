//! Bodies that sleep, made ready for a blow.

use super::{Engine, keys};
use crate::engine::body::Tuned;
use crate::engine::damper::{Dampers, bit};

/// Bodies asleep that are made ready in one cell.
pub(super) const PREPARED: usize = 4;

impl Engine {
    /// Tunes a body to what holds now, at once; whether it is to be tuned once more when nothing moves.
    pub(super) fn fit(&mut self, key: u8) -> bool {
        let tuned = self.tuned(key);
        self.take_up(key, tuned)
    }

    /// Whether a body is tuned to what holds now, and has nothing left to be put right.
    pub(super) fn is_fit(&self, key: u8) -> bool {
        let (tuned, hearing) = (self.tuned(key), self.hearing(key));
        self.body(key)
            .is_none_or(|body| body.is_tuned(&tuned, &hearing))
    }

    fn take_up(&mut self, key: u8, tuned: Tuned) -> bool {
        let hearing = self.hearing(key);
        let Some(body) = self.bodies[usize::from(key)].as_mut() else {
            return false;
        };
        body.trim(&self.trims, self.trims_number);
        let moved = body.listen(&hearing);
        body.tune(self.kernel, &mut self.packs, (tuned, moved), self.step_s)
    }

    /// Tunes a few of the bodies that sleep, so that a chord finds them ready: `most` of them.
    ///
    /// A blow lifts felt and hand, so they are tuned as without. What is made so is what a blow would make, hence no sound tells whether this has been.
    pub(super) fn prepare(&mut self, most: usize) {
        let waiting = (self.stale | self.unheard) & !self.awake & !self.swinging;
        if waiting == 0 {
            return;
        }
        let mut left = most;
        for key in keys(waiting) {
            if self.body(key).is_none() {
                (self.stale, self.unheard) = (self.stale & !bit(key), self.unheard & !bit(key));
                continue;
            }
            if left == 0 {
                return;
            }
            left -= 1;
            self.unheard &= !bit(key);
            let tuned = self.tuned_under(&Dampers::OFF, key);
            if !self.take_up(key, tuned) {
                self.stale &= !bit(key);
            }
            if let Some(body) = self.bodies[usize::from(key)].as_mut() {
                body.prepare(self.kernel, self.step_s);
            }
        }
    }
}
