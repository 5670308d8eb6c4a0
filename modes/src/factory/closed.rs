//! Bodies of closed form: one is computed for the lowest key, and all keys have it at their size.

mod board;
mod body;
mod films;
mod grid;
mod lowest;
mod outline;
mod sheet;
mod string;

use super::BuildError;
use super::body::band;
use super::sound::{self, Found, sounding};
use crate::analytic::{
    BarMode, CircularMembrane, ClampedPlate, LMembrane, LSpectrum, RectangularMembrane, RigidBar,
};
use crate::bank::{Enough, Spread, SpreadRule, Zone};
use crate::shape::{BarEnds, ClosedShape};
use crate::solve::Band;
use crate::{Bank, Recipe, equal_temperament_hz};
use board::through_board;
use body::{Air, Flat};
use grid::Grid;
use lowest::Lowest;
use outline::Outline;
use std::f64::consts::{PI, SQRT_2};

/// Cells of a picture along and across: fine enough for the waves that are seen.
const DRAWN: [usize; 2] = [32, 24];

/// Strikes on a bar that is held start at this share of its length, on a string near the bridge.
const BAR_STRUCK: f64 = 0.3;

/// The bank of `recipe`, whose shape is `shape`.
pub(super) fn bank(recipe: &Recipe, shape: &ClosedShape) -> Result<Bank, BuildError> {
    let lowest = lowest(recipe, shape);
    let key = recipe.keys.low;
    let pitch_hz = equal_temperament_hz(key, recipe.tuning.a4_hz);
    let Some(own_hz) = lowest.solved.modes.first().map(|mode| mode.hz) else {
        return Err(BuildError::Silent {
            recipe: recipe.name.clone(),
        });
    };
    let enough = recipe.mesh.fewest_modes.map(|modes| Enough {
        hz: band(recipe).high_hz,
        modes: modes.into(),
    });
    let highest_hz = match enough {
        Some(_) => Band::AUDIBLE.high_hz,
        None => band(recipe).high_hz,
    };
    let larger = own_hz / pitch_hz;
    let place = 0.5;
    let mut body = sounding(
        lowest.solved.scaled(larger, highest_hz),
        (key, pitch_hz),
        place,
        &recipe.listener,
        &recipe.losses,
        None,
    );
    lowest.complete(&mut body, larger);
    let found = Found {
        mesh: "none: closed form".to_owned(),
        solver: solver(shape),
        residual: 0.0,
        orthonormality: 0.0,
    };
    let spread = Spread {
        rule: SpreadRule::Size,
        a4_hz: recipe.tuning.a4_hz,
        zones: vec![Zone {
            low: key,
            high: recipe.keys.high,
            tuned: 0,
            rule: None,
        }],
        enough,
    };
    Ok(sound::bank(recipe, found, vec![body], Some(spread)))
}

fn solver(shape: &ClosedShape) -> &'static str {
    match shape {
        ClosedShape::LMembrane { .. } => "method of particular solutions",
        _ => "roots of the closed form",
    }
}

