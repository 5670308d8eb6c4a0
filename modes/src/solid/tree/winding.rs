//! How often the triangles wind around a point.

use super::super::vector::{add, cross, distance, dot, doubled_area, norm, scale, sub};
use super::Tree;
use std::f64::consts::PI;

/// A box is a single dipole from this many of its radii on.
const FAR: f64 = 2.5;

/// Triangles seen from afar (Barill et al. 2018, §3.1, first order).
pub(super) struct Dipole {
    middle: [f64; 3],
    /// Area along the normal.
    area: [f64; 3],
    radius: f64,
}

impl Dipole {
    pub(super) fn of(triangles: impl Iterator<Item = [[f64; 3]; 3]> + Clone) -> Self {
        let (mut area, mut weight, mut middle) = ([0.0; 3], 0.0, [0.0; 3]);
        let (mut count, mut plain) = (0.0, [0.0; 3]);
        for corners in triangles.clone() {
            let a = scale(doubled_area(corners), 0.5);
            let m = scale(corners.into_iter().fold([0.0; 3], add), 1.0 / 3.0);
            area = add(area, a);
            weight += norm(a);
            middle = add(middle, scale(m, norm(a)));
            count += 1.0;
            plain = add(plain, m);
        }
        middle = if weight > 0.0 {
            scale(middle, 1.0 / weight)
        } else {
            scale(plain, 1.0 / count)
        };
        let radius = triangles
            .flatten()
            .map(|p| distance(p, middle))
            .fold(0.0, f64::max);
        Self {
            middle,
            area,
            radius,
        }
    }
}

impl Tree {
    /// The generalised winding number (Jacobson et al. 2013): 1 inside a closed outward surface, 0
    /// outside.
    pub(in crate::solid) fn winding(&self, p: [f64; 3]) -> f64 {
        let mut sum = 0.0;
        let mut stack = [0u32; 64];
        let mut depth = usize::from(!self.nodes.is_empty());
        while depth > 0 {
            depth -= 1;
            let at = stack[depth];
            let node = &self.nodes[at as usize];
            let away = sub(node.dipole.middle, p);
            let d = norm(away);
            if d > FAR * node.dipole.radius {
                sum += dot(node.dipole.area, away) / d.powi(3);
            } else if node.count == 0 {
                stack[depth] = at + 1;
                stack[depth + 1] = node.second;
                depth += 2;
            } else {
                sum += self.corners[self.leaf(node)]
                    .iter()
                    .map(|&corners| solid_angle(corners, p))
                    .sum::<f64>();
            }
        }
        sum / (4.0 * PI)
    }
}

/// The solid angle of a triangle from `p` (Van Oosterom & Strackee 1983), positive from behind.
pub(super) fn solid_angle(corners: [[f64; 3]; 3], p: [f64; 3]) -> f64 {
    let [a, b, c] = corners.map(|corner| sub(corner, p));
    let (la, lb, lc) = (norm(a), norm(b), norm(c));
    let above = dot(a, cross(b, c));
    let below = la * lb * lc + dot(a, b) * lc + dot(b, c) * la + dot(c, a) * lb;
    2.0 * above.atan2(below)
}
