//! Everything that the window shows, without the window.

use super::figure::key_name;
use super::frame::Frame;
use super::hands::Hands;
use super::header::header;
use super::instruments::Instruments;
use super::link::Link;
use super::meter::Meter;
use super::notice::notice;
use super::pages::Pages;
use super::param::Param;
use super::plot::{Scene, plot};
use super::row::{Row, Stage};
use super::saved::Saved;
use super::shown::Shown;
use super::strip::strip;
use super::theme::{APART, CORNER, NEAR, Theme, small};
use crate::engine::{Settings, contact_s};
use crate::params::Controls;
use crate::shelf::Shelved;
use egui::{Align2, CornerRadius, Rect, pos2, vec2};
use modes::Bank;
use nice_plug::prelude::ParamSetter;
use std::sync::Arc;

/// The editor's picture and what it remembers.
pub struct Ui {
    controls: Arc<Controls>,
    saved: Arc<Saved>,
    link: Arc<Link>,
    params: Vec<Param>,
    frame: Box<Frame>,
    /// What is seen of an instrument that does not yet sound.
    nothing: Frame,
    hands: Hands,
    row: Row,
    shown: Shown,
    meter: Meter,
    pages: Pages,
    instruments: Instruments,
    /// The theme that egui has been told of.
    dressed: Option<bool>,
}

impl Ui {
    /// For an instance's parameters, joined to its audio thread by `link`.
    #[must_use]
    pub fn new(controls: Arc<Controls>, saved: Arc<Saved>, link: Arc<Link>) -> Self {
        Self {
            params: Param::all(&controls),
            instruments: Instruments::new(&controls),
            controls,
            saved,
            link,
            frame: Box::default(),
            nothing: Frame::default(),
            hands: Hands::default(),
            row: Row::default(),
            shown: Shown::new(0, Shelved::factory(0), None),
            meter: Meter::default(),
            pages: Pages::default(),
            dressed: None,
        }
    }

    fn param(&self, id: &str) -> Option<Param> {
        self.params
            .iter()
            .find(|param| param.spec.id == id)
            .cloned()
    }

    /// Banks of the user's own.
    pub fn instruments(&mut self) -> &mut Instruments {
        &mut self.instruments
    }

    /// A new window: egui knows nothing of the theme yet.
    pub fn undress(&mut self) {
        self.dressed = None;
    }

    /// Draws everything, plays what is played, and sets what is set.
    pub fn show(&mut self, ui: &mut egui::Ui, setter: &ParamSetter<'_>) {
        let dark = self.saved.dark();
        let theme = if dark { Theme::DARK } else { Theme::LIGHT };
        if self.dressed != Some(dark) {
            theme.apply(ui.ctx());
            self.dressed = Some(dark);
        }
        if self.link.look(&mut self.frame) {
            self.meter.hear(self.frame.peaks);
        }
        // A gesture whose widget is gone ends with the button.
        if !ui.input(|input| input.pointer.any_down())
            && !ui.input(|input| input.pointer.any_released())
        {
            self.hands.hold.let_go(setter);
        }
        let instrument = self.param("instr");
        #[expect(clippy::cast_sign_loss, reason = "what is below 0 saturates")]
        let index = instrument.as_ref().map_or(0.0, Param::plain).round() as usize;
        let shelf = Arc::clone(self.controls.shelf());
        let index = shelf.number(index);
        let frame = if self.frame.instrument == index {
            &*self.frame
        } else {
            &self.nothing
        };
        self.shown.follow(index, |number| shelf.bank(number), frame);
        let all = ui.max_rect();
        ui.painter().rect_filled(all, 0.0, theme.ground);
        let places = Places::of(all);
        for panel in [places.row, places.partials, places.pages] {
            ui.painter()
                .rect_filled(panel, CornerRadius::same(CORNER), theme.panel);
        }
        if header(
            ui,
            places.header,
            instrument.as_ref(),
            &self.instruments,
            &mut self.meter,
            &theme,
            setter,
        ) {
            self.saved.set_dark(!dark);
            ui.ctx().request_repaint();
        }
        if let Some(param) = &instrument {
            self.instruments.arrive(param, setter);
        }
        let hint = self.play(ui, places.row, index, &theme, setter);
        let settings = self.controls.settings();
        let bank = self.shown.bank.clone();
        plot(
            ui,
            places.partials.shrink(APART),
            &Scene {
                shown: &self.shown,
                frame: if self.frame.instrument == index {
                    &self.frame
                } else {
                    &self.nothing
                },
                settings: &settings,
                own: &bank.damping,
                contact_s: self.contact_s(&bank, &settings),
                theme: &theme,
            },
        );
        self.pages.show(
            ui,
            places.pages.shrink(NEAR),
            &self.params,
            &theme,
            &mut self.hands,
            setter,
        );
        let usual = format!(
            "Click a body to strike it there; drag across for a glissando. Keys Z S X D C … play from {}, \
             − and + move them an octave.",
            key_name(self.row.lowest())
        );
        if let Some(news) = self.instruments.news() {
            notice(ui, places.hint, &news, &self.instruments, &theme);
            return;
        }
        ui.painter().with_clip_rect(places.hint).text(
            places.hint.left_center(),
            Align2::LEFT_CENTER,
            hint.unwrap_or(usual),
            small(),
            theme.quiet,
        );
    }

