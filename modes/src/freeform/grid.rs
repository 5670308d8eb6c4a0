//! The strike grid over any closed surface: rays from all around a body's longest axis.

use super::axes::{Frame, doubled_area};
use crate::StrikeLine;
use std::f64::consts::TAU;

/// A place on a small triangle of the surface.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Foot {
    pub(super) nodes: [u32; 3],
    /// Shares of the three nodes.
    pub(super) shares: [f64; 3],
}

/// The grid: its points and what they stand on.
pub(super) struct Grid {
    pub(super) line: StrikeLine,
    pub(super) feet: Vec<Foot>,
}

/// How the rays turn to the ends: at x = ±1 they run along the axis, and well before across it.
const TURN: i32 = 9;

/// Where the rays of the ends meet the axis, in half extents.
const AIM: f64 = 0.8;

impl Grid {
    /// `rows` rows around the longest axis of `columns` points along it each.
    ///
    /// In a frame in which the body is as wide as it is long, rays come from outside towards the axis;
    /// the first triangle that one meets is struck. Where none is in the way, the one nearest to the ray's
    /// aim is: every point lies on the surface.
    pub(super) fn new(
        (nodes, triangles): (&[[f64; 3]], &[[u32; 3]]),
        frame: &Frame,
        (columns, rows): (usize, usize),
    ) -> Self {
        let even = |point: [f64; 3]| {
            let local = frame.local(point);
            [0, 1, 2].map(|a| local[a] / frame.half_m[a])
        };
        let corners: Vec<[[f64; 3]; 3]> = triangles
            .iter()
            .map(|t| t.map(|i| even(nodes[i as usize])))
            .collect();
        let mut feet = Vec::with_capacity(rows * columns);
        for row in 0..rows {
            for column in 0..columns {
                let (aim, from) = ray(
                    column as f64 / (columns - 1) as f64,
                    row as f64 / rows as f64,
                );
                let (index, shares) =
                    first_met(&corners, aim, from).unwrap_or_else(|| nearest(&corners, aim));
                feet.push(Foot {
                    nodes: triangles[index],
                    shares,
                });
            }
        }
        let points = feet.iter().map(|foot| foot.at(|node| nodes[node as usize]));
        let normals = feet.iter().map(|foot| {
            let doubled = doubled_area(&foot.nodes.map(|node| nodes[node as usize]));
            let length = doubled.iter().map(|x| x * x).sum::<f64>().sqrt();
            doubled.map(|x| x / length)
        });
        Self {
            line: StrikeLine {
                points_m: points.collect(),
                normals: normals.collect(),
                rows,
                closed: true,
            },
            feet,
        }
    }
}

impl Foot {
    /// The value here of what is `of` each node.
    pub(super) fn at(&self, of: impl Fn(u32) -> [f64; 3]) -> [f64; 3] {
        let values = self.nodes.map(of);
        [0, 1, 2].map(|a| (0..3).map(|i| self.shares[i] * values[i][a]).sum())
    }
}

/// Where the ray at `position` and `across` aims at, and the direction that it comes from.
fn ray(position: f64, across: f64) -> ([f64; 3], [f64; 3]) {
    let x = 2.0 * position - 1.0;
    let along = x.powi(TURN);
    let out = (1.0 - along * along).max(0.0).sqrt();
    let (sin, cos) = (TAU * across).sin_cos();
    ([AIM * x, 0.0, 0.0], [along, out * cos, out * sin])
}

/// The outermost triangle on the way out from `aim` along `from`, and the shares of its corners (Möller
/// & Trumbore 1997).
fn first_met(
    corners: &[[[f64; 3]; 3]],
    aim: [f64; 3],
    from: [f64; 3],
) -> Option<(usize, [f64; 3])> {
    let mut farthest = (0.0, None);
    for (index, triangle) in corners.iter().enumerate() {
        let Some((distance, shares)) = met(triangle, aim, from) else {
            continue;
        };
        if distance > farthest.0 {
            farthest = (distance, Some((index, shares)));
        }
    }
    farthest.1
}

