//! A surface in smaller triangles, for what changes faster over it than its shape does.

use super::edges::edges;
use super::{Motions, Solid, Vector, unit};
use std::collections::HashMap;

/// The motion of a surface whose edges have been halved.
#[derive(Clone, Debug)]
pub(super) struct Halved {
    of: Motions,
    /// The ends of the edges in whose middles the further points are.
    ends: Vec<[u32; 2]>,
}

impl Halved {
    pub(super) fn motion(&self, mode: usize) -> Vec<Vector> {
        let mut motion = self.of.motion(mode);
        let middles = middles(&self.ends, &motion);
        motion.extend(middles);
        motion
    }
}

fn middles(ends: &[[u32; 2]], of: &[Vector]) -> Vec<Vector> {
    let middle = |[a, b]: [u32; 2]| -> Vector {
        let [a, b] = [a, b].map(|i| of[i as usize]);
        // The same from either end, to the bit.
        [0, 1, 2].map(|k| 0.5 * (a[k] + b[k]))
    };
    ends.iter().map(|ends| middle(*ends)).collect()
}

impl Solid {
    /// The same surface, each triangle cut into four as often as there are no more than `most` triangles then.
    #[must_use]
    pub(crate) fn finer(self, most: usize) -> Self {
        let mut solid = self;
        while !solid.triangles.is_empty() && 4 * solid.triangles.len() <= most {
            solid = solid.quartered();
        }
        solid
    }

    fn quartered(mut self) -> Self {
        let first = self.points_m.len() as u32;
        let mut known: HashMap<[u32; 2], u32> = HashMap::new();
        let mut ends: Vec<[u32; 2]> = Vec::new();
        let mut middle = |a: u32, b: u32| {
            let name = [a.min(b), a.max(b)];
            *known.entry(name).or_insert_with(|| {
                ends.push(name);
                first + ends.len() as u32 - 1
            })
        };
        let mut triangles = Vec::with_capacity(4 * self.triangles.len());
        for [a, b, c] in &self.triangles {
            let [ab, bc, ca] = [middle(*a, *b), middle(*b, *c), middle(*c, *a)];
            triangles.extend([[*a, ab, ca], [*b, bc, ab], [*c, ca, bc], [ab, bc, ca]]);
        }
        let points = middles(&ends, &self.points_m);
        self.points_m.extend(points);
        let normals = middles(&ends, &self.normals);
        self.normals.extend(normals.into_iter().map(unit));
        if !self.places.is_empty() {
            let place =
                |[a, b]: &[u32; 2]| 0.5 * (self.places[*a as usize] + self.places[*b as usize]);
            let places: Vec<f32> = ends.iter().map(place).collect();
            self.places.extend(places);
        }
        Self {
            edges: edges(&triangles, &self.points_m),
            triangles,
            motions: Motions::Halved(Box::new(Halved {
                of: self.motions,
                ends,
            })),
            ..self
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::{cross, dot};
    use super::*;
    use crate::factory;

    fn volume_m3(solid: &Solid) -> f32 {
        let corner = |i: u32| solid.points_m[i as usize];
        let six = |t: &[u32; 3]| dot(corner(t[0]), cross(corner(t[1]), corner(t[2])));
        solid.triangles.iter().map(six).sum::<f32>() / 6.0
    }

    /// Of a bar, which is struck along its length, and of a drum, which is drawn.
    #[test]
    fn the_surface_stays_closed_where_it_was_and_moves_as_it_did() {
        for name in ["vibraphone", "square-drums"] {
            let index = factory::BANKS.iter().position(|(other, _)| *other == name);
            let bank = factory::bank(index.unwrap());
            let coarse = Solid::of(&bank.bodies[3], &bank.material);
            let count = coarse.triangles.len();
            let fine = coarse.clone().finer(16 * count + 1);
            assert_eq!(fine.triangles.len(), 16 * count);
            assert_eq!(2 * fine.edges.len(), 3 * fine.triangles.len());
            let [before, after] = [&coarse, &fine].map(volume_m3);
            assert!(
                (after - before).abs() <= 1e-4 * before.abs() + 1e-12,
                "{before} {after}"
            );
            let (known, all) = (coarse.motion(2), fine.motion(2));
            assert_eq!(all.len(), fine.points_m.len());
            assert_eq!(known[..], all[..known.len()]);
            let most = known.iter().fold(0.0f32, |most, u| most.max(dot(*u, *u)));
            assert!(all.iter().all(|u| dot(*u, *u) <= 1.0001 * most));
            assert_eq!(fine.normals.len(), fine.points_m.len());
            let places = fine.places_struck();
            for (place, point) in coarse.places_struck().into_iter().zip(&places) {
                assert_eq!(place, *point);
            }
            assert_eq!(coarse.clone().finer(count).triangles.len(), count);
        }
    }
}
