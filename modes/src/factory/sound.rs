//! From solved bodies to those that are heard, in a bank: ears, and what takes each mode's energy.

use crate::bank::Spread;
use crate::radiation::{Listener, Pipe, Transfers, coupling};
use crate::{
    Bank, Body, CODE, ListenerRecipe, LossRecipe, Mode, Provenance, Recipe, ResonatorRecipe,
    SolvedBody,
};
use rayon::prelude::*;

/// Distance between the ears, in m (O'Brien, Cook & Essl 2001, §4).
const BETWEEN_EARS_M: f64 = 0.2;

/// The listener's ears in the frame of the row, in m: x along it, y away from the player, z up.
#[must_use]
pub(crate) fn ears_m(recipe: &ListenerRecipe) -> [[f64; 3]; 2] {
    [-0.5, 0.5].map(|side| [side * BETWEEN_EARS_M, -recipe.distance_m, recipe.above_m])
}

/// How the bodies of a bank were found.
pub(super) struct Found {
    /// Mesh and element in words.
    pub(super) mesh: String,
    /// The method in words.
    pub(super) solver: &'static str,
    /// Largest relative residual of all modes.
    pub(super) residual: f64,
    /// Largest departure of all bodies from mass-orthonormality.
    pub(super) orthonormality: f64,
}

/// The bank of a recipe's bodies.
pub(super) fn bank(
    recipe: &Recipe,
    found: Found,
    bodies: Vec<Body>,
    spread: Option<Spread>,
) -> Bank {
    Bank {
        name: recipe.name.clone(),
        title: recipe.title.clone(),
        material: recipe.material,
        damping: recipe.damping,
        ears_m: ears_m(&recipe.listener),
        provenance: Provenance {
            recipe: recipe.text.clone(),
            code: CODE.to_owned(),
            mesh: found.mesh,
            solver: found.solver.to_owned(),
            tolerance_cents: recipe.tuning.tolerance_cents,
            max_residual: found.residual,
            max_orthonormality_error: found.orthonormality,
        },
        bodies,
        spread,
    }
}

/// The body of `key` as the listener hears it from its `place` in the row, 0 leftmost to 1.
pub(crate) fn sounding(
    solved: SolvedBody,
    (key, pitch_hz): (u8, f64),
    place: f64,
    recipe: &ListenerRecipe,
    losses: &LossRecipe,
    resonator: Option<ResonatorRecipe>,
) -> Body {
    let x_m = recipe.row_m * (place - 0.5);
    let listener = Listener {
        ears_m: ears_m(recipe).map(|[x, y, z]| [x - x_m, y, z]),
    };
    let transfers = Transfers::new(&solved.surface, &listener);
    let pipe = resonator.map(|recipe| Pipe {
        hz: pitch_hz,
        radius_m: recipe.radius_m,
        layer_m: recipe.layer_m,
    });
    let modes = solved
        .modes
        .into_par_iter()
        .map(|mode| {
            let rise = mode.shape.first().map_or(0.0, |u| f64::from(u[2]));
            let (pipe_ears, pipe_per_s) = pipe.map_or(([[0.0; 2]; 2], 0.0), |pipe| {
                let (flow, rate) = pipe.response(mode.hz, rise);
                (pipe.ears(mode.hz, flow, transfers.distances_m()), rate)
            });
            Mode {
                hz: mode.hz,
                coupling: coupling(mode.rectified_area, mode.hz),
                ears: transfers.ears(mode.hz, &mode.motion, mode.radiation_per_s),
                pipe_ears,
                radiation_per_s: mode.radiation_per_s as f32,
                // A resistance R takes R|φ|²/2 of a mode's amplitude per second.
                support_per_s: (0.5 * losses.support_kg_s * mode.held) as f32,
                felt_per_s: (0.5 * losses.felt_kg_s * mode.felt) as f32,
                pipe_per_s: pipe_per_s as f32,
                residual: mode.residual,
                label: mode.label,
                shape: mode.shape.into(),
            }
        })
        .collect();
    Body {
        key,
        pitch_hz,
        length_m: solved.length_m,
        mass_kg: solved.mass_kg,
        matter: None,
        line: solved.line,
        surface: None,
        modes,
    }
}
