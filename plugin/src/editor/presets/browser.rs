//! The browser over the window's middle: shelves, presets, and the card of one.

use super::super::icon::Icon;
use super::super::link::Link;
use super::super::theme::{APART, CORNER, NEAR, SIDE, Theme, body, small};
use super::button::sign;
use super::form::{Form, Outcome};
use super::hearing::Hearing;
use super::session::Session;
use crate::presets::{Broken, Origin, Search};
use egui::{
    Align2, Area, CornerRadius, Id, Key, Modifiers, Order, Rect, Sense, Stroke, StrokeKind,
    TextEdit, Ui, UiBuilder, pos2, vec2,
};
use nice_plug::prelude::ParamSetter;

/// Height of the line with the search, and of that at the bottom.
const LINE: f32 = 34.0;

/// What the browser remembers.
#[derive(Default)]
pub(in super::super) struct Browser {
    open: bool,
    pub(super) search: Search,
    /// Whose card is shown; else the chosen one's.
    pub(super) shown: Option<Origin>,
    pub(super) form: Option<Form>,
    /// What was last done, or why not.
    message: Option<Result<String, String>>,
    pub(super) hearing: Hearing,
    /// Just opened: takes the keyboard.
    fresh: bool,
    /// The list is to go where the chosen preset is.
    pub(super) seek: bool,
}

impl Browser {
    /// Whether it covers the window.
    pub(in super::super) fn is_open(&self) -> bool {
        self.open
    }

    /// Opens or closes it.
    pub(super) fn toggle(&mut self, session: &mut Session) {
        if self.open {
            self.open = false;
        } else {
            self.open(session);
        }
    }

    fn open(&mut self, session: &mut Session) {
        session.library.look();
        self.open = true;
        self.fresh = true;
        self.seek = true;
        self.shown = None;
        self.form = None;
        self.message = None;
    }

    fn begin(&mut self, form: Form, session: &mut Session) {
        self.open(session);
        self.fresh = false;
        self.form = Some(form);
    }

    /// Opens it to save what is heard.
    pub(super) fn begin_saving(&mut self, session: &mut Session) {
        self.begin(Form::save(session.card()), session);
    }

    /// Opens it to take in a file.
    pub(super) fn begin_importing(&mut self, session: &mut Session) {
        self.begin(Form::import(), session);
    }

    /// Opens it to write what is heard to a file.
    pub(super) fn begin_exporting(&mut self, session: &mut Session) {
        let preset = session.capture(session.card());
        self.begin(Form::export(preset, &session.library), session);
    }

    /// What the bar's arrows go through: what is found, or all if that is nothing.
    pub(super) fn among(&self, session: &Session) -> Vec<Origin> {
        let found = self.found(session);
        if found.is_empty() {
            Self::default().found(session)
        } else {
            found
        }
    }

    /// What is found, in its order.
    pub(super) fn found(&self, session: &Session) -> Vec<Origin> {
        let entries = session.library.entries().iter();
        let found = entries.filter(|entry| self.search.finds(entry));
        found.map(|entry| entry.origin.clone()).collect()
    }

    /// Says what came of something.
    pub(super) fn say(&mut self, done: Result<String, Broken>) {
        self.message = Some(done.map_err(|broken| broken.to_string()));
    }

    /// Plays the preset that was chosen, if that is wanted and its instrument `ready`.
    pub(in super::super) fn play(&mut self, ui: &Ui, ready: bool, place: [f32; 2], link: &Link) {
        self.hearing.play(ui, ready, place, link);
    }

    /// Draws it over `area`, if it is open.
    pub(in super::super) fn show(
        &mut self,
        ui: &Ui,
        area: Rect,
        session: &mut Session,
        theme: &Theme,
        setter: &ParamSetter<'_>,
    ) {
        if !self.open {
            return;
        }
        self.keys(ui, session, setter);
        Area::new(Id::unique("preset browser"))
            .order(Order::Middle)
            .fixed_pos(area.min)
            .constrain(false)
            .fade_in(false)
            .show(ui.ctx(), |ui| {
                ui.set_clip_rect(area);
                // Nothing beneath hears of the pointer.
                ui.allocate_rect(area, Sense::click_and_drag());
                ui.painter().rect(
                    area,
                    CornerRadius::same(CORNER),
                    theme.panel,
                    Stroke::new(1.0, theme.line),
                    StrokeKind::Inside,
                );
                self.fill(ui, area.shrink(APART), session, theme, setter);
            });
    }

    /// Arrows go on to the next preset; Enter and Escape close.
    fn keys(&mut self, ui: &Ui, session: &mut Session, setter: &ParamSetter<'_>) {
        let pressed = |key| ui.input_mut(|input| input.consume_key(Modifiers::NONE, key));
        if pressed(Key::Escape) {
            match self.form {
                Some(_) => self.form = None,
                None => self.open = false,
            }
        }
        if self.form.is_some() {
            return;
        }
        for (key, way) in [(Key::ArrowUp, -1), (Key::ArrowDown, 1)] {
            if pressed(key) {
                let among = self.found(session);
                session.next(way, &among, setter);
                self.hearing.ask(ui.input(|input| input.time));
                self.shown = None;
                self.seek = true;
            }
        }
        if pressed(Key::Enter) {
            self.open = false;
        }
    }

