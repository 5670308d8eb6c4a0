//! The outside of a mesh.

use super::{Elements, Mesh};
use crate::fem::{CUBIC_NODES, HEX20_NODES, TET10_EDGES, WEDGE_NODES};
use std::collections::HashMap;

/// Faces of a tetrahedron, counter-clockwise from outside.
pub(crate) const TET_FACES: [[usize; 3]; 4] = [[0, 2, 1], [0, 1, 3], [1, 2, 3], [0, 3, 2]];

/// One element's face on the surface of a mesh.
pub(crate) struct Face {
    /// The small triangles between its nodes, counter-clockwise from outside.
    pub(crate) triangles: Vec<[u32; 3]>,
    /// Fewer of them: between corners, and on cubic sides one node between two.
    pub(crate) few: Vec<[u32; 3]>,
}

impl Mesh {
    /// Triangles of the surface, counter-clockwise from outside. A face with nodes between its corners
    /// gives one to each corner and those in between: four of six nodes, six of eight, nine of ten.
    #[must_use]
    pub fn surface(&self) -> Vec<[u32; 3]> {
        let faces = self.faces().into_iter();
        faces.flat_map(|face| face.triangles).collect()
    }

    /// Faces of the surface.
    pub(crate) fn faces(&self) -> Vec<Face> {
        let faces: Vec<Vec<u32>> = match &self.elements {
            Elements::Tet4(tets) => tets
                .iter()
                .flat_map(|tet| TET_FACES.map(|face| face.map(|i| tet[i]).to_vec()))
                .collect(),
            Elements::Tet10(tets) => {
                let local = TET_FACES.map(with_middles);
                tets.iter()
                    .flat_map(|tet| local.map(|face| face.map(|i| tet[i]).to_vec()))
                    .collect()
            }
            Elements::Wedge23(wedges) => wedges.iter().flat_map(wedge_faces).collect(),
            Elements::Hex20(hexes) => {
                let local = hex_faces();
                hexes
                    .iter()
                    .flat_map(|hex| local.each_ref().map(|face| face.map(|i| hex[i]).to_vec()))
                    .collect()
            }
        };
        let sorted = |face: &[u32]| {
            let mut nodes = face.to_vec();
            nodes.sort_unstable();
            nodes
        };
        let mut seen: HashMap<Vec<u32>, usize> = HashMap::new();
        for face in &faces {
            *seen.entry(sorted(face)).or_default() += 1;
        }
        let outer = faces.iter().filter(|face| seen[&sorted(face)] == 1);
        let rims = matches!(self.elements, Elements::Wedge23(_));
        outer.map(|face| cut(face, rims)).collect()
    }
}

/// A face of these nodes cut into triangles; one of eight nodes is a wedge's where there are `rims`.
fn cut(face: &[u32], rims: bool) -> Face {
    let n = face.len();
    match *face {
        [p, q, r] => Face {
            triangles: vec![[p, q, r]],
            few: vec![[p, q, r]],
        },
        [p, pq, qp, q, qr, rq, r, rp, pr, middle] => {
            let [x, y, z] = [[p, pq, qp, q], [q, qr, rq, r], [r, rp, pr, p]].map(one_between);
            Face {
                triangles: [
                    [p, pq, pr],
                    [q, qr, qp],
                    [r, rp, rq],
                    [pq, qp, middle],
                    [qp, qr, middle],
                    [qr, rq, middle],
                    [rq, rp, middle],
                    [rp, pr, middle],
                    [pr, pq, middle],
                ]
                .into(),
                few: vec![[p, x, z], [q, y, x], [r, z, y], [x, y, z]],
            }
        }
        [p, pq, qp, q, r, rs, sr, s] if rims => {
            let [x, y] = [[p, pq, qp, q], [r, rs, sr, s]].map(one_between);
            Face {
                triangles: halves([[p, pq, sr, s], [pq, qp, rs, sr], [qp, q, r, rs]]),
                few: halves([[p, x, y, s], [x, q, r, y]]),
            }
        }
        // Corners and edge middles in turn.
        _ => {
            let corner = |i| [face[(i + n - 1) % n], face[i], face[i + 1]];
            let between = |i| [face[1], face[i + 1], face[i + 3]];
            let corners = (0..n).step_by(2).map(corner);
            Face {
                triangles: corners.chain((2..n - 2).step_by(2).map(between)).collect(),
                few: (2..n - 2)
                    .step_by(2)
                    .map(|i| [face[0], face[i], face[i + 2]])
                    .collect(),
            }
        }
    }
}

/// Quadrangles as two triangles each.
fn halves<const N: usize>(quadrangles: [[u32; 4]; N]) -> Vec<[u32; 3]> {
    let halves = quadrangles
        .iter()
        .map(|&[a, b, c, d]| [[a, b, c], [a, c, d]]);
    halves.flatten().collect()
}

