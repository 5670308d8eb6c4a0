//! Nodes in the middle of edges, those of the boundary on the body's surface.

use super::{Fit, Hold};
use crate::fem::{TET10_EDGES, tet10_jacobians};
use crate::mesh::{Elements, Mesh};
use crate::solid::body::Side;
use crate::solid::vector::{distance, lerp};
use std::collections::{HashMap, HashSet};

/// A node is not moved farther off the middle of its edge than this share of the edge.
const FARTHEST: f64 = 0.35;

/// The least Jacobian of a curved element over that of the straight one.
const LEAST: f64 = 0.2;

/// Halvings of the way to the surface before an edge is left straight.
const HALVINGS: usize = 3;

/// A mesh of ten-node tetrahedra.
pub(in crate::solid) struct Curved {
    pub(in crate::solid) mesh: Mesh,
    /// Edges of the boundary left straight, over all.
    pub(in crate::solid) straight_share: f64,
}

/// Adds the nodes in the middle.
pub(in crate::solid) fn curve(fit: &Fit) -> Curved {
    let mut nodes = fit.mesh.points.clone();
    let mut middles: HashMap<[u32; 2], u32> = HashMap::with_capacity(8 * nodes.len());
    let tets: Vec<[u32; 10]> = fit
        .mesh
        .tets
        .iter()
        .map(|tet| {
            std::array::from_fn(|node| match node {
                0..4 => tet[node],
                _ => {
                    let edge = sorted(TET10_EDGES[node - 4].map(|corner| tet[corner]));
                    *middles.entry(edge).or_insert_with(|| {
                        let [p, q] = edge.map(|i| fit.mesh.points[i as usize]);
                        nodes.push(lerp(p, q, 0.5));
                        nodes.len() as u32 - 1
                    })
                }
            })
        })
        .collect();
    let goals = goals(fit, &middles);
    let straight = bend(&mut nodes, &tets, &goals);
    Curved {
        straight_share: straight as f64 / goals.len().max(1) as f64,
        mesh: Mesh {
            nodes,
            elements: Elements::Tet10(tets),
        },
    }
}

fn sorted([p, q]: [u32; 2]) -> [u32; 2] {
    [p.min(q), p.max(q)]
}

/// Where the middles of the boundary's edges should be.
fn goals(fit: &Fit, middles: &HashMap<[u32; 2], u32>) -> HashMap<u32, [f64; 3]> {
    let mut sides: HashMap<[u32; 2], Vec<Option<u32>>> = HashMap::new();
    for (face, _) in &fit.boundary {
        let [a, b, c] = *face;
        for edge in [[a, b], [b, c], [c, a]] {
            sides.entry(sorted(edge)).or_default().push(fit.part(*face));
        }
    }
    sides
        .into_iter()
        .filter_map(|(edge, patches)| {
            let [p, q] = edge.map(|i| fit.mesh.points[i as usize]);
            let middle = lerp(p, q, 0.5);
            let goal = goal(fit, edge, &patches, middle)?;
            let near = distance(goal, middle) <= FARTHEST * distance(p, q);
            near.then_some((middles[&edge], goal))
        })
        .collect()
}

/// Where the middle of an edge between triangles on these parts belongs.
fn goal(fit: &Fit, edge: [u32; 2], parts: &[Option<u32>], middle: [f64; 3]) -> Option<[f64; 3]> {
    let holds = edge.map(|i| fit.holds[i as usize]);
    if parts.iter().any(Option::is_none) {
        let inner = holds.iter().all(|hold| *hold == Hold::Inner);
        let point = fit
            .body
            .project(middle, fit.cell_m, Side::Inner, |_| true)?
            .point;
        return inner.then_some(point);
    }
    let on = |pair: [u32; 2], hold| match hold {
        Hold::Edge(own) => own == pair,
        _ => hold == Hold::Corner,
    };
    match *parts {
        [Some(a), Some(b)] if a != b => {
            let pair = sorted([a, b]);
            let along = holds.iter().all(|&hold| on(pair, hold));
            let near = fit
                .features
                .nearest(middle, f64::INFINITY, |other| other == pair)?;
            along.then_some(near.0)
        }
        [Some(a), ..] => {
            let own = |t: u32| fit.features.patch[t as usize] == a;
            Some(
                fit.body
                    .project(middle, fit.cell_m, Side::Outer, own)?
                    .point,
            )
        }
        _ => None,
    }
}

/// Moves nodes to their goals as far as the elements stay sound; returns how many stayed behind.
fn bend(nodes: &mut [[f64; 3]], tets: &[[u32; 10]], goals: &HashMap<u32, [f64; 3]>) -> usize {
    let starts: HashMap<u32, [f64; 3]> = goals
        .keys()
        .map(|&node| (node, nodes[node as usize]))
        .collect();
    for (&node, &goal) in goals {
        nodes[node as usize] = goal;
    }
    let touched: Vec<&[u32; 10]> = tets
        .iter()
        .filter(|tet| tet[4..].iter().any(|node| goals.contains_key(node)))
        .collect();
    let mut behind = HashSet::new();
    for halving in 0..=HALVINGS {
        let bad: HashSet<u32> = touched
            .iter()
            .filter(|tet| !sound(tet.map(|node| nodes[node as usize])))
            .flat_map(|tet| tet[4..].iter().copied())
            .filter(|node| goals.contains_key(node))
            .collect();
        for &node in &bad {
            let here = &mut nodes[node as usize];
            *here = match halving {
                HALVINGS => starts[&node],
                _ => lerp(starts[&node], *here, 0.5),
            };
        }
        behind.extend(bad);
    }
    behind.len()
}

/// Whether the element's Jacobian keeps well above 0 wherever it is integrated and at its nodes.
fn sound(nodes: [[f64; 3]; 10]) -> bool {
    let corners = [nodes[0], nodes[1], nodes[2], nodes[3]];
    let straight = crate::solid::vector::six_volumes(corners);
    let jacobians = tet10_jacobians(&nodes);
    jacobians
        .iter()
        .all(|&jacobian| jacobian > LEAST * straight)
}
