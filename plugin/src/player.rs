//! Host events to engine calls, each at its sample.

mod hear;
mod move_on;
#[cfg(test)]
mod tests;
#[cfg(feature = "gui")]
mod touch;

use crate::engine::{GRID, Outputs, Settings};
use crate::guard::put_right;
use crate::hands::Hands;
use crate::notes::{Note, Notes, each};
use crate::params::Controls;
use crate::params::bow::Keys;
use crate::stage::Stage;
use crate::tuner::Tuner;
use nice_plug::midi::Key;
use nice_plug::prelude::{NoteEvent, Plugin, ProcessContext};
use std::sync::Arc;

/// Frames between two looks at how long what sounds will go on.
const LOOK: u64 = 8192;

/// Instruments, the hands that play them, and the notes that the host is owed an end of.
///
/// All events of a sample are heard before any of its strikes is made, as hosts say what is special about
/// a note right after it; so the sound does not depend on how the host cuts its blocks, nor on the order
/// of what happens at once.
pub(crate) struct Player {
    stage: Stage,
    notes: Notes,
    hands: Hands,
    tuner: Tuner,
    controls: Arc<Controls>,
    /// With hands off.
    settings: Settings,
    keys: Keys,
    /// Keys to be struck at this sample, as bits, and those of them that then come up again.
    due: u128,
    up: u128,
    /// Keys whose bodies' holds are to be told again, as bits.
    stale: u128,
    /// Whether the host has modulated a note.
    modulated: bool,
    /// Frames since the last reset.
    position: u64,
    /// What was last found out about the tail: its end, and when to look again.
    tail_end: u64,
    look_at: u64,
    rate_hz: f64,
}

impl Player {
    pub(crate) fn new(stage: Stage, tuner: Tuner, controls: Arc<Controls>, rate_hz: f64) -> Self {
        Self {
            stage,
            notes: Notes::new(),
            hands: Hands::new(),
            tuner,
            settings: controls.settings(),
            keys: controls.bow.keys(),
            controls,
            due: 0,
            up: 0,
            stale: u128::MAX,
            modulated: false,
            position: 0,
            tail_end: 0,
            look_at: 0,
            rate_hz,
        }
    }

    /// The instruments.
    pub(crate) fn stage(&mut self) -> &mut Stage {
        &mut self.stage
    }

    /// Silence, at once.
    pub(crate) fn reset(&mut self) {
        self.stage.reset();
        self.notes = Notes::new();
        self.hands.reset();
        self.tuner.reset();
        (self.due, self.up, self.stale) = (0, 0, u128::MAX);
        self.modulated = false;
        (self.position, self.tail_end, self.look_at) = (0, 0, 0);
    }

    /// Frames until nothing is heard any longer if nothing happens: 0 if all is silent, `None` if it goes
    /// on as long as a key is down.
    pub(crate) fn tail(&mut self) -> Option<u32> {
        if self.due != 0 || self.bowed() != 0 {
            return None;
        }
        if self.stage.awake() == 0 {
            return Some(0);
        }
        if self.position >= self.look_at {
            self.look_at = self.position + LOOK;
            let tail_s = self.stage.tail_s().min(1e6);
            // At least until the next look, which may find that a body sleeps.
            #[expect(clippy::cast_sign_loss, reason = "a tail is no less than nothing")]
            let frames = (tail_s * self.rate_hz).ceil() as u64;
            self.tail_end = self.position + frames.max(LOOK);
        }
        // CLAP counts what is longer as without end.
        let longest = i32::MAX.unsigned_abs() - 1;
        let left = u32::try_from(self.tail_end - self.position);
        Some(left.map_or(longest, |left| left.min(longest)))
    }

    /// Renders a block, cut where events fall; those beyond the block wait for the next.
    pub(crate) fn play<P: Plugin>(
        &mut self,
        out: &mut Outputs<'_>,
        context: &mut impl ProcessContext<P>,
    ) {
        self.aim();
        let frames = out.frames();
        let mut done = 0;
        let mut event = context.next_event();
        loop {
            let until = event.as_ref().map_or(frames, |event| {
                usize::try_from(event.timing()).map_or(frames, |time| time.clamp(done, frames))
            });
            if until > done {
                self.settle::<P>(done, context);
                self.render(&mut out.part(done..until));
                done = until;
                self.end_notes::<P>(done.min(frames - 1), context);
            }
            let Some(next) = event.take() else {
                return;
            };
            if let Some(event) = put_right(next, context.plugin_api()) {
                self.hear::<P>(&event, done.min(frames.saturating_sub(1)), context);
            }
            event = context.next_event();
        }
    }

    /// Renders what lies between two events.
    fn render(&mut self, out: &mut Outputs<'_>) {
        let frames = out.frames();
        let mut done = 0;
        while done < frames {
            let mut run = frames - done;
            if self.tuner.may_change() {
                let phase = (self.position % GRID as u64) as usize;
                if phase == 0 {
                    for key in each(self.tuner.follow()) {
                        self.tell(key);
                    }
                }
                run = run.min(GRID - phase);
            }
            self.stage.render(&mut out.part(done..done + run));
            self.position += run as u64;
            done += run;
        }
    }

    /// Tells the host of the notes whose bodies have come to rest.
    fn end_notes<P: Plugin>(&mut self, now: usize, context: &mut impl ProcessContext<P>) {
        let waiting = self.notes.waiting();
        if waiting == 0 {
            return;
        }
        let (awake, bowed) = (self.stage.awake(), self.bowed());
        let sounds = |key: u8| match self.tuner.place(key) {
            Some(place) => (awake >> place.body | bowed >> key) & 1 == 1,
            None => false,
        };
        let sounding = each(waiting).filter(|key| sounds(*key));
        let sounding = sounding.fold(self.due, |keys, key| keys | 1 << key);
        while let Some(note) = self.notes.end_one(sounding) {
            end::<P>(note, now, context);
        }
    }

    /// Keys that are down and rub, or may.
    fn bowed(&self) -> u128 {
        if self.keys == Keys::Strike {
            return 0;
        }
        let placed = each(self.hands.held()).filter(|key| self.tuner.place(*key).is_some());
        placed.fold(0, |keys, key| keys | 1 << key)
    }
}

/// Tells the host that a note has ended; a host without room for it is no worse off.
fn end<P: Plugin>(note: Note, now: usize, context: &mut impl ProcessContext<P>) {
    let _ = context.try_send_event(NoteEvent::VoiceTerminated {
        // The host counts in u32.
        timing: u32::try_from(now).unwrap_or(u32::MAX),
        voice_id: note.voice_id,
        channel: note.channel,
        key: Key::Number(note.key),
    });
}
