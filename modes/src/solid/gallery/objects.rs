//! Flat things: a star, a key.

use super::super::Soup;
use super::{prism, revolve};
use std::f64::consts::{PI, TAU};

/// A star of `points` tips, `radius_m` from its middle to a tip, `thickness_m` thick.
#[must_use]
pub fn star(points: usize, radius_m: f64, thickness_m: f64) -> Soup {
    let outline: Vec<[f64; 2]> = (0..2 * points)
        .map(|k| {
            let radius = if k % 2 == 0 { radius_m } else { 0.5 * radius_m };
            let (sin, cos) = (PI * k as f64 / points as f64 + 0.5 * PI).sin_cos();
            [radius * cos, radius * sin]
        })
        .collect();
    prism(&outline, thickness_m)
}

/// A key to a door, `length_m` long: a ring, a shaft in it, two teeth at its end. The three go through
/// each other and are one body.
#[must_use]
pub fn key(length_m: f64) -> Soup {
    let unit = length_m / 80.0;
    let rod: Vec<[f64; 2]> = (0..16)
        .map(|k| {
            let (sin, cos) = (TAU * f64::from(k) / 16.0).sin_cos();
            [11.0 + 3.0 * cos, 3.0 * sin]
        })
        .collect();
    let mut key = scaled(&revolve(&rod, 64), unit, [14.0, 0.0]);
    let bar = |[x0, y0]: [f64; 2], [x1, y1]: [f64; 2], half: f64| {
        let outline = [[x0, y0], [x1, y0], [x1, y1], [x0, y1]];
        let mut bar = prism(&outline, 2.0 * half);
        for point in &mut bar.points {
            point[2] -= half;
        }
        scaled(&bar, unit, [0.0; 2])
    };
    key.append(&bar([26.0, -2.5], [80.0, 2.5], 2.5));
    key.append(&bar([62.0, -12.0], [67.0, 0.0], 2.0));
    key.append(&bar([72.0, -14.0], [78.0, 0.0], 2.0));
    for (object, name) in key
        .objects
        .iter_mut()
        .zip(["ring", "shaft", "tooth", "tooth"])
    {
        name.clone_into(&mut object.name);
    }
    key
}

/// `shape` moved in its plane, then times `unit`.
fn scaled(shape: &Soup, unit: f64, [dx, dy]: [f64; 2]) -> Soup {
    let mut scaled = shape.clone();
    for point in &mut scaled.points {
        *point = [
            unit * (point[0] + dx),
            unit * (point[1] + dy),
            unit * point[2],
        ];
    }
    scaled
}
