//! What the window's system tells, as egui wants to hear it.

use super::files::Files;
use super::keys::said;
use baseview::{Event, MouseButton, MouseEvent, ScrollDelta, WindowEvent, WindowSize};
use egui::{
    Event as Said, Modifiers, MouseWheelSource, MouseWheelUnit, PointerButton, Pos2, RawInput,
    Rect, TouchPhase, ViewportId, pos2, vec2,
};
use keyboard_types::Modifiers as Held;
use nice_plug::editor::dpi::PhysicalPosition;
use std::path::Path;
use std::time::Instant;

/// What has been told since the last frame.
pub(super) struct Input {
    said: Vec<Said>,
    files: Files,
    pointer: Pos2,
    modifiers: Modifiers,
    focused: bool,
    most_texture_side: Option<usize>,
    since: Instant,
}

impl Input {
    pub(super) fn new(most_texture_side: Option<usize>) -> Self {
        Self {
            said: Vec::new(),
            files: Files::default(),
            pointer: Pos2::ZERO,
            modifiers: Modifiers::NONE,
            focused: true,
            most_texture_side,
            since: Instant::now(),
        }
    }

    /// What a frame begins with, in a window of that size.
    pub(super) fn take(&mut self, size: WindowSize, zoom: f32) -> RawInput {
        let scale = size.scale_factor * f64::from(zoom);
        let logical = size.physical.to_logical::<f32>(scale);
        let points = vec2(logical.width, logical.height);
        let mut input = RawInput {
            screen_rect: Some(Rect::from_min_size(Pos2::ZERO, points)),
            max_texture_side: self.most_texture_side,
            time: Some(self.since.elapsed().as_secs_f64()),
            events: std::mem::take(&mut self.said),
            hovered_files: self.files.hovered(),
            dropped_files: self.files.take(),
            focused: self.focused,
            ..RawInput::default()
        };
        if let Some(viewport) = input.viewports.get_mut(&ViewportId::ROOT) {
            viewport.native_pixels_per_point = Some(size.scale_factor as f32);
        }
        input
    }

    /// Whether a file of some kind is dragged or has just been dropped.
    pub(super) fn drags(&self, kind: impl Fn(&Path) -> bool) -> bool {
        self.files.all().any(kind)
    }

    /// Takes up what is told, in a window of so many pixels to a point; `pasted` is what the clipboard has.
    pub(super) fn take_up(
        &mut self,
        event: &Event,
        scale: f64,
        pasted: impl FnOnce() -> Option<String>,
    ) {
        match event {
            Event::Mouse(event) => self.mouse(event, scale),
            Event::Keyboard(event) => {
                self.hold(event.modifiers);
                self.said.extend(said(event, self.modifiers, pasted));
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

    fn hold(&mut self, held: Held) {
        let mac_cmd = cfg!(target_os = "macos") && held.meta();
        let modifiers = Modifiers {
            alt: held.alt(),
            ctrl: held.ctrl(),
            shift: held.shift(),
            mac_cmd,
            command: mac_cmd || !cfg!(target_os = "macos") && held.ctrl(),
        };
        if modifiers != self.modifiers {
            self.modifiers = modifiers;
            self.said.push(Said::ModifiersChanged(modifiers));
        }
    }

    fn mouse(&mut self, event: &MouseEvent, scale: f64) {
        match event {
            MouseEvent::CursorMoved {
                position,
                modifiers,
            } => {
                self.hold(*modifiers);
                self.point(*position, scale);
            }
            MouseEvent::ButtonPressed { button, modifiers } => {
                self.hold(*modifiers);
                self.button(*button, true);
            }
            MouseEvent::ButtonReleased { button, modifiers } => {
                self.hold(*modifiers);
                self.button(*button, false);
            }
            MouseEvent::WheelScrolled { delta, modifiers } => {
                self.hold(*modifiers);
                self.wheel(delta);
            }
            MouseEvent::CursorLeft => self.said.push(Said::PointerGone),
            // What is beneath is not pointed at while something is dragged over it.
            MouseEvent::DragEntered { data, .. } | MouseEvent::DragMoved { data, .. } => {
                self.files.hover(data);
                self.said.push(Said::PointerGone);
            }
            MouseEvent::DragDropped { data, .. } => self.files.fall(data),
            MouseEvent::DragLeft => self.files.leave(),
            _ => {}
        }
    }

    fn point(&mut self, position: PhysicalPosition<f64>, scale: f64) {
        let at = position.to_logical::<f32>(scale);
        self.pointer = pos2(at.x, at.y);
        self.said.push(Said::PointerMoved(self.pointer));
    }

    fn wheel(&mut self, delta: &ScrollDelta) {
        let (unit, delta) = match delta {
            ScrollDelta::Lines { x, y } => (MouseWheelUnit::Line, vec2(*x, *y)),
            // Only AppKit tells these, and in points.
            ScrollDelta::Pixels { x, y } => (MouseWheelUnit::Point, vec2(*x, *y)),
        };
        self.said.push(Said::MouseWheel {
            unit,
            delta,
            phase: TouchPhase::Move,
            source: MouseWheelSource::Unknown,
            modifiers: self.modifiers,
        });
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
    use baseview::DropData;
    use nice_plug::editor::dpi::{LogicalSize, PhysicalSize};
    use std::path::PathBuf;

    const SIZE: WindowSize = WindowSize {
        logical: LogicalSize::new(500.0, 300.0),
        physical: PhysicalSize::new(1000, 600),
        scale_factor: 2.0,
    };

    fn tell(input: &mut Input, event: MouseEvent) {
        input.take_up(&Event::Mouse(event), 2.0, || None);
    }

    fn over(name: &str) -> (PhysicalPosition<f64>, Held, DropData) {
        let files = DropData::Files(vec![PathBuf::from(name)]);
        (PhysicalPosition::new(80.0, 60.0), Held::empty(), files)
    }

    #[test]
    fn files_hover_until_they_leave_or_fall_and_fall_once() {
        let mut input = Input::new(None);
        let (position, modifiers, data) = over("/bell.obj");
        tell(
            &mut input,
            MouseEvent::DragEntered {
                position,
                modifiers,
                data: data.clone(),
            },
        );
        for _ in 0..2 {
            let frame = input.take(SIZE, 1.0);
            assert_eq!(
                frame.hovered_files[0].path.as_deref(),
                Some("/bell.obj".as_ref())
            );
            assert!(frame.dropped_files.is_empty());
        }
        assert!(input.drags(|path| path.ends_with("bell.obj")));
        tell(&mut input, MouseEvent::DragLeft);
        assert!(input.take(SIZE, 1.0).hovered_files.is_empty());
        assert!(!input.drags(|_| true));
        tell(
            &mut input,
            MouseEvent::DragDropped {
                position,
                modifiers,
                data,
            },
        );
        assert!(input.drags(|_| true), "the system asks right after");
        let frame = input.take(SIZE, 1.0);
        assert!(frame.hovered_files.is_empty());
        assert_eq!(
            frame.dropped_files[0].path(),
            AsRef::<Path>::as_ref("/bell.obj")
        );
        assert_eq!(frame.events, [], "nothing beneath was pointed at");
        assert!(input.take(SIZE, 1.0).dropped_files.is_empty());
    }

    #[test]
    fn what_is_drawn_twice_as_large_has_half_the_points() {
        let mut input = Input::new(Some(2048));
        let frame = input.take(SIZE, 2.0);
        let points = frame.screen_rect.unwrap().size();
        assert_eq!(points, vec2(250.0, 150.0));
        assert_eq!(frame.max_texture_side, Some(2048));
    }
}
