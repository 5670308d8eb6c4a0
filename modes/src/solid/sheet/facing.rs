//! What each triangle of a surface has behind it.

use crate::solid::ClosedSurface;
use crate::solid::body::Body;
use crate::solid::vector::{add, distance, dot, doubled_area, lerp, norm, scale, sub, unit};

/// How alike the way there and the way back are.
const ALIKE: f64 = 0.4;

/// A place behind a triangle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Facing {
    /// The triangle there.
    pub(super) triangle: u32,
    /// How far it is, in m.
    pub(super) way_m: f64,
    /// The cosine between the two outward normals.
    pub(super) cosine: f64,
}

/// For each triangle the one behind its middle, if that has it behind it in turn.
pub(super) fn facing(surface: &ClosedSurface, body: &Body) -> Vec<Option<Facing>> {
    let (low, high) = surface.bounds_m();
    let across_m = norm(sub(high, low));
    let normal = |t: usize| unit(doubled_area(surface.corners_m(t)));
    let behind = |p: [f64; 3], normal: [f64; 3]| {
        let from = add(p, scale(normal, -1e-7 * across_m));
        let to = add(p, scale(normal, -across_m));
        let share = body.tree().hits(from, to).into_iter().next()?;
        let there = lerp(from, to, share);
        let near = body.tree().nearest(there, 1e-6 * across_m, |_| true)?;
        Some((near.triangle, there, distance(p, there)))
    };
    let look = |t: usize| {
        let corners = surface.corners_m(t);
        let middle = scale(corners.into_iter().fold([0.0; 3], add), 1.0 / 3.0);
        let (triangle, there, way_m) = behind(middle, normal(t))?;
        let other = normal(triangle as usize);
        let (_, _, back_m) = behind(there, other)?;
        let mutual = (ALIKE..1.0 / ALIKE).contains(&(back_m / way_m));
        mutual.then_some(Facing {
            triangle,
            way_m,
            cosine: dot(normal(t), other),
        })
    };
    (0..surface.triangles.len()).map(look).collect()
}
