//! Faces that bound nothing.

use super::super::vector::{distance, doubled_area, norm};
use super::{Note, Work};
use std::collections::HashMap;

/// Height over longest side below which a triangle has no area.
const FLAT: f64 = 1e-9;

/// Drops triangles whose corners are one or in a line.
pub(super) fn drop_flat(work: &mut Work) {
    let before = work.triangles.len();
    let points = &work.points;
    work.triangles.retain(|&[a, b, c]| {
        let corners @ [p, q, r] = [a, b, c].map(|i| points[i as usize]);
        let longest = distance(p, q).max(distance(q, r)).max(distance(r, p));
        a != b && b != c && c != a && norm(doubled_area(corners)) > FLAT * longest * longest
    });
    let faces = before - work.triangles.len();
    if faces > 0 {
        work.notes.push(Note::NoArea { faces });
    }
}

/// How often a triangle comes, one way round and the other.
#[derive(Default)]
struct Counts {
    ways: [u32; 2],
}

/// Keeps one of several triangles on the same corners; of two back to back none, unless the whole
/// surface is made double to be seen from both sides.
pub(super) fn drop_doubles(work: &mut Work) {
    let mut counts: HashMap<[u32; 3], Counts> = HashMap::with_capacity(work.triangles.len());
    for &triangle in &work.triangles {
        let (key, way) = sorted(triangle);
        counts.entry(key).or_default().ways[way] += 1;
    }
    let back_to_back = counts.values().filter(|c| c.ways[0] > 0 && c.ways[1] > 0);
    let two_sided = 2 * back_to_back.count() > counts.len();
    let before = work.triangles.len();
    let mut walls = 0;
    work.triangles.retain(|&triangle| {
        let (key, way) = sorted(triangle);
        let Some(count) = counts.get_mut(&key) else {
            return false;
        };
        let [same, other] = [count.ways[way], count.ways[1 - way]];
        match (same, other) {
            (0, _) => false,
            (_, 0) => {
                count.ways[way] = 0;
                true
            }
            _ if two_sided => {
                count.ways = [0, 0];
                true
            }
            _ => {
                count.ways[way] -= 1;
                count.ways[1 - way] -= 1;
                walls += 2;
                false
            }
        }
    });
    let dropped = before - work.triangles.len();
    let doubled = dropped.saturating_sub(walls);
    if walls > 0 {
        work.notes.push(Note::InnerWalls { faces: walls });
    }
    if doubled > 0 {
        work.notes.push(Note::Doubled { faces: doubled });
    }
}

/// The corners in rising order, and which way round they came.
fn sorted(triangle: [u32; 3]) -> ([u32; 3], usize) {
    let mut key = triangle;
    key.sort_unstable();
    let [a, b, c] = triangle;
    let even = [[a, b, c], [b, c, a], [c, a, b]].contains(&key);
    (key, usize::from(!even))
}
