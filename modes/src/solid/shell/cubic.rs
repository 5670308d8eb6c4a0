//! The nodes of cubic triangles on the surface.

use super::outer::Outer;
use crate::fem::{CUBIC_NODES, CUBIC_SHARES};
use crate::solid::body::Side;
use crate::solid::fit::Hold;
use crate::solid::vector::{add, distance, lerp, scale};
use std::collections::HashMap;

/// A node is not moved farther off its edge than this share of the edge.
const FARTHEST: f64 = 0.35;

/// Cubic triangles.
pub(in crate::solid) struct Cubic {
    /// The corners as in [`Outer::points`], then the others.
    pub(in crate::solid) points: Vec<[f64; 3]>,
    /// Nodes by [`CUBIC_SHARES`], counter-clockwise from outside.
    pub(super) faces: Vec<[u32; CUBIC_NODES]>,
}

/// A triangle's sides, each as the numbers of its ends and of its two nodes between.
const SIDES: [[usize; 4]; 3] = [[0, 1, 3, 4], [1, 2, 5, 6], [2, 0, 7, 8]];

impl Cubic {
    /// On the surface wherever that is not too far off.
    pub(super) fn of(outer: &Outer) -> Self {
        let mut beside: HashMap<[u32; 2], Vec<Option<u32>>> = HashMap::new();
        for (face, part) in outer.faces.iter().zip(&outer.parts) {
            for [from, to, ..] in SIDES {
                let edge = sorted([face[from], face[to]]);
                beside.entry(edge).or_default().push(*part);
            }
        }
        let mut points = outer.points.clone();
        let mut known: HashMap<[u32; 2], [u32; 2]> = HashMap::new();
        let mut faces = Vec::with_capacity(outer.faces.len());
        for (face, part) in outer.faces.iter().zip(&outer.parts) {
            let mut nodes = [0; CUBIC_NODES];
            nodes[..3].copy_from_slice(face);
            for [from, to, first, second] in SIDES {
                let ends = [face[from], face[to]];
                let edge = sorted(ends);
                let between = known.entry(edge).or_insert_with(|| {
                    let sides = &beside[&edge];
                    [1.0 / 3.0, 2.0 / 3.0].map(|share| {
                        points.push(on_edge(outer, edge, sides, share));
                        points.len() as u32 - 1
                    })
                });
                let [one, other] = *between;
                let along = if edge == ends {
                    [one, other]
                } else {
                    [other, one]
                };
                [nodes[first], nodes[second]] = along;
            }
            let corners = face.map(|corner| outer.points[corner as usize]);
            let longest = (0..3).map(|k| distance(corners[k], corners[(k + 1) % 3]));
            let middle = middle(&nodes.map(|node| points[node as usize]));
            let goal = part.and_then(|part| on_part(outer, part, middle));
            points.push(near(goal, middle, longest.fold(0.0, f64::max)));
            nodes[CUBIC_NODES - 1] = points.len() as u32 - 1;
            faces.push(nodes);
        }
        Self { points, faces }
    }

    /// Moves the nodes of a face, and their `arrows`, halfway to where they are evenly between its corners,
    /// or `all` the way.
    pub(super) fn flatten(&mut self, face: usize, arrows: &mut [[f64; 3]], all: bool) {
        let by = if all { 1.0 } else { 0.5 };
        let nodes = self.faces[face];
        for values in [&mut self.points[..], arrows] {
            let corners = [0, 1, 2].map(|k| values[nodes[k] as usize]);
            for (&node, shares) in nodes.iter().zip(CUBIC_SHARES) {
                let weighted = corners
                    .into_iter()
                    .zip(shares)
                    .map(|(p, share)| scale(p, share));
                let even = weighted.fold([0.0; 3], add);
                values[node as usize] = lerp(values[node as usize], even, by);
            }
        }
    }

    /// Whether each node is on an edge of only one triangle.
    pub(in crate::solid) fn open_nodes(&self) -> Vec<bool> {
        let mut triangles = vec![0; self.points.len()];
        // The nodes between tell edges apart.
        for face in &self.faces {
            for node in &face[3..] {
                triangles[*node as usize] += 1;
            }
        }
        let mut open = vec![false; self.points.len()];
        for face in &self.faces {
            for side in SIDES {
                let nodes = side.map(|k| face[k] as usize);
                if triangles[nodes[2]] == 1 {
                    nodes.into_iter().for_each(|node| open[node] = true);
                }
            }
        }
        open
    }

    /// Shortens the `arrows` of all nodes to the shares of their corners, evenly between these.
    pub(super) fn shorten(&self, arrows: &mut [[f64; 3]], shares: &[f64]) {
        let mut own = vec![1.0; arrows.len()];
        for face in &self.faces {
            let corners = [0, 1, 2].map(|k| shares[face[k] as usize]);
            for (&node, weights) in face.iter().zip(CUBIC_SHARES) {
                own[node as usize] = (0..3).map(|k| weights[k] * corners[k]).sum();
            }
        }
        for (arrow, share) in arrows.iter_mut().zip(own) {
            *arrow = scale(*arrow, share);
        }
    }
}

/// Where the middle is that bends no more than the sides do (Zienkiewicz & Taylor 2000, §8.8): the last of
/// the `nodes` is not looked at.
fn middle(nodes: &[[f64; 3]; CUBIC_NODES]) -> [f64; 3] {
    let sum = |nodes: &[[f64; 3]]| nodes.iter().copied().fold([0.0; 3], add);
    let (corners, sides) = (sum(&nodes[..3]), sum(&nodes[3..CUBIC_NODES - 1]));
    add(scale(sides, 0.25), scale(corners, -1.0 / 6.0))
}

/// Where the node at `share` of an edge between triangles on these parts belongs.
fn on_edge(outer: &Outer, edge: [u32; 2], parts: &[Option<u32>], share: f64) -> [f64; 3] {
    let [p, q] = edge.map(|i| outer.points[i as usize]);
    let straight = lerp(p, q, share);
    let holds = edge.map(|i| outer.holds[i as usize]);
    let along = |pair: [u32; 2]| {
        let on = |hold: &Hold| *hold == Hold::Edge(pair) || *hold == Hold::Corner;
        let near = outer
            .features
            .nearest(straight, f64::INFINITY, |other| other == pair);
        near.filter(|_| holds.iter().all(on)).map(|near| near.0)
    };
    let goal = match *parts {
        [Some(a), Some(b)] if a != b => along(sorted([a, b])),
        [Some(a), Some(_)] => on_part(outer, a, straight),
        // The rim of an open side.
        [Some(_)] => holds.iter().find_map(|hold| match hold {
            Hold::Edge(pair) => along(*pair),
            _ => None,
        }),
        _ => None,
    };
    near(goal, straight, distance(p, q))
}

fn on_part(outer: &Outer, part: u32, p: [f64; 3]) -> Option<[f64; 3]> {
    let own = |t: u32| outer.features.patch[t as usize] == part;
    let near = outer.body.project(p, outer.reach_m, Side::Outer, own)?;
    Some(near.point)
}

/// The goal, or where the node is if that is too far for an edge so long.
fn near(goal: Option<[f64; 3]>, straight: [f64; 3], edge_m: f64) -> [f64; 3] {
    let close = |goal: &[f64; 3]| distance(*goal, straight) <= FARTHEST * edge_m;
    goal.filter(close).unwrap_or(straight)
}

pub(super) fn sorted([p, q]: [u32; 2]) -> [u32; 2] {
    [p.min(q), p.max(q)]
}
