//! Triangles in nested boxes: what is near a point, on a line, around a point.

mod nearest;
mod segment;
mod winding;

pub(super) use nearest::Near;

use super::vector::{add, bounds, scale};
use winding::Dipole;

/// Triangles in a box that is not divided further.
const LEAF: usize = 4;

/// Triangles in a binary tree of boxes.
pub(super) struct Tree {
    nodes: Vec<Node>,
    /// Corners of the triangles, in the order of the leaves.
    corners: Vec<[[f64; 3]; 3]>,
    /// The caller's number of each.
    numbers: Vec<u32>,
}

struct Node {
    low: [f64; 3],
    high: [f64; 3],
    /// First triangle of a leaf.
    first: u32,
    /// Triangles of a leaf; 0 for a node with children.
    count: u32,
    /// The second child; the first follows its parent.
    second: u32,
    dipole: Dipole,
}

impl Tree {
    /// Of these triangles, which may be without area.
    pub(super) fn new(points: &[[f64; 3]], triangles: &[[u32; 3]]) -> Self {
        let corners_of = |t: &u32| triangles[*t as usize].map(|i| points[i as usize]);
        let mut items: Vec<(u32, [f64; 3])> = (0..u32::try_from(triangles.len())
            .unwrap_or(u32::MAX))
            .map(|t| {
                let [p, q, r] = corners_of(&t);
                (t, scale(add(add(p, q), r), 1.0 / 3.0))
            })
            .collect();
        let mut tree = Self {
            nodes: Vec::new(),
            corners: Vec::with_capacity(items.len()),
            numbers: Vec::with_capacity(items.len()),
        };
        if !items.is_empty() {
            tree.build(&mut items, &corners_of);
        }
        tree
    }

    /// Appends the tree of `items`; returns its root.
    fn build(
        &mut self,
        items: &mut [(u32, [f64; 3])],
        corners_of: &impl Fn(&u32) -> [[f64; 3]; 3],
    ) -> usize {
        let root = self.nodes.len();
        let (low, high) = bounds(items.iter().flat_map(|(t, _)| corners_of(t)));
        let corners = items.iter().map(|(t, _)| corners_of(t));
        self.nodes.push(Node {
            low,
            high,
            first: index(self.corners.len()),
            count: index(items.len()),
            second: 0,
            dipole: Dipole::of(corners),
        });
        if items.len() <= LEAF {
            for (t, _) in items.iter() {
                self.corners.push(corners_of(t));
                self.numbers.push(*t);
            }
            return root;
        }
        let (low, high) = bounds(items.iter().map(|(_, middle)| *middle));
        let widest = (0..3)
            .max_by(|&a, &b| (high[a] - low[a]).total_cmp(&(high[b] - low[b])))
            .unwrap_or(0);
        let half = items.len() / 2;
        items.select_nth_unstable_by(half, |(_, p), (_, q)| p[widest].total_cmp(&q[widest]));
        let (first, second) = items.split_at_mut(half);
        self.build(first, corners_of);
        let second = self.build(second, corners_of);
        self.nodes[root].count = 0;
        self.nodes[root].second = index(second);
        root
    }

    /// Triangles of a leaf.
    fn leaf(&self, node: &Node) -> std::ops::Range<usize> {
        node.first as usize..(node.first + node.count) as usize
    }
}

fn index(at: usize) -> u32 {
    u32::try_from(at).unwrap_or(u32::MAX)
}

#[cfg(test)]
pub(in crate::solid) mod tests {
    use super::*;
    use crate::solid::vector::{distance, doubled_area, norm};

    /// A unit cube's faces, outward.
    pub(in crate::solid) fn cube() -> (Vec<[f64; 3]>, Vec<[u32; 3]>) {
        let points = (0..8)
            .map(|c| [c & 1, c >> 1 & 1, c >> 2].map(f64::from))
            .collect();
        let faces = [
            [0, 2, 3, 1],
            [4, 5, 7, 6],
            [0, 1, 5, 4],
            [2, 6, 7, 3],
            [0, 4, 6, 2],
            [1, 3, 7, 5],
        ];
        let triangles = faces
            .iter()
            .flat_map(|&[a, b, c, d]| [[a, b, c], [a, c, d]])
            .collect();
        (points, triangles)
    }

    #[test]
    fn a_cube_is_where_it_is() {
        let (points, triangles) = cube();
        let tree = Tree::new(&points, &triangles);
        let middle = [0.5, 0.4, 0.3];
        assert!((tree.winding(middle) - 1.0).abs() < 1e-12);
        assert!(tree.winding([0.5, 0.4, 1.3]).abs() < 1e-12);
        let near = tree
            .nearest([0.5, 0.4, 1.3], f64::INFINITY, |_| true)
            .unwrap();
        assert!(distance(near.point, [0.5, 0.4, 1.0]) < 1e-12);
        let hits = tree.hits(middle, [0.5, 0.4, 1.3]);
        assert_eq!(hits.len(), 1);
        assert!((hits[0] - 0.7).abs() < 1e-12);
    }

    #[test]
    fn far_away_a_sphere_winds_as_its_triangles_do() {
        let (points, triangles) = crate::solid::gallery::sphere(1.0, 3).into_parts();
        let tree = Tree::new(&points, &triangles);
        for k in 0..200 {
            let t = f64::from(k);
            let p = scale(
                [(1.3 * t).sin(), (2.1 * t).cos(), (0.7 * t).sin()],
                0.1 * (t % 17.0),
            );
            if (norm(p) - 1.0).abs() < 0.05 {
                continue;
            }
            let exact: f64 = triangles
                .iter()
                .map(|t| winding::solid_angle(t.map(|i| points[i as usize]), p))
                .sum::<f64>()
                / (4.0 * std::f64::consts::PI);
            let fast = tree.winding(p);
            assert!((exact - fast).abs() < 0.05, "{p:?}: {exact} {fast}");
            let area = doubled_area(triangles[0].map(|i| points[i as usize]));
            assert!(norm(area) > 0.0);
        }
    }
}