    fn fill(
        &mut self,
        ui: &mut Ui,
        area: Rect,
        session: &mut Session,
        theme: &Theme,
        setter: &ParamSetter<'_>,
    ) {
        let wide = area.width() > 760.0;
        let (shelves, card) = if wide { (168.0, 286.0) } else { (124.0, 214.0) };
        let left = Rect::from_min_max(area.min, pos2(area.left() + shelves, area.bottom()));
        let right = Rect::from_min_max(pos2(area.right() - card, area.top()), area.max);
        let middle = Rect::from_min_max(
            pos2(left.right() + APART, area.top()),
            pos2(right.left() - APART, area.bottom()),
        );
        let body = |rect: Rect| Rect::from_min_max(rect.min + vec2(0.0, LINE + NEAR), rect.max);
        let head = |rect: Rect| Rect::from_min_size(rect.min, vec2(rect.width(), LINE - NEAR));
        ui.painter().text(
            head(left).left_center() + vec2(SIDE, 0.0),
            Align2::LEFT_CENTER,
            "Presets",
            super::super::theme::title(),
            theme.glow,
        );
        self.shelves(&mut part(ui, "shelves", body(left)), session, theme);
        let mut search = head(middle);
        search.max.x -= 30.0;
        self.find(ui, search, theme);
        self.ear(ui, head(middle), theme);
        self.list(&mut part(ui, "list", body(middle)), session, theme, setter);
        let close = Rect::from_min_size(pos2(right.right() - 26.0, right.top()), vec2(26.0, 26.0));
        if sign(ui, close, Icon::Close, "Close presets", true, theme).clicked() {
            self.open = false;
        }
        ui.painter().vline(
            right.left() - 0.5 * APART,
            right.y_range(),
            Stroke::new(1.0, theme.line),
        );
        let card = Rect::from_min_max(right.min + vec2(SIDE, 0.0), right.max);
        let told = self.tell(ui, card, theme);
        let card = Rect::from_min_max(card.min, pos2(card.right(), told));
        let mut ui = part(ui, "card", card);
        match self.form.take() {
            Some(mut form) => match form.show(&mut ui, session, theme) {
                Outcome::Open => self.form = Some(form),
                Outcome::Closed => {}
                Outcome::Done(done) => {
                    // What cannot be done so may be done otherwise.
                    if done.is_err() {
                        self.form = Some(form);
                    }
                    self.shown = None;
                    self.seek = true;
                    self.say(done);
                }
            },
            None => self.card(&mut ui, session, theme, setter),
        }
    }

    /// The button by which presets are heard as they are chosen.
    fn ear(&mut self, ui: &Ui, head: Rect, theme: &Theme) {
        let size = vec2(26.0, head.height());
        let rect = Rect::from_min_size(pos2(head.right() - size.x, head.top()), size);
        let response = sign(ui, rect, Icon::Hear, "Hear each preset", true, theme);
        if response.clicked() {
            self.hearing.on = !self.hearing.on;
        }
        if self.hearing.on {
            Icon::Hear.paint(ui.painter(), rect, theme.glow);
        }
        response.on_hover_text("Strike C4 whenever a preset is chosen here");
    }

    /// The field to type words in.
    fn find(&mut self, ui: &mut Ui, rect: Rect, theme: &Theme) {
        let sign = Rect::from_min_size(rect.min, vec2(26.0, rect.height()));
        ui.painter().rect(
            rect,
            CornerRadius::same(5),
            theme.ground,
            Stroke::new(1.0, theme.line),
            StrokeKind::Inside,
        );
        Icon::Find.paint(ui.painter(), sign, theme.quiet);
        let field = Rect::from_min_max(
            pos2(sign.right(), rect.top() + 6.0),
            rect.max - vec2(NEAR, 0.0),
        );
        let edit = TextEdit::singleline(&mut self.search.text)
            .id(Id::unique("preset search"))
            .font(body())
            .frame(egui::Frame::NONE)
            .hint_text("Search names, tags, authors")
            .desired_width(field.width());
        let response = ui.put(field, edit).accessible_name("Search presets");
        if self.fresh {
            self.fresh = false;
            response.request_focus();
        }
    }

    /// What was last done, at the bottom; where it begins.
    fn tell(&self, ui: &Ui, area: Rect, theme: &Theme) -> f32 {
        let Some(message) = &self.message else {
            return area.bottom();
        };
        let (text, ink) = match message {
            Ok(text) => (text, theme.quiet),
            Err(text) => (text, theme.alarm),
        };
        let text = ui
            .painter()
            .layout(text.clone(), small(), ink, area.width());
        let top = area.bottom() - text.size().y;
        ui.painter().galley(pos2(area.left(), top), text, ink);
        top - SIDE
    }
}

/// A part of the browser with its own layout.
fn part(ui: &mut Ui, name: &str, rect: Rect) -> Ui {
    let mut inner = ui.new_child(UiBuilder::new().id_salt(name).max_rect(rect));
    inner.set_clip_rect(rect.intersect(ui.clip_rect()));
    inner
}
