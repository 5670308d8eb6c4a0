//! Which points of a lattice are inside a body, and where its edges leave it.

use super::super::body::Body;
use super::super::lattice::{Lattice, NEIGHBOURS};
use super::super::vector::{distance, lerp};
use rayon::prelude::*;
use std::collections::HashMap;

/// A point moves onto a cut nearer than this share of an edge along the axes, or of a diagonal one:
/// in cubic cells no dihedral angle below 10.78° or above 164.74° is left (Labelle & Shewchuk 2007,
/// Table 1).
const MOVES: [f64; 2] = [0.24999, 0.41189];

/// How near the surface, over the cell, a point is on it.
const ON: f64 = 1e-6;

/// Where a lattice point is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum State {
    Inside,
    /// On the boundary, or moved there.
    On,
    Outside,
}

/// The lattice as the body cuts it.
pub(super) struct Cuts {
    pub(super) states: Vec<State>,
    /// Where the points are, moved or not, in m.
    pub(super) places: Vec<[f64; 3]>,
    /// Places of the cuts, in m, from the inner point to the outer.
    cuts: HashMap<(usize, usize), [f64; 3]>,
    /// Whether the surface encloses a point more than once.
    pub(super) overlaps: bool,
    /// Whether a point is enclosed but not in the wall.
    pub(super) hollow: bool,
}

impl Cuts {
    pub(super) fn find(body: &Body, lattice: &Lattice) -> Self {
        let near = ON * lattice.cell_m.iter().copied().fold(f64::INFINITY, f64::min);
        let seen: Vec<([f64; 3], State, bool, bool)> = (0..lattice.len())
            .into_par_iter()
            .with_min_len(256)
            .map(|n| {
                let p = lattice.place(n);
                if !lattice.in_box(n) {
                    return (p, State::Outside, false, false);
                }
                let on = body.tree().nearest(p, near, |_| true);
                if let Some(on) = on.filter(|_| !body.surrounds(p, 100.0 * near)) {
                    return (on.point, State::On, false, false);
                }
                let (enclosed, winding) = body.enclosed(p);
                let inside = enclosed && body.in_wall(p);
                let state = if inside {
                    State::Inside
                } else {
                    State::Outside
                };
                (p, state, winding.abs() > 1.5, enclosed && !inside)
            })
            .collect();
        let mut found = Self {
            states: seen.iter().map(|s| s.1).collect(),
            places: seen.iter().map(|s| s.0).collect(),
            cuts: HashMap::new(),
            overlaps: seen.iter().any(|s| s.2),
            hollow: seen.iter().any(|s| s.3),
        };
        let edges = found.edges(lattice);
        let shares: Vec<f64> = edges
            .par_iter()
            .map(|&(inner, outer, _)| body.end(found.places[inner], found.places[outer]))
            .collect();
        found.settle(&edges, &shares);
        found
    }

    /// Where the edge between an inner and an outer point is cut, in m.
    pub(super) fn place(&self, inner: usize, outer: usize) -> [f64; 3] {
        self.cuts[&(inner, outer)]
    }

    /// Edges from an inner to an outer point, and the kind of each: 0 along the axes, 1 diagonal.
    fn edges(&self, lattice: &Lattice) -> Vec<(usize, usize, usize)> {
        let inner = (0..self.states.len()).filter(|&n| self.states[n] == State::Inside);
        inner
            .flat_map(|n| {
                (0..NEIGHBOURS.len()).filter_map(move |direction| {
                    let other = lattice.neighbour(n, direction)?;
                    let diagonal = NEIGHBOURS[direction].iter().all(|&step| step != 0);
                    (self.states[other] == State::Outside).then_some((
                        n,
                        other,
                        usize::from(diagonal),
                    ))
                })
            })
            .collect()
    }

    /// Moves points onto cuts that are too near, and keeps the other cuts.
    fn settle(&mut self, edges: &[(usize, usize, usize)], shares: &[f64]) {
        let mut nearest: HashMap<usize, (f64, [f64; 3])> = HashMap::new();
        for (&(inner, outer, kind), &share) in edges.iter().zip(shares) {
            let (p, q) = (self.places[inner], self.places[outer]);
            let cut = lerp(p, q, share);
            let mover = match share {
                _ if share < MOVES[kind] => inner,
                _ if share > 1.0 - MOVES[kind] => outer,
                _ => continue,
            };
            let away = distance(self.places[mover], cut);
            let best = nearest.entry(mover).or_insert((away, cut));
            if away < best.0 {
                *best = (away, cut);
            }
        }
        for (&(inner, outer, _), &share) in edges.iter().zip(shares) {
            if !nearest.contains_key(&inner) && !nearest.contains_key(&outer) {
                let cut = lerp(self.places[inner], self.places[outer], share);
                self.cuts.insert((inner, outer), cut);
            }
        }
        for (mover, (_, cut)) in nearest {
            self.places[mover] = cut;
            self.states[mover] = State::On;
        }
    }
}
