//! How thick the parts of a body are.

use super::ClosedSurface;
use super::body::Body;
use super::vector::{add, doubled_area, lerp, norm, scale, sub, unit, whole};

/// Triangles that are looked from, spread evenly over the area.
const LOOKS: usize = 1000;

/// The share of the surface that may be thinner: the tips of wedges are.
const THINNER: f64 = 0.06;

/// The thickness, in m, that all but a small share of the surface has behind it; `None` where nothing
/// can be seen.
pub(super) fn thickness_m(surface: &ClosedSurface, body: &Body) -> Option<f64> {
    let (low, high) = surface.bounds_m();
    let across = norm(sub(high, low));
    let areas = (0..surface.triangles.len()).map(|t| norm(doubled_area(surface.corners_m(t))));
    let step = areas.clone().sum::<f64>() / LOOKS as f64;
    let (mut passed, mut seen) = (0.0, Vec::with_capacity(LOOKS));
    for (t, area) in areas.enumerate() {
        let before = whole(passed / step);
        passed += area;
        let looks = whole(passed / step) - before;
        if looks == 0 {
            continue;
        }
        let corners = surface.corners_m(t);
        let middle = scale(corners.into_iter().fold([0.0; 3], add), 1.0 / 3.0);
        let inward = scale(unit(doubled_area(corners)), -1.0);
        let from = add(middle, scale(inward, 1e-6 * across));
        let outside = add(middle, scale(inward, -1e-6 * across));
        if body.enclosed(outside).0 {
            // One part's face inside another bounds nothing.
            continue;
        }
        let to = add(from, scale(inward, across));
        let through = body.tree().hits(from, to).into_iter();
        let mut ends = through.filter(|share| !body.enclosed(lerp(from, to, share + 1e-6)).0);
        if let Some(share) = ends.next() {
            seen.extend(std::iter::repeat_n(share * across, looks));
        }
    }
    seen.sort_by(f64::total_cmp);
    seen.get(whole(THINNER * seen.len() as f64)).copied()
}
