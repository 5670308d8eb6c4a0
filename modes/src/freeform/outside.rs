//! The part of a mesh's boundary that the outside world sees.

use super::axes::doubled_area;
use crate::mesh::{Face, Mesh};
use std::ops::Range;

/// The outer boundary: some small triangles to each face of an element, between its nodes.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Outside {
    /// Small triangles of mesh nodes, counter-clockwise from outside, those of a face together.
    pub(super) triangles: Vec<[u32; 3]>,
    /// Those of each face.
    faces: Vec<Range<usize>>,
    /// Fewer of them, for all faces.
    few: Vec<[u32; 3]>,
}

impl Outside {
    /// Of a mesh: walls of closed cavities, which face inwards, are left out.
    pub(super) fn of(mesh: &Mesh) -> Self {
        let all = mesh.faces();
        let triangles: Vec<[u32; 3]> = all
            .iter()
            .flat_map(|face| &face.triangles)
            .copied()
            .collect();
        let piece = pieces(mesh.nodes.len(), &triangles);
        let mut volumes = vec![0.0; mesh.nodes.len()];
        for triangle in &triangles {
            let corners = triangle.map(|i| mesh.nodes[i as usize]);
            let doubled = doubled_area(&corners);
            let cone: f64 = (0..3).map(|a| doubled[a] * corners[0][a]).sum();
            volumes[piece[triangle[0] as usize] as usize] += cone;
        }
        let outer = |face: &Face| volumes[piece[face.few[0][0] as usize] as usize] > 0.0;
        let mut outside = Self {
            triangles: Vec::new(),
            faces: Vec::new(),
            few: Vec::new(),
        };
        for mut face in all.into_iter().filter(outer) {
            let first = outside.triangles.len();
            outside.triangles.append(&mut face.triangles);
            outside.faces.push(first..outside.triangles.len());
            outside.few.append(&mut face.few);
        }
        outside
    }

    /// The faces, each as its small triangles.
    pub(super) fn faces(&self) -> impl Iterator<Item = &[[u32; 3]]> {
        self.faces
            .iter()
            .map(|range| &self.triangles[range.clone()])
    }

    /// Triangles between the faces' corners, and nodes between those where a face is cubic.
    pub(super) fn few(&self) -> &[[u32; 3]] {
        &self.few
    }
}

/// Which connected piece each node belongs to, named by one of its nodes.
fn pieces(nodes: usize, triangles: &[[u32; 3]]) -> Vec<u32> {
    let mut parent: Vec<u32> = (0u32..).take(nodes).collect();
    fn root(parent: &mut [u32], mut node: u32) -> u32 {
        while parent[node as usize] != node {
            parent[node as usize] = parent[parent[node as usize] as usize];
            node = parent[node as usize];
        }
        node
    }
    for [p, q, r] in triangles {
        let first = root(&mut parent, *p);
        for other in [q, r] {
            let other = root(&mut parent, *other);
            parent[other as usize] = first;
        }
    }
    (0u32..)
        .take(nodes)
        .map(|node| root(&mut parent, node))
        .collect()
}

#[cfg(test)]
mod tests {
    use super::super::axes::area_m2;
    use super::*;
    use crate::mesh::hollow_ball_tet10;
    use std::f64::consts::PI;

    #[test]
    fn a_cavity_is_not_outside() {
        let mesh = hollow_ball_tet10([0.04, 0.1], 3, 1);
        let outside = Outside::of(&mesh);
        let corners = |t: &[u32; 3]| t.map(|i| mesh.nodes[i as usize]);
        let area: f64 = outside.triangles.iter().map(|t| area_m2(&corners(t))).sum();
        assert!((area / (4.0 * PI * 0.01) - 1.0).abs() < 0.02, "{area}");
        assert_eq!(2 * outside.triangles.len(), mesh.surface().len());
        for face in outside.faces() {
            // The middle one joins the middles of the face's sides.
            let shared = |t: &[u32; 3]| t.iter().filter(|i| face[3].contains(i)).count();
            assert!(face[..3].iter().all(|t| shared(t) == 2));
        }
    }
}
