//! Everything that the window shows, without the window.

use super::caption::Told;
use super::doors::{Doors, Rooms};
use super::frame::Frame;
use super::hands::Hands;
use super::header::{Top, header};
use super::instruments::Instruments;
use super::link::Link;
use super::log::Log;
use super::meter::Meter;
use super::notice::notice;
use super::pages::Pages;
use super::param::Param;
use super::places::Places;
use super::plot::{Pointed, Scene, leading, plot};
use super::presets::{Browser, Session};
use super::row::{Row, Stage};
use super::saved::Saved;
use super::shown::Shown;
use super::strip::strip;
use super::taps::Taps;
use super::theme::{APART, CORNER, NEAR, Theme, small};
use super::trimming::Trimming;
use super::view::{Sight, View};
use super::why::{Blow, Leaf, Spectrum, Why, damping};
use crate::engine::{Settings, contact_s};
use crate::key_name::key_name;
use crate::params::Controls;
use crate::params::mallet::{HARDNESS, MALLET};
use crate::shelf::Shelved;
use egui::{Align2, CornerRadius, Rect, pos2, vec2};
use modes::Bank;
use nice_plug::prelude::ParamSetter;
use std::path::PathBuf;
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
    session: Session,
    browser: Browser,
    view: View,
    why: Why,
    trimming: Trimming,
    blow: Blow,
    spectrum: Spectrum,
    instruments: Instruments,
    doors: Doors,
    /// The theme that egui has been told of.
    dressed: Option<bool>,
}

impl Ui {
    /// For an instance's parameters, joined to its audio thread by `link`.
    #[must_use]
    pub fn new(controls: Arc<Controls>, saved: Arc<Saved>, link: Arc<Link>) -> Self {
        let log = Arc::new(Log::default());
        let params = Param::all(&controls, &log);
        Self {
            session: Session::new(&controls, &saved, &params, &log),
            browser: Browser::default(),
            instruments: Instruments::new(&controls),
            params,
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
            view: View::default(),
            why: Why::default(),
            trimming: Trimming::default(),
            blow: Blow::default(),
            spectrum: Spectrum::default(),
            doors: Doors::default(),
            dressed: None,
        }
    }

    fn param(&self, id: &str) -> Option<Param> {
        self.params
            .iter()
            .find(|param| param.spec.id == id)
            .cloned()
    }

    /// Keeps presets and favourites in another folder than the user's; in none, if there is none.
    pub fn keep_presets_in(&mut self, home: Option<PathBuf>) {
        self.session.move_to(home);
    }

    /// Banks of the user's own.
    pub fn instruments(&mut self) -> &mut Instruments {
        &mut self.instruments
    }

    /// A new window: egui knows nothing of the theme yet.
    pub fn undress(&mut self) {
        self.dressed = None;
        self.spectrum.forget();
    }

    /// Draws everything, plays what is played, and sets what is set.
    pub fn show(&mut self, ui: &mut egui::Ui, setter: &ParamSetter<'_>) {
        let dark = self.saved.dark();
        let theme = if dark { Theme::DARK } else { Theme::LIGHT };
        if self.dressed != Some(dark) {
            theme.apply(ui.ctx());
            ui.ctx().add_plugin(Taps::default());
            self.dressed = Some(dark);
        }
        if self.link.look(&mut self.frame) {
            self.meter.hear(self.frame.peaks);
        }
        self.spectrum.hear(&self.link, self.frame.rate_hz);
        // A gesture whose widget is gone ends with the button.
        if !ui.input(|input| input.pointer.any_down())
            && !ui.input(|input| input.pointer.any_released())
        {
            self.hands.hold.let_go(setter);
        }
        self.session.keys(ui, setter);
        let instrument = self.param("instr");
        #[expect(clippy::cast_sign_loss, reason = "what is below 0 saturates")]
        let index = instrument.as_ref().map_or(0.0, Param::plain).round() as usize;
        let index = self.controls.shelf().number(index);
        let frame = if self.frame.instrument == index {
            &*self.frame
        } else {
            &self.nothing
        };
        self.shown
            .follow(index, self.controls.sounding(index), frame);
        let all = ui.max_rect();
        ui.painter().rect_filled(all, 0.0, theme.ground);
        let places = Places::of(all);
        for panel in places.panels() {
            ui.painter()
                .rect_filled(panel, CornerRadius::same(CORNER), theme.panel);
        }
        self.session.compare();
        let top = Top {
            instrument: instrument.as_ref(),
            instruments: &self.instruments,
            meter: &mut self.meter,
            session: &mut self.session,
            browser: &mut self.browser,
        };
        if header(ui, places.header, top, &theme, setter) {
            self.saved.set_dark(!dark);
            ui.ctx().request_repaint();
        }
        if let Some(param) = &instrument {
            self.instruments.arrive(param, setter);
        }
        let rooms = Rooms {
            instruments: &self.instruments,
            session: &mut self.session,
        };
        self.doors.show(ui, rooms, &theme, setter);
        self.instruments.show_sheet(ui, &theme);
        let now_s = ui.input(|input| input.time);
        self.session.listen(now_s, false);
        let row_hint = self.play(ui, places.row, index, &theme, setter);
        let body_hint = self.middle(ui, &places, index, &theme, setter);
        self.session.listen(now_s, true);
        self.session.trimmed(self.trimming.ended(), now_s);
        let hint = self.doors.told(ui).or(row_hint).or(body_hint);
        self.pages.follow(index, &self.shown.bank);
        self.pages.show(
            ui,
            places.pages.shrink(NEAR),
            &self.params,
            &theme,
            &mut self.hands,
            setter,
        );
        let usual = if self.browser.is_open() {
            "Up and down go through the presets, Enter and Escape close, a click on a star marks."
                .into()
        } else {
            format!(
                "Click a body to strike it there; drag across for a glissando. Keys Z S X D C … play from {}, \
                 − and + move them an octave.",
                key_name(self.row.lowest())
            )
        };
        if let Some(news) = self.instruments.news() {
            notice(ui, places.hint, &news, &self.instruments, &theme);
        } else {
            ui.painter().with_clip_rect(places.hint).text(
                places.hint.left_center(),
                Align2::LEFT_CENTER,
                hint.unwrap_or(usual),
                small(),
                theme.quiet,
            );
        }
        self.session.listen(now_s, false);
        let middle = Rect::from_min_max(places.header.left_bottom(), places.hint.right_top());
        let ready = self.frame.instrument == index;
        let place = ["pos", "acrs"].map(|id| self.param(id).map_or(0.0, |param| param.value()));
        self.browser.play(ui, ready, place, &self.link);
        self.browser
            .show(ui, middle, &mut self.session, &theme, setter);
    }

