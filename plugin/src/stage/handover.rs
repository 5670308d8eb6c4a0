//! The present instrument gives way to another drawing of itself, without a break.
//!
//! The new engine takes over the motion of the old; for a moment both sound, the one fading in and the other
//! out, since the same motion sounds a little different from another shape.

use super::{GRID, Stage};
use crate::engine::{Engine, Outputs, Room};
use crate::maker::{Drawing, Order};
use crate::workshop::{Bench, Ready};
use std::sync::Arc;

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
/// How long a knob rests before what it is at is waited for in whole, in s.
const REST_S: f64 = 0.1;
/// How long a drawing that was waited for sounds before another is, in s: more than a listener would get.
const PACE_S: f64 = 0.05;
const _: () = assert!(PACE_S < REST_S);

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
    /// The drawing that was waited for last, and frames since then.
    drawing: Option<Drawing>,
    sounded: usize,
    /// The last that was asked for, and frames since then.
    asked: Option<Drawing>,
    rested: usize,
    /// Whether no more than drafts of it have been waited for.
    rough: bool,
    /// Who draws, if drawings are waited for.
    order: Option<Arc<Order>>,
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
        self.last.as_ref().is_some_and(|last| last.left > 0)
    }

    /// Counts frames that are rendered.
    pub(super) fn pass(&mut self, frames: usize) {
        for count in [&mut self.rested, &mut self.sounded] {
            *count = count.saturating_add(frames);
        }
    }

    /// Takes note of the drawing that is asked for; the one to wait for now. A knob's are not waited for in
    /// whole before it comes to rest, but at first, nor all of them: rendering one that turns would take hours
    /// otherwise.
    fn follow(&mut self, asked: &Drawing, rate_hz: f64) -> Drawing {
        if self.asked.replace(*asked) != Some(*asked) {
            (self.rested, self.rough) = (0, self.drawing.is_some());
        }
        self.rough &= self.rested < frames_in(REST_S, rate_hz);
        match self.drawing {
            Some(drawing) if self.until_next(rate_hz).is_some_and(|left| left > 0) => drawing,
            _ => self.accept(asked),
        }
    }

    fn accept(&mut self, asked: &Drawing) -> Drawing {
        if self.drawing.replace(*asked) != Some(*asked) {
            self.sounded = 0;
        }
        *asked
    }

    /// Frames until the drawing that is asked for is to be waited for, if it is not the last that was.
    fn until_next(&self, rate_hz: f64) -> Option<usize> {
        let left = frames_in(PACE_S, rate_hz).saturating_sub(self.sounded);
        (self.asked != self.drawing).then_some(left)
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

    /// Puts the next aside, which was never heard; whether there was room.
    fn forgo(&mut self) -> bool {
        let Some((number, engine)) = self.next.take() else {
            return true;
        };
        let left = self.spend(engine).err();
        self.next = left.map(|engine| (number, engine));
        self.next.is_none()
    }

    /// Cuts the fade short.
    pub(super) fn reset(&mut self) {
        if let Some(last) = &mut self.last {
            last.left = 0;
        }
    }

    /// Hands over what has faded out, and what is no drawing of the instrument of that number.
    fn clear(&mut self, number: usize, discard: impl Fn(Box<Engine>) -> Result<(), Box<Engine>>) {
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

#[expect(clippy::cast_sign_loss, reason = "neither is less than nothing")]
fn frames_in(time_s: f64, rate_hz: f64) -> usize {
    (time_s * rate_hz).round() as usize
}

impl Stage {
    /// The drawing that sounds, to be told from others.
    #[cfg(test)]
    pub(crate) fn drawn(&self) -> *const Engine {
        &raw const *self.present.engine
    }

    /// Wants the present instrument in a drawing, and takes what has come of that; does not allocate. A
    /// patient stage waits for it.
    pub(crate) fn reshape(&mut self, drawing: &Drawing, order: &Arc<Order>, bench: &Bench) {
        let patient = self.patient;
        let drawing = if patient {
            self.handover.follow(drawing, self.rate_hz)
        } else {
            *drawing
        };
        order.pace(!patient || !self.handover.rough);
        order.want(self.number, &drawing, self.present.engine.awake());
        self.handover.clear(self.number, |engine| {
            if patient {
                bench.discard_surely(engine)
            } else {
                bench.discard(engine)
            }
        });
        if patient {
            let order = self.handover.order.get_or_insert_with(|| Arc::clone(order));
            self.patient = order.wait();
            self.exchange();
        } else if self.handover.next.is_none() {
            self.handover.next = order.fetch();
            (self.handover.ahead, self.handover.ready) = (0, false);
        }
        // Before what the block strikes, which would keep it waiting.
        if self.until_handover() == Some(0) {
            self.hand_over();
        }
    }

    /// Waits for the present instrument, which has just come, in the drawing that is wanted.
    pub(super) fn redraw(&mut self) {
        let Handover { order, drawing, .. } = &self.handover;
        if let (Some(order), Some(drawing)) = (order, drawing) {
            order.want(self.number, drawing, self.present.engine.awake());
            self.patient = order.wait();
            self.exchange();
        }
    }

    /// Frames until what a knob has come to rest at is to be waited for in whole, if anybody waits.
    pub(super) fn until_rest(&self) -> Option<usize> {
        let left = frames_in(REST_S, self.rate_hz).saturating_sub(self.handover.rested);
        (self.patient && self.handover.rough).then_some(left)
    }

    /// Frames to the next sample, if one may come, at which something is to be done about drawings.
    pub(super) fn until_news(&self) -> Option<usize> {
        let look = self.handover.next.is_some().then(|| {
            let until_grid = self.present.engine.until_grid();
            if until_grid == 0 { GRID } else { until_grid }
        });
        let fade = self.handover.last.as_ref().filter(|last| last.left > 0);
        let come = fade.filter(|_| self.patient && self.wanted != self.number);
        let come = come.map(|last| last.left);
        let knob = self.until_rest().into_iter().chain(self.until_next());
        look.into_iter().chain(knob).chain(come).min()
    }

    /// Frames until what a turning knob is at is to be waited for, if anybody waits.
    pub(super) fn until_next(&self) -> Option<usize> {
        let left = self.handover.until_next(self.rate_hz);
        left.filter(|_| self.patient)
    }

    /// Waits for what a turning knob is at.
    pub(super) fn next(&mut self) {
        if let Some(asked) = self.handover.asked {
            self.handover.accept(&asked);
            self.redraw();
        }
    }

    /// Waits for the whole of what is wanted.
    pub(super) fn rest(&mut self) {
        self.handover.rough = false;
        if let Some(order) = &self.handover.order {
            order.pace(true);
            self.patient = order.wait();
            self.exchange();
        }
    }

    /// Takes the last that has been made, in place of any before it.
    fn exchange(&mut self) {
        let handover = &mut self.handover;
        let Some(made) = handover.order.as_ref().and_then(|order| order.fetch()) else {
            return;
        };
        if handover.forgo() {
            handover.next = Some(made);
            // Who waits has time to tune all bodies when they take over.
            handover.ready = true;
        }
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
            && (handover.last.is_none() || handover.spent.iter().any(Option::is_none))
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