/// Distance at which the ray leaves through the triangle.
fn met([p, q, r]: &[[f64; 3]; 3], aim: [f64; 3], from: [f64; 3]) -> Option<(f64, [f64; 3])> {
    let [u, v, w] = [sub(*q, *p), sub(*r, *p), sub(aim, *p)];
    let across = cross(v, from);
    let determinant = dot(u, across);
    // Sides that face inwards, or along the ray, are not struck.
    if determinant <= 0.0 {
        return None;
    }
    let first = dot(w, across) / determinant;
    let around = cross(u, w);
    let second = dot(from, around) / determinant;
    let distance = dot(v, around) / determinant;
    let inside = first >= 0.0 && second >= 0.0 && first + second <= 1.0 && distance > 0.0;
    inside.then_some((distance, [1.0 - first - second, first, second]))
}

/// The triangle nearest to `point`, and the shares of its corners at the nearest place.
fn nearest(corners: &[[[f64; 3]; 3]], point: [f64; 3]) -> (usize, [f64; 3]) {
    let mut best = (f64::INFINITY, (0, [1.0, 0.0, 0.0]));
    for (index, triangle) in corners.iter().enumerate() {
        let shares = nearest_on(triangle, point);
        let at = [0, 1, 2].map(|a| (0..3).map(|i| shares[i] * triangle[i][a]).sum::<f64>());
        let way = sub(at, point);
        let square = dot(way, way);
        if square < best.0 {
            best = (square, (index, shares));
        }
    }
    best.1
}

/// Shares of the corners at the place of a triangle nearest to `point` (Ericson, Real-Time Collision
/// Detection, 2005, §5.1.5).
fn nearest_on([a, b, c]: &[[f64; 3]; 3], point: [f64; 3]) -> [f64; 3] {
    let (ab, ac) = (sub(*b, *a), sub(*c, *a));
    let arms = [a, b, c].map(|corner| sub(point, *corner));
    let [d1, d3, d5] = arms.map(|arm| dot(ab, arm));
    let [d2, d4, d6] = arms.map(|arm| dot(ac, arm));
    if d1 <= 0.0 && d2 <= 0.0 {
        return [1.0, 0.0, 0.0];
    }
    if d3 >= 0.0 && d4 <= d3 {
        return [0.0, 1.0, 0.0];
    }
    if d6 >= 0.0 && d5 <= d6 {
        return [0.0, 0.0, 1.0];
    }
    let vc = d1 * d4 - d3 * d2;
    if vc <= 0.0 && d1 >= 0.0 && d3 <= 0.0 {
        let share = d1 / (d1 - d3);
        return [1.0 - share, share, 0.0];
    }
    let vb = d5 * d2 - d1 * d6;
    if vb <= 0.0 && d2 >= 0.0 && d6 <= 0.0 {
        let share = d2 / (d2 - d6);
        return [1.0 - share, 0.0, share];
    }
    let va = d3 * d6 - d5 * d4;
    if va <= 0.0 && d4 >= d3 && d5 >= d6 {
        let share = (d4 - d3) / ((d4 - d3) + (d5 - d6));
        return [0.0, 1.0 - share, share];
    }
    let whole = va + vb + vc;
    [va / whole, vb / whole, vc / whole]
}

fn sub(p: [f64; 3], q: [f64; 3]) -> [f64; 3] {
    [0, 1, 2].map(|a| p[a] - q[a])
}

fn dot(u: [f64; 3], v: [f64; 3]) -> f64 {
    (0..3).map(|a| u[a] * v[a]).sum()
}

fn cross(u: [f64; 3], v: [f64; 3]) -> [f64; 3] {
    [
        u[1] * v[2] - u[2] * v[1],
        u[2] * v[0] - u[0] * v[2],
        u[0] * v[1] - u[1] * v[0],
    ]
}
