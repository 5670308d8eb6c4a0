//! A thin wall: cubic triangles of a surface and their offsets joined by wedges.

mod cubic;
mod layers;
mod offset;
mod outer;

use super::quality::volume_length;
use super::stuffing::Tets;
use super::vector::{add, scale};
use crate::mesh::Mesh;
pub(super) use cubic::Cubic;
pub(super) use outer::Outer;
use std::collections::HashSet;

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
    pub(super) mesh: Mesh,
    /// Its wedges with straight edges, as tetrahedra.
    pub(super) straight: Tets,
    /// Triangles that had to stay flat, over all.
    pub(super) flat_share: f64,
    pub(super) thinner: usize,
}

impl Wall {
    /// Its volume in m³.
    pub(super) fn volume_m3(&self) -> f64 {
        self.mesh.volume_m3()
    }
}

/// The wall between `outer` and where the arrows from its nodes lead to: these are told from the nodes and arrows that
/// are one thickness deep below each smooth part. `None` where it folds, or there are no arrows.
pub(super) fn between(
    outer: &Outer,
    arrows: impl Fn(&Cubic, &[[f64; 3]]) -> Option<Vec<[f64; 3]>>,
) -> Option<Wall> {
    let mut cubic = Cubic::of(outer);
    let mut arrows = arrows(&cubic, &offset::offsets(outer, &cubic, 1.0))?;
    let inner = outer.points.iter().zip(&arrows);
    let inner: Vec<[f64; 3]> = inner.map(|(p, arrow)| add(*p, *arrow)).collect();
    let straight = layers::straight(&outer.points, &inner, &outer.faces);
    let (mesh, flat_share) = layers::curved(&mut cubic, &mut arrows)?;
    Some(Wall {
        mesh,
        straight,
        flat_share,
        thinner: 0,
    })
}

/// The wall `wall_m` thick within `outer`, one element through, thinner in edges so sharp that it folds.
/// `None` where that is not enough.
pub(super) fn wall(outer: &Outer, wall_m: f64) -> Option<Wall> {
    let mut cubic = Cubic::of(outer);
    let full = offset::offsets(outer, &cubic, wall_m);
    let mut shares = vec![1.0; outer.points.len()];
    for _ in 0..=THINNINGS.0 {
        let moved =
            |(corner, share): (usize, &f64)| add(outer.points[corner], scale(full[corner], *share));
        let inner: Vec<[f64; 3]> = shares.iter().enumerate().map(moved).collect();
        let straight = layers::straight(&outer.points, &inner, &outer.faces);
        let mut folded = layers::corners_where(&straight, |tet| volume_length(tet) < WORST);
        folded.extend((0u32..).zip(&inner).filter_map(|(corner, &p)| {
            let share = shares[corner as usize];
            let nearest = NEAREST[usize::from(share < THIN)];
            let least_m = nearest * share * wall_m;
            let depth_m = outer.body.depth_m(p, least_m).unwrap_or(0.0);
            (depth_m < least_m).then_some(corner)
        }));
        let thinner = shares.iter().filter(|&&share| share < 1.0).count();
        if folded.is_empty() {
            let mut arrows = full;
            cubic.shorten(&mut arrows, &shares);
            let (mesh, flat_share) = layers::curved(&mut cubic, &mut arrows)?;
            return Some(Wall {
                mesh,
                straight,
                flat_share,
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

fn thin(shares: &mut [f64], folded: &HashSet<u32>) {
    for &corner in folded {
        shares[corner as usize] *= THINNINGS.1;
    }
}
