//! Where the nodes of a sheet's outer wall have the inner one.

use super::sides::Sides;
use crate::solid::body::Side;
use crate::solid::shell::{Cubic, Outer};
use crate::solid::vector::{add, distance, norm, scale, sub};

/// The longest arrow over the thickness in the middle.
const FARTHEST: f64 = 12.0;

/// For each node the arrow to the inner wall: `along` is one thickness deep, as far as the wall is there, and then the
/// nearest way. From rims it leads to the other side of the rim. `None` where there is no wall near.
pub(super) fn arrows(
    outer: &Outer,
    sides: &Sides,
    cubic: &Cubic,
    along: &[[f64; 3]],
) -> Option<Vec<[f64; 3]>> {
    let bound_m = FARTHEST * sides.middle_m;
    let rims = cubic.open_nodes();
    let inner = |t: u32| sides.is_inner(outer.features.patch[t as usize]);
    let nodes = cubic.points.iter().zip(along).zip(rims);
    nodes
        .map(|((&p, &along), rim)| {
            let near = outer.body.project(p, bound_m, Side::Outer, inner)?;
            let guess = add(p, scale(along, near.distance_m / norm(along)));
            let there = if rim {
                let own = outer
                    .features
                    .nearest(p, bound_m, |pair| sides.rim(pair).is_some())?;
                let line = sides.rim(own.1)?;
                outer
                    .features
                    .nearest(guess, bound_m, |pair| pair == line)?
                    .0
            } else {
                let reach_m = bound_m + distance(p, guess);
                outer
                    .body
                    .project(guess, reach_m, Side::Outer, inner)?
                    .point
            };
            Some(sub(there, p))
        })
        .collect()
}
