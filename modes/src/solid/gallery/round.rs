//! Shapes turned about the z axis, and the sphere.

use super::super::Soup;
use super::super::vector::{add, scale, unit};
use std::collections::HashMap;
use std::f64::consts::TAU;

/// A sphere about the origin: an icosahedron's faces divided in four `times` times.
#[must_use]
pub fn sphere(radius_m: f64, times: usize) -> Soup {
    let golden = 0.5 * (1.0 + 5.0f64.sqrt());
    let mut points: Vec<[f64; 3]> = Vec::new();
    for (a, b) in [
        (1.0, golden),
        (-1.0, golden),
        (1.0, -golden),
        (-1.0, -golden),
    ] {
        points.extend([[0.0, a, b], [a, b, 0.0], [b, 0.0, a]].map(unit));
    }
    // The faces are the triples of nearest points.
    let near = |i: usize, j: usize| {
        (0..3).map(|a| points[i][a] * points[j][a]).sum::<f64>() > 0.4 && i != j
    };
    let mut triangles = Vec::new();
    for i in 0..12 {
        for j in i + 1..12 {
            for k in j + 1..12 {
                if near(i, j) && near(j, k) && near(k, i) {
                    let outward = super::super::vector::six_volumes([
                        points[i], points[j], points[k], [0.0; 3],
                    ]) < 0.0;
                    let [i, j, k] = [i as u32, j as u32, k as u32];
                    triangles.push(if outward { [i, j, k] } else { [i, k, j] });
                }
            }
        }
    }
    for _ in 0..times {
        let mut middles: HashMap<[u32; 2], u32> = HashMap::new();
        let mut finer = Vec::with_capacity(4 * triangles.len());
        for &[a, b, c] in &triangles {
            let [p, q, r] = [[a, b], [b, c], [c, a]].map(|[i, j]| {
                *middles.entry([i.min(j), i.max(j)]).or_insert_with(|| {
                    points.push(unit(add(points[i as usize], points[j as usize])));
                    points.len() as u32 - 1
                })
            });
            finer.extend([[a, p, r], [p, b, q], [r, q, c], [p, q, r]]);
        }
        triangles = finer;
    }
    for point in &mut points {
        *point = scale(*point, radius_m);
    }
    Soup::single(points, triangles)
}

/// The closed line of `outline_m`, pairs of distance from the z axis and height, counter-clockwise in
/// that plane, turned about the axis in `around` steps. Points on the axis are one point each.
#[must_use]
pub fn revolve(outline_m: &[[f64; 2]], around: usize) -> Soup {
    let (mut points, mut rings) = (Vec::new(), Vec::new());
    for &[r, z] in outline_m {
        let first = points.len() as u32;
        if r == 0.0 {
            points.push([0.0, 0.0, z]);
            rings.push(vec![first; around]);
        } else {
            points.extend((0..around).map(|step| {
                let (sin, cos) = (TAU * step as f64 / around as f64).sin_cos();
                [r * cos, r * sin, z]
            }));
            rings.push((0..around as u32).map(|step| first + step).collect());
        }
    }
    let mut triangles = Vec::new();
    for (i, ring) in rings.iter().enumerate() {
        let next = &rings[(i + 1) % rings.len()];
        for step in 0..around {
            let over = (step + 1) % around;
            let [a, b, c, d] = [ring[step], ring[over], next[over], next[step]];
            triangles.extend(
                [[a, b, c], [a, c, d]]
                    .into_iter()
                    .filter(|&[p, q, r]| p != q && q != r && r != p),
            );
        }
    }
    Soup::single(points, triangles)
}

/// A torus about the z axis: a circle of `tube_m` at `radius_m`, in `around` steps one way and half as
/// many the other.
#[must_use]
pub fn torus(radius_m: f64, tube_m: f64, around: usize) -> Soup {
    let circle: Vec<[f64; 2]> = (0..around / 2)
        .map(|step| {
            let (sin, cos) = (2.0 * TAU * step as f64 / around as f64).sin_cos();
            [radius_m + tube_m * cos, tube_m * sin]
        })
        .collect();
    revolve(&circle, around)
}

/// A cylinder along the z axis, in `around` steps.
#[must_use]
pub fn cylinder(radius_m: f64, height_m: f64, around: usize) -> Soup {
    let outline = [
        [0.0, 0.0],
        [radius_m, 0.0],
        [radius_m, height_m],
        [0.0, height_m],
    ];
    revolve(&outline, around)
}
