//! The row of bodies: a keyboard to play by mouse and by the computer's keys.

use super::figure::{Figure, lay_out};
use super::frame::Frame;
use super::hold::Hold;
use super::keys::{Press, letter, presses};
use super::link::{Link, Touch};
use super::outline::Outlines;
use super::paint_body::{Look, paint_body};
use super::param::Param;
use super::theme::{Theme, small};
use crate::key_name::key_name;
use egui::{Align2, CursorIcon, Id, Pos2, Rect, Role, Sense, Ui, WidgetInfo, pos2};
use modes::Bank;
use nice_plug::prelude::ParamSetter;

/// Pointer speed in points a second at which a body swept over is struck with the set velocity.
const SWEEP: f32 = 1500.0;
/// Points between two looks at what a sweep passes over.
const STRIDE: f32 = 2.0;
/// Energies in dB below the reference that glow: none and all of it.
const DIM_DB: f32 = -66.0;

/// What the row remembers.
pub(super) struct Row {
    /// How hard clicks and keys strike, 1…127.
    pub(super) velocity: f32,
    /// MIDI key that the computer's Z plays.
    lowest: u8,
    /// The body under the pointer that holds the button down.
    under: Option<u8>,
    /// Where the pointer was then.
    at: Option<Pos2>,
    /// Energy in J that glows most.
    reference_j: f32,
    outlines: Outlines,
}

impl Default for Row {
    fn default() -> Self {
        Self {
            velocity: 100.0,
            lowest: 60,
            under: None,
            at: None,
            reference_j: 1e-3,
            outlines: Outlines::default(),
        }
    }
}

/// What the row needs of its surroundings.
pub(super) struct Stage<'a, 'b> {
    pub(super) bank: &'a Bank,
    pub(super) frame: &'a Frame,
    pub(super) link: &'a Link,
    pub(super) theme: &'a Theme,
    /// The strike position.
    pub(super) position: Option<&'a Param>,
    /// The place across.
    pub(super) across: Option<&'a Param>,
    pub(super) setter: &'a ParamSetter<'b>,
}

impl Row {
    /// MIDI key that the computer's Z plays.
    pub(super) fn lowest(&self) -> u8 {
        self.lowest
    }

    /// Draws the row at `area`, and plays; what the pointer is on, in words.
    pub(super) fn show(
        &mut self,
        ui: &mut Ui,
        area: Rect,
        stage: &Stage<'_, '_>,
        hold: &mut Hold,
    ) -> Option<String> {
        let names = 16.0;
        let figures = lay_out(
            stage.bank,
            Rect::from_min_max(area.min, pos2(area.right(), area.bottom() - names)),
            &mut self.outlines,
        );
        self.press(ui, stage, &figures);
        let hovered = self.point(ui, area, stage, &figures, hold);
        self.paint(
            ui,
            area,
            stage,
            &figures,
            hovered.map(|(figure, _)| figure.key),
        );
        hovered.map(|(figure, position)| describe(stage.bank, figure, position))
    }

    fn strike(&self, stage: &Stage<'_, '_>, figure: &Figure, place: [f32; 2], share: f32) {
        let [position, across] = place;
        stage.link.touch(Touch::Strike {
            key: figure.key,
            velocity: (share * self.velocity / 127.0).clamp(1.0 / 127.0, 1.0),
            position,
            across,
        });
    }

    /// Where strikes of keys land, along and across.
    fn set_place(stage: &Stage<'_, '_>) -> [f32; 2] {
        [
            stage.position.map_or(0.03, |param| param.plain() / 100.0),
            stage.across.map_or(0.0, |param| param.plain() / 100.0),
        ]
    }

    /// Plays the computer's keys.
    fn press(&mut self, ui: &Ui, stage: &Stage<'_, '_>, figures: &[Figure]) {
        for press in presses(ui, self.lowest) {
            match press {
                Press::Down(key) => {
                    if let Some(figure) = figures.iter().find(|figure| figure.key == key) {
                        self.strike(stage, figure, Self::set_place(stage), 1.0);
                    }
                }
                Press::Up(key) => stage.link.touch(Touch::Release { key }),
                Press::Octave(step) => {
                    let moved = self.lowest.saturating_add_signed(12 * step);
                    if (12..=108).contains(&moved) {
                        self.lowest = moved;
                    }
                }
            }
        }
    }

