//! The body taken by hand: struck, turned and come near to.

use super::super::hold::Hold;
use super::super::knob::notches;
use super::super::link::Touch;
use super::super::solid::{Place, Solid};
use super::camera::Camera;
use super::{Press, Sight, View};
use egui::{EventFilter, Key, PointerButton, Response, Ui, Vec2, vec2};

/// Zoom of a notch of the wheel, and turn in points of drag of an arrow key.
const NOTCH: f32 = 1.15;
const ARROW: f32 = 12.0;

impl View {
    /// What pointer and keys do.
    pub(super) fn hands(
        &mut self,
        ui: &Ui,
        response: &Response,
        (key, solid): (u8, &Solid),
        sight: &Sight<'_, '_>,
        hold: &mut Hold,
    ) {
        let primary = ui.input(|input| input.pointer.button_down(PointerButton::Primary));
        if response.is_pointer_button_down_on() {
            if self.press == Press::Nothing {
                let on = response
                    .interact_pointer_pos()
                    .filter(|_| primary)
                    .and_then(|at| self.portrait.struck_at(solid, at));
                self.press = match on {
                    Some((point, place)) => {
                        self.strike(key, place, sight, hold);
                        self.clicked = Some((point, place));
                        Press::Struck(key)
                    }
                    None => Press::Turns,
                };
            } else if self.press == Press::Turns {
                self.portrait.camera.turn(response.drag_delta());
            }
        } else {
            if let Press::Struck(key) = self.press {
                sight.link.touch(Touch::Release { key });
                hold.let_go(sight.setter);
            } else if response.double_clicked() {
                self.portrait.camera = Camera::on(solid.kind);
            } else if response.clicked() && !ui.input(|input| input.pointer.any_released()) {
                self.touch(key, sight.set_place(), sight);
                sight.link.touch(Touch::Release { key });
            }
            self.press = Press::Nothing;
        }
        if response.hovered() {
            self.portrait.camera.approach(NOTCH.powf(notches(ui)));
        }
        if response.has_focus() {
            self.arrows(ui, response);
        }
    }

    fn arrows(&mut self, ui: &Ui, response: &Response) {
        let filter = EventFilter {
            horizontal_arrows: true,
            vertical_arrows: true,
            ..EventFilter::default()
        };
        ui.memory_mut(|memory| memory.set_focus_lock_filter(response.id, filter));
        let pressed = |key: Key| ui.input(|input| input.key_pressed(key));
        let moves = [
            (Key::ArrowLeft, vec2(-ARROW, 0.0)),
            (Key::ArrowRight, vec2(ARROW, 0.0)),
            (Key::ArrowUp, vec2(0.0, -ARROW)),
            (Key::ArrowDown, vec2(0.0, ARROW)),
        ];
        let turn = moves
            .into_iter()
            .filter(|(key, _)| pressed(*key))
            .fold(Vec2::ZERO, |sum, (_, by)| sum + by);
        self.portrait.camera.turn(turn);
        for (key, factor) in [(Key::PageUp, NOTCH), (Key::PageDown, 1.0 / NOTCH)] {
            if pressed(key) {
                self.portrait.camera.approach(factor);
            }
        }
    }

    /// Strikes at a place, which is automation of the strike position and of the place across.
    fn strike(&self, key: u8, place: Place, sight: &Sight<'_, '_>, hold: &mut Hold) {
        let Place { along, across } = place;
        if let Some(param) = sight.position {
            hold.take(param, sight.setter);
            hold.put(param.place(100.0 * along), sight.setter);
        }
        if let (Some(param), Some(across)) = (sight.across, across) {
            hold.put_beside(param, param.place(100.0 * across), sight.setter);
        }
        let across = across.unwrap_or_else(|| sight.set_across());
        self.touch(key, [along, across], sight);
    }

    fn touch(&self, key: u8, [position, across]: [f32; 2], sight: &Sight<'_, '_>) {
        sight.link.touch(Touch::Strike {
            key,
            velocity: sight.velocity,
            position,
            across,
        });
    }
}
