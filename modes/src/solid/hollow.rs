//! The wall of a hollow body from the triangles of its outside, made anew.

use super::body::Body;
use super::features::Features;
use super::remesh::remesh;
use super::repair::edges::Edges;
use super::shell::{self, Wall};
use super::vector::{add, doubled_area, norm, scale, sub, unit};
use super::{ClosedSurface, Meshing, Resolution};

/// Nodes of a wall of wedges over its area in squared edges: nineteen to a corner, two triangles to that.
const NODES: f64 = 22.0;

/// The longest edge over the wall where it is flat.
const WIDEST: f64 = 10.0;

/// The longest edge over the square root of the wall times the radius it is bent to: what is left of a bent
/// wall's sharpness is some thousandths then.
const BENT: f64 = 2.0;

/// The longest edge over that radius.
const ROUND: f64 = 0.6;

/// Triangles that are looked at, spread evenly.
const LOOKS: usize = 4000;

/// The wall `wall_m` thick within `surface`; `None` where that is no single sound surface, or folds.
pub(super) fn hollow(
    surface: &ClosedSurface,
    body: &Body,
    features: &Features,
    wall_m: f64,
    how: &Meshing,
) -> Option<Wall> {
    if !clean(surface, body) {
        return None;
    }
    let edge_m = edge_m(surface, features, |_| true, wall_m, how)?;
    let outer = remesh(surface, body, features, |_| true, edge_m)?;
    if !outer.hangs_together() {
        return None;
    }
    shell::wall(&outer, wall_m)
}

/// How long edges are on the smooth parts that are `wanted`, of a wall `wall_m` thick; `None` if that takes more nodes
/// than are allowed.
pub(super) fn edge_m(
    surface: &ClosedSurface,
    features: &Features,
    wanted: impl Fn(u32) -> bool,
    wall_m: f64,
    how: &Meshing,
) -> Option<f64> {
    let own = |t: usize| wanted(features.patch[t]);
    let area_of = |t: usize| 0.5 * norm(doubled_area(surface.corners_m(t)));
    let area_m2: f64 = (0..surface.triangles.len())
        .filter(|&t| own(t))
        .map(area_of)
        .sum();
    let radius_m = area_m2 / bend_m(surface, features, own);
    let bent_m = (BENT * (wall_m * radius_m).sqrt()).min(ROUND * radius_m);
    let edge_m = asked_m(area_m2, how).min(bent_m).min(WIDEST * wall_m);
    let needed = NODES * area_m2 / (edge_m * edge_m);
    (needed <= how.most_nodes as f64).then_some(edge_m)
}

/// How long edges on so much of one side are for the nodes asked for.
pub(super) fn asked_m(area_m2: f64, how: &Meshing) -> f64 {
    match how.resolution {
        Resolution::Nodes(most) => (NODES * area_m2 / most as f64).sqrt(),
        Resolution::CellM(cell_m) => cell_m,
    }
}

/// The integral of curvature: the angles by which the smooth parts turn at edges, times their lengths in m.
fn bend_m(surface: &ClosedSurface, features: &Features, own: impl Fn(usize) -> bool) -> f64 {
    let normal = |t: u32| unit(doubled_area(surface.corners_m(t as usize)));
    let mut bend_m = 0.0;
    for sides in Edges::of(&surface.triangles).iter() {
        let [a, b] = [sides[0], sides[sides.len() - 1]].map(|side| side.triangle);
        if features.patch[a as usize] != features.patch[b as usize] || !own(a as usize) {
            continue;
        }
        let [p, q] = sides[0].edge.map(|end| surface.points_m[end as usize]);
        let turn = norm(sub(normal(a), normal(b)));
        bend_m += turn * norm(sub(p, q));
    }
    bend_m
}

/// Whether just the inner side of every triangle is inside, once.
pub(super) fn clean(surface: &ClosedSurface, body: &Body) -> bool {
    if Edges::of(&surface.triangles).many_faced() > 0 {
        return false;
    }
    let (low, high) = surface.bounds_m();
    let off_m = 1e-6 * norm(sub(high, low));
    let step = surface.triangles.len().div_ceil(LOOKS);
    (0..surface.triangles.len()).step_by(step).all(|t| {
        let corners = surface.corners_m(t);
        let normal = unit(doubled_area(corners));
        let middle = scale(corners.into_iter().fold([0.0; 3], add), 1.0 / 3.0);
        let winding = |by_m: f64| body.enclosed(add(middle, scale(normal, by_m))).1;
        (winding(-off_m) - 1.0).abs() < 0.5 && winding(off_m).abs() < 0.5
    })
}
