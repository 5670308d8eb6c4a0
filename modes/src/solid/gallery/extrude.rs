//! Flat outlines given a thickness.

use super::super::Soup;
use super::super::obj::cut_polygon;

/// A box with a corner at the origin.
#[must_use]
pub fn cuboid(sides_m: [f64; 3]) -> Soup {
    let [x, y, z] = sides_m;
    prism(&[[0.0, 0.0], [x, 0.0], [x, y], [0.0, y]], z)
}

/// The polygon `outline_m` in the x-y plane, counter-clockwise, up to the height `thickness_m`.
#[must_use]
pub fn prism(outline_m: &[[f64; 2]], thickness_m: f64) -> Soup {
    let n = outline_m.len() as u32;
    let at = |z: f64| outline_m.iter().map(move |&[x, y]| [x, y, z]);
    let points: Vec<[f64; 3]> = at(0.0).chain(at(thickness_m)).collect();
    let face: Vec<u32> = (0..n).collect();
    let lid = cut_polygon(&face, &points);
    let mut triangles: Vec<[u32; 3]> = lid.iter().map(|&[a, b, c]| [a, c, b]).collect();
    triangles.extend(lid.iter().map(|t| t.map(|i| i + n)));
    for i in 0..n {
        let j = (i + 1) % n;
        triangles.extend([[i, j, j + n], [i, j + n, i + n]]);
    }
    Soup::single(points, triangles)
}
