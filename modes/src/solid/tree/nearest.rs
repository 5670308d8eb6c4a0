//! The point of the triangles nearest to a place.

use super::super::vector::{add, dot, scale, sub};
use super::{Node, Tree};

/// A point of a triangle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(in crate::solid) struct Near {
    pub(in crate::solid) point: [f64; 3],
    /// Number of the triangle.
    pub(in crate::solid) triangle: u32,
    /// How far it is, in m.
    pub(in crate::solid) distance_m: f64,
}

impl Tree {
    /// The nearest point, within `bound_m`, of the triangles for which `wanted` holds.
    pub(in crate::solid) fn nearest(
        &self,
        p: [f64; 3],
        bound_m: f64,
        wanted: impl Fn(u32) -> bool,
    ) -> Option<Near> {
        let mut best = bound_m * bound_m;
        let mut found = None;
        let mut stack = [(0u32, 0.0); 64];
        let mut depth = usize::from(!self.nodes.is_empty());
        if depth == 1 {
            stack[0].1 = gap2(&self.nodes[0], p);
        }
        while depth > 0 {
            depth -= 1;
            let (at, gap) = stack[depth];
            if gap > best {
                continue;
            }
            let node = &self.nodes[at as usize];
            if node.count == 0 {
                let children = [at + 1, node.second];
                let [a, b] = children.map(|child| (child, gap2(&self.nodes[child as usize], p)));
                let (near, far) = if a.1 < b.1 { (a, b) } else { (b, a) };
                stack[depth] = far;
                stack[depth + 1] = near;
                depth += 2;
                continue;
            }
            for t in self.leaf(node) {
                let q = on_triangle(self.corners[t], p);
                let d = sub(p, q);
                let d2 = dot(d, d);
                if d2 <= best && wanted(self.numbers[t]) {
                    best = d2;
                    found = Some((q, self.numbers[t]));
                }
            }
        }
        found.map(|(point, triangle)| Near {
            point,
            triangle,
            distance_m: best.sqrt(),
        })
    }
}

/// Square of how far a box is.
fn gap2(node: &Node, p: [f64; 3]) -> f64 {
    (0..3)
        .map(|a| {
            (node.low[a] - p[a])
                .max(p[a] - node.high[a])
                .max(0.0)
                .powi(2)
        })
        .sum()
}

/// The point of a triangle nearest to `p`, by the region of its plane that `p` is over (Ericson 2005,
/// §5.1.5).
fn on_triangle([a, b, c]: [[f64; 3]; 3], p: [f64; 3]) -> [f64; 3] {
    let (ab, ac, ap) = (sub(b, a), sub(c, a), sub(p, a));
    let (d1, d2) = (dot(ab, ap), dot(ac, ap));
    if d1 <= 0.0 && d2 <= 0.0 {
        return a;
    }
    let bp = sub(p, b);
    let (d3, d4) = (dot(ab, bp), dot(ac, bp));
    if d3 >= 0.0 && d4 <= d3 {
        return b;
    }
    let vc = d1 * d4 - d3 * d2;
    if vc <= 0.0 && d1 >= 0.0 && d3 <= 0.0 {
        return add(a, scale(ab, d1 / (d1 - d3)));
    }
    let cp = sub(p, c);
    let (d5, d6) = (dot(ab, cp), dot(ac, cp));
    if d6 >= 0.0 && d5 <= d6 {
        return c;
    }
    let vb = d5 * d2 - d1 * d6;
    if vb <= 0.0 && d2 >= 0.0 && d6 <= 0.0 {
        return add(a, scale(ac, d2 / (d2 - d6)));
    }
    let va = d3 * d6 - d5 * d4;
    if va <= 0.0 && d4 >= d3 && d5 >= d6 {
        return add(b, scale(sub(c, b), (d4 - d3) / ((d4 - d3) + (d5 - d6))));
    }
    let sum = va + vb + vc;
    add(a, add(scale(ab, vb / sum), scale(ac, vc / sum)))
}
