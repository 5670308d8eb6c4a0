//! Polygons into triangles.

use super::super::vector::{add, cross, dot, sub};

/// Corners up to which ears are looked for; the time rises with the cube.
const MOST_EARS: usize = 256;

/// Triangles that cover the polygon `face`, which need be neither convex nor quite plane: ears are
/// cut off one by one (Meisters 1975). Where there is none, a fan winds as often around each point.
pub(in crate::solid) fn cut_polygon(face: &[u32], points: &[[f64; 3]]) -> Vec<[u32; 3]> {
    // From the lowest corner on, so that a face and its back are cut alike.
    let lowest = (0..face.len()).min_by_key(|&i| face[i]).unwrap_or(0);
    let mut left = [&face[lowest..], &face[..lowest]].concat();
    let mut triangles = Vec::with_capacity(face.len().saturating_sub(2));
    let place = |i: u32| points[i as usize];
    let normal = (0..face.len())
        .map(|i| cross(place(face[i]), place(face[(i + 1) % face.len()])))
        .fold([0.0; 3], add);
    while left.len() > 3 && left.len() <= MOST_EARS {
        let n = left.len();
        let corners = |i: usize| [left[(i + n - 1) % n], left[i], left[(i + 1) % n]];
        let ear = (0..n).find(|&i| {
            let [p, q, r] = corners(i).map(place);
            let outward = |a, b, c| dot(cross(sub(b, a), sub(c, a)), normal);
            let inside =
                |x| outward(p, q, x) >= 0.0 && outward(q, r, x) >= 0.0 && outward(r, p, x) >= 0.0;
            let others = left.iter().filter(|other| !corners(i).contains(other));
            outward(p, q, r) > 0.0 && !others.map(|&other| place(other)).any(inside)
        });
        let Some(ear) = ear else { break };
        triangles.push(corners(ear));
        left.remove(ear);
    }
    triangles.extend((2..left.len()).map(|i| [left[0], left[i - 1], left[i]]));
    triangles
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::solid::vector::{doubled_area, norm};

    #[test]
    fn an_arrow_head_is_cut_within_itself() {
        let points = [
            [0.0, 0.0, 5.0],
            [2.0, 1.0, 5.0],
            [0.0, 2.0, 5.0],
            [1.0, 1.0, 5.0],
        ];
        for start in 0..4 {
            let face: Vec<u32> = (0..4).map(|i| (i + start) % 4).collect();
            let area: f64 = cut_polygon(&face, &points)
                .into_iter()
                .map(|t| 0.5 * norm(doubled_area(t.map(|i| points[i as usize]))))
                .sum();
            assert!((area - 1.0).abs() < 1e-12, "{area}");
        }
    }
}
