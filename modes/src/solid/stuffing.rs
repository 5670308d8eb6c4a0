//! Isosurface stuffing (Labelle & Shewchuk 2007): a lattice's tetrahedra, cut where the body ends.

mod cuts;
mod stencil;
mod whole;

use super::body::Body;
use super::lattice::Lattice;
use super::quality::volume_length;
use super::vector::{add, scale};
use super::{MeshError, Note};
use cuts::{Cuts, State};
use std::collections::HashMap;
pub(super) use stencil::wedge;
use whole::{largest_part, unpinch};

/// How deep in the body the middle of a tetrahedron is, in cells, that goes through a thin part.
const DEEP: f64 = 0.12;

/// The least quality of such a tetrahedron.
const SPANNING: f64 = 0.2;

/// Tetrahedra of four corners.
#[derive(Clone, Debug)]
pub(super) struct Tets {
    pub(super) points: Vec<[f64; 3]>,
    /// Corner numbers, positively oriented.
    pub(super) tets: Vec<[u32; 4]>,
}

/// The tetrahedra of `body` on `lattice`; what of them hangs together most.
pub(super) fn stuff(
    body: &Body,
    lattice: &Lattice,
    notes: &mut Vec<Note>,
) -> Result<Tets, MeshError> {
    let cuts = Cuts::find(body, lattice);
    if cuts.overlaps {
        notes.push(Note::Overlaps);
    }
    if let Some(wall_m) = body.wall_m().filter(|_| !cuts.hollow) {
        notes.push(Note::WallFills { wall_m });
    }
    let mut tets = fill(body, lattice, &cuts);
    let parts = largest_part(&mut tets);
    if tets.tets.is_empty() {
        return Err(MeshError::NoElements);
    }
    if parts > 1 {
        notes.push(Note::PiecesLeft {
            kept: 1,
            left: parts - 1,
        });
    }
    unpinch(&mut tets);
    Ok(tets)
}

/// A corner of the tetrahedra to be: a point of the lattice, or the cut between an inner and an outer
/// one.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
enum Corner {
    Point(usize),
    Cut(usize, usize),
}

/// Whether a tetrahedron whose corners are all on the boundary goes from one side of a thin part to the
/// other: a flat one lies along the surface.
fn spans(body: &Body, lattice: &Lattice, corners: [[f64; 3]; 4]) -> bool {
    let middle = scale(corners.into_iter().fold([0.0; 3], add), 0.25);
    let deep_m = DEEP * lattice.cell_m.into_iter().fold(f64::INFINITY, f64::min);
    volume_length(corners) > SPANNING
        && body
            .depth_m(middle, deep_m)
            .is_some_and(|depth_m| depth_m >= deep_m)
}

fn fill(body: &Body, lattice: &Lattice, cuts: &Cuts) -> Tets {
    let mut filled = Tets {
        points: Vec::new(),
        tets: Vec::new(),
    };
    let mut ids: HashMap<Corner, u32> = HashMap::new();
    for tet in lattice.tetrahedra() {
        let on = tet.iter().all(|&n| cuts.states[n] == State::On);
        let inside = tet.iter().any(|&n| cuts.states[n] == State::Inside);
        let stays = inside || on && spans(body, lattice, tet.map(|n| cuts.places[n]));
        if !stays {
            continue;
        }
        stencil::cut_tet(
            tet,
            lattice,
            |n| cuts.states[n],
            |corners| {
                let tet = corners.map(|corner| {
                    *ids.entry(corner).or_insert_with(|| {
                        filled.points.push(match corner {
                            Corner::Point(n) => cuts.places[n],
                            Corner::Cut(inner, outer) => cuts.place(inner, outer),
                        });
                        filled.points.len() as u32 - 1
                    })
                });
                filled.tets.push(tet);
            },
        );
    }
    filled
}
