//! Taps that are shorter than a frame.

use egui::{Context, Event, Plugin, RawInput, Ui};

/// Lets a button that is pressed and let go within a frame go in the next, so that all see it down.
#[derive(Default)]
pub(super) struct Taps {
    /// For the next frame.
    held: Vec<Event>,
}

impl Plugin for Taps {
    fn debug_name(&self) -> &'static str {
        "taps"
    }

    fn input_hook(&mut self, _context: &Context, input: &mut RawInput) {
        self.held.append(&mut input.events);
        let later = self.held.split_off(first_frame(&self.held));
        input.events = std::mem::replace(&mut self.held, later);
    }

    fn on_end_pass(&mut self, ui: &mut Ui) {
        if !self.held.is_empty() {
            ui.ctx().request_repaint();
        }
    }
}

/// How many events come before a button that was pressed among them is let go.
fn first_frame(events: &[Event]) -> usize {
    let mut down = Vec::new();
    let ends = |event: &Event| match event {
        Event::PointerButton {
            button, pressed, ..
        } => {
            if *pressed {
                down.push(*button);
            }
            !pressed && down.contains(button)
        }
        _ => false,
    };
    events.iter().position(ends).unwrap_or(events.len())
}

#[cfg(test)]
mod tests {
    use super::*;
    use egui::{Modifiers, PointerButton, Pos2};

    fn button(pressed: bool) -> Event {
        Event::PointerButton {
            pos: Pos2::ZERO,
            button: PointerButton::Primary,
            pressed,
            modifiers: Modifiers::NONE,
        }
    }

    #[test]
    fn a_tap_takes_two_frames_and_two_take_three() {
        let context = Context::default();
        let mut taps = Taps::default();
        let mut frame = |events: &[Event]| {
            let mut input = RawInput {
                events: events.to_vec(),
                ..RawInput::default()
            };
            taps.input_hook(&context, &mut input);
            input.events
        };
        let [down, up] = [button(true), button(false)];
        assert_eq!(
            frame(std::slice::from_ref(&up)),
            [button(false)],
            "one from before"
        );
        let two = [down.clone(), up.clone(), down.clone(), up.clone()];
        assert_eq!(frame(&two), [button(true)]);
        assert_eq!(frame(&[]), [up.clone(), down]);
        assert_eq!(frame(&[Event::PointerGone]), [up, Event::PointerGone]);
        assert_eq!(frame(&[]), []);
    }
}
