//! The body in three dimensions: turned, struck and seen to move.

mod camera;
mod hands;
mod marks;
mod nodal;
mod picture;
mod portrait;
mod shade;
mod sway;

pub use portrait::{Paint, Portrait, Swinging};

use super::caption::{CAPTION, Told, caption, place};
use super::figure::tint;
use super::frame::Frame;
use super::hold::Hold;
use super::kind::Kind;
use super::link::Link;
use super::param::Param;
use super::shown::Shown;
use super::solid::{Place, Solid, Vector};
use super::theme::{Cause, NEAR, Theme};
use crate::key_name::key_name;
use crate::shelf::Shelved;
use camera::Camera;
use egui::{CursorIcon, Id, Rect, Role, Sense, Shape, Ui, WidgetInfo, pos2, vec2};
use marks::{Mark, controls, mark};
use nice_plug::prelude::ParamSetter;

/// Density in kg/m³ from which a material shines as metals do.
const SHINES: f64 = 2600.0;
/// Height of what lies below the body.
const CONTROLS: f32 = 14.0;

/// Right, up and towards the eye, as a body of that kind is looked at at first.
pub(super) fn first_axes(kind: Kind) -> [Vector; 3] {
    Camera::on(kind).axes()
}

/// What the panel remembers.
pub(super) struct View {
    /// The body, and its surface.
    solid: Option<(Seen, Solid)>,
    portrait: Portrait,
    /// How far the picture exaggerates, 1 for well to be seen, 0 for not at all.
    motion: f32,
    press: Press,
    /// Where it was clicked last, and as which place.
    clicked: Option<(Vector, Place)>,
}

/// Whose body it is, and its key.
struct Seen {
    instrument: usize,
    bank: Shelved,
    key: u8,
}

/// What the button that is held down does.
#[derive(Clone, Copy, PartialEq)]
enum Press {
    Nothing,
    Turns,
    Struck(u8),
}

/// What the panel needs of its surroundings.
pub(super) struct Sight<'a, 'b> {
    pub(super) instrument: usize,
    pub(super) frame: &'a Frame,
    pub(super) told: Told<'a>,
    /// The partial that is shown alone, if one is.
    pub(super) alone: Option<usize>,
    pub(super) link: &'a Link,
    pub(super) theme: &'a Theme,
    /// How hard clicks strike, 0…1.
    pub(super) velocity: f32,
    pub(super) position: Option<&'a Param>,
    /// The place across.
    pub(super) across: Option<&'a Param>,
    pub(super) setter: &'a ParamSetter<'b>,
}

impl Sight<'_, '_> {
    fn shown(&self) -> &Shown {
        self.told.shown
    }

    /// Where across notes strike, 0…1.
    fn set_across(&self) -> f32 {
        self.across.map_or(0.0, |param| param.plain() / 100.0)
    }
}

impl Default for View {
    fn default() -> Self {
        Self {
            solid: None,
            portrait: Portrait::default(),
            motion: 1.0,
            press: Press::Nothing,
            clicked: None,
        }
    }
}

impl View {
    /// Draws the body in `area` and plays it; what the pointer is on, in words.
    pub(super) fn show(
        &mut self,
        ui: &mut Ui,
        area: Rect,
        sight: &Sight<'_, '_>,
        hold: &mut Hold,
    ) -> Option<String> {
        let (seen, solid) = self.follow(sight)?;
        let key = seen.key;
        let top_left = pos2(area.left(), area.top() + CAPTION);
        let stage = Rect::from_min_max(top_left, area.max - vec2(0.0, CONTROLS));
        let response = ui.interact(area, Id::unique("body"), Sense::click_and_drag());
        let name = format!("Body {}", key_name(key));
        response.widget_info(|| WidgetInfo::labeled(Role::Button, true, &name));
        self.paint(ui, stage, &solid, sight);
        let hovered = response.hover_pos().filter(|at| stage.contains(*at));
        let on = hovered.and_then(|at| self.portrait.struck_at(&solid, at));
        self.hands(ui, &response, (key, &solid), sight, hold);
        self.mark(ui, &solid, sight, on);
        caption(ui, area, solid.kind, &sight.told, sight.theme);
        controls(ui, area, &mut self.motion, solid.thicker, sight);
        let cursor = match (self.press, on) {
            (Press::Turns, _) => CursorIcon::Grabbing,
            (_, Some(_)) => CursorIcon::PointingHand,
            _ => CursorIcon::Grab,
        };
        response.on_hover_and_drag_cursor(cursor);
        let kind = solid.kind;
        self.solid = Some((seen, solid));
        hovered.map(|_| match on {
            Some((_, at)) => format!("A click strikes here, {}", place(kind, at.along)),
            None => "Drag to turn the body, wheel to come nearer; a double click looks as at first"
                .to_owned(),
        })
    }

