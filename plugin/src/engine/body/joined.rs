//! A body on the support that it shares with others.

use super::Body;
use crate::engine::GRID;
use crate::engine::oscillators::{Kernel, LANES, Pack};
use crate::engine::sympathy::{Answer, Feel};

/// What the support has to do to a silent body in a cell for it to wake: −160 dB.
const WAKES: f32 = 1e-8;

impl Body {
    /// Adds what the body does to the common support in the next cell to `all`.
    pub(crate) fn feel(&mut self, kernel: Kernel, packs: &[Pack], all: &mut [f32; GRID]) {
        let (Some(tone), Some(pack)) = (self.tones.first(), packs.get(self.place.start)) else {
            return;
        };
        kernel.run(Feel {
            strand: &mut self.strand,
            pack,
            turn: tone.turn(),
        });
        for (all, own) in all.iter_mut().zip(&self.strand.moves) {
            *all += own;
        }
    }

    /// Works out what the support, moved by `all` bodies, does to this one in the next cell.
    pub(crate) fn answer(&mut self, kernel: Kernel, all: &[f32; GRID], share: f32) {
        if let Some(tone) = self.tones.first() {
            kernel.run(Answer {
                strand: &mut self.strand,
                turn: tone.turn(),
                all,
                share,
            });
        }
    }

    /// Gives the modes what the support has done to them in the last cell, if that is or will be heard;
    /// whether it is.
    pub(crate) fn take_answer(&mut self, packs: &mut [Pack]) -> bool {
        let (Some(source), Some(pack)) = (self.sources.first(), packs.get_mut(self.place.start))
        else {
            return false;
        };
        let [x, y] = &self.strand.answer;
        let level = |i: usize| (x[i] * x[i] + y[i] * y[i]) * source.weight[i] * source.weight[i];
        if self.live == 0 && (0..LANES).all(|i| level(i) < WAKES * WAKES) {
            return false;
        }
        self.strand.take(pack);
        self.live = self.live.max(1);
        true
    }
}
