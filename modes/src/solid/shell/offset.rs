//! Where the points of a surface go when it is moved inwards.

use crate::solid::fit::{Fit, Hold};
use crate::solid::vector::{add, dot, doubled_area, scale, unit};
use std::collections::HashMap;

/// Rounds of stepping onto the offset of each smooth part in turn.
const ROUNDS: usize = 200;

/// The normals' sums over the triangles around a point, for each smooth part there.
type Normals = Vec<(Option<u32>, [f64; 3])>;

/// For each point of the boundary the arrow to the offset: `wall_m` along the normal; at edges and
/// corners the shortest that is `wall_m` deep below each of the smooth parts that meet there.
pub(super) fn offsets(fit: &Fit, wall_m: f64) -> HashMap<u32, [f64; 3]> {
    let mut normals: HashMap<u32, Normals> = HashMap::new();
    for (face, _) in &fit.boundary {
        let area = doubled_area(face.map(|i| fit.mesh.points[i as usize]));
        let part = fit.part(*face);
        for corner in *face {
            let smooth = matches!(fit.holds[corner as usize], Hold::Face(_));
            let own = if smooth { None } else { part };
            let parts = normals.entry(corner).or_default();
            match parts.iter_mut().find(|(other, _)| *other == own) {
                Some((_, sum)) => *sum = add(*sum, area),
                None => parts.push((own, area)),
            }
        }
    }
    let arrows = normals.into_iter();
    arrows
        .map(|(corner, parts)| (corner, arrow(parts, wall_m)))
        .collect()
}

fn arrow(parts: Normals, wall_m: f64) -> [f64; 3] {
    let normals: Vec<[f64; 3]> = parts.into_iter().map(|(_, sum)| unit(sum)).collect();
    let mut arrow = [0.0; 3];
    // Projections onto planes in turn end nearest to where they began (Kaczmarz 1937).
    for _ in 0..ROUNDS {
        for &normal in &normals {
            arrow = add(arrow, scale(normal, -(dot(normal, arrow) + wall_m)));
        }
    }
    arrow
}
