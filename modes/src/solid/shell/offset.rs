//! Where the nodes of a surface go when it is moved inwards.

use super::cubic::Cubic;
use super::outer::Outer;
use crate::fem::{CUBIC_SHARES, cubic_gradients};
use crate::solid::fit::Hold;
use crate::solid::vector::{add, cross, dot, scale, sub, unit};

/// Rounds of stepping onto the offset of each smooth part in turn.
const ROUNDS: usize = 200;

/// The normals around a node, one for each smooth part there.
type Normals = Vec<(Option<u32>, [f64; 3])>;

/// For each node the arrow to the offset: `wall_m` along the normal of the curved triangles; at edges and
/// corners the shortest that is `wall_m` deep below each of the smooth parts that meet there. How far such an
/// arrow leads aside is spread evenly over the triangles beside.
pub(super) fn offsets(outer: &Outer, cubic: &Cubic, wall_m: f64) -> Vec<[f64; 3]> {
    let normals = normals(outer, cubic);
    let mut arrows: Vec<[f64; 3]> = normals
        .iter()
        .map(|normals| arrow(normals.iter().map(|(_, normal)| *normal), wall_m))
        .collect();
    let corners = arrows[..outer.points.len()].to_vec();
    // What leads aside at a corner, of the parts that a node near it is on.
    let aside = |corner: u32, parts: &Normals| {
        let known = &normals[corner as usize];
        let own = |part: &Option<u32>| {
            let same = known.iter().find(|(other, _)| other == part);
            same.or(known.iter().find(|(other, _)| other.is_none()))
        };
        let own: Option<Vec<[f64; 3]>> = parts
            .iter()
            .map(|(part, _)| own(part).map(|(_, normal)| *normal))
            .collect();
        own.map_or([0.0; 3], |own| {
            sub(corners[corner as usize], arrow(own.into_iter(), wall_m))
        })
    };
    let mut done = vec![false; arrows.len()];
    for face in &cubic.faces {
        for (&node, shares) in face.iter().zip(CUBIC_SHARES).skip(3) {
            let at = node as usize;
            if std::mem::replace(&mut done[at], true) {
                continue;
            }
            for (&corner, share) in face[..3]
                .iter()
                .zip(shares)
                .filter(|(_, share)| *share > 0.0)
            {
                arrows[at] = add(arrows[at], scale(aside(corner, &normals[at]), share));
            }
        }
    }
    arrows
}

/// Unit normals of the curved triangles around each node, by smooth part; of all parts at once at a corner that
/// is amid a smooth part.
fn normals(outer: &Outer, cubic: &Cubic) -> Vec<Normals> {
    let slopes = CUBIC_SHARES.map(|[_, r, s]| cubic_gradients([r, s]));
    let mut normals: Vec<Normals> = vec![Normals::new(); cubic.points.len()];
    for (face, part) in cubic.faces.iter().zip(&outer.parts) {
        for (&node, slopes) in face.iter().zip(&slopes) {
            let mut along = [[0.0; 3]; 2];
            for (&other, slope) in face.iter().zip(slopes) {
                for (way, by) in along.iter_mut().zip(slope) {
                    *way = add(*way, scale(cubic.points[other as usize], *by));
                }
            }
            let area = cross(along[0], along[1]);
            let smooth = matches!(outer.holds.get(node as usize), Some(Hold::Face(_)));
            let own = if smooth { None } else { *part };
            let parts = &mut normals[node as usize];
            match parts.iter_mut().find(|(other, _)| *other == own) {
                Some((_, sum)) => *sum = add(*sum, area),
                None => parts.push((own, area)),
            }
        }
    }
    for (_, normal) in normals.iter_mut().flatten() {
        *normal = unit(*normal);
    }
    normals
}

/// The shortest arrow that is `wall_m` deep below planes of these normals.
fn arrow(normals: impl Iterator<Item = [f64; 3]> + Clone, wall_m: f64) -> [f64; 3] {
    let mut arrow = [0.0; 3];
    // Projections onto planes in turn end nearest to where they began (Kaczmarz 1937).
    for _ in 0..ROUNDS {
        for normal in normals.clone() {
            arrow = add(arrow, scale(normal, -(dot(normal, arrow) + wall_m)));
        }
    }
    arrow
}
