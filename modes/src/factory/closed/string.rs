//! Strings, heard through the board under their bridge.

use super::DRAWN;
use super::board::through_board;
use super::body::{Air, Flat};
use super::grid;
use super::outline::Outline;
use crate::analytic::{StringMode, TautString};
use crate::bank::Surface as Picture;
use crate::shape::ClosedShape;
use crate::{Recipe, SolvedBody};

/// Where a string is struck, as a share of its length from the bridge: an eighth, as in a piano.
const STRUCK: f64 = 0.125;

/// The string as drawn, with modes up to `reach` times its lowest.
///
/// # Panics
///
/// If `shape` is no string.
pub(super) fn string(recipe: &Recipe, shape: &ClosedShape, reach: f64) -> (SolvedBody, Picture) {
    let ClosedShape::String {
        length_m,
        radius_m,
        tension_n,
        board_s_kg,
    } = *shape
    else {
        unreachable!("the caller has found a string")
    };
    let material = &recipe.material;
    let string = TautString::from_wire(
        [length_m, radius_m],
        material.density_kg_m3,
        material.young_pa(),
        tension_n,
    );
    let modes = string.modes(reach * string.hz(1));
    let width_m = 2.0 * radius_m;
    let outline = Outline::Strip { length_m, width_m };
    let flat = Flat {
        outline,
        mass_kg: string.mass_kg(),
        grid: grid::single(modes.len() as f64, STRUCK, true),
        air: Air::Open {
            width_m,
            thickness_m: width_m,
        },
        felt_m: [STRUCK * length_m, 0.0],
        cells: outline.cells(recipe.mesh.max_element_m),
        drawn: [4 * DRAWN[0], 1],
    };
    let mut body = flat.solved(&modes);
    let forces_n = modes.iter().map(StringMode::end_force_n);
    through_board(&mut body, board_s_kg, forces_n);
    (body, flat.picture(&modes))
}
