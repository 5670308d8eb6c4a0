//! Ten-node tetrahedra in blocks of cells that any map may bend.

use super::{Elements, Mesh, number};
use crate::fem::TET10_EDGES;
use std::collections::HashMap;

/// A block of cells: how many along each of its sides, and where the points of the unit cube go, in m.
pub struct Block<'a> {
    /// Cells along each side.
    pub counts: [usize; 3],
    /// From the unit cube to space.
    pub place_m: &'a dyn Fn([f64; 3]) -> [f64; 3],
}

/// Steps of the grid on which all nodes of a cell lie, to a side.
const STEPS: usize = 4;

/// Part of the blocks' size within which nodes are one.
const SAME: f64 = 1e-7;

/// The blocks as one body: each cell makes 24 tetrahedra, from its middle over the middles of its faces
/// to its edges, so that neighbours fit however they are turned. Blocks that touch must agree on the
/// nodes of the faces that they share.
#[must_use]
pub fn blocks_tet10(blocks: &[Block<'_>]) -> Mesh {
    let mut builder = Builder::new(extent_m(blocks) * SAME);
    for block in blocks {
        let [nx, ny, nz] = block.counts;
        for x in 0..nx {
            for y in 0..ny {
                for z in 0..nz {
                    builder.cell(block, [x, y, z]);
                }
            }
        }
    }
    Mesh {
        nodes: builder.nodes,
        elements: Elements::Tet10(builder.tets),
    }
}

/// A brick of `sides_m`, its middle at the origin.
#[must_use]
pub fn brick_tet10(sides_m: [f64; 3], counts: [usize; 3]) -> Mesh {
    let place = |p: [f64; 3]| [0, 1, 2].map(|a| sides_m[a] * (p[a] - 0.5));
    blocks_tet10(&[Block {
        counts,
        place_m: &place,
    }])
}

/// Greatest coordinate of the blocks' corners, in m.
fn extent_m(blocks: &[Block<'_>]) -> f64 {
    let corner = |c: usize| [c & 1, c >> 1 & 1, c >> 2].map(|bit| bit as f64);
    let corners = blocks
        .iter()
        .flat_map(|block| (0..8).map(move |c| (block.place_m)(corner(c))));
    corners.flatten().fold(0.0, |most, x| x.abs().max(most))
}

struct Builder {
    nodes: Vec<[f64; 3]>,
    tets: Vec<[u32; 10]>,
    same_m: f64,
    known: HashMap<[i64; 3], u32>,
}

impl Builder {
    fn new(same_m: f64) -> Self {
        Self {
            nodes: Vec::new(),
            tets: Vec::new(),
            same_m,
            known: HashMap::new(),
        }
    }

    fn cell(&mut self, block: &Block<'_>, cell: [usize; 3]) {
        let at = |step: [usize; 3]| {
            let along =
                |a: usize| (STEPS * cell[a] + step[a]) as f64 / (STEPS * block.counts[a]) as f64;
            (block.place_m)([0, 1, 2].map(along))
        };
        const HALF: usize = STEPS / 2;
        let middle = [HALF; 3];
        for axis in 0..3 {
            for side in [0, STEPS] {
                let mut face = middle;
                face[axis] = side;
                let [p, q] = [(axis + 1) % 3, (axis + 2) % 3];
                let ring = [[0, 0], [STEPS, 0], [STEPS, STEPS], [0, STEPS]].map(|[a, b]| {
                    let mut corner = face;
                    (corner[p], corner[q]) = (a, b);
                    corner
                });
                for i in 0..4 {
                    let corners = [middle, face, ring[i], ring[(i + 1) % 4]];
                    self.tet(corners, &at);
                }
            }
        }
    }

    /// Of corners at these steps of a cell, turned so that its volume is positive.
    fn tet(&mut self, mut corners: [[usize; 3]; 4], at: &impl Fn([usize; 3]) -> [f64; 3]) {
        if volume(&corners.map(at)) < 0.0 {
            corners.swap(2, 3);
        }
        let between =
            |i: usize, j: usize| [0, 1, 2].map(|a| usize::midpoint(corners[i][a], corners[j][a]));
        let steps: [[usize; 3]; 10] = std::array::from_fn(|node| match node {
            0..4 => corners[node],
            _ => between(TET10_EDGES[node - 4][0], TET10_EDGES[node - 4][1]),
        });
        let tet = steps.map(|step| self.node(at(step)));
        self.tets.push(tet);
    }

    /// The node at `point`, the same one for points that differ by rounding.
    fn node(&mut self, point: [f64; 3]) -> u32 {
        let key = point.map(|x| (x / self.same_m).round() as i64);
        for dx in -1..=1 {
            for dy in -1..=1 {
                for dz in -1..=1 {
                    let near = [key[0] + dx, key[1] + dy, key[2] + dz];
                    if let Some(&node) = self.known.get(&near) {
                        return node;
                    }
                }
            }
        }
        let node = number(self.nodes.len());
        self.nodes.push(point);
        self.known.insert(key, node);
        node
    }
}

fn volume([o, p, q, r]: &[[f64; 3]; 4]) -> f64 {
    let [u, v, w] = [p, q, r].map(|p| [0, 1, 2].map(|a| p[a] - o[a]));
    (u[0] * (v[1] * w[2] - v[2] * w[1])
        + u[1] * (v[2] * w[0] - v[0] * w[2])
        + u[2] * (v[0] * w[1] - v[1] * w[0]))
        / 6.0
}
