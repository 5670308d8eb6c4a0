//! Two layers of points and what joins them.

use crate::fem::{TET10_EDGES, tet10_jacobians};
use crate::mesh::{Elements, Mesh};
use crate::solid::fit::Curved;
use crate::solid::stuffing::{Tets, wedge};
use crate::solid::vector::{add, lerp, norm, scale, six_volumes, unit};
use std::collections::{HashMap, HashSet};

/// The least Jacobian of a curved element over that of the straight one.
const LEAST: f64 = 0.1;

/// Rounds of straightening edges.
const STRAIGHTENINGS: usize = 6;

/// How alike, over their length, two arrows are that differ only in their way.
const ALIKE: f64 = 1e-3;

/// A point of the wall: on the outer or the inner layer, by its number in the surface.
#[derive(Clone, Copy)]
struct Corner {
    inner: bool,
    base: u32,
}

/// The surface's triangles, twice.
pub(super) struct Layers {
    /// Triangles of the surface: corners, then middles of edges.
    faces: Vec<[u32; 6]>,
    /// The middle of each edge.
    middles: HashMap<[u32; 2], u32>,
    /// Places on the outer and the inner layer of each point of the surface.
    places: HashMap<u32, [[f64; 3]; 2]>,
    /// Its number on the outer layer; on the inner it is one more.
    numbers: HashMap<u32, u32>,
}

impl Layers {
    /// Of the boundary of `filled`, whose corners are moved by `offsets`; the middles of edges follow.
    pub(super) fn new(filled: &Curved, offsets: &HashMap<u32, [f64; 3]>) -> Self {
        let mut layers = Self {
            faces: filled.boundary.clone(),
            middles: HashMap::new(),
            places: HashMap::new(),
            numbers: HashMap::new(),
        };
        // Corners first, so that a mesh with straight edges has the first numbers.
        for face in &filled.boundary {
            for &base in &face[..3] {
                layers.place(base, filled.mesh.nodes[base as usize], offsets[&base]);
            }
        }
        for face in &filled.boundary {
            for (k, &base) in face[3..].iter().enumerate() {
                let ends = [face[k], face[(k + 1) % 3]];
                layers.middles.insert(sorted(ends), base);
                let [d, e] = ends.map(|end| offsets[&end]);
                let arrow = between(d, e);
                layers.place(base, filled.mesh.nodes[base as usize], arrow);
            }
        }
        layers
    }

    fn place(&mut self, base: u32, outer: [f64; 3], arrow: [f64; 3]) {
        let next = 2 * self.numbers.len() as u32;
        self.numbers.entry(base).or_insert(next);
        self.places.insert(base, [outer, add(outer, arrow)]);
    }

    fn number(&self, corner: Corner) -> u32 {
        self.numbers[&corner.base] + u32::from(corner.inner)
    }

    /// The point of the surface in the middle of an edge's ends, or above both if they lie over each
    /// other.
    fn middle(&self, ends: [Corner; 2]) -> u32 {
        match ends[0].base == ends[1].base {
            true => ends[0].base,
            false => self.middles[&sorted(ends.map(|end| end.base))],
        }
    }

    /// The wedges' tetrahedra.
    fn tets(&self) -> Vec<[Corner; 4]> {
        let mut tets = Vec::with_capacity(3 * self.faces.len());
        for &[a, b, c, ..] in &self.faces {
            let layer = |inner| [a, b, c].map(|base| Corner { inner, base });
            // By number, so that neighbours agree and no three diagonals go round in a circle.
            let down = [a < b, b < c, c < a];
            wedge(layer(true), layer(false), down, &mut |tet| tets.push(tet));
        }
        tets
    }

    /// Points of both layers by their numbers.
    fn points(&self) -> Vec<[f64; 3]> {
        let mut points = vec![[0.0; 3]; 2 * self.numbers.len()];
        for (base, &number) in &self.numbers {
            let [outer, inner] = self.places[base];
            points[number as usize] = outer;
            points[number as usize + 1] = inner;
        }
        points
    }

