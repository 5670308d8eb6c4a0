//! Edges and corners of a surface that a mesh must not round off.

use super::ClosedSurface;
use super::repair::edges::{Edges, Side};
use super::tree::Tree;
use super::vector::{dot, doubled_area, sub, unit};
use std::collections::HashMap;

/// Angle between the normals of two faces, in degrees, from which their edge is sharp: a cylinder of
/// twelve sides is round.
const SHARP_DEG: f64 = 35.0;

/// Turn of a line of sharp edges, in degrees, from which it has a corner.
const CORNER_DEG: f64 = 45.0;

/// The sharp edges and what lies between them.
pub(super) struct Features {
    /// Number of the smooth part each triangle belongs to.
    pub(super) patch: Vec<u32>,
    /// Sharp edges between two different patches.
    segments: Tree,
    /// The two patches of each.
    pub(super) beside: Vec<[u32; 2]>,
    /// Where sharp edges end, meet or turn, in m.
    pub(super) corners_m: Vec<[f64; 3]>,
}

impl Features {
    pub(super) fn of(surface: &ClosedSurface) -> Self {
        let edges = Edges::of(&surface.triangles);
        let normal = |t: u32| unit(doubled_area(surface.corners_m(t as usize)));
        let limit = SHARP_DEG.to_radians().cos();
        let sharp = |sides: &[Side]| match sides {
            [a, b] => {
                let (m, n) = (normal(a.triangle), normal(b.triangle));
                // Nothing can be said of a face without a normal.
                dot(m, m) > 0.5 && dot(n, n) > 0.5 && dot(m, n) < limit
            }
            _ => false,
        };
        Self::between(surface, patches(&edges, surface.triangles.len(), &sharp))
    }

    /// The edges between triangles of different `patch` as the sharp ones.
    pub(super) fn between(surface: &ClosedSurface, patch: Vec<u32>) -> Self {
        let (mut lines, mut beside) = (Vec::new(), Vec::new());
        for sides in Edges::of(&surface.triangles).iter() {
            let [first, second] = sides else { continue };
            let mut pair = [first, second].map(|side| patch[side.triangle as usize]);
            pair.sort_unstable();
            if pair[0] != pair[1] {
                lines.push(first.edge);
                beside.push(pair);
            }
        }
        let segments: Vec<[u32; 3]> = lines.iter().map(|&[a, b]| [a, b, b]).collect();
        Self {
            patch,
            segments: Tree::new(&surface.points_m, &segments),
            beside,
            corners_m: corners(surface, &lines),
        }
    }

    /// The nearest point, within `bound_m`, of sharp edges whose patches `wanted` accepts, and those
    /// patches.
    pub(super) fn nearest(
        &self,
        p: [f64; 3],
        bound_m: f64,
        wanted: impl Fn([u32; 2]) -> bool,
    ) -> Option<([f64; 3], [u32; 2], f64)> {
        let near = self
            .segments
            .nearest(p, bound_m, |s| wanted(self.beside[s as usize]))?;
        let pair = self.beside[near.triangle as usize];
        Some((near.point, pair, near.distance_m))
    }
}

/// Numbers the parts that hang together by edges that are not sharp.
fn patches(edges: &Edges, triangles: usize, sharp: &impl Fn(&[Side]) -> bool) -> Vec<u32> {
    let mut joined: Vec<Vec<u32>> = vec![Vec::new(); triangles];
    for sides in edges.iter().filter(|sides| !sharp(sides)) {
        for pair in sides.windows(2) {
            joined[pair[0].triangle as usize].push(pair[1].triangle);
            joined[pair[1].triangle as usize].push(pair[0].triangle);
        }
    }
    let mut patch = vec![u32::MAX; triangles];
    let mut number = 0;
    for start in 0..triangles {
        if patch[start] != u32::MAX {
            continue;
        }
        patch[start] = number;
        let mut stack = vec![start];
        while let Some(at) = stack.pop() {
            for &other in &joined[at] {
                if patch[other as usize] == u32::MAX {
                    patch[other as usize] = number;
                    stack.push(other as usize);
                }
            }
        }
        number += 1;
    }
    patch
}

/// Points where not just two sharp edges meet, or the two turn.
fn corners(surface: &ClosedSurface, lines: &[[u32; 2]]) -> Vec<[f64; 3]> {
    let mut ends: HashMap<u32, Vec<u32>> = HashMap::new();
    for &[a, b] in lines {
        ends.entry(a).or_default().push(b);
        ends.entry(b).or_default().push(a);
    }
    let place = |i: u32| surface.points_m[i as usize];
    let straight = CORNER_DEG.to_radians().cos();
    let mut corners: Vec<u32> = ends
        .into_iter()
        .filter(|(at, others)| match others[..] {
            [p, q] => {
                let [to, from] = [p, q].map(|end| unit(sub(place(end), place(*at))));
                -dot(to, from) < straight
            }
            _ => true,
        })
        .map(|(at, _)| at)
        .collect();
    corners.sort_unstable();
    corners.into_iter().map(place).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::solid::{Repair, gallery, repair};

    #[test]
    fn a_box_has_twelve_edges_and_a_cylinder_two() {
        let cube = gallery::cuboid([1.0, 2.0, 3.0]);
        let cube = Features::of(&repair(&cube, &Repair::default()).unwrap());
        assert_eq!((cube.beside.len(), cube.corners_m.len()), (12, 8));
        let can = gallery::cylinder(0.1, 0.3, 48);
        let can = Features::of(&repair(&can, &Repair::default()).unwrap());
        assert_eq!((can.beside.len(), can.corners_m.len()), (96, 0));
        assert_eq!(can.patch.iter().max(), Some(&2));
    }
}
