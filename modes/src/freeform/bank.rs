//! From a mesh to an instrument: one body, heard from the listener's place, spread over keys.

use super::body::{FreeBody, free_body};
use super::solve::Limits;
use crate::factory::{ears_m, sounding};
use crate::mesh::Mesh;
use crate::solve::Watch;
use crate::{
    Bank, Body, CODE, FreeRecipe, Provenance, SolveError, Spread, SpreadRule, TunedMode, Zone,
    equal_temperament_hz,
};
use std::sync::Arc;

/// Why a mesh gave no bank.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum FreeError {
    /// Its modes cannot be found.
    #[error("the mesh cannot be solved: {0}")]
    Solve(#[from] SolveError),
    /// It has no mode that people hear.
    #[error(
        "the body has no mode below {highest_hz:.0} Hz; make it larger, thinner or of a softer \
         material"
    )]
    Silent {
        /// Highest frequency looked for, in Hz.
        highest_hz: f64,
    },
    /// The mode to tune is not there.
    #[error("mode {number} is to be tuned, but {found} were found; choose a lower one")]
    NoSuchMode {
        /// The number asked for, from 1.
        number: u32,
        /// Modes found.
        found: usize,
    },
}

/// The bank of a body of any shape: one body, and how it is given to keys.
///
/// The body is solved as it is; modes are found as high as the lowest key needs them.
///
/// # Errors
///
/// [`FreeError`], with [`SolveError::Cancelled`] in it when `watch` says so.
pub fn free_bank(recipe: &FreeRecipe, mesh: &Mesh, watch: &dyn Watch) -> Result<Bank, FreeError> {
    let free = free_body(mesh, &recipe.material, limits(recipe), watch)?;
    let residuals = free.solved.modes.iter().map(|mode| mode.residual);
    let provenance = Provenance {
        recipe: recipe.text.clone(),
        code: CODE.to_owned(),
        mesh: format!(
            "10-node tetrahedra, curved: {} elements, {} nodes",
            free.elements, free.nodes
        ),
        solver: "shift-invert block Lanczos, inertia counts".into(),
        tolerance_cents: 0.0,
        max_residual: residuals.fold(0.0, f64::max),
        max_orthonormality_error: free.solved.orthonormality,
    };
    let (body, tuned) = tuned_body(recipe, free)?;
    Ok(Bank {
        name: recipe.name.clone(),
        title: recipe.title.clone(),
        material: recipe.material,
        damping: recipe.damping,
        ears_m: ears_m(&recipe.listener),
        provenance,
        spread: Some(Spread {
            rule: recipe.tuning.rule,
            a4_hz: recipe.tuning.a4_hz,
            zones: vec![Zone {
                low: recipe.keys.low,
                high: recipe.keys.high,
                tuned,
                rule: None,
            }],
        }),
        bodies: vec![body],
    })
}

/// Up to where the modes of the body as it is are heard on its lowest key.
fn limits(recipe: &FreeRecipe) -> Limits {
    let (tuning, fineness) = (&recipe.tuning, &recipe.fineness);
    let number = match tuning.mode {
        TunedMode::Number(number) => (number as usize).clamp(1, fineness.most_modes),
        TunedMode::Lowest | TunedMode::Loudest => 1,
    };
    let pitch_hz = equal_temperament_hz(recipe.keys.low, tuning.a4_hz);
    Limits {
        highest_hz: fineness.highest_hz,
        most: fineness.most_modes,
        tuned: (tuning.rule != SpreadRule::Fixed).then_some((number, pitch_hz)),
    }
}

/// The body at the key nearest to its own pitch, and which of its modes carries that, from 0.
fn tuned_body(recipe: &FreeRecipe, free: FreeBody) -> Result<(Body, u32), FreeError> {
    let found = free.solved.modes.len();
    if found == 0 {
        return Err(FreeError::Silent {
            highest_hz: recipe.fineness.highest_hz,
        });
    }
    let (keys, tuning) = (recipe.keys, &recipe.tuning);
    // The row has but this body, in the middle.
    let middle = 0.5;
    let mut body = sounding(
        free.solved,
        (keys.low, 1.0),
        middle,
        &recipe.listener,
        &recipe.losses,
        None,
    );
    let tuned = match tuning.mode {
        TunedMode::Lowest => 0,
        TunedMode::Loudest => loudest(&body),
        TunedMode::Number(number) if (1..=found).contains(&(number as usize)) => number - 1,
        TunedMode::Number(number) => return Err(FreeError::NoSuchMode { number, found }),
    };
    let own_hz = body.modes[tuned as usize].hz;
    let cents = |key: &u8| {
        (own_hz / equal_temperament_hz(*key, tuning.a4_hz))
            .log2()
            .abs()
    };
    let nearest = keys.iter().min_by(|p, q| cents(p).total_cmp(&cents(q)));
    body.key = nearest.unwrap_or(keys.low);
    body.pitch_hz = own_hz;
    body.surface = Some(Arc::new(free.surface));
    Ok((body, tuned))
}

/// Which mode, counted from 0, has the most pressure at the ears for an impulse where it moves most.
fn loudest(body: &Body) -> u32 {
    let level = |mode: &crate::Mode| {
        let spots = mode.shape.iter().zip(&body.line.normals);
        let reach = spots.map(|(u, n)| (0..3).map(|a| f64::from(u[a]) * n[a]).sum::<f64>().abs());
        let ears = mode
            .ears
            .iter()
            .map(|[re, im]| f64::from(*re).hypot(f64::from(*im)));
        reach.fold(0.0, f64::max) * ears.fold(0.0, f64::max) / mode.hz
    };
    let levels = (0u32..).zip(body.modes.iter().map(level));
    let best = levels.max_by(|(_, p), (_, q)| p.total_cmp(q));
    best.map_or(0, |(mode, _)| mode)
}
