//! The present instrument gives way to another drawing of itself, without a break.
//!
//! The new engine takes over the motion of the old; for a moment both sound, the one fading in and the other
//! out, since the same motion sounds a little different from another shape.

use super::patience::frames_in;
use super::{GRID, Stage};
use crate::engine::{Engine, Outputs, Room};
use crate::workshop::Ready;

/// How long both sound, in s.
const FADE_S: f64 = 0.01;

/// Bodies of the new drawing that are tuned ahead within as many samples as a cell of the grid has.
const AHEAD: usize = 4;
/// Bodies that are tuned ahead at most: where parameters move all the time the last of them come with the
/// handover.
const MOST_AHEAD: usize = 256;
/// Instruments that may have to go between two looks of the host: one that has faded out, one that another
/// took the place of before it was heard, and one that this one fades out.
const SPENT: usize = 3;
/// A new drawing on its way in, and an old one on its way out.
#[derive(Default)]
pub(super) struct Handover {
    next: Option<Ready>,
    /// Bodies of it that may have been tuned ahead, and whether that will do.
    ahead: usize,
    ready: bool,
    last: Option<Fading>,
    /// What sounds no longer.
    spent: [Option<Box<Engine>>; SPENT],
}

/// What fades out.
struct Fading {
    engine: Box<Engine>,
    /// Frames left, of all the fade has.
    left: usize,
    all: usize,
}

impl Handover {
    /// Whether two drawings sound.
    pub(super) fn is_fading(&self) -> bool {
        self.until_faded().is_some()
    }

    /// Puts an instrument that sounds no longer aside; back, if there is no room.
    fn spend(&mut self, engine: Box<Engine>) -> Result<(), Box<Engine>> {
        match self.spent.iter_mut().find(|place| place.is_none()) {
            Some(place) => {
                *place = Some(engine);
                Ok(())
            }
            None => Err(engine),
        }
    }

    /// Whether there is room for an instrument to be put aside.
    fn has_room(&self) -> bool {
        self.spent.iter().any(Option::is_none)
    }

    /// Whether [`Handover::exchange`] may be called.
    pub(super) fn may_exchange(&self) -> bool {
        self.next.is_none() || self.has_room()
    }

    /// Takes a drawing in place of the next, which was never heard. It takes over as it is: who waits for drawings
    /// has time to tune all bodies then.
    pub(super) fn exchange(&mut self, made: Ready) {
        if let Some((_, engine)) = self.next.replace(made) {
            // There is room, or it would not have been called.
            let _ = self.spend(engine);
        }
        self.ready = true;
    }

    /// Takes a drawing whose bodies are to be tuned ahead, if there is no next.
    pub(super) fn receive(&mut self, fetch: impl FnOnce() -> Option<Ready>) {
        if self.next.is_none() {
            self.next = fetch();
            (self.ahead, self.ready) = (0, false);
        }
    }

    /// Whether there is a next drawing.
    pub(super) fn has_next(&self) -> bool {
        self.next.is_some()
    }

    /// Frames until the old drawing has faded out, while two sound.
    pub(super) fn until_faded(&self) -> Option<usize> {
        self.last
            .as_ref()
            .map(|last| last.left)
            .filter(|left| *left > 0)
    }

    /// Cuts the fade short.
    pub(super) fn reset(&mut self) {
        if let Some(last) = &mut self.last {
            last.left = 0;
        }
    }

    /// Hands over what has faded out, and what is no drawing of the instrument of that number.
    pub(super) fn clear(
        &mut self,
        number: usize,
        discard: impl Fn(Box<Engine>) -> Result<(), Box<Engine>>,
    ) {
        for place in &mut self.spent {
            *place = place.take().and_then(|engine| discard(engine).err());
        }
        if let Some(last) = self.last.take_if(|last| last.left == 0)
            && let Err(engine) = discard(last.engine)
        {
            self.last = Some(Fading { engine, ..last });
        }
        if let Some((of, engine)) = self.next.take_if(|next| next.0 != number)
            && let Err(engine) = discard(engine)
        {
            self.next = Some((of, engine));
        }
    }

    /// Fades from the old drawing to the new, which has rendered.
    pub(super) fn mix(&mut self, out: &mut Outputs<'_>) {
        let Some(last) = self.last.as_mut().filter(|last| last.left > 0) else {
            return;
        };
        let frames = last.left.min(out.frames());
        for done in (0..frames).step_by(GRID) {
            let mut part = out.part(done..frames.min(done + GRID));
            let mut old = Room::<GRID>::new();
            last.engine.render(&mut old.like(&part));
            for (output, sides) in part.each() {
                for (new, old) in sides.into_iter().zip(old.pair(output)) {
                    for ((new, old), left) in new.iter_mut().zip(old).zip((0..=last.left).rev()) {
                        *new += left as f32 / last.all as f32 * (old - *new);
                    }
                }
            }
            last.left -= part.frames();
        }
    }
}

impl Stage {
    /// The drawing that sounds, to be told from others.
    #[cfg(test)]
    pub(crate) fn drawn(&self) -> *const Engine {
        &raw const *self.present.engine
    }

    /// Tunes bodies of the new drawing ahead, as many as `frames` have time for.
    pub(super) fn tune_ahead(&mut self, frames: usize) {
        let handover = &mut self.handover;
        if handover.ready {
            return;
        }
        let Some((_, engine)) = handover.next.as_mut().filter(|_| handover.last.is_none()) else {
            return;
        };
        let most = AHEAD * frames.div_ceil(GRID);
        engine.set_trims(&self.trims);
        let all = engine.foresee(&self.present.engine, most);
        handover.ahead += most;
        handover.ready |= all || handover.ahead >= MOST_AHEAD;
    }

    /// Frames to the point where a new drawing can take over; none if there is none, or a mallet is on a
    /// body.
    pub(super) fn until_handover(&self) -> Option<usize> {
        let handover = &self.handover;
        let ready = handover.ready
            && !handover.is_fading()
            && (handover.last.is_none() || handover.has_room())
            && matches!(&handover.next, Some((number, _)) if *number == self.number)
            && !self.present.engine.is_struck();
        ready.then(|| self.present.engine.until_grid())
    }

    /// Lets the new drawing take over, at a point of the grid.
    pub(super) fn hand_over(&mut self) {
        let Some((_, mut engine)) = self.handover.next.take() else {
            return;
        };
        let faded = self.handover.last.take();
        // There is room, or it would not have been due.
        let _ = faded.map_or(Ok(()), |last| self.handover.spend(last.engine));
        engine.set_trims(&self.trims);
        engine.inherit(&self.present.engine);
        let all = frames_in(FADE_S, self.rate_hz);
        self.handover.last = Some(Fading {
            engine: std::mem::replace(&mut self.present.engine, engine),
            left: all,
            all,
        });
    }
}