    /// The surface of the body that is shown; taken out, to be put back.
    fn follow(&mut self, sight: &Sight<'_, '_>) -> Option<(Seen, Solid)> {
        let seen = Seen {
            instrument: sight.instrument,
            bank: sight.shown().bank.clone(),
            key: sight.shown().key,
        };
        let known = self.solid.take();
        let instrument = known.as_ref().map(|(old, _)| old.instrument);
        if let Some((old, solid)) = known
            && instrument == Some(seen.instrument)
            && old.key == seen.key
            && old.bank.is(&seen.bank)
        {
            return Some((seen, solid));
        }
        let bank = &seen.bank;
        let body = bank.bodies.iter().find(|body| body.key == seen.key)?;
        let solid = Solid::of(body, &bank.material);
        let other = instrument != Some(seen.instrument);
        self.portrait.turn_to(&solid, other);
        self.clicked = None;
        Some((seen, solid))
    }

    fn paint(&mut self, ui: &Ui, area: Rect, solid: &Solid, sight: &Sight<'_, '_>) {
        let theme = sight.theme;
        let material = &sight.shown().bank.material;
        let hz: Vec<f64> = sight.shown().partials.iter().map(|p| p.hz).collect();
        let ours = sight
            .frame
            .struck
            .is_some_and(|struck| struck.key == sight.shown().key);
        let swinging = Swinging {
            hz: &hz,
            swings: if ours { &sight.frame.swings } else { &[] },
            alone: sight.alone,
            times: self.motion,
        };
        let passed_s = ui.input(|input| input.stable_dt).min(0.1);
        if self.portrait.swing(solid, area, &swinging, passed_s) {
            ui.ctx().request_repaint();
        }
        let inwards = match sight.alone {
            Some(_) => theme.cause(Cause::Radiation),
            None => theme.glow,
        };
        let paint = Paint {
            own: Theme::mix(
                tint(material, false),
                theme.panel,
                if theme.dark { 0.08 } else { 0.0 },
            ),
            moving: [theme.glow, inwards],
            ink: theme.text,
            metal: material.density_kg_m3 > SHINES,
            pixel: 1.0 / ui.ctx().pixels_per_point(),
        };
        let mesh = self.portrait.mesh(solid, &swinging, &paint);
        ui.painter()
            .with_clip_rect(area.expand(NEAR))
            .add(Shape::mesh(mesh));
    }

    /// Marks where the body was struck last, where notes strike it, and where a click would.
    fn mark(&self, ui: &Ui, solid: &Solid, sight: &Sight<'_, '_>, on: Option<(Vector, Place)>) {
        let Some(lens) = &self.portrait.lens else {
            return;
        };
        let struck = sight
            .frame
            .struck
            .filter(|struck| struck.key == sight.shown().key);
        let set = sight.position.map_or(0.0, |param| param.plain() / 100.0);
        let (at, normal) = solid.at([set, sight.set_across()]);
        mark(ui, lens, at, Some(normal), Mark::Set, sight.theme);
        if let Some(struck) = struck {
            let [along, across] = [struck.position, struck.across].map(|x| x as f32);
            let clicked = self.clicked.filter(|(_, place)| {
                let aside = place.across.map_or(0.0, |clicked| clicked - across);
                (place.along - along).abs().max(aside.abs()) < 0.005
            });
            let (at, normal) = match clicked {
                Some((at, _)) => (at, None),
                None => {
                    let (at, normal) = solid.at([along, across]);
                    (at, Some(normal))
                }
            };
            mark(ui, lens, at, normal, Mark::Struck, sight.theme);
        }
        if let Some((at, _)) = on {
            mark(ui, lens, at, None, Mark::Pointed, sight.theme);
        }
    }
}
