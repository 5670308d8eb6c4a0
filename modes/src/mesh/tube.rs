//! Structured meshes of a tube.

use super::{Elements, Mesh, number};
use crate::fem::{HEX20_NODES, TET10_EDGES};
use crate::shape::Tube;

/// How many cells a tube is cut into on its wall.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct TubeGrid {
    /// Cells around the axis.
    pub around: usize,
    /// Cells along the axis.
    pub along: usize,
}

/// The two tetrahedra on each side of a cube's long diagonal 0–7, three pairs in all, corner c at
/// (c & 1, c >> 1 & 1, c >> 2): neighbouring cells agree on the diagonals they share.
const CUBE_TETS: [[usize; 4]; 6] = [
    [0, 1, 3, 7],
    [0, 3, 2, 7],
    [0, 2, 6, 7],
    [0, 6, 4, 7],
    [0, 4, 5, 7],
    [0, 5, 1, 7],
];

fn point(tube: &Tube, radial: f64, around: f64, along: f64) -> [f64; 3] {
    let radius = tube.inner_radius_m() + radial * tube.wall_m;
    let (sin, cos) = (std::f64::consts::TAU * around).sin_cos();
    [radius * cos, radius * sin, along * tube.length_m]
}

/// Linear tetrahedra, six to a cell, `layers` of cells through the wall:
/// (layers + 1)·around·(along + 1) nodes.
#[must_use]
pub fn tube_tet4(tube: &Tube, grid: TubeGrid, layers: usize) -> Mesh {
    let TubeGrid { around, along } = grid;
    let across = layers + 1;
    let id = |r: usize, a: usize, z: usize| number((z * around + a % around) * across + r);
    let mut nodes = Vec::with_capacity(across * around * (along + 1));
    for z in 0..=along {
        for a in 0..around {
            for r in 0..across {
                nodes.push(point(
                    tube,
                    r as f64 / layers as f64,
                    a as f64 / around as f64,
                    z as f64 / along as f64,
                ));
            }
        }
    }
    let mut tets = Vec::with_capacity(6 * layers * around * along);
    for z in 0..along {
        for a in 0..around {
            for r in 0..layers {
                let corner = |c: usize| id(r + (c & 1), a + (c >> 1 & 1), z + (c >> 2));
                tets.extend(CUBE_TETS.map(|tet| tet.map(corner)));
            }
        }
    }
    Mesh {
        nodes,
        elements: Elements::Tet4(tets),
    }
}

/// Ten-node tetrahedra, six to a cell, `layers` of cells through the wall, with mid-side nodes on
/// the true circles: (2·layers + 1)·2·around·(2·along + 1) nodes.
#[must_use]
pub fn tube_tet10(tube: &Tube, grid: TubeGrid, layers: usize) -> Mesh {
    // Every node of the grid twice as fine is a corner or the middle of an edge.
    let fine = TubeGrid {
        around: 2 * grid.around,
        along: 2 * grid.along,
    };
    let nodes = tube_tet4(tube, fine, 2 * layers).nodes;
    let across = 2 * layers + 1;
    let id = |[r, a, z]: [usize; 3]| number((z * fine.around + a % fine.around) * across + r);
    let mut tets = Vec::with_capacity(6 * layers * grid.around * grid.along);
    for z in 0..grid.along {
        for a in 0..grid.around {
            for r in 0..layers {
                // Half cells from the origin to the middle of two corners, or to one twice.
                let between = |c: usize, d: usize| {
                    let step = |bit: usize| (c >> bit & 1) + (d >> bit & 1);
                    id([2 * r + step(0), 2 * a + step(1), 2 * z + step(2)])
                };
                tets.extend(CUBE_TETS.map(|tet| {
                    std::array::from_fn(|node| match node {
                        0..4 => between(tet[node], tet[node]),
                        _ => {
                            let [p, q] = TET10_EDGES[node - 4];
                            between(tet[p], tet[q])
                        }
                    })
                }));
            }
        }
    }
    Mesh {
        nodes,
        elements: Elements::Tet10(tets),
    }
}

/// Twenty-node hexahedra, one layer through the wall, with mid-side nodes on the true circles.
#[must_use]
pub fn tube_hex20(tube: &Tube, grid: TubeGrid) -> Mesh {
    let TubeGrid { around, along } = grid;
    let (columns, rows) = (2 * around, 2 * along + 1);
    let slot = |r: usize, a: usize, z: usize| (z * columns + a % columns) * 3 + r;
    let mut ids = vec![u32::MAX; 3 * columns * rows];
    let mut nodes = Vec::new();
    for z in 0..rows {
        for a in 0..columns {
            for r in 0..3 {
                // Serendipity nodes are corners and edge middles: at most one odd index.
                if r % 2 + a % 2 + z % 2 > 1 {
                    continue;
                }
                ids[slot(r, a, z)] = number(nodes.len());
                nodes.push(point(
                    tube,
                    r as f64 / 2.0,
                    a as f64 / columns as f64,
                    z as f64 / (rows - 1) as f64,
                ));
            }
        }
    }
    let mut hexes = Vec::with_capacity(around * along);
    for z in 0..along {
        for a in 0..around {
            hexes.push(HEX20_NODES.map(|[r, t, h]| {
                let step = |local: f64, from: usize| match local {
                    -1.0 => from,
                    0.0 => from + 1,
                    _ => from + 2,
                };
                ids[slot(step(r, 0), step(t, 2 * a), step(h, 2 * z))]
            }));
        }
    }
    Mesh {
        nodes,
        elements: Elements::Hex20(hexes),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_paper_s_mesh_has_the_paper_s_nodes() {
        let grid = TubeGrid {
            around: 74,
            along: 126,
        };
        assert_eq!(tube_tet4(&Tube::D5, grid, 1).nodes.len(), 18_796);
    }

    #[test]
    fn mid_side_nodes_lie_on_the_true_circles() {
        let (tube, layers) = (Tube::D5, 1);
        let grid = TubeGrid {
            around: 8,
            along: 3,
        };
        let mesh = tube_tet10(&tube, grid, layers);
        assert_eq!(mesh.nodes.len(), 3 * 16 * 7);
        let mut used = vec![false; mesh.nodes.len()];
        for tet in mesh.elements.iter() {
            let radius = |node: usize| {
                let [x, y, _] = mesh.nodes[tet[node] as usize];
                x.hypot(y)
            };
            for (middle, [p, q]) in (4..10).zip(TET10_EDGES) {
                let expected = 0.5 * (radius(p) + radius(q));
                assert!((radius(middle) - expected).abs() < 1e-15);
            }
            for &node in tet {
                used[node as usize] = true;
            }
        }
        assert!(used.into_iter().all(|used| used));
    }

    #[test]
    fn every_hexahedron_has_twenty_different_nodes() {
        let grid = TubeGrid {
            around: 8,
            along: 3,
        };
        let mesh = tube_hex20(&Tube::D5, grid);
        for hex in mesh.elements.iter() {
            let mut nodes = hex.to_vec();
            nodes.sort_unstable();
            nodes.dedup();
            assert_eq!(nodes.len(), 20);
            assert!((nodes[19] as usize) < mesh.nodes.len());
        }
    }
}
