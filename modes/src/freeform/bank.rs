//! From meshes to an instrument: bodies, each heard from the listener's place and spread over its keys.

use super::body::{FreeBody, free_body};
use super::solve::Limits;
use crate::factory::{ears_m, sounding};
use crate::mesh::Mesh;
use crate::solve::Watch;
use crate::{
    Bank, Body, CODE, FreeRecipe, Matter, Piece, Provenance, SolveError, Spread, SpreadRule,
    TunedMode, Zone, equal_temperament_hz,
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

/// A piece of an instrument, solved.
#[derive(Clone, Debug, PartialEq)]
pub struct SolvedPiece {
    body: Body,
    zone: Zone,
    mesh: String,
    orthonormality: f64,
}

/// Solves the body of the recipe's piece of that number, counted from 0.
///
/// The body is solved as it is; modes are found as high as the lowest of its keys needs them. The row has
/// the bodies side by side, the lowest keys leftmost.
///
/// # Errors
///
/// [`FreeError`], with [`SolveError::Cancelled`] in it when `watch` says so.
///
/// # Panics
///
/// If the recipe has no such piece.
pub fn solved_piece(
    recipe: &FreeRecipe,
    number: usize,
    mesh: &Mesh,
    watch: &dyn Watch,
) -> Result<SolvedPiece, FreeError> {
    let piece = &recipe.pieces[number];
    let free = free_body(mesh, &piece.material, limits(recipe, piece), watch)?;
    let words = format!("{} elements, {} nodes", free.elements, free.nodes);
    let orthonormality = free.solved.orthonormality;
    let place = match recipe.pieces.len() {
        1 => 0.5,
        count => number as f64 / (count - 1) as f64,
    };
    let (body, tuned) = tuned_body(recipe, piece, free, place)?;
    Ok(SolvedPiece {
        body,
        zone: Zone {
            low: piece.keys.low,
            high: piece.keys.high,
            tuned,
            rule: Some(piece.tuning.rule),
        },
        mesh: words,
        orthonormality,
    })
}

/// The bank of all pieces of the recipe, solved, in its order: a body of each, and how they are given to
/// keys. It is of the first one's material.
///
/// # Panics
///
/// If there are no pieces, or not as many as the recipe has.
#[must_use]
pub fn free_bank(recipe: &FreeRecipe, solved: Vec<SolvedPiece>) -> Bank {
    assert_eq!(recipe.pieces.len(), solved.len(), "one for each piece");
    let first = &recipe.pieces[0];
    let residuals = solved.iter().flat_map(|piece| &piece.body.modes);
    let max_residual = residuals.fold(0.0, |most: f64, mode| most.max(mode.residual));
    let deviations = solved.iter().map(|piece| piece.orthonormality);
    let meshes: Vec<&str> = solved.iter().map(|piece| piece.mesh.as_str()).collect();
    let provenance = Provenance {
        recipe: recipe.text.clone(),
        code: CODE.to_owned(),
        mesh: format!("10-node tetrahedra, curved: {}", meshes.join("; ")),
        solver: "shift-invert block Lanczos, inertia counts".into(),
        tolerance_cents: 0.0,
        max_residual,
        max_orthonormality_error: deviations.fold(0.0, f64::max),
    };
    let rule = first.tuning.rule;
    let matter = matter(first);
    let (mut bodies, mut zones) = (Vec::new(), Vec::new());
    for (piece, solved) in recipe.pieces.iter().zip(solved) {
        let own = self::matter(piece);
        bodies.push(Body {
            matter: (own != matter).then_some(own),
            ..solved.body
        });
        zones.push(Zone {
            rule: solved.zone.rule.filter(|own| *own != rule),
            ..solved.zone
        });
    }
    Bank {
        name: recipe.name.clone(),
        title: recipe.title.clone(),
        material: matter.material,
        damping: matter.damping,
        ears_m: ears_m(&recipe.listener),
        provenance,
        spread: Some(Spread {
            rule,
            a4_hz: recipe.a4_hz,
            zones,
            enough: None,
        }),
        bodies,
    }
}

fn matter(piece: &Piece) -> Matter {
    Matter {
        material: piece.material,
        damping: piece.damping,
    }
}

/// Up to where the modes of the body as it is are heard on its lowest key.
fn limits(recipe: &FreeRecipe, piece: &Piece) -> Limits {
    let (tuning, fineness) = (&piece.tuning, &piece.fineness);
    let number = match tuning.mode {
        TunedMode::Number(number) => (number as usize).clamp(1, fineness.most_modes),
        TunedMode::Lowest | TunedMode::Loudest => 1,
    };
    let pitch_hz = equal_temperament_hz(piece.keys.low, recipe.a4_hz);
    Limits {
        highest_hz: fineness.highest_hz,
        most: fineness.most_modes,
        tuned: (tuning.rule != SpreadRule::Fixed).then_some((number, pitch_hz)),
    }
}

/// The body, at its `place` in the row, at the key nearest to its own pitch, and which of its modes carries
/// that, from 0.
fn tuned_body(
    recipe: &FreeRecipe,
    piece: &Piece,
    free: FreeBody,
    place: f64,
) -> Result<(Body, u32), FreeError> {
    let found = free.solved.modes.len();
    if found == 0 {
        return Err(FreeError::Silent {
            highest_hz: piece.fineness.highest_hz,
        });
    }
    let (keys, tuning) = (piece.keys, &piece.tuning);
    let mut body = sounding(
        free.solved,
        (keys.low, 1.0),
        place,
        &recipe.listener,
        &piece.losses,
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
        (own_hz / equal_temperament_hz(*key, recipe.a4_hz))
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
