//! Bodies of closed form: one is computed for the lowest key, and all keys have it at their size.

mod board;
mod body;
mod grid;
mod outline;
mod string;

use super::BuildError;
use super::body::band;
use super::sound::{self, Found, sounding};
use crate::analytic::{
    BarMode, CircularMembrane, ClampedPlate, ClosedMode, LMembrane, LSpectrum, RectangularMembrane,
    RigidBar,
};
use crate::bank::{Spread, SpreadRule, Surface, Zone};
use crate::shape::{BarEnds, ClosedShape};
use crate::{Bank, Recipe, SolvedBody, equal_temperament_hz};
use board::through_board;
use body::{Air, Flat};
use grid::Grid;
use outline::Outline;
use std::f64::consts::{PI, SQRT_2};
use std::sync::Arc;

/// Cells of a picture along and across: fine enough for the waves that are seen.
const DRAWN: [usize; 2] = [32, 24];

/// Strikes on a bar that is held start at this share of its length, on a string near the bridge.
const BAR_STRUCK: f64 = 0.3;

/// Most modes of a body: what grids of strike points may weigh.
const MOST_MODES: usize = 70;

/// The bank of `recipe`, whose shape is `shape`.
pub(super) fn bank(recipe: &Recipe, shape: &ClosedShape) -> Result<Bank, BuildError> {
    let (solved, picture) = lowest(recipe, shape);
    let key = recipe.keys.low;
    let pitch_hz = equal_temperament_hz(key, recipe.tuning.a4_hz);
    let highest_hz = band(recipe).high_hz;
    let Some(own_hz) = solved.modes.first().map(|mode| mode.hz) else {
        return Err(BuildError::Silent {
            recipe: recipe.name.clone(),
        });
    };
    let solved = solved.scaled(own_hz / pitch_hz, highest_hz);
    let place = 0.5;
    let mut body = sounding(
        solved,
        (key, pitch_hz),
        place,
        &recipe.listener,
        &recipe.losses,
        None,
    );
    body.surface = Some(Arc::new(picture));
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
fn lowest(recipe: &Recipe, shape: &ClosedShape) -> (SolvedBody, Surface) {
    let material = &recipe.material;
    let density = material.density_kg_m3;
    // In frequencies of the lowest mode.
    let pitch_hz = equal_temperament_hz(recipe.keys.low, recipe.tuning.a4_hz);
    let reach = band(recipe).high_hz / pitch_hz;
    let longest_m = recipe.mesh.max_element_m;
    match *shape {
        ClosedShape::String { .. } => string::string(recipe, shape, reach),
        ClosedShape::Bar {
            length_m,
            thickness_m,
            width_m,
            ends,
            board_s_kg,
        } => {
            let section = [length_m, thickness_m, width_m];
            let bar = RigidBar::from_rectangle(section, density, material.young_pa(), ends);
            let modes = bar.modes(reach * bar.hz(1));
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
            (body, flat.picture(&modes))
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
            let modes = most(membrane.modes(reach * membrane.hz([1, 1])));
            let half_waves = [0, 1].map(|axis| {
                let all = modes.iter().map(|mode| mode.half_waves()[axis]);
                f64::from(all.max().unwrap_or(1))
            });
            let grid = grid::film(half_waves);
            film(
                Outline::Rectangle { sides_m },
                membrane.mass_kg(),
                grid,
                longest_m,
                &modes,
            )
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
            let first_hz = membrane.hz(crate::analytic::bessel_zeros(0, PI)[0]);
            let modes = most(membrane.modes(reach * first_hz));
            let highest = modes
                .last()
                .map_or(1.0, |mode| mode.hz() / membrane.hz(1.0));
            let outline = Outline::Disc { radius_m };
            film(
                outline,
                membrane.mass_kg(),
                grid::disc(highest, orders(&modes)),
                longest_m,
                &modes,
            )
        }
        ClosedShape::CircularPlate {
            radius_m,
            thickness_m,
        } => {
            let plate = ClampedPlate::of(material, radius_m, thickness_m);
            let first_hz = plate.hz(crate::analytic::clamped_plate_roots(0, 4.0)[0]);
            let modes = most(plate.modes(reach * first_hz));
            let highest = modes
                .last()
                .map_or(1.0, |mode| (mode.hz() / plate.hz(1.0)).sqrt());
            let outline = Outline::Disc { radius_m };
            film(
                outline,
                plate.mass_kg(),
                grid::disc(highest, orders(&modes)),
                longest_m,
                &modes,
            )
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
            let spectrum = LSpectrum::new((reach * lowest).min(L_HIGHEST));
            let modes = membrane.modes(&spectrum, f64::INFINITY);
            let highest = spectrum.roots().last().copied().unwrap_or(lowest);
            // Along the outer edge, and across on the diagonal.
            let half_waves = [4.0 * highest / PI, SQRT_2 * highest / PI];
            let outline = Outline::Ell { square_m };
            film(
                outline,
                membrane.mass_kg(),
                grid::film(half_waves),
                longest_m,
                &modes,
            )
        }
    }
}

/// Highest wave number to which the modes of an L are computed: 53 modes.
const L_HIGHEST: f64 = 16.2;

/// The lowest modes.
fn most<M>(mut modes: Vec<M>) -> Vec<M> {
    modes.truncate(MOST_MODES);
    modes
}

/// Most nodal diameters.
fn orders<M: ClosedMode>(modes: &[M]) -> u16 {
    let orders = modes.iter().map(|mode| mode.label().order);
    orders.max().unwrap_or(0)
}

fn film<M: ClosedMode + Sync>(
    outline: Outline,
    mass_kg: f64,
    grid: Grid,
    longest_m: f64,
    modes: &[M],
) -> (SolvedBody, Surface) {
    let flat = Flat {
        outline,
        mass_kg,
        felt_m: grid.points_m(outline)[0],
        grid,
        air: Air::Wall,
        cells: outline.cells(longest_m),
        drawn: DRAWN,
    };
    (flat.solved(modes), flat.picture(modes))
}

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