/// The body as drawn in the recipe, with modes as high as the lowest key's body has them, and its
/// picture.
fn lowest(recipe: &Recipe, shape: &ClosedShape) -> Lowest {
    let material = &recipe.material;
    let density = material.density_kg_m3;
    // In frequencies of the lowest mode.
    let pitch_hz = equal_temperament_hz(recipe.keys.low, recipe.tuning.a4_hz);
    let reach = Reach {
        wanted: band(recipe).high_hz / pitch_hz,
        heard: Band::AUDIBLE.high_hz / pitch_hz,
    };
    let longest_m = recipe.mesh.max_element_m;
    match *shape {
        ClosedShape::String { .. } => string::string(recipe, shape, reach.wanted).into(),
        ClosedShape::Bar {
            length_m,
            thickness_m,
            width_m,
            ends,
            board_s_kg,
        } => {
            let section = [length_m, thickness_m, width_m];
            let bar = RigidBar::from_rectangle(section, density, material.young_pa(), ends);
            let modes = bar.modes(reach.wanted * bar.hz(1));
            let outline = Outline::Strip { length_m, width_m };
            let half_waves = modes.len() as f64 + 1.0;
            let flat = Flat {
                outline,
                mass_kg: bar.mass_kg(),
                grid: bar_grid(ends, half_waves),
                air: Air::Open {
                    width_m,
                    thickness_m,
                },
                felt_m: [bar_felt(ends) * length_m, 0.0],
                cells: outline.cells(longest_m),
                drawn: [4 * DRAWN[0], 1],
            };
            let mut body = flat.solved(&modes);
            if let Some(board_s_kg) = board_s_kg {
                through_board(
                    &mut body,
                    board_s_kg,
                    modes.iter().map(BarMode::end_force_n),
                );
            }
            (body, flat.picture(&modes)).into()
        }
        ClosedShape::RectangularMembrane {
            sides_m,
            thickness_m,
            tension_n_m,
        } => {
            let membrane = RectangularMembrane {
                sides_m,
                tension_n_m,
                mass_kg_m2: density * thickness_m,
            };
            films::rectangle(&membrane, recipe, reach)
        }
        ClosedShape::CircularMembrane {
            radius_m,
            thickness_m,
            tension_n_m,
        } => {
            let membrane = CircularMembrane {
                radius_m,
                tension_n_m,
                mass_kg_m2: density * thickness_m,
            };
            films::drum(&membrane, recipe, reach)
        }
        ClosedShape::CircularPlate {
            radius_m,
            thickness_m,
        } => {
            let plate = ClampedPlate::of(material, radius_m, thickness_m);
            films::plate(&plate, recipe, reach)
        }
        ClosedShape::LMembrane {
            square_m,
            thickness_m,
            tension_n_m,
        } => {
            let membrane = LMembrane {
                square_m,
                tension_n_m,
                mass_kg_m2: density * thickness_m,
            };
            let lowest = LSpectrum::new(PI).roots()[0];
            let spectrum = LSpectrum::kept((reach.wanted * lowest).min(L_HIGHEST));
            let modes = membrane.modes(&spectrum, f64::INFINITY);
            let highest = spectrum.roots().last().copied().unwrap_or(lowest);
            // Along the outer edge, and across on the diagonal.
            let half_waves = [4.0 * highest / PI, SQRT_2 * highest / PI];
            let outline = Outline::Ell { square_m };
            let grid = grid::film(half_waves);
            let flat = Flat {
                outline,
                mass_kg: membrane.mass_kg(),
                felt_m: grid.points_m(outline)[0],
                grid,
                air: Air::Wall,
                cells: outline.cells(longest_m),
                drawn: DRAWN,
            };
            (flat.solved(&modes), flat.picture(&modes)).into()
        }
    }
}

/// How high the modes of the lowest key's body go, in frequencies of its lowest.
#[derive(Clone, Copy, Debug)]
struct Reach {
    /// As the recipe wants them.
    wanted: f64,
    /// As they are heard.
    heard: f64,
}

/// Highest wave number to which the modes of an L are computed: 53 modes.
const L_HIGHEST: f64 = 16.2;

/// Clamped bars are struck from 3/10 of their length on, free ones from the first end, cantilevers from
/// the free one.
fn bar_grid(ends: BarEnds, half_waves: f64) -> Grid {
    match ends {
        BarEnds::Clamped => grid::single(half_waves, BAR_STRUCK, true),
        BarEnds::Free => grid::single(half_waves, 0.0, false),
        BarEnds::Cantilever => grid::single(half_waves, 0.0, false).reversed(),
    }
}

/// Where the felt lies on a bar, as a share of its length.
fn bar_felt(ends: BarEnds) -> f64 {
    match ends {
        BarEnds::Clamped => BAR_STRUCK,
        BarEnds::Free => 0.05,
        BarEnds::Cantilever => 0.95,
    }
}

#[cfg(test)]
mod tests;
#[cfg(test)]
mod varied_tests;
