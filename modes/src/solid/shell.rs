//! A thin wall: the triangles of a surface and their offsets joined by wedges of three tetrahedra.

mod layers;
mod offset;

use super::body::Body;
use super::fit::{Curved, Fit};
use super::quality::volume_length;
use super::stuffing::Tets;
use super::vector::{add, scale};
use layers::Layers;
use std::collections::{HashMap, HashSet};

/// How near the surface, over its way along the normal, a point of the offset may come: nearer, two
/// walls meet. Where the wall is already thin, the edge is what is near, however thin it is.
const NEAREST: [f64; 2] = [0.8, 0.4];

/// The share of the wall below which it is thin.
const THIN: f64 = 0.6;

/// The least quality of a wedge's tetrahedra: they are flat where the wall is thin, but not folded.
const WORST: f64 = 0.02;

/// Times that the wall is made thinner where it folds, by so much.
const THINNINGS: (usize, f64) = (10, 0.8);

/// The share of points at which it may be thinner.
const THINNER: f64 = 0.05;

/// A wall, and at how many points it is thinner than asked.
pub(super) struct Wall {
    pub(super) curved: Curved,
    pub(super) straight: Tets,
    pub(super) thinner: usize,
}

/// The wall `wall_m` thick within the boundary of a filled `body`, one element through, thinner in
/// edges so sharp that it folds. `None` where that is not enough.
pub(super) fn wall(body: &Body, filled: &Curved, fit: &Fit, wall_m: f64) -> Option<Wall> {
    let full = offset::offsets(fit, wall_m);
    let mut shares: HashMap<u32, f64> = full.keys().map(|&corner| (corner, 1.0)).collect();
    for _ in 0..=THINNINGS.0 {
        let offsets: HashMap<u32, [f64; 3]> = full
            .iter()
            .map(|(&corner, &arrow)| (corner, scale(arrow, shares[&corner])))
            .collect();
        let layers = Layers::new(filled, &offsets);
        let straight = layers.straight();
        let quality = |tet: [u32; 4]| volume_length(tet.map(|i| straight.points[i as usize]));
        let mut folded = layers.corners_where(|tet| quality(tet) < WORST);
        folded.extend(offsets.iter().filter_map(|(&corner, &arrow)| {
            let inner = add(fit.mesh.points[corner as usize], arrow);
            let share = shares[&corner];
            let nearest = NEAREST[usize::from(share < THIN)];
            let least_m = nearest * share * wall_m;
            let depth_m = body.depth_m(inner, least_m).unwrap_or(0.0);
            (depth_m < least_m).then_some(corner)
        }));
        let thinner = shares.values().filter(|&&share| share < 1.0).count();
        if folded.is_empty() {
            let curved = layers.curved()?;
            return Some(Wall {
                curved,
                straight,
                thinner,
            });
        }
        if thinner as f64 > THINNER * shares.len() as f64 {
            return None;
        }
        thin(&mut shares, &folded);
    }
    None
}

fn thin(shares: &mut HashMap<u32, f64>, folded: &HashSet<u32>) {
    for corner in folded {
        if let Some(share) = shares.get_mut(corner) {
            *share *= THINNINGS.1;
        }
    }
}
