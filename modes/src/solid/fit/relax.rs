//! Points moved so that the worst element around each becomes better.

use super::{Fit, Hold};
use crate::solid::body::Side;
use crate::solid::quality::volume_length;
use crate::solid::vector::{add, cross, distance, lerp, scale, sub, unit};

/// No move makes an element worse than this unless it was worse already.
const FLOOR: f64 = 0.2;

/// A star whose worst element is this good is left alone.
const GOOD: f64 = 0.7;

/// The least gain worth a move.
const GAIN: f64 = 1e-4;

impl Fit<'_> {
    /// Moves points towards where they should be, as far as their elements bear it.
    pub(super) fn approach(&mut self) {
        for point in 0..self.goals.len() {
            let Some(goal) = self.goals[point] else {
                continue;
            };
            let here = self.mesh.points[point];
            let least = self.worst_at(point, here).min(FLOOR);
            let bears = |&share: &f64| self.worst_at(point, lerp(here, goal, share)) >= least;
            let Some(share) = [1.0, 0.7, 0.4, 0.2].into_iter().find(bears) else {
                continue;
            };
            self.mesh.points[point] = lerp(here, goal, share);
            if share == 1.0 {
                self.goals[point] = None;
            }
        }
    }

    /// One sweep over all points; whether any moved.
    pub(super) fn relax(&mut self) -> bool {
        let mut moved = self.goals.iter().any(Option::is_some);
        for point in 0..self.holds.len() {
            if self.holds[point] == Hold::Corner || self.goals[point].is_some() {
                continue;
            }
            let here = self.mesh.points[point];
            let worst = self.worst_at(point, here);
            if worst > GOOD {
                continue;
            }
            if let Some(better) = self.better(point, here, worst) {
                self.mesh.points[point] = better;
                moved = true;
            }
        }
        moved
    }

    /// A place where the worst element around a point is better.
    fn better(&self, point: usize, here: [f64; 3], worst: f64) -> Option<[f64; 3]> {
        let middle = self.middle(point);
        let lift = unit(self.lift(point, worst));
        let mut best = (worst + GAIN, None);
        for (way, shares) in [
            (sub(middle, here), [1.0, 0.6, 0.3, 0.1]),
            (scale(lift, self.cell_m), [0.3, 0.15, 0.06, 0.02]),
        ] {
            for share in shares {
                let Some(p) = self.held(point, here, add(here, scale(way, share))) else {
                    continue;
                };
                let quality = self.worst_at(point, p);
                if quality > best.0 {
                    best = (quality, Some(p));
                }
            }
        }
        best.1
    }

    /// The middle of the points beside one that it may follow: on an edge those on the same edge.
    fn middle(&self, point: usize) -> [f64; 3] {
        let hold = self.holds[point];
        let follows = |&&other: &&u32| match (hold, self.holds[other as usize]) {
            (Hold::Edge(own), Hold::Edge(other)) => own == other,
            (Hold::Edge(_), other) => other == Hold::Corner,
            _ => true,
        };
        let (mut sum, mut count) = ([0.0; 3], 0.0);
        for &other in self.beside.get(point).iter().filter(follows) {
            sum = add(sum, self.mesh.points[other as usize]);
            count += 1.0;
        }
        if count > 0.0 {
            scale(sum, 1.0 / count)
        } else {
            self.mesh.points[point]
        }
    }

    /// The way in which the worst element around a point gains volume.
    fn lift(&self, point: usize, worst: f64) -> [f64; 3] {
        let bad = self.stars.get(point).iter();
        let bad = bad.filter(|&&tet| volume_length(self.corners(tet)) <= worst + GAIN);
        bad.map(|&tet| {
            let corners = self.mesh.tets[tet as usize];
            let own = corners.iter().position(|&i| i as usize == point);
            let places = self.corners(tet);
            // Opposite each corner a face that sees it on its inner side.
            let [a, b, c] = [[1, 3, 2], [0, 2, 3], [0, 3, 1], [0, 1, 2]][own.unwrap_or(0)];
            let inward = cross(sub(places[b], places[a]), sub(places[c], places[a]));
            unit(inward)
        })
        .fold([0.0; 3], add)
    }

    /// `p` brought back to what a point, now at `here`, may not leave.
    fn held(&self, point: usize, here: [f64; 3], p: [f64; 3]) -> Option<[f64; 3]> {
        let bound_m = distance(here, p);
        match self.holds[point] {
            Hold::Free => Some(p),
            Hold::Face(patch) => {
                let own = |t: u32| self.features.patch[t as usize] == patch;
                Some(self.body.project(p, bound_m, Side::Outer, own)?.point)
            }
            Hold::Inner => Some(self.body.project(p, bound_m, Side::Inner, |_| true)?.point),
            Hold::Edge(pair) => {
                let own = |other| pair == other;
                Some(self.features.nearest(p, 1.001 * bound_m, own)?.0)
            }
            Hold::Corner => None,
        }
    }
}
