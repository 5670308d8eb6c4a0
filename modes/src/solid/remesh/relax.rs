//! Points moved to the middle of those around them.

use super::{Remesh, sorted};
use crate::solid::fit::Hold;
use crate::solid::vector::{add, doubled_area, lerp, norm, scale};

/// Sweeps over all points.
const SWEEPS: usize = 3;

/// The share of the way that a point goes.
const WAY: f64 = 0.8;

impl Remesh<'_> {
    pub(super) fn relax(&mut self) {
        for _ in 0..SWEEPS {
            for point in 0..self.points.len() as u32 {
                self.ease(point);
            }
        }
    }

    fn ease(&mut self, point: u32) {
        let hold = self.holds[point as usize];
        let goal = match hold {
            Hold::Face(_) => self.middle(point),
            Hold::Edge(_) => self.between(point),
            _ => None,
        };
        let here = self.points[point as usize];
        let Some(there) = goal.and_then(|goal| self.held(lerp(here, goal, WAY), hold)) else {
            return;
        };
        let bears = self.stars[point as usize].iter().all(|&face| {
            let corners = self.corners(face);
            let before = self.places(corners);
            let after = [0, 1, 2].map(|k| {
                if corners[k] == point {
                    there
                } else {
                    before[k]
                }
            });
            Self::bears(before, after)
        });
        if bears {
            self.points[point as usize] = there;
        }
    }

    /// The middle of the triangles around a point.
    fn middle(&self, point: u32) -> Option<[f64; 3]> {
        let (mut sum, mut whole) = ([0.0; 3], 0.0);
        for &face in &self.stars[point as usize] {
            let places = self.places(self.corners(face));
            let area = norm(doubled_area(places));
            let middle = scale(places.into_iter().fold([0.0; 3], add), 1.0 / 3.0);
            sum = add(sum, scale(middle, area));
            whole += area;
        }
        (whole > 0.0).then(|| scale(sum, 1.0 / whole))
    }

    /// The middle of the two points beside one on its sharp edge.
    fn between(&self, point: u32) -> Option<[f64; 3]> {
        let along = |&other: &u32| self.lines.contains_key(&sorted([point, other]));
        match self
            .around(point)
            .into_iter()
            .filter(along)
            .collect::<Vec<_>>()[..]
        {
            [p, q] => Some(lerp(self.points[p as usize], self.points[q as usize], 0.5)),
            _ => None,
        }
    }
}
