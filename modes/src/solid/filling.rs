//! A body filled with tetrahedra that fit it.

use super::body::Body;
use super::features::Features;
use super::fit::Fit;
use super::lattice::Lattice;
use super::resolution::Size;
use super::stuffing::{Tets, stuff};
use super::topology::Faces;
use super::{ClosedSurface, MeshError, Meshing, Note, Resolution};
use crate::factory::Progress;

/// Lattices tried until one has the nodes asked for.
const TRIES: usize = 5;

/// How far from the nodes asked for is near enough.
const NEAR: std::ops::RangeInclusive<f64> = 0.85..=1.03;

/// Steps of work that are told: lattices, rounds of fitting, curving.
pub(super) const STEPS: usize = 20;

/// Tetrahedra that fill `body`, their points on its surface, edges and corners.
pub(super) fn fitted<'a>(
    surface: &ClosedSurface,
    body: &'a Body,
    features: &'a Features,
    how: &Meshing,
    progress: &dyn Progress,
    notes: &mut Vec<Note>,
) -> Result<Fit<'a>, MeshError> {
    let (tets, cell_m) = stuffed(surface, body, how, progress, notes)?;
    let mut fit = Fit::new(body, features, tets, cell_m);
    let told =
        |round, rounds| progress.advance(TRIES + round * (STEPS - TRIES - 1) / rounds, STEPS);
    if fit.fit(told).is_break() {
        return Err(MeshError::Cancelled);
    }
    if fit.short() > 0 {
        notes.push(Note::Rounded {
            points: fit.short(),
        });
    }
    Ok(fit)
}

/// The lattice's tetrahedra, as near to the nodes asked for as a few tries bring them.
fn stuffed(
    surface: &ClosedSurface,
    body: &Body,
    how: &Meshing,
    progress: &dyn Progress,
    notes: &mut Vec<Note>,
) -> Result<(Tets, f64), MeshError> {
    let size = Size::choose(surface, body, how)?;
    let mut edge_m = size.cell_m;
    for step in 0.. {
        if progress.advance(step, STEPS).is_break() {
            return Err(MeshError::Cancelled);
        }
        edge_m = Lattice::feasible_m(surface.bounds_m(), edge_m);
        let lattice = Lattice::fitting(surface.bounds_m(), edge_m);
        let mut own = Vec::new();
        let stuffed = stuff(body, &lattice, &mut own);
        let cell_m = lattice.cell_m.into_iter().fold(0.0, f64::max);
        let last = step + 1 >= TRIES;
        let tets = match stuffed {
            Ok(tets) => tets,
            Err(MeshError::NoElements) if !last => {
                edge_m *= 0.7;
                continue;
            }
            Err(error) => return Err(error),
        };
        let nodes = nodes(&tets);
        let ratio = size.nodes.map_or(1.0, |asked| nodes as f64 / asked as f64);
        if last || NEAR.contains(&ratio) {
            notes.append(&mut own);
            if let (Some(thin_m), Resolution::Nodes(asked)) = (size.thin_m, how.resolution)
                && nodes > asked
            {
                notes.push(Note::Finer {
                    thin_m,
                    nodes,
                    asked,
                });
            }
            return Ok((tets, cell_m));
        }
        edge_m *= (ratio / 0.95).powf(1.0 / 2.7);
    }
    Err(MeshError::NoElements)
}

/// Nodes once edges have middles: points and edges, by Euler's formula for a body without holes.
fn nodes(tets: &Tets) -> usize {
    let outside = Faces::of(&tets.tets).outside(&tets.tets).len();
    2 * tets.points.len() + tets.tets.len() + outside / 2
}
