//! The body in three dimensions: turned, struck and seen to move.

mod camera;
mod hands;
mod legend;
mod marks;
mod nodal;
mod picture;
mod portrait;
mod shade;
mod sway;
mod timbre;

pub use portrait::{Laid, Paint, Portrait, Swinging};

use super::caption::{CAPTION, Told, caption, place};
use super::figure::tint;
use super::frame::Frame;
use super::hold::Hold;
use super::kind::Kind;
use super::link::Link;
use super::param::Param;
use super::saved::Saved;
use super::shown::Shown;
use super::solid::{Place, Solid, Vector};
use super::theme::{Cause, NEAR, Theme};
use crate::key_name::key_name;
use crate::shelf::Shelved;
use camera::Camera;
use egui::{CursorIcon, Id, Rect, Role, Sense, Shape, Ui, WidgetInfo, pos2, vec2};
use legend::{LEGEND, legend, switch};
use marks::{Mark, controls, mark};
use nice_plug::prelude::ParamSetter;
use timbre::{FINE, Timbre};

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
    /// The map of timbre on it, once it has been asked for.
    timbre: Option<Timbre>,
    /// How far the picture exaggerates, 1 for well to be seen, 0 for not at all.
    motion: f32,
    press: Press,
    /// Where it was clicked last, and as which place.
    clicked: Option<(Vector, Place)>,
}

/// Which surface is seen.
struct Seen {
    instrument: usize,
    bank: Shelved,
    key: u8,
    /// Whether it is fine enough for a map.
    fine: bool,
}

impl Seen {
    /// Whether both are of the same body, fine or not.
    fn is(&self, other: &Self) -> bool {
        let drawn = self.instrument == other.instrument && self.bank.is(&other.bank);
        drawn && self.key == other.key
    }
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
    /// Whether the map lies on the body.
    pub(super) saved: &'a Saved,
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

    /// Where notes strike, along and across.
    fn set_place(&self) -> [f32; 2] {
        let along = self.position.map_or(0.0, |param| param.plain() / 100.0);
        [along, self.set_across()]
    }
}

impl Default for View {
    fn default() -> Self {
        Self {
            solid: None,
            portrait: Portrait::default(),
            timbre: None,
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
        let above = Rect::from_min_max(area.min, area.max - vec2(0.0, CONTROLS));
        let low = if sight.saved.map() { LEGEND } else { 0.0 };
        let stage = Rect::from_min_max(top_left, above.max - vec2(0.0, low));
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
        let apart_db = on.and_then(|(_, place)| self.apart_db(place, sight));
        if sight.saved.map() {
            legend(ui, above, apart_db, sight.theme);
        }
        if switch(ui, area, sight.saved.map(), sight.theme) {
            sight.saved.set_map(!sight.saved.map());
            ui.ctx().request_repaint();
        }
        let cursor = match (self.press, on) {
            (Press::Turns, _) => CursorIcon::Grabbing,
            (_, Some(_)) => CursorIcon::PointingHand,
            _ => CursorIcon::Grab,
        };
        response.on_hover_and_drag_cursor(cursor);
        let kind = solid.kind;
        self.solid = Some((seen, solid));
        hovered.map(|_| match on {
            Some((_, at)) => {
                let here = place(kind, at.along);
                let apart = apart_db.map_or_else(String::new, |db| {
                    format!(
                        ": partials {db:.1} dB louder or softer than where notes strike, on average"
                    )
                });
                format!("A click strikes here, {here}{apart}")
            }
            None => "Drag to turn the body, wheel to come nearer; a double click looks as at first"
                .to_owned(),
        })
    }

    /// The surface of the body that is shown, fine enough for a map if one is to lie on it; taken out, to be put
    /// back.
    fn follow(&mut self, sight: &Sight<'_, '_>) -> Option<(Seen, Solid)> {
        let sought = Seen {
            instrument: sight.instrument,
            bank: sight.shown().bank.clone(),
            key: sight.shown().key,
            fine: sight.saved.map(),
        };
        let before = match self.solid.take() {
            Some((seen, solid)) if seen.is(&sought) && seen.fine == sought.fine => {
                return Some((sought, solid));
            }
            known => known.map(|(seen, _)| seen),
        };
        let bank = &sought.bank;
        let body = bank.bodies.iter().find(|body| body.key == sought.key)?;
        let mut solid = Solid::of(body, &bank.matter_of(body).material);
        if sought.fine {
            solid = solid.finer(FINE);
        }
        let before = before.as_ref();
        let other = before.is_none_or(|seen| seen.instrument != sought.instrument);
        self.portrait.turn_to(&solid, other);
        self.timbre = None;
        if before.is_none_or(|seen| !seen.is(&sought)) {
            self.clicked = None;
        }
        Some((sought, solid))
    }

    /// By how many dB a partial of a blow there differs, on average, from where notes strike; nothing without the
    /// map.
    fn apart_db(&self, place: Place, sight: &Sight<'_, '_>) -> Option<f32> {
        let timbre = self.timbre.as_ref().filter(|_| sight.saved.map())?;
        let from = sight.set_place();
        let across = place.across.unwrap_or(from[1]);
        Some(timbre.apart_db(from, [place.along, across]))
    }

    fn paint(&mut self, ui: &Ui, area: Rect, solid: &Solid, sight: &Sight<'_, '_>) {
        let theme = sight.theme;
        let material = &sight.shown().matter().material;
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
        let map = mapped(&mut self.timbre, solid, sight);
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
            map,
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
        let (at, normal) = solid.at(sight.set_place());
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

/// The map of timbre, if it is to lie on the body.
fn mapped<'a>(
    timbre: &'a mut Option<Timbre>,
    solid: &Solid,
    sight: &Sight<'_, '_>,
) -> Option<Laid<'a>> {
    if !sight.saved.map() {
        return None;
    }
    if timbre.is_none() {
        let Shown { bank, key, .. } = sight.shown();
        let body = bank.bodies.iter().find(|body| body.key == *key)?;
        *timbre = Timbre::of(solid, body);
    }
    let timbre = timbre.as_mut()?;
    Some(timbre.laid(sight.set_place(), sight.theme))
}
