//! The board under what holds a body.

use crate::SolvedBody;
use crate::radiation::{AIR_KG_M3, SOUND_M_S, Surface};
use std::f64::consts::TAU;

/// Lets `body` be heard through a board that gives way by a velocity of `board_s_kg` for 1 N and sends
/// all that it takes into the air; `forces_n` are those of unit displacements of the modes on it.
///
/// The board counts as a piston of such a size that the air's ρc is all of its resistance.
pub(super) fn through_board(
    body: &mut SolvedBody,
    board_s_kg: f64,
    forces_n: impl Iterator<Item = f64>,
) {
    body.surface = Surface {
        points_m: vec![[0.0; 3]],
        normals: vec![[0.0, 0.0, 1.0]],
        areas_m2: vec![1.0 / (AIR_KG_M3 * SOUND_M_S * board_s_kg)],
        mouth_m: None,
    };
    for (mode, force_n) in body.modes.iter_mut().zip(forces_n) {
        let push = force_n / (TAU * mode.hz);
        mode.motion = vec![(board_s_kg * push) as f32];
        mode.rectified_area = body.surface.rectified_area(&mode.motion);
        // Half the force times the velocity, over ω².
        mode.radiation_per_s = 0.5 * board_s_kg * push * push;
    }
}
