//! A surface's triangles made anew, all about equally long, their sharp edges kept (Botsch & Kobbelt 2004).

mod collapse;
mod flip;
mod relax;
mod split;
#[cfg(test)]
mod tests;

use super::body::{Body, Side};
use super::features::Features;
use super::fit::Hold;
use super::shell::Outer;
use super::vector::{dot, doubled_area, norm, unit};
use super::{ClosedSurface, repair::edges::Edges};
use std::collections::{HashMap, HashSet};

/// Rounds of splitting, collapsing, flipping and relaxing.
const ROUNDS: usize = 8;

/// The longest edge over that asked for, and the shortest: what is cut in two or joined stays between.
const LONGEST: f64 = 4.0 / 3.0;
const SHORTEST: f64 = 4.0 / 5.0;

/// The least cosine between a triangle's normal before and after a change.
const TURN: f64 = 0.3;

/// The least height of a triangle over its longest side that a change may leave.
const SLIVER: f64 = 0.05;

/// Triangles on a surface while they are changed.
struct Remesh<'a> {
    body: &'a Body,
    features: &'a Features,
    /// Length in m that edges should have.
    edge_m: f64,
    points: Vec<[f64; 3]>,
    holds: Vec<Hold>,
    /// Corners, or none of a triangle that is gone.
    faces: Vec<Option<[u32; 3]>>,
    /// The smooth part of each.
    parts: Vec<u32>,
    /// Triangles around each point.
    stars: Vec<Vec<u32>>,
    /// Edges along sharp ones, and the parts beside these.
    lines: HashMap<[u32; 2], [u32; 2]>,
}

/// The smooth parts of `surface` that are `wanted` in triangles with edges about `edge_m` long. `None` where these do
/// not fit it.
pub(super) fn remesh<'a>(
    surface: &ClosedSurface,
    body: &'a Body,
    features: &'a Features,
    wanted: impl Fn(u32) -> bool,
    edge_m: f64,
) -> Option<Outer<'a>> {
    let mut mesh = Remesh::new(surface, body, features, wanted, edge_m);
    mesh.collapse();
    for _ in 0..ROUNDS {
        mesh.split();
        mesh.collapse();
        mesh.flip();
        mesh.relax();
    }
    mesh.flip();
    mesh.sound().then(|| mesh.outer())
}

impl<'a> Remesh<'a> {
    fn new(
        surface: &ClosedSurface,
        body: &'a Body,
        features: &'a Features,
        wanted: impl Fn(u32) -> bool,
        edge_m: f64,
    ) -> Self {
        let chosen: Vec<usize> = (0..surface.triangles.len())
            .filter(|&t| wanted(features.patch[t]))
            .collect();
        let mut mesh = Self {
            body,
            features,
            edge_m,
            points: surface.points_m.clone(),
            holds: vec![Hold::Free; surface.points_m.len()],
            faces: chosen.iter().map(|&t| Some(surface.triangles[t])).collect(),
            parts: chosen.iter().map(|&t| features.patch[t]).collect(),
            stars: vec![Vec::new(); surface.points_m.len()],
            lines: HashMap::new(),
        };
        for (face, corners) in (0u32..).zip(&mesh.faces) {
            for corner in corners.iter().flatten() {
                mesh.stars[*corner as usize].push(face);
                mesh.holds[*corner as usize] = Hold::Face(mesh.parts[face as usize]);
            }
        }
        mesh.hold_lines(surface);
        mesh
    }

    /// Finds the edges between parts, and what their ends hold to.
    fn hold_lines(&mut self, surface: &ClosedSurface) {
        for sides in Edges::of(&surface.triangles).iter() {
            let mut own: Vec<u32> = sides
                .iter()
                .map(|side| self.features.patch[side.triangle as usize])
                .collect();
            own.sort_unstable();
            let [first, last] = [own[0], own[own.len() - 1]];
            let edge = sorted(sides[0].edge);
            if first == last || self.beside(edge).is_empty() {
                continue;
            }
            self.lines.insert(edge, [first, last]);
            for end in edge {
                let hold = &mut self.holds[end as usize];
                *hold = match *hold {
                    Hold::Edge(pair) if pair != [first, last] => Hold::Corner,
                    Hold::Corner => Hold::Corner,
                    _ => Hold::Edge([first, last]),
                };
            }
        }
        let corners: HashSet<[u64; 3]> = self
            .features
            .corners_m
            .iter()
            .map(|p| p.map(f64::to_bits))
            .collect();
        for (hold, p) in self.holds.iter_mut().zip(&self.points) {
            if matches!(hold, Hold::Edge(_)) && corners.contains(&p.map(f64::to_bits)) {
                *hold = Hold::Corner;
            }
        }
    }

