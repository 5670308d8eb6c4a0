//! The map of timbre: how different a blow at each point of the body sounds from one where notes strike it.

use super::super::kind::is_thread;
use super::super::ramp::Ramp;
use super::super::solid::Solid;
use super::super::theme::Theme;
use super::portrait::Laid;
use egui::Color32;
use modes::sound_map::{BodyMap, Hearing};
use modes::{Body, Stencil};
use std::collections::HashMap;

/// By how many dB a partial differs on average where the ramp ends.
pub(super) const FARTHEST_DB: f32 = 20.0;
/// Steps along and across the strike grid between which places are not told apart.
const STEPS: [f32; 2] = [256.0, 64.0];
/// Triangles that a surface is cut into at most, so that the map is not as coarse as the shape can be.
pub(super) const FINE: usize = 20_000;
/// How far beyond a thread's sides its map is drawn, in points.
const BEYOND: f32 = 2.5;

/// The map on one body.
pub(super) struct Timbre {
    map: BodyMap,
    /// Which of the map's places each point of the surface is struck as.
    places: Vec<u32>,
    beyond: f32,
    seen: Option<Seen>,
}

/// The map as it looks from one place.
struct Seen {
    from: [f32; 2],
    dark: bool,
    colours: Vec<Color32>,
}

impl Timbre {
    /// That of a body with this surface, if its strike grid is one.
    pub(super) fn of(solid: &Solid, body: &Body) -> Option<Self> {
        if body.line.grid().columns < Stencil::POINTS {
            return None;
        }
        let mut known: HashMap<[i16; 2], u32> = HashMap::new();
        let mut distinct: Vec<[f64; 2]> = Vec::new();
        let places = solid.places_struck().into_iter().map(|place| {
            let step = [0, 1].map(|k| (STEPS[k] * place[k]).round());
            *known.entry(step.map(|x| x as i16)).or_insert_with(|| {
                distinct.push([0, 1].map(|k| f64::from(step[k] / STEPS[k])));
                distinct.len() as u32 - 1
            })
        });
        Some(Self {
            places: places.collect(),
            map: BodyMap::new(&Hearing::HUMAN, body, &distinct),
            beyond: if is_thread(body) { BEYOND } else { 0.0 },
            seen: None,
        })
    }

    /// The map as it looks `from` a place along and across.
    pub(super) fn laid(&mut self, from: [f32; 2], theme: &Theme) -> Laid<'_> {
        let known = self.seen.take();
        let seen = known.filter(|seen| seen.from == from && seen.dark == theme.dark);
        let seen = seen.unwrap_or_else(|| self.look(from, theme));
        Laid {
            colours: &self.seen.insert(seen).colours,
            beyond: self.beyond,
        }
    }

    fn look(&self, from: [f32; 2], theme: &Theme) -> Seen {
        let ramp = Ramp::of(theme);
        let scale = 1.0 / (self.map.unit().max(f32::MIN_POSITIVE) * FARTHEST_DB);
        let distances_db = self.map.from_place_db(from.map(f64::from));
        let colours: Vec<Color32> = (distances_db.iter())
            .map(|distance_db| ramp.colour(scale * distance_db))
            .collect();
        Seen {
            from,
            dark: theme.dark,
            colours: (self.places.iter())
                .map(|place| colours[*place as usize])
                .collect(),
        }
    }

    /// By how many dB a partial differs on average between blows at two places.
    pub(super) fn apart_db(&self, one: [f32; 2], other: [f32; 2]) -> f32 {
        let [one, other] = [one, other].map(|place| place.map(f64::from));
        self.map.distance_db(one, other) / self.map.unit().max(f32::MIN_POSITIVE)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::factory;

    /// On a square drum all eight places that its symmetries exchange have the colour of the place struck.
    #[test]
    fn the_map_is_lightest_where_notes_strike_and_wherever_that_is_heard() {
        let index = factory::BANKS
            .iter()
            .position(|(name, _)| *name == "square-drums");
        let bank = factory::bank(index.unwrap());
        let body = &bank.bodies[12];
        let solid = Solid::of(body, &bank.material);
        let mut timbre = Timbre::of(&solid, body).unwrap();
        let ramp = Ramp::of(&Theme::DARK);
        // A point of the surface away from the middle and from the diagonals.
        let half_m = 0.5 * body.length_m as f32;
        let away = |p: &[f32; 3]| p[0] > 0.2 * half_m && p[1] > 2.0 * p[0] && p[1] < 0.8 * half_m;
        let number = solid.points_m.iter().position(away).unwrap();
        let at = solid.points_m[number];
        let from = solid.places_struck()[number];
        let from = [0, 1].map(|k| (STEPS[k] * from[k]).round() / STEPS[k]);
        let laid = timbre.laid(from, &Theme::DARK);
        assert_eq!(laid.colours[number], ramp.colour(0.0));
        let mut twins = 0;
        for (point, colour) in solid.points_m.iter().zip(laid.colours) {
            let [mut x, mut y] = [point[0].abs(), point[1].abs()];
            if x > y {
                (x, y) = (y, x);
            }
            if (x - at[0]).abs() + (y - at[1]).abs() < 1e-4 {
                twins += 1;
                let red = i32::from(colour.r()) - i32::from(ramp.colour(0.0).r());
                assert!(red.abs() < 40, "{point:?} {colour:?}");
            }
        }
        assert!(twins >= 8, "{twins}");
        assert!(
            laid.colours
                .iter()
                .any(|colour| *colour == ramp.colour(1.0))
        );
    }
}
