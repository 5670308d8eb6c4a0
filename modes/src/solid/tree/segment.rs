//! Where a straight line between two points goes through the triangles.

use super::super::vector::{cross, dot, sub};
use super::{Node, Tree};

impl Tree {
    /// Shares of the way from `from` to `to`, rising, at which a triangle is crossed.
    pub(in crate::solid) fn hits(&self, from: [f64; 3], to: [f64; 3]) -> Vec<f64> {
        let way = sub(to, from);
        let mut hits = Vec::new();
        let mut stack = vec![0usize];
        while let Some(at) = stack.pop() {
            let Some(node) = self.nodes.get(at) else {
                break;
            };
            if !meets(node, from, way) {
                continue;
            }
            if node.count == 0 {
                stack.extend([at + 1, node.second as usize]);
            } else {
                hits.extend(
                    self.leaf(node)
                        .filter_map(|t| hit(self.corners[t], from, way)),
                );
            }
        }
        hits.sort_by(f64::total_cmp);
        // The two triangles at an edge are one crossing.
        hits.dedup_by(|a, b| (*a - *b).abs() < 1e-9);
        hits
    }
}

/// Whether the line goes through a box, by the overlap of its stays between the three pairs of sides.
fn meets(node: &Node, from: [f64; 3], way: [f64; 3]) -> bool {
    let (mut enter, mut leave) = (0.0f64, 1.0f64);
    for a in 0..3 {
        if way[a] == 0.0 {
            if from[a] < node.low[a] || from[a] > node.high[a] {
                return false;
            }
            continue;
        }
        let (s, t) = (
            (node.low[a] - from[a]) / way[a],
            (node.high[a] - from[a]) / way[a],
        );
        enter = enter.max(s.min(t));
        leave = leave.min(s.max(t));
    }
    enter <= leave
}

/// Möller & Trumbore 1997, with both sides of the triangle and a hair beyond its edges.
fn hit([a, b, c]: [[f64; 3]; 3], from: [f64; 3], way: [f64; 3]) -> Option<f64> {
    const HAIR: f64 = 1e-12;
    let (ab, ac) = (sub(b, a), sub(c, a));
    let p = cross(way, ac);
    let det = dot(ab, p);
    if det == 0.0 {
        return None;
    }
    let s = sub(from, a);
    let u = dot(s, p) / det;
    let q = cross(s, ab);
    let v = dot(way, q) / det;
    let t = dot(ac, q) / det;
    let inside = u >= -HAIR && v >= -HAIR && u + v <= 1.0 + HAIR;
    (inside && (0.0..=1.0).contains(&t)).then_some(t)
}