    /// The surface's corners under tetrahedra for which `bad` holds.
    pub(super) fn corners_where(&self, bad: impl Fn([u32; 4]) -> bool) -> HashSet<u32> {
        let tets = self.tets().into_iter();
        tets.filter(|tet| bad(tet.map(|corner| self.number(corner))))
            .flat_map(|tet| tet.map(|corner| corner.base))
            .collect()
    }

    /// With straight edges.
    pub(super) fn straight(&self) -> Tets {
        let tets = self.tets().into_iter();
        Tets {
            points: self.points(),
            tets: tets
                .map(|tet| tet.map(|corner| self.number(corner)))
                .collect(),
        }
    }

    /// With the middles of edges on the curved layers where no element is turned inside out.
    pub(super) fn curved(&self) -> Option<Curved> {
        let mut nodes = self.points();
        let mut between: HashMap<[u32; 2], u32> = HashMap::new();
        let mut tets = Vec::new();
        for tet in self.tets() {
            tets.push(std::array::from_fn(|node| {
                if node < 4 {
                    return self.number(tet[node]);
                }
                let ends = TET10_EDGES[node - 4].map(|corner| tet[corner]);
                let (inner, base) = (ends[0].inner, self.middle(ends));
                if inner == ends[1].inner {
                    return self.number(Corner { inner, base });
                }
                let key = sorted(ends.map(|end| self.number(end)));
                *between.entry(key).or_insert_with(|| {
                    let [outer, inner] = self.places[&base];
                    nodes.push(lerp(outer, inner, 0.5));
                    nodes.len() as u32 - 1
                })
            }));
        }
        let straight = straighten(&mut nodes, &tets)?;
        Some(Curved {
            boundary: self.boundary(),
            straight_share: straight as f64 / nodes.len() as f64,
            mesh: Mesh {
                nodes,
                elements: Elements::Tet10(tets),
            },
        })
    }

    /// Both layers' triangles, outward from the wall.
    fn boundary(&self) -> Vec<[u32; 6]> {
        let layer = |face: [u32; 6], inner| face.map(|base| self.number(Corner { inner, base }));
        let outer = self.faces.iter().map(|&face| layer(face, false));
        let inner = self.faces.iter();
        let inner = inner.map(|&[a, b, c, ab, bc, ca]| layer([a, c, b, ca, bc, ab], true));
        outer.chain(inner).collect()
    }
}

/// Straightens the edges of elements that are bent inside out, and of those that this bends; returns
/// how many, `None` if that goes on.
fn straighten(nodes: &mut [[f64; 3]], tets: &[[u32; 10]]) -> Option<usize> {
    let mut straight = HashSet::new();
    for _ in 0..STRAIGHTENINGS {
        let unsound = |tet: &&[u32; 10]| {
            let places = tet.map(|node| nodes[node as usize]);
            let straight = six_volumes([places[0], places[1], places[2], places[3]]);
            let jacobians = tet10_jacobians(&places);
            jacobians
                .iter()
                .any(|jacobian| *jacobian < LEAST * straight)
        };
        let bad: Vec<&[u32; 10]> = tets.iter().filter(unsound).collect();
        if bad.is_empty() {
            return Some(straight.len());
        }
        for tet in bad {
            for (edge, &node) in TET10_EDGES.iter().zip(&tet[4..]) {
                let [p, q] = edge.map(|corner| nodes[tet[corner] as usize]);
                nodes[node as usize] = lerp(p, q, 0.5);
                straight.insert(node);
            }
        }
    }
    None
}

/// The arrow halfway between two: as long as they are where they turn along a round part, their middle
/// where one leads to the edge of a flat one.
fn between(d: [f64; 3], e: [f64; 3]) -> [f64; 3] {
    let middle = scale(add(d, e), 0.5);
    if (norm(d) - norm(e)).abs() < ALIKE * norm(d) {
        scale(unit(middle), norm(d))
    } else {
        middle
    }
}

fn sorted([p, q]: [u32; 2]) -> [u32; 2] {
    [p.min(q), p.max(q)]
}