/// Of the two nodes between the ends of a cubic side the one that both faces along it choose.
fn one_between([from, near_from, near_to, to]: [u32; 4]) -> u32 {
    if from < to { near_from } else { near_to }
}

/// Nodes of a wedge's five faces, counter-clockwise from outside: on either side corner, two between,
/// corner, … and the middle; across the wall those along its two sides.
fn wedge_faces(wedge: &[u32; WEDGE_NODES]) -> [Vec<u32>; 5] {
    let of = |local: &[usize]| local.iter().map(|&i| wedge[i]).collect();
    let rim = |[p, pq, qp, q]: [usize; 4]| {
        let over = |i: usize| i + CUBIC_NODES;
        of(&[p, pq, qp, q, over(q), over(qp), over(pq), over(p)])
    };
    [
        of(&[0, 8, 7, 2, 6, 5, 1, 4, 3, 9]),
        of(&[0, 3, 4, 1, 5, 6, 2, 7, 8, 9].map(|i| i + CUBIC_NODES)),
        rim([0, 3, 4, 1]),
        rim([1, 5, 6, 2]),
        rim([2, 7, 8, 0]),
    ]
}

/// Corner, middle, corner, … of a ten-node tetrahedron's face with these corners.
fn with_middles(corners: [usize; 3]) -> [usize; 6] {
    std::array::from_fn(|i| {
        let (from, to) = (corners[i / 2], corners[(i / 2 + 1) % 3]);
        let edge = TET10_EDGES
            .iter()
            .position(|edge| edge.contains(&from) && edge.contains(&to));
        match i % 2 {
            0 => from,
            _ => 4 + edge.expect("every two corners have an edge"),
        }
    })
}

/// Local nodes of the six faces, corner, middle, corner, …, counter-clockwise from outside.
fn hex_faces() -> [[usize; 8]; 6] {
    const RING: [[f64; 2]; 8] = [
        [-1.0, -1.0],
        [0.0, -1.0],
        [1.0, -1.0],
        [1.0, 0.0],
        [1.0, 1.0],
        [0.0, 1.0],
        [-1.0, 1.0],
        [-1.0, 0.0],
    ];
    std::array::from_fn(|face| {
        let (axis, side) = (face / 2, if face % 2 == 0 { -1.0 } else { 1.0 });
        let [p, q] = [(axis + 1) % 3, (axis + 2) % 3];
        std::array::from_fn(|i| {
            // Axis, p, q are right-handed: seen from the positive side p to q is counter-clockwise.
            let [first, second] = RING[if side > 0.0 { i } else { (8 - i) % 8 }];
            let mut node = [0.0; 3];
            node[axis] = side;
            node[p] = first;
            node[q] = second;
            HEX20_NODES
                .iter()
                .position(|&n| n == node)
                .expect("every face node is a node")
        })
    })
}

#[cfg(test)]
mod tests {
    use crate::mesh::{Mesh, TubeGrid, tube_hex20, tube_tet4, tube_tet10};
    use crate::shape::Tube;

    fn volume_and_area(mesh: &Mesh) -> (f64, f64) {
        let mut sums = (0.0, 0.0);
        for triangle in mesh.surface() {
            let [p, q, r] = triangle.map(|node| mesh.nodes[node as usize]);
            let (u, v) = (
                [0, 1, 2].map(|a| q[a] - p[a]),
                [0, 1, 2].map(|a| r[a] - p[a]),
            );
            let cross = [
                u[1] * v[2] - u[2] * v[1],
                u[2] * v[0] - u[0] * v[2],
                u[0] * v[1] - u[1] * v[0],
            ];
            sums.0 += (p[0] * cross[0] + p[1] * cross[1] + p[2] * cross[2]) / 6.0;
            sums.1 += 0.5 * cross.iter().map(|c| c * c).sum::<f64>().sqrt();
        }
        sums
    }

    #[test]
    fn surfaces_close_and_face_outwards() {
        let tube = Tube::D5;
        let grid = TubeGrid {
            around: 64,
            along: 4,
        };
        let walls = std::f64::consts::TAU * (tube.outer_radius_m + tube.inner_radius_m());
        let area = walls * tube.length_m + 2.0 * tube.section_area_m2();
        for mesh in [
            tube_tet4(&tube, grid, 1),
            tube_tet10(&tube, grid, 1),
            tube_hex20(&tube, grid),
        ] {
            let (v, a) = volume_and_area(&mesh);
            assert!((v / tube.volume_m3() - 1.0).abs() < 2e-3, "{v}");
            assert!((a / area - 1.0).abs() < 1e-3, "{a}");
        }
    }
}
