//! A stuffed mesh brought to the body's edges and corners, and its elements improved.

mod cover;
mod curve;
mod relax;

pub(super) use curve::{Curved, curve};

use super::body::{Body, Side};
use super::features::Features;
use super::quality::volume_length;
use super::stuffing::Tets;
use super::topology::Faces;
use super::vector::lerp;
use std::collections::HashSet;
use std::ops::ControlFlow;

/// Rounds of moving towards edges and improving.
const ROUNDS: usize = 18;

/// Rounds after which goals not yet reached are given up, and other points may go instead.
const PATIENCE: usize = 6;

/// What a point of the mesh may not leave.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Hold {
    /// Inside: goes anywhere.
    Free,
    /// On a smooth part of the surface.
    Face(u32),
    /// On the surface inside a wall.
    Inner,
    /// On a sharp edge between two smooth parts.
    Edge([u32; 2]),
    /// At a corner.
    Corner,
}

/// A mesh with what its points hold to.
pub(super) struct Fit<'a> {
    pub(super) body: &'a Body,
    pub(super) features: &'a Features,
    pub(super) mesh: Tets,
    pub(super) holds: Vec<Hold>,
    /// Where a point still has to go, in m.
    goals: Vec<Option<[f64; 3]>>,
    /// Triangles of the boundary, outward, and their tetrahedra.
    pub(super) boundary: Vec<([u32; 3], u32)>,
    /// Tetrahedra around each point.
    stars: Lists,
    /// Points next to each point; along the boundary for one that is on it.
    beside: Lists,
    /// A cell's longest side, in m.
    pub(super) cell_m: f64,
    /// Points whose goals were given up.
    barred: HashSet<usize>,
}

/// Short lists back to back.
struct Lists {
    start: Vec<u32>,
    items: Vec<u32>,
}

impl Lists {
    /// `pairs` of list and item, repeats left out.
    fn of(lists: usize, mut pairs: Vec<(u32, u32)>) -> Self {
        pairs.sort_unstable();
        pairs.dedup();
        let mut start = vec![0; lists + 1];
        for &(list, _) in &pairs {
            start[list as usize + 1] += 1;
        }
        for list in 0..lists {
            start[list + 1] += start[list];
        }
        Self {
            start,
            items: pairs.into_iter().map(|(_, item)| item).collect(),
        }
    }

    fn get(&self, list: usize) -> &[u32] {
        &self.items[self.start[list] as usize..self.start[list + 1] as usize]
    }
}

impl<'a> Fit<'a> {
    /// Of a mesh whose boundary points are on the body's surface.
    pub(super) fn new(body: &'a Body, features: &'a Features, mesh: Tets, cell_m: f64) -> Self {
        let boundary = Faces::of(&mesh.tets).outside(&mesh.tets);
        let count = mesh.points.len();
        let mut holds = vec![Hold::Free; count];
        for &corner in boundary.iter().flat_map(|(face, _)| face) {
            let (at, p) = (corner as usize, mesh.points[corner as usize]);
            if holds[at] == Hold::Free {
                holds[at] = match body.side(p) {
                    Side::Inner => Hold::Inner,
                    side @ Side::Outer => body
                        .project(p, cell_m, side, |_| true)
                        .map_or(Hold::Free, |near| {
                            Hold::Face(features.patch[near.triangle as usize])
                        }),
                };
            }
        }
        let star = (0u32..)
            .zip(&mesh.tets)
            .flat_map(|(t, tet)| tet.map(|corner| (corner, t)));
        let stars = Lists::of(count, star.collect());
        let mut beside: Vec<(u32, u32)> = boundary
            .iter()
            .flat_map(|&([a, b, c], _)| [(a, b), (b, c), (c, a), (b, a), (c, b), (a, c)])
            .collect();
        for tet in &mesh.tets {
            let free = tet.iter().filter(|&&i| holds[i as usize] == Hold::Free);
            beside.extend(
                free.flat_map(|&i| tet.iter().filter(move |&&j| j != i).map(move |&j| (i, j))),
            );
        }
        Self {
            body,
            features,
            holds,
            goals: vec![None; count],
            boundary,
            stars,
            beside: Lists::of(count, beside),
            mesh,
            cell_m,
            barred: HashSet::new(),
        }
    }

    /// Brings points to edges and corners and improves the elements; `told` hears of each round.
    pub(super) fn fit(
        &mut self,
        told: impl Fn(usize, usize) -> ControlFlow<()>,
    ) -> ControlFlow<()> {
        self.aim();
        for round in 0..ROUNDS {
            told(round, ROUNDS)?;
            self.approach();
            if round % PATIENCE == PATIENCE - 1 {
                self.release();
                if round + PATIENCE < ROUNDS {
                    self.aim();
                }
            }
            if !self.relax() {
                break;
            }
        }
        ControlFlow::Continue(())
    }

    /// The smooth part that a triangle of the boundary lies on; none within a wall.
    pub(super) fn part(&self, face: [u32; 3]) -> Option<u32> {
        let holds = face.map(|i| self.holds[i as usize]);
        if holds.contains(&Hold::Inner) {
            return None;
        }
        let own = holds.iter().find_map(|hold| match hold {
            Hold::Face(patch) => Some(*patch),
            _ => None,
        });
        own.or_else(|| {
            let [p, q, r] = face.map(|i| self.mesh.points[i as usize]);
            let middle = lerp(lerp(p, q, 0.5), r, 1.0 / 3.0);
            let near = self
                .body
                .project(middle, self.cell_m, Side::Outer, |_| true)?;
            Some(self.features.patch[near.triangle as usize])
        })
    }

    /// Points that did not get where they should.
    pub(super) fn short(&self) -> usize {
        self.barred.len()
    }

    /// Sends points to edges and corners.
    fn aim(&mut self) {
        for snap in cover::snaps(self) {
            self.holds[snap.point] = snap.hold;
            self.goals[snap.point] = Some(snap.goal);
        }
    }

    /// Gives up goals that are out of reach, and leaves the points on the smooth part beside.
    fn release(&mut self) {
        for point in 0..self.goals.len() {
            if self.goals[point].take().is_none() {
                continue;
            }
            self.barred.insert(point);
            let here = self.mesh.points[point];
            if let Some(near) = self.body.project(here, self.cell_m, Side::Outer, |_| true) {
                self.holds[point] = Hold::Face(self.features.patch[near.triangle as usize]);
            }
        }
    }

    /// Whether a point is on a smooth part and may be sent to its edge.
    fn can_go(&self, point: u32) -> bool {
        let point = point as usize;
        matches!(self.holds[point], Hold::Face(_)) && !self.barred.contains(&point)
    }

    fn corners(&self, tet: u32) -> [[f64; 3]; 4] {
        self.mesh.tets[tet as usize].map(|i| self.mesh.points[i as usize])
    }

    /// The worst quality around a point if it were at `p`.
    fn worst_at(&self, point: usize, p: [f64; 3]) -> f64 {
        let quality = |&tet: &u32| {
            volume_length(self.mesh.tets[tet as usize].map(|i| {
                if i as usize == point {
                    p
                } else {
                    self.mesh.points[i as usize]
                }
            }))
        };
        let star = self.stars.get(point).iter().map(quality);
        star.fold(f64::INFINITY, f64::min)
    }
}
