//! Which triangles meet at which edges.

use super::Vector;
use std::collections::HashMap;

/// Two points and two triangles for each edge that two triangles share; points at one place count as one.
pub(super) fn edges(triangles: &[[u32; 3]], points_m: &[Vector]) -> Vec<[u32; 4]> {
    let mut first: HashMap<[u32; 3], u32> = HashMap::new();
    let same: Vec<u32> = (0..)
        .zip(points_m)
        // Adding 0 turns −0 to 0.
        .map(|(i, point)| *first.entry(point.map(|x| (x + 0.0).to_bits())).or_insert(i))
        .collect();
    let mut open: HashMap<[u32; 2], [u32; 3]> = HashMap::new();
    let mut edges = Vec::with_capacity(3 * triangles.len() / 2);
    for (number, triangle) in (0..).zip(triangles) {
        for k in 0..3 {
            let ends = [triangle[k], triangle[(k + 1) % 3]];
            let mut name = ends.map(|i| same[i as usize]);
            name.sort_unstable();
            match open.remove(&name) {
                Some([from, to, other]) => edges.push([from, to, other, number]),
                None => {
                    open.insert(name, [ends[0], ends[1], number]);
                }
            }
        }
    }
    edges
}
