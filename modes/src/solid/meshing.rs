//! From a closed surface to its mesh.

use super::body::Body;
use super::features::Features;
use super::fit::{Curved, Fit, curve};
use super::lattice::Lattice;
use super::quality::{dihedrals_deg, volume_length};
use super::repair::length;
use super::resolution::Size;
use super::stuffing::{Tets, stuff};
use super::topology::Faces;
use super::{ClosedSurface, MeshError, Meshing, Note, Quality, Resolution};
use crate::factory::Progress;
use crate::fem::tet10_volume;
use crate::mesh::{Elements, Mesh};

/// Lattices tried until one has the nodes asked for.
const TRIES: usize = 5;

/// How far from the nodes asked for is near enough.
const NEAR: std::ops::RangeInclusive<f64> = 0.85..=1.03;

/// Steps of work that are told: lattices, rounds of fitting, curving.
const STEPS: usize = 20;

/// Volume over that of the surface below which parts are said to be lost.
const LOST: f64 = 0.97;

/// A meshed body.
#[derive(Clone, Debug, PartialEq)]
pub struct Meshed {
    /// Ten-node tetrahedra, in m.
    pub mesh: Mesh,
    /// Triangles of its boundary: three corners, counter-clockwise from outside, then the nodes in
    /// the middle of their three edges in turn.
    pub boundary: Vec<[u32; 6]>,
    /// The surface that was filled, in m.
    pub surface: ClosedSurface,
    /// The elements' shapes.
    pub quality: Quality,
    /// What the owner should know, repairs included.
    pub notes: Vec<Note>,
}

/// Fills `surface` with ten-node tetrahedra, its sharp edges kept and its curved sides followed by the
/// nodes in the middle of edges.
///
/// # Errors
///
/// [`MeshError`] if the body is too thin for the nodes allowed, or `progress` breaks.
pub fn mesh_solid(
    surface: &ClosedSurface,
    how: &Meshing,
    progress: &dyn Progress,
) -> Result<Meshed, MeshError> {
    let told = |step: usize| match progress.advance(step, STEPS) {
        std::ops::ControlFlow::Continue(()) => Ok(()),
        std::ops::ControlFlow::Break(()) => Err(MeshError::Cancelled),
    };
    told(0)?;
    check(surface, how)?;
    let mut notes = surface.notes.clone();
    let body = Body::new(surface, how.wall_m);
    let features = Features::of(surface);
    let (tets, cell_m) = stuffed(surface, &body, how, &mut notes, &told)?;
    let mut fit = Fit::new(&body, &features, tets, cell_m);
    let rounds =
        |round, rounds| progress.advance(TRIES + round * (STEPS - TRIES - 1) / rounds, STEPS);
    if fit.fit(rounds).is_break() {
        return Err(MeshError::Cancelled);
    }
    if fit.short() > 0 {
        notes.push(Note::Rounded {
            points: fit.short(),
        });
    }
    let Curved {
        mesh,
        boundary,
        straight_share,
    } = curve(&fit);
    let quality = quality(&fit.mesh, &mesh, straight_share);
    let share = quality.volume_m3 / surface.volume_m3();
    if how.wall_m.is_none() && share < LOST && !notes.contains(&Note::Overlaps) {
        notes.push(Note::Lost { share });
    }
    told(STEPS)?;
    Ok(Meshed {
        mesh,
        boundary,
        surface: surface.clone(),
        quality,
        notes,
    })
}

/// That lengths are lengths.
fn check(surface: &ClosedSurface, how: &Meshing) -> Result<(), MeshError> {
    let (low, high) = surface.bounds_m();
    let longest = (0..3).map(|a| high[a] - low[a]).fold(0.0, f64::max);
    if let Some(wall_m) = how.wall_m {
        length("the wall", wall_m, (1e-4 * longest, longest))?;
    }
    if let Resolution::CellM(cell_m) = how.resolution {
        length("the cells' size", cell_m, (1e-3 * longest, longest))?;
    }
    Ok(())
}

/// The lattice's tetrahedra, as near to the nodes asked for as a few tries bring them.
fn stuffed(
    surface: &ClosedSurface,
    body: &Body,
    how: &Meshing,
    notes: &mut Vec<Note>,
    told: &impl Fn(usize) -> Result<(), MeshError>,
) -> Result<(Tets, f64), MeshError> {
    let size = Size::choose(surface, body, how)?;
    let mut edge_m = size.cell_m;
    for step in 0.. {
        told(step)?;
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

fn quality(straight: &Tets, mesh: &Mesh, straight_share: f64) -> Quality {
    let (mut least, mut most, mut worst) = (180.0f64, 0.0f64, f64::INFINITY);
    for tet in &straight.tets {
        let corners = tet.map(|i| straight.points[i as usize]);
        let (low, high) = dihedrals_deg(corners);
        least = least.min(low);
        most = most.max(high);
        worst = worst.min(volume_length(corners));
    }
    let volume_m3 = match &mesh.elements {
        Elements::Tet10(tets) => tets
            .iter()
            .map(|tet| tet10_volume(&tet.map(|node| mesh.nodes[node as usize])))
            .sum(),
        _ => 0.0,
    };
    Quality {
        min_dihedral_deg: least,
        max_dihedral_deg: most,
        min_volume_length: worst,
        elements: straight.tets.len(),
        nodes: mesh.nodes.len(),
        volume_m3,
        straight_share,
    }
}
