//! Points at the same place become one.

use super::super::vector::{bounds, distance};
use super::{Note, Work};
use std::collections::HashMap;

/// How close two points are one, over the diagonal of the bounding box.
const CLOSE: f64 = 1e-6;

pub(super) fn weld(work: &mut Work) {
    let used = work.triangles.iter().flatten();
    let (low, high) = bounds(used.map(|&i| work.points[i as usize]));
    let close = CLOSE * distance(low, high);
    if close.is_nan() || close <= 0.0 {
        return;
    }
    // Few points lie so near a cell's side that a neighbour must be looked at.
    let cell = 8.0 * close;
    let step = |x: f64, a: usize| ((x - low[a]) / cell).floor() as i64;
    let mut cells: HashMap<[i64; 3], u32> = HashMap::new();
    let mut next = vec![u32::MAX; work.points.len()];
    let mut becomes = vec![u32::MAX; work.points.len()];
    let mut welded = 0;
    for corner in work.triangles.iter_mut().flatten() {
        let at = *corner as usize;
        if becomes[at] == u32::MAX {
            let p = work.points[at];
            let near = [0, 1, 2].map(|a| [step(p[a] - close, a), step(p[a] + close, a)]);
            let twin = corners(near).into_iter().find_map(|key| {
                let mut other = *cells.get(&key)?;
                while other != u32::MAX {
                    if distance(work.points[other as usize], p) <= close {
                        return Some(other);
                    }
                    other = next[other as usize];
                }
                None
            });
            becomes[at] = twin.unwrap_or(*corner);
            if twin.is_none() {
                let head = cells.entry([0, 1, 2].map(|a| step(p[a], a)));
                let head = head.or_insert(u32::MAX);
                next[at] = std::mem::replace(head, *corner);
            } else {
                welded += 1;
            }
        }
        *corner = becomes[at];
    }
    if welded > 0 {
        work.notes.push(Note::Welded { points: welded });
    }
}

/// The cells between two along each axis, without repeats.
fn corners(near: [[i64; 2]; 3]) -> Vec<[i64; 3]> {
    let [xs, ys, zs] = near.map(|[from, to]| from..=to);
    let mut keys = Vec::with_capacity(1);
    for x in xs {
        for y in ys.clone() {
            keys.extend(zs.clone().map(|z| [x, y, z]));
        }
    }
    keys
}
