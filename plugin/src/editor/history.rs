//! What can be undone and done again.

use super::chosen::Chosen;
use super::log::Change;
use crate::presets::{Scala, TrimList};

/// Steps that are kept.
const MOST: usize = 500;
/// Gestures on one parameter that follow each other so soon are one: the notches of a wheel, in s.
const SOON_S: f64 = 0.5;

/// Before and after.
pub(super) type Turn<T> = [T; 2];

/// Something that was done.
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct Step {
    /// For people.
    pub(super) name: String,
    pub(super) changes: Vec<Change>,
    pub(super) scala: Option<Turn<Scala>>,
    pub(super) trims: Option<Turn<TrimList>>,
    pub(super) chosen: Option<Turn<Chosen>>,
    /// Which side of the comparison was heard.
    pub(super) side: Option<Turn<usize>>,
}

/// Everything that was done, oldest first.
#[derive(Clone, Debug, Default)]
pub(super) struct History {
    steps: Vec<Step>,
    /// Steps that are done and not undone.
    done: usize,
    /// When the last gesture ended, in s, if another may still join it.
    last_s: Option<f64>,
    /// Whether the last step was made by playing.
    played: bool,
}

/// One side of a comparison.
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct Side {
    /// Parameters' places 0…1 by id.
    pub(super) values: Vec<(&'static str, f32)>,
    pub(super) scala: Scala,
    pub(super) trims: TrimList,
    pub(super) chosen: Chosen,
}

/// What outlives a window.
#[derive(Clone, Debug, Default)]
pub(super) struct Past {
    pub(super) history: History,
    /// The sides; that which is heard is only put down when it is left.
    pub(super) sides: [Option<Side>; 2],
    pub(super) heard: usize,
}

impl History {
    /// Something greater than a gesture was done.
    pub(super) fn push(&mut self, step: Step) {
        self.steps.truncate(self.done);
        self.steps.push(step);
        if self.steps.len() > MOST {
            self.steps.remove(0);
        }
        self.done = self.steps.len();
        self.last_s = None;
        self.played = false;
    }

    /// A gesture was made at a time, in s; `played` says that playing made it, as a click on a body does.
    pub(super) fn gesture(&mut self, change: Change, name: &str, now_s: f64, played: bool) {
        let soon = self.last_s.is_some_and(|last_s| now_s - last_s < SOON_S);
        let joins = soon || played && self.played;
        let all_done = self.done == self.steps.len();
        let last = self.steps.last_mut().filter(|_| all_done);
        match last.map(|step| &mut step.changes) {
            Some(changes) if played && self.played => {
                // A click on a surface moves two parameters.
                match changes.iter_mut().find(|last| last.id == change.id) {
                    Some(last) => last.to = change.to,
                    None => changes.push(change),
                }
            }
            Some(changes) if joins && changes.len() == 1 && changes[0].id == change.id => {
                changes[0].to = change.to;
            }
            _ => self.push(Step {
                name: name.to_owned(),
                changes: vec![change],
                ..Step::default()
            }),
        }
        self.last_s = Some(now_s);
        self.played = played;
    }

    /// Modes were trimmed at a time, in s.
    pub(super) fn trim(&mut self, trims: Turn<TrimList>, name: &str, now_s: f64) {
        let soon = self.last_s.is_some_and(|last_s| now_s - last_s < SOON_S);
        let all_done = self.done == self.steps.len();
        let last = self.steps.last_mut().filter(|_| all_done && soon);
        let [from, to] = trims;
        match last.map(|step| (&step.name, &mut step.trims)) {
            Some((last, Some([_, end]))) if last == name => *end = to,
            _ => self.push(Step {
                name: name.to_owned(),
                trims: Some([from, to]),
                ..Step::default()
            }),
        }
        self.last_s = Some(now_s);
    }

    /// The step that undoing would undo.
    pub(super) fn before(&self) -> Option<&Step> {
        self.done.checked_sub(1).and_then(|at| self.steps.get(at))
    }

    /// The step that redoing would do.
    pub(super) fn after(&self) -> Option<&Step> {
        self.steps.get(self.done)
    }

    /// Goes back a step, which is given.
    pub(super) fn undo(&mut self) -> Option<Step> {
        let step = self.before()?.clone();
        self.done -= 1;
        (self.last_s, self.played) = (None, false);
        Some(step)
    }

    /// Goes forward a step, which is given.
    pub(super) fn redo(&mut self) -> Option<Step> {
        let step = self.after()?.clone();
        self.done += 1;
        (self.last_s, self.played) = (None, false);
        Some(step)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn change(id: &'static str, from: f32, to: f32) -> Change {
        Change { id, from, to }
    }

    #[test]
    fn gestures_are_steps_unless_they_follow_at_once() {
        let mut history = History::default();
        history.gesture(change("a", 0.0, 0.1), "A", 1.0, false);
        history.gesture(change("a", 0.1, 0.2), "A", 1.2, false);
        history.gesture(change("a", 0.2, 0.5), "A", 3.0, false);
        history.gesture(change("b", 0.0, 1.0), "B", 3.1, false);
        assert_eq!(history.undo().unwrap().changes, [change("b", 0.0, 1.0)]);
        assert_eq!(history.undo().unwrap().changes, [change("a", 0.2, 0.5)]);
        assert_eq!(history.undo().unwrap().changes, [change("a", 0.0, 0.2)]);
        assert_eq!(history.undo(), None);
        assert_eq!(history.redo().unwrap().changes, [change("a", 0.0, 0.2)]);
        history.gesture(change("a", 0.2, 0.9), "A", 3.2, false);
        assert_eq!(history.after(), None, "what was undone is gone");
        assert_eq!(history.undo().unwrap().changes, [change("a", 0.2, 0.9)]);
    }

    #[test]
    fn playing_is_one_step_however_long() {
        let mut history = History::default();
        for at in 0..9u8 {
            let from = f32::from(at) / 10.0;
            history.gesture(
                change("pos", from, from + 0.1),
                "P",
                9.0 * f64::from(at),
                true,
            );
        }
        history.gesture(change("pos", 0.9, 0.0), "P", 99.0, false);
        history.undo();
        let step = history.undo().unwrap();
        assert_eq!((step.changes[0].from, step.changes.len()), (0.0, 1));
        assert_eq!(history.undo(), None);
    }

    #[test]
    fn trims_of_one_mode_that_follow_at_once_are_a_step() {
        let label = modes::ModeLabel {
            family: modes::Family::Other,
            order: 0,
            index: 1,
            member: modes::Member::Single,
        };
        let list = |level_db: f32| {
            let ringing = 1.0;
            vec![(label, crate::engine::Trim { level_db, ringing })]
        };
        let mut history = History::default();
        history.trim([Vec::new(), list(-1.0)], "mode 1", 1.0);
        history.trim([list(-1.0), list(-2.0)], "mode 1", 1.2);
        history.trim([list(-2.0), list(-3.0)], "mode 2", 1.3);
        history.trim([list(-3.0), list(-4.0)], "mode 2", 9.0);
        let turn = |step: Option<Step>| step.unwrap().trims.unwrap();
        assert_eq!(turn(history.undo()), [list(-3.0), list(-4.0)]);
        assert_eq!(turn(history.undo()), [list(-2.0), list(-3.0)]);
        assert_eq!(turn(history.undo()), [Vec::new(), list(-2.0)]);
        assert_eq!(history.undo(), None);
    }

    #[test]
    fn old_steps_go() {
        let mut history = History::default();
        for number in 0..2 * MOST {
            history.gesture(change("a", 0.0, 1.0), "A", number as f64, false);
        }
        let mut undone = 0;
        while history.undo().is_some() {
            undone += 1;
        }
        assert_eq!(undone, MOST);
    }
}
