//! Vessels turned about their axis: a bell, a cup, a wok.

use super::super::Soup;
use super::revolve;

/// Steps around the axis.
const AROUND: usize = 96;

/// A church bell's outline from the rim up, outside: distance from the axis and height, over the
/// rim's radius, and the wall there.
const BELL: [[f64; 3]; 9] = [
    [1.0, 0.0, 0.02],
    [0.985, 0.1, 0.14],
    [0.9, 0.25, 0.12],
    [0.76, 0.55, 0.08],
    [0.66, 0.9, 0.065],
    [0.6, 1.2, 0.065],
    [0.55, 1.42, 0.075],
    [0.42, 1.54, 0.09],
    [0.0, 1.58, 0.1],
];

/// A bell with its mouth down, `radius_m` at the rim.
#[must_use]
pub fn bell(radius_m: f64) -> Soup {
    let outside = BELL.map(|[r, z, _]| [r * radius_m, z * radius_m]);
    let inside: Vec<[f64; 2]> = BELL
        .iter()
        .enumerate()
        .map(|(i, &[r, z, wall])| {
            let [above, below] = [BELL[(i + 1).min(8)], BELL[i.saturating_sub(1)]];
            // Across the outline, to the left of the way up.
            let (dr, dz) = (above[0] - below[0], above[1] - below[1]);
            let along = dr.hypot(dz);
            let (r, z) = match i {
                0 => (r - wall, 0.0),
                8 => (0.0, z - wall),
                _ => (r - wall * dz / along, z + wall * dr / along),
            };
            [r * radius_m, z * radius_m]
        })
        .collect();
    let outline: Vec<[f64; 2]> = smooth(&outside)
        .into_iter()
        .chain(smooth(&inside).into_iter().rev())
        .collect();
    revolve(&outline, AROUND)
}

/// A cup that opens upwards, without a handle, its wall `wall_m` thick.
#[must_use]
pub fn cup(radius_m: f64, height_m: f64, wall_m: f64) -> Soup {
    let side = |inset: f64, from: f64| -> Vec<[f64; 2]> {
        // Narrower at the foot by a fifth.
        let at = |z: f64| radius_m * (0.8 + 0.2 * z / height_m) - inset;
        let steps = (0..=8).map(|k| from + (height_m - from) * f64::from(k) / 8.0);
        steps.map(|z| [at(z), z]).collect()
    };
    let mut outline = vec![[0.0, 0.0]];
    outline.extend(side(0.0, 0.0));
    outline.extend(side(wall_m, wall_m).into_iter().rev());
    outline.push([0.0, wall_m]);
    revolve(&outline, AROUND)
}

/// A wok: a cap of a sphere `radius_m` wide and `depth_m` deep, its wall `wall_m` thick.
#[must_use]
pub fn wok(radius_m: f64, depth_m: f64, wall_m: f64) -> Soup {
    let ball_m = (radius_m * radius_m + depth_m * depth_m) / (2.0 * depth_m);
    let opening = (radius_m / ball_m).asin();
    let arc = |ball: f64| -> Vec<[f64; 2]> {
        let steps = (0..=24).map(|k| opening * f64::from(k) / 24.0);
        steps
            .map(|angle| match angle {
                0.0 => [0.0, ball_m - ball],
                _ => [ball * angle.sin(), ball_m - ball * angle.cos()],
            })
            .collect()
    };
    let mut outline = arc(ball_m);
    outline.extend(arc(ball_m - wall_m).into_iter().rev());
    revolve(&outline, AROUND)
}

/// The line through `points` with its parts cut in four and rounded (Catmull & Rom 1974).
fn smooth(points: &[[f64; 2]]) -> Vec<[f64; 2]> {
    let last = points.len() - 1;
    let mut line = Vec::with_capacity(4 * last + 1);
    for i in 0..last {
        let [a, b, c, d] = [
            points[i.saturating_sub(1)],
            points[i],
            points[i + 1],
            points[(i + 2).min(last)],
        ];
        line.extend((0..4).map(|quarter| {
            let t = f64::from(quarter) / 4.0;
            [0, 1].map(|x| {
                b[x] + 0.5
                    * t
                    * ((c[x] - a[x])
                        + t * ((2.0 * a[x] - 5.0 * b[x] + 4.0 * c[x] - d[x])
                            + t * (3.0 * (b[x] - c[x]) + d[x] - a[x])))
            })
        }));
    }
    line.push(points[last]);
    line
}
