//! Where lists of events are put in order.

use super::{Event, List, Source};

/// Events of a block that can be sorted, and that can wait for the next.
///
/// Those beyond are passed on in the order in which they come, none before the last of these; in a
/// block of no frames, notes beyond are lost.
const CAPACITY: usize = 4096;

/// Events that cannot pass as they came.
///
/// Only [`Desk::new`] allocates.
pub(super) struct Desk {
    events: Vec<Event>,
    /// Times and indices of those that are due, in order.
    due: Vec<(u32, u32)>,
}

impl Desk {
    /// A desk with nothing on it.
    pub(super) fn new() -> Self {
        Self {
            events: Vec::with_capacity(CAPACITY),
            due: Vec::with_capacity(CAPACITY),
        }
    }

    /// Whether nothing waits.
    pub(super) const fn is_clear(&self) -> bool {
        self.events.is_empty()
    }

    /// Forgets what waits.
    pub(super) fn clear(&mut self) {
        self.events.clear();
    }

    /// What has waited and what is in order of `source`, sorted by time, for a block of so many
    /// frames; without frames, what cannot wait.
    pub(super) fn sort<'a>(&'a mut self, source: Source<'a>, frames: u32) -> List<'a> {
        let sent = source.len();
        let mut taken = 0;
        while taken < sent && self.events.len() < CAPACITY {
            self.events.extend(source.event(taken, frames));
            taken += 1;
        }
        self.due.clear();
        for (index, event) in (0..).zip(&mut self.events) {
            if frames > 0 || !event.waits() {
                self.due.push((event.header_mut().time, index));
            }
        }
        // The indices keep events of one time in their order.
        self.due.sort_unstable();
        List::new(&self.events, &self.due, source, taken..sent, frames)
    }

    /// Clears away what a block of so many frames has had; whether anything waits.
    pub(super) fn tidy(&mut self, frames: u32) -> bool {
        self.events.retain(|event| frames == 0 && event.waits());
        !self.is_clear()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::guard::source::tests::{Host, note, seen, tempo, value};

    /// What the framework sees: times and keys, or times and −1 for a parameter.
    fn sorted(desk: &mut Desk, events: Vec<Event>, frames: u32) -> Vec<(u32, i16)> {
        let host = Host::new(events);
        let seen = seen(&mut desk.sort(host.source(), frames));
        desk.tidy(frames);
        seen
    }

    #[test]
    fn events_of_one_time_keep_their_order() {
        let mut desk = Desk::new();
        let events = vec![
            note(9, 0, 1, 0.5),
            note(3, 0, 2, 0.5),
            value(3, 0.5),
            note(9, 0, 3, 0.5),
            note(0, 0, 4, 0.5),
            note(3, 0, 5, 0.5),
        ];
        assert_eq!(
            sorted(&mut desk, events, 64),
            [(0, 4), (3, 2), (3, -1), (3, 5), (9, 1), (9, 3)]
        );
        assert!(desk.is_clear());
    }

    #[test]
    fn what_is_late_comes_at_the_last_frame_and_what_is_wrong_not_at_all() {
        let mut desk = Desk::new();
        let events = vec![
            note(64, 0, 1, 0.5),
            note(u32::MAX, 0, 2, 0.5),
            note(5, 16, 3, 0.5),
            note(5, 0, 128, 0.5),
            value(5, f64::NAN),
            note(63, 0, 4, f64::NAN),
        ];
        assert_eq!(sorted(&mut desk, events, 64), [(63, 1), (63, 2), (63, 4)]);
    }

    #[test]
    fn notes_wait_for_frames_and_parameters_do_not() {
        let mut desk = Desk::new();
        let events = vec![note(7, 0, 1, 0.5), value(5, 0.5), note(0, 0, 2, 0.5)];
        assert_eq!(sorted(&mut desk, events, 0), [(0, -1)]);
        assert_eq!(sorted(&mut desk, vec![note(3, 0, 3, 0.5)], 0), []);
        assert!(!desk.is_clear());
        assert_eq!(
            sorted(&mut desk, vec![note(0, 0, 4, 0.5)], 16),
            [(0, 1), (0, 2), (0, 3), (0, 4)]
        );
        assert!(desk.is_clear());
        sorted(&mut desk, vec![note(3, 0, 3, 0.5)], 0);
        desk.clear();
        assert_eq!(sorted(&mut desk, vec![], 16), []);
    }

    #[test]
    fn what_cannot_wait_is_not_played_between() {
        let mut desk = Desk::new();
        let mut events = vec![note(0, 0, 1, 0.5); CAPACITY];
        events.extend([note(3, 0, 2, 0.5), value(5, 0.5), tempo(7, 120.0)]);
        assert_eq!(sorted(&mut desk, events, 0), [(0, -1)]);
        assert_eq!(sorted(&mut desk, vec![], 16), [(0, 1); CAPACITY]);
    }

    #[test]
    fn what_does_not_fit_passes_without_going_back() {
        let mut desk = Desk::new();
        let mut events = vec![note(20, 0, 1, 0.5); CAPACITY];
        events[0] = note(30, 0, 2, 0.5);
        events.extend([
            note(10, 0, 3, 0.5),
            note(40, 0, 4, 0.5),
            note(35, 0, 128, 0.5),
            note(35, 0, 5, 0.5),
            note(u32::MAX, 0, 6, 0.5),
            note(0, 0, 7, 0.5),
        ]);
        let seen = sorted(&mut desk, events, 64);
        assert_eq!(seen.len(), CAPACITY + 5);
        assert!(seen.is_sorted_by_key(|(time, _)| *time));
        assert_eq!(
            seen[CAPACITY - 2..],
            [
                (20, 1),
                (30, 2),
                (30, 3),
                (40, 4),
                (40, 5),
                (63, 6),
                (63, 7)
            ]
        );
        assert_eq!(desk.events.capacity(), CAPACITY);
        assert_eq!(desk.due.capacity(), CAPACITY);
    }
}
