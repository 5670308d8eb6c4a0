//! What drawings are wanted, and, offline, when they are waited for: at samples that do not depend on where
//! blocks end.

use super::{GRID, Stage};
use crate::maker::{Drawing, Order};
use crate::workshop::Bench;
use std::sync::Arc;

/// How long a knob rests before what it is at is waited for in whole, in s.
const REST_S: f64 = 0.1;
/// How long a drawing that was waited for sounds before another is, in s: less than a listener would have to
/// wait.
const PACE_S: f64 = 0.05;
const _: () = assert!(PACE_S < REST_S);

/// What a stage that waits has asked for.
#[derive(Default)]
pub(super) struct Patience {
    /// The drawing that was waited for last, and frames since then.
    drawing: Option<Drawing>,
    sounded: usize,
    /// The last that was asked for, and frames since then.
    asked: Option<Drawing>,
    rested: usize,
    /// Whether no more than drafts of it have been waited for.
    rough: bool,
    /// Who draws.
    order: Option<Arc<Order>>,
}

impl Patience {
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

    /// Frames until what a knob has come to rest at is to be waited for in whole, if it is not yet.
    fn until_rest(&self, rate_hz: f64) -> Option<usize> {
        let left = frames_in(REST_S, rate_hz).saturating_sub(self.rested);
        self.rough.then_some(left)
    }
}

#[expect(clippy::cast_sign_loss, reason = "neither is less than nothing")]
pub(super) fn frames_in(time_s: f64, rate_hz: f64) -> usize {
    (time_s * rate_hz).round() as usize
}

impl Stage {
    /// Wants the present instrument in a drawing, and takes what has come of that; does not allocate. A
    /// patient stage waits for it.
    pub(crate) fn reshape(&mut self, drawing: &Drawing, order: &Arc<Order>, bench: &Bench) {
        let discard = if self.patient {
            Bench::discard_surely
        } else {
            Bench::discard
        };
        self.handover
            .clear(self.number, |engine| discard(bench, engine));
        if self.patient {
            self.patience.order.get_or_insert_with(|| Arc::clone(order));
            let drawing = self.patience.follow(drawing, self.rate_hz);
            order.pace(!self.patience.rough);
            self.wait_for(&drawing);
        } else {
            order.pace(true);
            order.want(self.number, drawing, self.present.engine.awake());
            self.handover.receive(|| order.fetch());
        }
        // Before what the block strikes, which would keep it waiting.
        if self.until_handover() == Some(0) {
            self.hand_over();
        }
    }

    /// Frames to the next sample, if one may come, at which something is to be done about drawings.
    pub(super) fn until_news(&self) -> Option<usize> {
        let look = self.handover.has_next().then(|| {
            let until_grid = self.present.engine.until_grid();
            if until_grid == 0 { GRID } else { until_grid }
        });
        if !self.patient {
            return look;
        }
        let comes = self.wanted != self.number;
        let come = self.handover.until_faded().filter(|_| comes);
        let next = self.patience.until_next(self.rate_hz);
        let rest = self.patience.until_rest(self.rate_hz);
        [look, come, next, rest].into_iter().flatten().min()
    }

    /// Waits for what is to be waited for at this sample: what a turning knob is at, and what it rests at in
    /// whole.
    pub(super) fn wait(&mut self) {
        if !self.patient {
            return;
        }
        if self.patience.until_next(self.rate_hz) == Some(0)
            && let Some(asked) = self.patience.asked
        {
            let drawing = self.patience.accept(&asked);
            self.wait_for(&drawing);
        }
        if self.patience.until_rest(self.rate_hz) == Some(0) {
            self.patience.rough = false;
            if let Some(order) = &self.patience.order {
                order.pace(true);
            }
            self.redraw();
        }
    }

    /// Waits for the present instrument in the drawing that is wanted.
    pub(super) fn redraw(&mut self) {
        if let Some(drawing) = self.patience.drawing {
            self.wait_for(&drawing);
        }
    }

    fn wait_for(&mut self, drawing: &Drawing) {
        let Some(order) = &self.patience.order else {
            return;
        };
        order.want(self.number, drawing, self.present.engine.awake());
        self.patient = order.wait();
        if self.handover.may_exchange()
            && let Some(made) = order.fetch()
        {
            self.handover.exchange(made);
        }
    }
}
