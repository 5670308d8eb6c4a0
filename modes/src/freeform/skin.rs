//! What a body looks like: its outer boundary and the motion of its lowest modes.

use super::outside::Outside;
use crate::mesh::Mesh;
use crate::{Surface, SurfaceMotion};
use std::collections::HashMap;

/// Triangles up to which all nodes of the boundary are drawn, those between corners included.
const MOST_TRIANGLES: usize = 24_000;

/// The points that are drawn, and how each mode moves them.
pub(super) struct Skin {
    /// Mesh node of each drawn point.
    nodes: Vec<u32>,
    triangles: Vec<[u32; 3]>,
}

impl Skin {
    /// Of the boundary's faces: in all their small triangles, or in fewer if those would be too many.
    pub(super) fn of(outside: &Outside) -> Self {
        let fine = outside.triangles.len() <= MOST_TRIANGLES;
        let drawn = if fine {
            &outside.triangles
        } else {
            outside.few()
        };
        let (mut nodes, mut known) = (Vec::new(), HashMap::new());
        let triangles = drawn
            .iter()
            .map(|triangle| {
                triangle.map(|node| {
                    *known.entry(node).or_insert_with(|| {
                        nodes.push(node);
                        nodes.len() as u32 - 1
                    })
                })
            })
            .collect();
        Self { nodes, triangles }
    }

    /// The surface of a body `length_m` long, with the motion in the first of the `modes`.
    pub(super) fn surface<'a>(
        self,
        mesh: &Mesh,
        length_m: f64,
        modes: impl Iterator<Item = &'a [f64]>,
    ) -> Surface {
        let motions = modes.take(Surface::MOST_MODES).map(|vector| {
            let moved = |&node: &u32| displacement(vector, node).map(|x| x as f32);
            SurfaceMotion::of(&self.nodes.iter().map(moved).collect::<Vec<_>>())
        });
        Surface {
            length_m,
            motions: motions.collect(),
            points_m: self
                .nodes
                .iter()
                .map(|&node| mesh.nodes[node as usize].map(|x| x as f32))
                .collect(),
            triangles: self.triangles,
        }
    }
}

/// φ of a mode at a mesh node.
pub(super) fn displacement(vector: &[f64], node: u32) -> [f64; 3] {
    [0, 1, 2].map(|a| vector[3 * node as usize + a])
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mesh::ball_tet10;

    #[test]
    fn few_triangles_lie_within_many() {
        let mesh = ball_tet10(0.1, 2, 1);
        let outside = Outside::of(&mesh);
        let area = |triangles: &[[u32; 3]]| -> f64 {
            let place = |t: &[u32; 3]| t.map(|i| mesh.nodes[i as usize]);
            triangles
                .iter()
                .map(|t| super::super::axes::area_m2(&place(t)))
                .sum()
        };
        let (fine, coarse) = (area(&outside.triangles), area(outside.few()));
        assert!(coarse < fine && coarse > 0.9 * fine, "{coarse} {fine}");
    }
}
