//! What the window's system tells of hands, as egui wants to hear it.

use egui::{
    Event as Said, Key, Modifiers, MouseWheelSource, MouseWheelUnit, PointerButton, Pos2, RawInput,
    Rect, TouchPhase, ViewportId, pos2, vec2,
};
use nice_plug_egui::baseview::{
    Event, MouseButton, MouseEvent, ScrollDelta, WindowEvent, WindowSize,
};
use std::time::Instant;

/// What has been told since the last frame.
pub(super) struct Input {
    said: Vec<Said>,
    pointer: Pos2,
    modifiers: Modifiers,
    focused: bool,
    since: Instant,
}

impl Input {
    pub(super) fn new() -> Self {
        Self {
            said: Vec::new(),
            pointer: Pos2::ZERO,
            modifiers: Modifiers::NONE,
            focused: true,
            since: Instant::now(),
        }
    }

    /// What a frame begins with, in a window of that size.
    pub(super) fn take(&mut self, size: WindowSize) -> RawInput {
        let logical = size.physical.to_logical::<f32>(size.scale_factor);
        let points = vec2(logical.width, logical.height);
        let mut input = RawInput {
            screen_rect: Some(Rect::from_min_size(Pos2::ZERO, points)),
            time: Some(self.since.elapsed().as_secs_f64()),
            events: std::mem::take(&mut self.said),
            focused: self.focused,
            ..RawInput::default()
        };
        if let Some(viewport) = input.viewports.get_mut(&ViewportId::ROOT) {
            viewport.native_pixels_per_point = Some(size.scale_factor as f32);
        }
        input
    }

    /// Takes up what is told, in a window of so many pixels to a point.
    pub(super) fn take_up(&mut self, event: &Event, scale: f64) {
        match event {
            Event::Mouse(event) => self.mouse(event, scale),
            Event::Keyboard(event) => {
                let held = event.modifiers;
                self.hold(held.alt(), held.ctrl(), held.shift(), held.meta());
                let name = event.key.to_string();
                self.key(&name, event.state.is_down(), event.repeat);
            }
            Event::Window(WindowEvent::Focused) => self.focus(true),
            Event::Window(WindowEvent::Unfocused) => self.focus(false),
            _ => {}
        }
    }

    fn focus(&mut self, focused: bool) {
        self.focused = focused;
        self.said.push(Said::WindowFocused(focused));
    }

    fn hold(&mut self, alt: bool, ctrl: bool, shift: bool, meta: bool) {
        let mac_cmd = cfg!(target_os = "macos") && meta;
        let modifiers = Modifiers {
            alt,
            ctrl,
            shift,
            mac_cmd,
            command: mac_cmd || !cfg!(target_os = "macos") && ctrl,
        };
        if modifiers != self.modifiers {
            self.modifiers = modifiers;
            self.said.push(Said::ModifiersChanged(modifiers));
        }
    }

    /// A key by its name, which of one that writes is what it writes.
    fn key(&mut self, name: &str, pressed: bool, repeat: bool) {
        let capital = name.to_uppercase();
        let key = match name {
            " " => Some(Key::Space),
            _ => Key::from_name(name).or_else(|| Key::from_name(&capital)),
        };
        let modifiers = self.modifiers;
        if let Some(key) = key {
            self.said.push(Said::Key {
                key,
                physical_key: None,
                pressed,
                repeat,
                modifiers,
            });
        }
        let writes = name.chars().count() == 1 && !modifiers.ctrl && !modifiers.command;
        if pressed && writes {
            self.said.push(Said::Text(name.to_owned()));
        }
    }

    fn mouse(&mut self, event: &MouseEvent, scale: f64) {
        match event {
            MouseEvent::CursorMoved {
                position,
                modifiers: held,
            } => {
                self.hold(held.alt(), held.ctrl(), held.shift(), held.meta());
                let at = position.to_logical::<f32>(scale);
                self.pointer = pos2(at.x, at.y);
                self.said.push(Said::PointerMoved(self.pointer));
            }
            MouseEvent::ButtonPressed {
                button,
                modifiers: held,
            } => {
                self.hold(held.alt(), held.ctrl(), held.shift(), held.meta());
                self.button(*button, true);
            }
            MouseEvent::ButtonReleased {
                button,
                modifiers: held,
            } => {
                self.hold(held.alt(), held.ctrl(), held.shift(), held.meta());
                self.button(*button, false);
            }
            MouseEvent::WheelScrolled {
                delta,
                modifiers: held,
            } => {
                self.hold(held.alt(), held.ctrl(), held.shift(), held.meta());
                let (unit, delta) = match delta {
                    ScrollDelta::Lines { x, y } => (MouseWheelUnit::Line, vec2(*x, *y)),
                    ScrollDelta::Pixels { x, y } => {
                        (MouseWheelUnit::Point, vec2(*x, *y) / scale as f32)
                    }
                };
                self.said.push(Said::MouseWheel {
                    unit,
                    delta,
                    phase: TouchPhase::Move,
                    source: MouseWheelSource::Unknown,
                    modifiers: self.modifiers,
                });
            }
            MouseEvent::CursorLeft => self.said.push(Said::PointerGone),
            _ => {}
        }
    }

    fn button(&mut self, button: MouseButton, pressed: bool) {
        let button = match button {
            MouseButton::Left => PointerButton::Primary,
            MouseButton::Right => PointerButton::Secondary,
            MouseButton::Middle => PointerButton::Middle,
            _ => return,
        };
        self.said.push(Said::PointerButton {
            pos: self.pointer,
            button,
            pressed,
            modifiers: self.modifiers,
        });
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn key(name: &str) -> Vec<Said> {
        let mut input = Input::new();
        input.key(name, true, false);
        input.said
    }

    #[test]
    fn keys_are_pressed_and_write() {
        let pressed = |said: &[Said]| match said {
            [Said::Key { key, .. }, ..] => Some(*key),
            _ => None,
        };
        for (name, expected) in [
            ("z", Key::Z),
            ("7", Key::Num7),
            (" ", Key::Space),
            ("ArrowDown", Key::ArrowDown),
            ("Enter", Key::Enter),
            ("Escape", Key::Escape),
            ("Backspace", Key::Backspace),
        ] {
            let said = key(name);
            assert_eq!(pressed(&said), Some(expected), "{name}");
            let text = said.contains(&Said::Text(name.to_owned()));
            assert_eq!(text, name.len() == 1, "{name}");
        }
        assert_eq!(key("\u{e4}"), [Said::Text("\u{e4}".to_owned())]);
    }

    #[test]
    fn letters_with_control_write_nothing() {
        let mut input = Input::new();
        input.hold(false, true, false, false);
        input.key("z", true, false);
        assert!(!input.said.iter().any(|said| matches!(said, Said::Text(_))));
        assert!(matches!(input.said[..], [_, Said::Key { key: Key::Z, .. }]));
    }
}