    /// The body and why it sounds as it does; what the pointer is on.
    fn middle(
        &mut self,
        ui: &mut egui::Ui,
        places: &Places,
        index: usize,
        theme: &Theme,
        setter: &ParamSetter<'_>,
    ) -> Option<String> {
        let settings = self.controls.settings();
        let bank = self.shown.bank.clone();
        let contact_s = self.contact_s(&bank, &settings);
        let inner = places.why.shrink2(vec2(APART, NEAR));
        let mut leaves = self.why.leaves(ui, inner, places.body.is_none(), theme);
        leaves.extend(places.body.map(|body| (Leaf::Body, body.shrink(APART))));
        let [position, across] = ["pos", "acrs"].map(|id| self.param(id));
        let frame = if self.frame.instrument == index {
            &*self.frame
        } else {
            &self.nothing
        };
        let scene = Scene {
            shown: &self.shown,
            frame,
            settings: &settings,
            own: &self.shown.matter().damping,
            contact_s,
            trims: self.controls.trims(),
            theme,
        };
        let struck = frame.struck.filter(|struck| struck.key == self.shown.key);
        let mut hint = None;
        let mut pointed = Pointed::default();
        let solo = self.controls.trims().get().solo();
        let alone = self
            .shown
            .partials
            .iter()
            .position(|partial| Some(partial.label) == solo);
        for (leaf, area) in leaves {
            match leaf {
                Leaf::Partials => pointed = plot(ui, area, &scene, &mut self.trimming),
                Leaf::Damping => {
                    let hold = &mut self.hands.hold;
                    hint = damping(ui, area, &scene, &self.params, hold, setter);
                }
                Leaf::Blow => {
                    let velocity = f64::from(self.row.velocity) / 127.0;
                    self.blow.show(ui, area, velocity, &scene);
                }
                Leaf::Spectrum => self.spectrum.show(ui, area, theme),
                Leaf::Body => {
                    let sight = Sight {
                        instrument: index,
                        frame,
                        told: Told {
                            shown: &self.shown,
                            settings: &settings,
                            position: struck.map_or(settings.strike_position, |s| s.position)
                                as f32,
                            contact_s,
                            head: self.head(&settings),
                            partial: leading(&scene),
                        },
                        alone: pointed.number.or(alone),
                        link: &self.link,
                        theme,
                        velocity: self.row.velocity / 127.0,
                        position: position.as_ref(),
                        across: across.as_ref(),
                        saved: &self.saved,
                        setter,
                    };
                    let told = self.view.show(ui, area, &sight, &mut self.hands.hold);
                    hint = told.or(hint);
                }
            }
        }
        hint.or(pointed.hint)
    }

    /// The name of the mallet that is chosen, or how hard it is set.
    fn head(&self, settings: &Settings) -> String {
        let named = self.param(MALLET.id).filter(|mallet| mallet.plain() > 0.0);
        let hardness = || HARDNESS.format(settings.mallet.hardness_pa as f32);
        named.map_or_else(hardness, |mallet| mallet.text())
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
        let [position, across] = ["pos", "acrs"].map(|id| self.param(id));
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
            across: across.as_ref(),
            setter,
        };
        self.row.show(ui, area, &stage, &mut self.hands.hold)
    }
}

impl Drop for Ui {
    /// Nobody is to wonder why a window that is gone lets one partial sound alone.
    fn drop(&mut self) {
        self.controls.trims().change(|trims| trims.set_solo(None));
    }
}
