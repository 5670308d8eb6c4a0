//! Two layers of nodes and the wedges between them.

use super::cubic::Cubic;
use crate::fem::{CUBIC_NODES, WEDGE_NODES, wedge23_least_jacobian};
use crate::mesh::{Elements, Mesh};
use crate::solid::stuffing::{Tets, wedge};
use crate::solid::vector::{add, lerp, six_volumes};
use std::collections::{HashMap, HashSet};

/// The least Jacobian of a curved wedge over the mean of the straight one.
const LEAST: f64 = 0.1;

/// Rounds of straightening wedges.
const STRAIGHTENINGS: usize = 6;

/// The triangles' corners twice: the outer ones, then the inner ones in the same order.
pub(super) fn straight(outer: &[[f64; 3]], inner: &[[f64; 3]], faces: &[[u32; 3]]) -> Tets {
    let mut tets = Vec::with_capacity(3 * faces.len());
    for face in faces {
        let [a, b, c] = *face;
        let below = face.map(|corner| corner + outer.len() as u32);
        // By number, so that neighbours agree and no three diagonals go round in a circle.
        let down = [a < b, b < c, c < a];
        wedge(below, *face, down, &mut |tet| tets.push(tet));
    }
    let points = outer.iter().chain(inner).copied().collect();
    Tets { points, tets }
}

/// The surface's corners under tetrahedra for which `bad` holds.
pub(super) fn corners_where(tets: &Tets, bad: impl Fn([[f64; 3]; 4]) -> bool) -> HashSet<u32> {
    let outer = tets.points.len() as u32 / 2;
    let places = |tet: &[u32; 4]| tet.map(|i| tets.points[i as usize]);
    let bad = tets.tets.iter().filter(|tet| bad(places(tet)));
    bad.flat_map(|tet| tet.map(|i| i % outer)).collect()
}

/// Curved wedges between the surface's nodes and those moved by `arrows`, and the share of triangles made flat
/// because their wedges would have been turned inside out; `None` if that is not enough.
pub(super) fn curved(cubic: &mut Cubic, arrows: &mut [[f64; 3]]) -> Option<(Mesh, f64)> {
    let mut flat = HashSet::new();
    for round in 1..=STRAIGHTENINGS {
        let mesh = wedges(cubic, arrows);
        let Elements::Wedge23(wedges) = &mesh.elements else {
            return None;
        };
        let bad: Vec<usize> = (0..wedges.len())
            .filter(|&face| !sound(&wedges[face].map(|node| mesh.nodes[node as usize])))
            .collect();
        if bad.is_empty() {
            let share = flat.len() as f64 / cubic.faces.len() as f64;
            return Some((mesh, share));
        }
        for face in bad {
            cubic.flatten(face, arrows, round + 1 >= STRAIGHTENINGS);
            flat.insert(face);
        }
    }
    None
}

/// Whether the wedge's Jacobian keeps well above 0.
fn sound(nodes: &[[f64; 3]; WEDGE_NODES]) -> bool {
    let [a, b, c] = [0, 1, 2].map(|k| nodes[k]);
    let [d, e, f] = [0, 1, 2].map(|k| nodes[CUBIC_NODES + k]);
    let tets = [[a, b, c, f], [a, b, f, e], [a, e, f, d]];
    // The triangle's coordinates and the height's span a volume of one.
    let mean = tets.into_iter().map(six_volumes).sum::<f64>() / 6.0;
    wedge23_least_jacobian(nodes) > LEAST * mean
}

fn wedges(cubic: &Cubic, arrows: &[[f64; 3]]) -> Mesh {
    let inner = cubic.points.len() as u32;
    let moved = cubic
        .points
        .iter()
        .zip(arrows)
        .map(|(p, arrow)| add(*p, *arrow));
    let mut nodes: Vec<[f64; 3]> = cubic.points.iter().copied().chain(moved).collect();
    let mut between: HashMap<u32, u32> = HashMap::new();
    let mut wedges = Vec::with_capacity(cubic.faces.len());
    for face in &cubic.faces {
        let mut wedge = [0; WEDGE_NODES];
        for (k, &node) in face.iter().enumerate() {
            wedge[k] = node + inner;
            wedge[CUBIC_NODES + k] = node;
        }
        for (k, &node) in face[..3].iter().enumerate() {
            wedge[2 * CUBIC_NODES + k] = *between.entry(node).or_insert_with(|| {
                let [above, below] = [node, node + inner].map(|i| nodes[i as usize]);
                nodes.push(lerp(above, below, 0.5));
                nodes.len() as u32 - 1
            });
        }
        wedges.push(wedge);
    }
    Mesh {
        nodes,
        elements: Elements::Wedge23(wedges),
    }
}