    /// Triangles beside an edge.
    fn beside(&self, [a, b]: [u32; 2]) -> Vec<u32> {
        let other = &self.stars[b as usize];
        let own = self.stars[a as usize].iter().copied();
        own.filter(|face| other.contains(face)).collect()
    }

    /// Corners of a triangle that is there.
    fn corners(&self, face: u32) -> [u32; 3] {
        self.faces[face as usize].unwrap_or_default()
    }

    fn places(&self, corners: [u32; 3]) -> [[f64; 3]; 3] {
        corners.map(|corner| self.points[corner as usize])
    }

    fn length_m(&self, [a, b]: [u32; 2]) -> f64 {
        super::vector::distance(self.points[a as usize], self.points[b as usize])
    }

    /// Edges, each once.
    fn edges(&self) -> Vec<[u32; 2]> {
        let faces = self.faces.iter().flatten();
        let mut edges: Vec<[u32; 2]> = faces
            .flat_map(|&[a, b, c]| [[a, b], [b, c], [c, a]].map(sorted))
            .collect();
        edges.sort_unstable();
        edges.dedup();
        edges
    }

    /// The points joined to one, each once.
    fn around(&self, point: u32) -> Vec<u32> {
        let faces = self.stars[point as usize].iter();
        let mut others: Vec<u32> = faces
            .flat_map(|&face| self.corners(face))
            .filter(|&other| other != point)
            .collect();
        others.sort_unstable();
        others.dedup();
        others
    }

    /// `p` brought to what a point holds to; `None` where that is not near.
    fn held(&self, p: [f64; 3], hold: Hold) -> Option<[f64; 3]> {
        match hold {
            Hold::Face(part) => {
                let own = |t: u32| self.features.patch[t as usize] == part;
                let near = self.body.project(p, self.edge_m, Side::Outer, own)?;
                Some(near.point)
            }
            Hold::Edge(pair) => {
                let near = self
                    .features
                    .nearest(p, self.edge_m, |other| other == pair)?;
                Some(near.0)
            }
            Hold::Free | Hold::Inner | Hold::Corner => None,
        }
    }

    /// Whether a triangle that turns from one place to another is still one.
    fn bears(from: [[f64; 3]; 3], to: [[f64; 3]; 3]) -> bool {
        let (old, new) = (doubled_area(from), doubled_area(to));
        // What was flat may turn as it will.
        let turned = !flat(from) && dot(unit(old), unit(new)) < TURN;
        !turned && (!flat(to) || flat(from))
    }

    /// Whether each edge has the triangles it should, and none is flat or far too long.
    fn sound(&self) -> bool {
        let edges = self.edges();
        let closed = edges.iter().all(|&edge| match self.beside(edge)[..] {
            [_, _] => true,
            [_] => self.lines.contains_key(&edge),
            _ => false,
        });
        let short = edges
            .iter()
            .all(|&edge| self.length_m(edge) < 2.0 * self.edge_m);
        let full = self
            .faces
            .iter()
            .flatten()
            .all(|&face| !flat(self.places(face)));
        !edges.is_empty() && closed && short && full
    }

    /// Only what is there, numbered anew.
    fn outer(&self) -> Outer<'a> {
        let mut numbers: HashMap<u32, u32> = HashMap::new();
        let mut outer = Outer {
            body: self.body,
            features: self.features,
            points: Vec::new(),
            holds: Vec::new(),
            faces: Vec::new(),
            parts: Vec::new(),
            reach_m: self.edge_m,
        };
        for (face, &part) in self.faces.iter().zip(&self.parts) {
            let Some(face) = face else { continue };
            outer.parts.push(Some(part));
            outer.faces.push(face.map(|corner| {
                *numbers.entry(corner).or_insert_with(|| {
                    outer.points.push(self.points[corner as usize]);
                    outer.holds.push(self.holds[corner as usize]);
                    outer.points.len() as u32 - 1
                })
            }));
        }
        outer
    }
}

/// Whether a triangle is hardly one.
fn flat(places: [[f64; 3]; 3]) -> bool {
    let [p, q, r] = places;
    let longest = [[p, q], [q, r], [r, p]].map(|[p, q]| super::vector::distance(p, q));
    let longest = longest.into_iter().fold(0.0, f64::max);
    norm(doubled_area(places)) < SLIVER * longest * longest
}

fn sorted([p, q]: [u32; 2]) -> [u32; 2] {
    [p.min(q), p.max(q)]
}
