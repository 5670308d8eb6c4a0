//! Edges turned where the other diagonal is better.

use super::{Remesh, flat, sorted};
use crate::solid::vector::{add, cross, dot, doubled_area, norm, sub, unit};

/// Rounds of turning, at most.
const ROUNDS: usize = 6;

/// The least cosine between the normals of two triangles whose edge is turned.
const EVEN: f64 = 0.5;

/// How much the two angles that face an edge must exceed π together.
const GAIN: f64 = 1e-6;

impl Remesh<'_> {
    /// Turns edges until each is the shorter diagonal in Delaunay's sense.
    pub(super) fn flip(&mut self) {
        for _ in 0..ROUNDS {
            let mut any = false;
            for edge in self.edges() {
                any |= self.turn(edge);
            }
            if !any {
                break;
            }
        }
    }

    fn turn(&mut self, edge: [u32; 2]) -> bool {
        if self.lines.contains_key(&edge) {
            return false;
        }
        let [first, second] = self.beside(edge)[..] else {
            return false;
        };
        let third = |face: u32| {
            let corners = self.corners(face).into_iter();
            corners.into_iter().find(|corner| !edge.contains(corner))
        };
        let (Some(c), Some(d)) = (third(first), third(second)) else {
            return false;
        };
        if c == d
            || !self.beside([c, d]).is_empty()
            || self.facing(edge, c) + self.facing(edge, d) < std::f64::consts::PI + GAIN
        {
            return false;
        }
        // The way round in which the first triangle has the edge.
        let corners = self.corners(first);
        let at = corners.iter().position(|&corner| corner == c).unwrap_or(0);
        let [a, b] = [corners[(at + 1) % 3], corners[(at + 2) % 3]];
        let new = [[c, a, d], [c, d, b]];
        let old = add(
            unit(doubled_area(self.places(corners))),
            unit(doubled_area(self.places(self.corners(second)))),
        );
        let even = new.into_iter().all(|face| {
            let places = self.places(face);
            let kept = flat(self.places(corners)) || flat(self.places(self.corners(second)));
            (!flat(places) || kept) && dot(unit(doubled_area(places)), unit(old)) > EVEN
        });
        if !even {
            return false;
        }
        self.faces[first as usize] = Some(new[0]);
        self.faces[second as usize] = Some(new[1]);
        self.stars[b as usize].retain(|&face| face != first);
        self.stars[a as usize].retain(|&face| face != second);
        self.stars[d as usize].push(first);
        self.stars[c as usize].push(second);
        debug_assert_eq!(sorted([a, b]), edge);
        true
    }

    /// The angle at a triangle's corner that faces one of its edges.
    fn facing(&self, edge: [u32; 2], corner: u32) -> f64 {
        let [p, q] = edge.map(|end| sub(self.points[end as usize], self.points[corner as usize]));
        norm(cross(p, q)).atan2(dot(p, q))
    }
}