    /// How long a click touches the body that is shown, in s.
    fn contact_s(&self, bank: &Bank, settings: &Settings) -> f64 {
        let body = bank.bodies.iter().find(|body| body.key == self.shown.key);
        let velocity = f64::from(self.row.velocity) / 127.0;
        body.map_or(1e-3, |body| contact_s(bank, body, settings, velocity))
    }

    /// Velocity strip and row of bodies; what the pointer is on.
    fn play(
        &mut self,
        ui: &mut egui::Ui,
        panel: Rect,
        instrument: usize,
        theme: &Theme,
        setter: &ParamSetter<'_>,
    ) -> Option<String> {
        let inner = panel.shrink2(vec2(APART, NEAR * 2.0));
        let side = Rect::from_min_size(inner.min, vec2(44.0, inner.height()));
        strip(ui, side, &mut self.row.velocity, theme);
        let area = Rect::from_min_max(pos2(side.right() + APART, inner.top()), inner.max);
        let position = self.param("pos");
        let bank = self.shown.bank.clone();
        let stage = Stage {
            bank: &bank,
            frame: if self.frame.instrument == instrument {
                &self.frame
            } else {
                &self.nothing
            },
            link: &self.link,
            theme,
            position: position.as_ref(),
            setter,
        };
        self.row.show(ui, area, &stage, &mut self.hands.hold)
    }
}

/// Where everything is.
struct Places {
    header: Rect,
    row: Rect,
    partials: Rect,
    pages: Rect,
    hint: Rect,
}

impl Places {
    fn of(all: Rect) -> Self {
        let inner = all.shrink2(vec2(APART, 0.0));
        let slice = |top: f32, bottom: f32| {
            Rect::from_min_max(pos2(inner.left(), top), pos2(inner.right(), bottom))
        };
        let header = slice(all.top(), all.top() + 44.0);
        let hint = slice(all.bottom() - 24.0, all.bottom());
        let middle = slice(header.bottom(), hint.top());
        let row_height = (0.38 * middle.height()).clamp(120.0, 420.0);
        let row = slice(middle.top(), middle.top() + row_height);
        let rest = slice(row.bottom() + APART, middle.bottom());
        // Five knobs side by side at most.
        let pages_width = (0.51 * rest.width()).clamp(304.0, 500.0);
        let split = rest.right() - pages_width;
        Self {
            header,
            row,
            partials: Rect::from_min_max(rest.min, pos2(split - APART, rest.bottom())),
            pages: Rect::from_min_max(pos2(split, rest.top()), rest.max),
            hint,
        }
    }
}
