//! How fine a mesh is.

use super::body::Body;
use super::lattice::Lattice;
use super::thickness::thickness_m;
use super::vector::{sub, whole};
use super::{ClosedSurface, MeshError};

/// Longest side of a cell over the thickness of a part: one or two elements through it wherever the
/// lattice lies, and no holes.
const RESOLVES: f64 = 0.9;

/// Longest side of a cell over the bounding box's shortest: elements may lie flat in a plate.
const FLATTEST: f64 = 2.5;

/// Nodes of a wall of wedges over its area in cells squared.
const WEDGES: f64 = 41.0;

/// Sides of a wedge over its height, at most.
const WIDEST: f64 = 8.0;

/// How a body is meshed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Meshing {
    /// Thickness of the wall of a hollow body, in m; without it the body is solid.
    pub wall_m: Option<f64>,
    /// How fine.
    pub resolution: Resolution,
    /// Nodes that thin parts may take at most, whatever the resolution.
    pub most_nodes: usize,
}

/// What decides the elements' size.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Resolution {
    /// About this many nodes, mid-edge nodes included.
    Nodes(usize),
    /// Cells of about this size, in m; edges of elements are about as long.
    CellM(f64),
}

impl Default for Meshing {
    fn default() -> Self {
        Self {
            wall_m: None,
            resolution: Resolution::Nodes(20_000),
            most_nodes: 120_000,
        }
    }
}

/// The size of cells, and what decided it.
#[derive(Clone, Copy, Debug)]
pub(super) struct Size {
    /// In m.
    pub(super) cell_m: f64,
    /// Nodes that the mesh should not exceed by much.
    pub(super) nodes: Option<usize>,
    /// Thickness of parts that ask for smaller cells than the budget, in m.
    pub(super) thin_m: Option<f64>,
}

impl Size {
    /// For `surface`; its parts' thickness decides if the budget leaves cells that miss them.
    pub(super) fn choose(
        surface: &ClosedSurface,
        body: &Body,
        how: &Meshing,
    ) -> Result<Self, MeshError> {
        let (low, high) = surface.bounds_m();
        let shortest = sub(high, low).into_iter().fold(f64::INFINITY, f64::min);
        let nodes = |cell_m: f64| nodes(surface, how.wall_m, cell_m);
        let asked = match how.resolution {
            Resolution::CellM(cell_m) => cell_m,
            Resolution::Nodes(most) => largest(most, shortest, nodes),
        };
        let flat = asked.min(FLATTEST * shortest);
        let thin_m = match how.wall_m {
            Some(wall_m) => Some(wall_m),
            None => thickness_m(surface, body),
        };
        // A plate as thick as its box is a layer of cells of its own.
        let limit = thin_m.filter(|&thin_m| thin_m < 0.8 * shortest);
        let limit = limit.map_or(f64::INFINITY, |thin_m| RESOLVES * thin_m);
        let bounds_m = surface.bounds_m();
        let cell_m = Lattice::feasible_m(bounds_m, flat).min(limit);
        let needed = nodes(cell_m);
        if needed > how.most_nodes as f64 || cell_m < Lattice::feasible_m(bounds_m, cell_m) {
            return Err(MeshError::TooThin {
                thin_m: thin_m.unwrap_or(cell_m),
                nodes: whole(needed),
                allowed: how.most_nodes,
            });
        }
        let budget = match how.resolution {
            Resolution::Nodes(most) => Some(most),
            Resolution::CellM(_) => None,
        };
        let thin = cell_m < asked;
        Ok(Self {
            cell_m,
            nodes: budget.filter(|_| !thin),
            thin_m: thin_m.filter(|_| thin),
        })
    }
}

/// Nodes of a mesh of such cells: sixteen to a cell inside, more where the surface cuts it.
fn nodes(surface: &ClosedSurface, wall_m: Option<f64>, cell_m: f64) -> f64 {
    let (volume, area) = (surface.volume_m3().abs(), surface.area_m2());
    let (volume, area) = match wall_m {
        Some(wall_m) => (volume.min(area * wall_m), 2.0 * area),
        None => (volume, area),
    };
    16.0 * volume / cell_m.powi(3) + 9.0 * area / cell_m.powi(2)
}

/// How the outside of a hollow body is meshed to become its wall as wedges; `None` if the wall is thick
/// enough for cells within the budget.
pub(super) fn outer(surface: &ClosedSurface, how: &Meshing) -> Option<Meshing> {
    let wall_m = how.wall_m?;
    let through_m = RESOLVES * wall_m;
    let cell_m = match how.resolution {
        Resolution::CellM(cell_m) => (cell_m > through_m).then_some(cell_m),
        Resolution::Nodes(most) => (nodes(surface, how.wall_m, through_m) > most as f64)
            .then(|| (WEDGES * surface.area_m2() / most as f64).sqrt()),
    }?;
    Some(Meshing {
        wall_m: None,
        resolution: Resolution::CellM(cell_m.clamp(wall_m, WIDEST * wall_m)),
        most_nodes: how.most_nodes,
    })
}

/// The cell at which `nodes` are `most`, by halving.
fn largest(most: usize, shortest: f64, nodes: impl Fn(f64) -> f64) -> f64 {
    let (mut low, mut high) = (0.0, 1e3 * shortest);
    for _ in 0..60 {
        let middle = 0.5 * (low + high);
        if nodes(middle) > most as f64 {
            low = middle;
        } else {
            high = middle;
        }
    }
    high
}
