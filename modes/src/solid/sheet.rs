//! A closed surface around a thin sheet: wedges from one of its walls to the other.

mod facing;
mod inner;
mod sides;

use super::body::Body;
use super::features::Features;
use super::hollow::{asked_m, clean, edge_m};
use super::remesh::remesh;
use super::shell::{Wall, between};
use super::thickness::thickness_m;
use super::{ClosedSurface, Meshing};
use facing::facing;
use sides::Sides;

/// The shortest edge over the thickness: below that cells go through the sheet well enough.
const NARROWEST: f64 = 0.8;

/// The greatest cosines between the outward normals of two walls that are tried in turn: with the first more of a lip
/// that tapers or is round is taken for walls, with the second their ends are cleaner.
const OPPOSITE: [f64; 2] = [-0.5, -0.75];

/// How far the volume of the wedges may be off that of the surface: what is lost are rounded rims.
const LOST: f64 = 0.02;

/// The sheet within `surface` as wedges, and the least and greatest thickness of all but a small share of it, in m;
/// `None` where it is none, or not all over.
pub(super) fn sheet(surface: &ClosedSurface, how: &Meshing) -> Option<(Wall, [f64; 2])> {
    let body = Body::new(surface, None);
    // Most bodies are thick enough for cells: that much is soon seen.
    let seen_m = thickness_m(surface, &body)?;
    let half_m2 = 0.5 * surface.area_m2();
    if asked_m(half_m2, how) < NARROWEST * seen_m || !clean(surface, &body) {
        return None;
    }
    let sharp = Features::of(surface);
    let facing = facing(surface, &body);
    let tried = OPPOSITE.into_iter();
    let mut found = tried.filter_map(|opposite| {
        let sides = Sides::of(surface, &sharp, &facing, opposite)?;
        let wall = between_sides(surface, &body, &sides, how)?;
        let share = wall.volume_m3() / surface.volume_m3();
        ((share - 1.0).abs() < LOST).then_some((wall, sides.thickness_m))
    });
    found.next()
}

/// Wedges from the outer wall to the inner one.
fn between_sides(
    surface: &ClosedSurface,
    body: &Body,
    sides: &Sides,
    how: &Meshing,
) -> Option<Wall> {
    let features = sides.features(surface);
    let wanted = |part| sides.is_outer(part);
    let edge_m = edge_m(surface, &features, wanted, sides.middle_m, how)?;
    if edge_m < NARROWEST * sides.middle_m {
        return None;
    }
    let outer = remesh(surface, body, &features, wanted, edge_m)?;
    if !outer.hangs_together() {
        return None;
    }
    between(&outer, |cubic, along| {
        inner::arrows(&outer, sides, cubic, along)
    })
}
