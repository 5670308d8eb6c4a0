//! What a body sends through the tube below it, apart from the rest because discs may shut it.

use super::GRID;
use super::body::{Reached, gains_of, loudest};
use super::oscillators::{Buses, Hear, Kernel, LANES, Oscillators, Push};

/// The lowest modes once more, heard through the resonator alone.
#[derive(Clone, Debug)]
pub(crate) struct Resonator {
    oscillators: Oscillators,
}

impl Resonator {
    /// Takes what the lowest [`LANES`] of `modes` send through a resonator off what `oscillators` are
    /// heard as; none if that is nothing. A tube answers to its own pitch: higher modes do not count
    /// as what the discs can shut.
    pub(crate) fn take_from(oscillators: &mut Oscillators, modes: &[Reached]) -> Option<Self> {
        if modes.iter().all(|mode| loudest(&mode.piped) == 0.0) {
            return None;
        }
        let mut resonator = Oscillators::new(LANES);
        resonator.live = LANES;
        for (i, mode) in modes.iter().take(LANES).enumerate() {
            let size = loudest(&mode.ears);
            if size == 0.0 {
                continue;
            }
            let direct = [0, 1].map(|e| [0, 1].map(|k| mode.ears[e][k] - mode.piped[e][k]));
            let (all, direct) = (gains_of(&mode.ears, size), gains_of(&direct, size));
            for k in 0..all.len() {
                oscillators.hear[k][i] = direct[k];
                // The rest, so that an open resonator gives the sum of both to the bit of its power.
                resonator.hear[k][i] = all[k] - direct[k];
            }
        }
        Some(Self {
            oscillators: resonator,
        })
    }

    /// What reaches the buses through the open resonator, mode by mode.
    pub(crate) fn hear(&self) -> &Hear {
        &self.oscillators.hear
    }

    /// What comes through the open resonator in the next `samples`, of modes that move as those of
    /// `body` are about to.
    pub(crate) fn ring(
        &mut self,
        kernel: Kernel,
        body: &Oscillators,
        push: Option<Push<'_>>,
        samples: usize,
    ) -> Buses {
        let own = &mut self.oscillators;
        for (own, body) in [
            (&mut own.x, &body.x),
            (&mut own.y, &body.y),
            (&mut own.step_re, &body.step_re),
            (&mut own.step_im, &body.step_im),
            (&mut own.half_re, &body.half_re),
            (&mut own.half_im, &body.half_im),
        ] {
            own.copy_from_slice(&body[..LANES]);
        }
        let mut out = [[0.0; GRID]; 3];
        kernel.ring(own, push, samples, &mut out);
        out
    }
}