    /// Plays with the pointer; the body under it, and the place on it.
    fn point<'f>(
        &mut self,
        ui: &Ui,
        area: Rect,
        stage: &Stage<'_, '_>,
        figures: &'f [Figure],
        hold: &mut Hold,
    ) -> Option<(&'f Figure, f32)> {
        // Below the pointer's own area, lest they take its presses.
        for figure in figures {
            let id = Id::unique(("body", figure.key));
            let body = ui.interact(figure.rect, id, Sense::CLICK);
            body.widget_info(|| WidgetInfo::labeled(Role::Button, true, key_name(figure.key)));
            if body.clicked() && !ui.input(|input| input.pointer.any_released()) {
                self.strike(stage, figure, Self::set_place(stage), 1.0);
            }
        }
        let response = ui
            .interact(area, Id::unique("row"), Sense::CLICK | Sense::DRAG)
            .on_hover_cursor(CursorIcon::PointingHand);
        response.widget_info(|| WidgetInfo::labeled(Role::Group, true, "Bodies"));
        let here = response.interact_pointer_pos().or(response.hover_pos());
        if response.is_pointer_button_down_on() {
            if let Some(to) = here {
                self.sweep(ui, to, stage, figures, hold);
            }
        } else {
            if let Some(key) = self.under.take() {
                stage.link.touch(Touch::Release { key });
            }
            if self.at.take().is_some() {
                hold.let_go(stage.setter);
            }
        }
        let here = here?;
        let figure = figures.iter().find(|figure| figure.holds(here, 0.0))?;
        Some((figure, figure.position(here)))
    }

    /// The pointer has come to `to` with its button down: strikes every body that it has come upon.
    fn sweep(
        &mut self,
        ui: &Ui,
        to: Pos2,
        stage: &Stage<'_, '_>,
        figures: &[Figure],
        hold: &mut Hold,
    ) {
        let pressed = self.at.is_none();
        let from = self.at.replace(to).unwrap_or(to);
        // Velocity of a click is set; that of a sweep is the pointer's.
        let share = if pressed {
            1.0
        } else {
            let speed = ui.input(|input| input.pointer.velocity().length());
            (speed / SWEEP).clamp(0.2, 1.27)
        };
        #[expect(clippy::cast_sign_loss, reason = "lengths are not negative")]
        let steps = ((to - from).length() / STRIDE).ceil().max(1.0) as usize;
        for step in 1..=steps {
            let at = from + (to - from) * (step as f32 / steps as f32);
            let slack = if pressed { 2.0 } else { 0.0 };
            let found = figures.iter().find(|figure| figure.holds(at, slack));
            let Some(figure) = found.filter(|figure| self.under != Some(figure.key)) else {
                if found.is_none() {
                    self.leave(stage);
                }
                continue;
            };
            self.leave(stage);
            self.under = Some(figure.key);
            let (position, across) = figure.place(at);
            let place = [position, across.unwrap_or(Self::set_place(stage)[1])];
            if let Some(param) = stage.position {
                hold.take(param, stage.setter);
                hold.put(param.place(100.0 * place[0]), stage.setter);
            }
            if let (Some(param), Some(across)) = (stage.across, across) {
                hold.put_beside(param, param.place(100.0 * across), stage.setter);
            }
            self.strike(stage, figure, place, share);
        }
    }

    fn leave(&mut self, stage: &Stage<'_, '_>) {
        if let Some(key) = self.under.take() {
            stage.link.touch(Touch::Release { key });
        }
    }

    fn paint(
        &mut self,
        ui: &Ui,
        area: Rect,
        stage: &Stage<'_, '_>,
        figures: &[Figure],
        hovered: Option<u8>,
    ) {
        let energies = &stage.frame.energies_j;
        self.reference_j = energies
            .iter()
            .fold(self.reference_j, |most, e| most.max(*e));
        let pointer = ui.input(|input| input.pointer.hover_pos());
        let set = Self::set_place(stage);
        for figure in figures {
            let energy_j = energies[usize::from(figure.key)];
            let level_db = 10.0 * (energy_j / self.reference_j).max(1e-12).log10();
            let struck = stage.frame.struck.filter(|struck| struck.key == figure.key);
            let look = Look {
                glow: (1.0 - level_db / DIM_DB).clamp(0.0, 1.0),
                hovered: hovered == Some(figure.key),
                mark: struck.map(|struck| [struck.position, struck.across].map(|x| x as f32)),
                set,
                pointed: pointer.filter(|_| hovered == Some(figure.key)).map(|at| {
                    let (position, across) = figure.place(at);
                    [position, across.unwrap_or_default()]
                }),
            };
            paint_body(ui.painter(), figure, stage.bank, stage.theme, &look);
            let letter = figure.key.checked_sub(self.lowest).and_then(letter);
            if let Some(letter) = letter.filter(|_| figure.rect.width() > 12.0) {
                ui.painter().text(
                    figure.rect.center(),
                    Align2::CENTER_CENTER,
                    letter,
                    small(),
                    stage.theme.text.gamma_multiply(0.8),
                );
            }
            if figure.key % 12 == 0 {
                ui.painter().text(
                    pos2(figure.rect.center().x, area.bottom() - 7.0),
                    Align2::CENTER_CENTER,
                    key_name(figure.key),
                    small(),
                    stage.theme.quiet,
                );
            }
        }
    }
}

/// A body and a place on it in words.
fn describe(bank: &Bank, figure: &Figure, position: f32) -> String {
    let body = bank.bodies.iter().find(|body| body.key == figure.key);
    let size = body.map_or_else(String::new, |body| {
        format!(
            ", {:.0} Hz, {:.0} mm, {:.0} g",
            body.pitch_hz,
            1e3 * body.length_m,
            1e3 * body.mass_kg
        )
    });
    let [from, to] = figure.kind.ends();
    format!(
        "{} ({}{size}): a click here strikes {:.0} % of the way from {from} to {to}",
        key_name(figure.key),
        figure.kind.name(),
        100.0 * position
    )
}
