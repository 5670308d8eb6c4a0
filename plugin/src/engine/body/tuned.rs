//! A body's modes as they are tuned and heard now.

use super::Body;
use crate::engine::losses::Drain;
use crate::engine::oscillators::{Kernel, Pack, Tune, TuneSteps};
use crate::engine::source::Hearing;
use crate::engine::trims::Trims;

/// Everything that the steps of a body's modes depend on.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Tuned {
    pub(crate) drain: Drain,
    /// Frequencies over those as built.
    pub(crate) ratio: f64,
    /// Number of the table of trims.
    pub(crate) trims: u32,
}

/// How many leading packs are to be heard otherwise than before.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Moved(pub(crate) usize);

impl Moved {
    pub(crate) const NONE: Self = Self(0);
}

impl Body {
    /// Which packs are to be heard otherwise now.
    pub(crate) fn moved(&self, hearing: &Hearing) -> Moved {
        match &self.heard {
            Some(heard) if heard == hearing => Moved::NONE,
            Some(heard) if heard.without_pipe() == hearing.without_pipe() => Moved(self.piped),
            _ => Moved(self.tones.len()),
        }
    }

    /// Whether the modes are tuned and heard so, to the bit.
    pub(crate) fn is_tuned(&self, tuned: &Tuned, hearing: &Hearing) -> bool {
        self.tuned.as_ref() == Some(tuned) && !self.off && self.moved(hearing) == Moved::NONE
    }

    /// Takes up a table of trims by its number: it counts from when the modes are next tuned and listened
    /// to.
    pub(crate) fn trim(&mut self, trims: &Trims, number: u32) {
        self.trimmed.follow(trims, number);
    }

    /// From the end of this cell on the body is heard so; which packs are heard otherwise then.
    pub(crate) fn listen(&mut self, hearing: &Hearing) -> Moved {
        let moved = self.moved(hearing);
        let modes = self.tones.iter_mut().zip(&self.sources);
        for (pack, (tone, source)) in modes.enumerate().take(moved.0) {
            source.gains(hearing, &tone.omega, &mut tone.gain);
            self.trimmed.turn(pack, &mut tone.gain);
        }
        self.heard = Some(*hearing);
        moved
    }

    /// Tunes the modes, if they are not tuned so or are to be heard otherwise; whether they are to be tuned
    /// once more when nothing moves.
    pub(crate) fn tune(
        &mut self,
        kernel: Kernel,
        packs: &mut [Pack],
        (tuned, Moved(moved)): (Tuned, Moved),
        step_s: f64,
    ) -> bool {
        let pitch = self.tuned.is_none_or(|old| old.ratio != tuned.ratio);
        let all = self.tuned != Some(tuned);
        // What moving damping has left a hair off is put right when it rests.
        let exact = !all && std::mem::take(&mut self.off);
        let count = if all || exact {
            self.tones.len()
        } else {
            moved
        };
        if count == 0 {
            return false;
        }
        let trimmed = self.trimmed.drain(&mut self.tones[..count], &tuned);
        kernel.run(Tune {
            tones: &mut self.tones[..count],
            packs: &mut packs[self.place.clone()][..count],
            drain: tuned.drain,
            ratio: tuned.ratio,
            pitch,
            gains: moved > 0,
            causes: trimmed
                || self
                    .tuned
                    .is_none_or(|old| old.drain.shares() != tuned.drain.shares()),
            exact,
            off: &mut self.off,
            step_s,
        });
        self.tuned = Some(tuned);
        if all {
            self.stepped = 0;
        }
        if moved > 0 {
            self.hear(moved, self.live == 0);
        }
        if self.driven && all {
            self.tune_steps(kernel, step_s);
        }
        self.off
    }

    /// Makes the steps in which the body moves while it is pushed, if they are not made.
    pub(super) fn tune_steps(&mut self, kernel: Kernel, sample_s: f64) {
        if self.stepped == self.substeps {
            return;
        }
        self.stepped = self.substeps;
        kernel.run(TuneSteps {
            tones: &self.tones,
            steps: &mut self.steps,
            ratio: self.tuned.map_or(1.0, |tuned| tuned.ratio),
            sample_s,
            substeps: self.substeps,
        });
    }

    /// Takes the gains over to where the modes are pushed.
    fn hear(&mut self, packs: usize, at_once: bool) {
        for (step, tone) in self.steps.iter_mut().zip(&self.tones).take(packs) {
            step.listen(tone, at_once);
        }
    }
}
