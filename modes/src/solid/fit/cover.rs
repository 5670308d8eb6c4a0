//! Which points of the boundary go to the sharp edges, and where.
//!
//! Every edge of the mesh between two smooth parts needs an end on the sharp edge between them. The
//! fewest such ends, none of them for nothing, never hold all three corners of a triangle, which
//! would be flat.

use super::{Fit, Hold};
use crate::solid::tree::Tree;
use std::collections::HashSet;

/// How far a point goes to a corner, in cells.
const TO_CORNER: f64 = 0.9;

/// How far a point goes to an edge, in cells.
const TO_EDGE: f64 = 0.9;

/// A point that goes to an edge or a corner.
pub(super) struct Snap {
    pub(super) point: usize,
    pub(super) hold: Hold,
    pub(super) goal: [f64; 3],
}

pub(super) fn snaps(fit: &Fit) -> Vec<Snap> {
    let mut snaps = to_corners(fit);
    let at_corner: HashSet<usize> = snaps.iter().map(|snap| snap.point).collect();
    snaps.extend(to_edges(fit, &at_corner));
    snaps
}

/// For each corner the nearest point that no other corner has.
fn to_corners(fit: &Fit) -> Vec<Snap> {
    let mut on: Vec<u32> = fit.boundary.iter().flat_map(|(face, _)| *face).collect();
    on.sort_unstable();
    on.dedup();
    on.retain(|&i| fit.can_go(i) && between_parts(fit, i));
    let places: Vec<[u32; 3]> = on.iter().map(|&i| [i; 3]).collect();
    let tree = Tree::new(&fit.mesh.points, &places);
    let mut taken = HashSet::new();
    let mut snaps = Vec::new();
    let there = (0..fit.holds.len()).filter(|&i| fit.holds[i] == Hold::Corner);
    let there: Vec<[f64; 3]> = there.map(|i| fit.mesh.points[i]).collect();
    let reached = |goal: &[f64; 3]| there.contains(goal);
    for &goal in fit.features.corners_m.iter().filter(|goal| !reached(goal)) {
        let free = |i: u32| !taken.contains(&i);
        if let Some(near) = tree.nearest(goal, TO_CORNER * fit.cell_m, free) {
            taken.insert(near.triangle);
            snaps.push(Snap {
                point: on[near.triangle as usize] as usize,
                hold: Hold::Corner,
                goal,
            });
        }
    }
    snaps
}

/// Whether a point has one of another smooth part beside it: amid a part there is no corner.
fn between_parts(fit: &Fit, point: u32) -> bool {
    let own = fit.holds[point as usize];
    let beside = fit.beside.get(point as usize).iter();
    let mut others = beside.map(|&other| fit.holds[other as usize]);
    others.any(|other| matches!(other, Hold::Face(_)) && other != own)
}

/// Points between two smooth parts, and where their own part's sharp edge is nearest.
fn to_edges(fit: &Fit, at_corner: &HashSet<usize>) -> Vec<Snap> {
    let patch = |i: u32| match fit.holds[i as usize] {
        Hold::Face(patch) => Some(patch),
        _ => None,
    };
    let crossings: Vec<[u32; 2]> = fit
        .boundary
        .iter()
        .flat_map(|&([a, b, c], _)| [[a, b], [b, c], [c, a]])
        .filter(|&[a, b]| a < b && patch(a).is_some() && patch(b).is_some())
        .filter(|&[a, b]| patch(a) != patch(b))
        .filter(|edge| !edge.iter().any(|&i| at_corner.contains(&(i as usize))))
        .collect();
    let mut ends: Vec<u32> = crossings.iter().flatten().copied().collect();
    ends.sort_unstable();
    ends.dedup();
    let mut ways: Vec<(f64, Snap)> = ends
        .iter()
        .filter(|&&i| fit.can_go(i))
        .filter_map(|&i| {
            let p = fit.mesh.points[i as usize];
            let own = |pair: [u32; 2]| patch(i).is_some_and(|own| pair.contains(&own));
            let (goal, pair, away) = fit.features.nearest(p, TO_EDGE * fit.cell_m, own)?;
            let snap = Snap {
                point: i as usize,
                hold: Hold::Edge(pair),
                goal,
            };
            Some((away, snap))
        })
        .collect();
    ways.sort_by(|(a, _), (b, _)| a.total_cmp(b));
    let chosen = cover(&crossings, &ways, fit.mesh.points.len());
    let snaps = ways.into_iter().map(|(_, snap)| snap);
    snaps.filter(|snap| chosen[snap.point]).collect()
}

/// Marks ends that cover every crossing, the nearest first, none of them for nothing.
fn cover(crossings: &[[u32; 2]], ways: &[(f64, Snap)], points: usize) -> Vec<bool> {
    let mut others: Vec<Vec<u32>> = vec![Vec::new(); points];
    for &[a, b] in crossings {
        others[a as usize].push(b);
        others[b as usize].push(a);
    }
    let mut chosen = vec![false; points];
    for (_, snap) in ways {
        let needed = others[snap.point].iter().any(|&i| !chosen[i as usize]);
        chosen[snap.point] = needed;
    }
    for (_, snap) in ways.iter().rev() {
        let for_nothing = others[snap.point].iter().all(|&i| chosen[i as usize]);
        chosen[snap.point] &= !for_nothing;
    }
    chosen
}
