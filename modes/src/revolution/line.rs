//! The strike line of a body of revolution, sampled evenly from the nodes along it.

use super::Wall;
use crate::StrikeLine;

/// The element's own interpolation at `position` in 0…1 of end, middle, end, … values of cells.
fn quadratic(value: impl Fn(usize) -> f64, count: usize, position: f64) -> f64 {
    let cells = count / 2;
    let x = position * cells as f64;
    #[expect(clippy::cast_sign_loss, reason = "positions are not negative")]
    let cell = (x as usize).min(cells - 1);
    let t = 2.0 * (x - cell as f64) - 1.0;
    let [start, middle, end] = [0, 1, 2].map(|i| value(2 * cell + i));
    0.5 * t * (t - 1.0) * start + (1.0 - t * t) * middle + 0.5 * t * (t + 1.0) * end
}

/// Half-waves of the largest component along the line.
pub(super) fn half_waves(line: &[[f64; 3]]) -> usize {
    let component = (0..3)
        .max_by(|&a, &b| {
            let energy = |c: usize| line.iter().map(|u| u[c] * u[c]).sum::<f64>();
            energy(a).total_cmp(&energy(b))
        })
        .unwrap_or(0);
    1 + line
        .windows(2)
        .filter(|pair| pair[0][component] * pair[1][component] < 0.0)
        .count()
}

/// (U, V, W) at the samples of the strike line.
pub(super) fn sampled(wall: &Wall, line: &[[f64; 3]], samples: usize) -> Vec<[f64; 3]> {
    let mut sampled: Vec<[f64; 3]> = (0..samples)
        .map(|i| {
            let position = i as f64 / (samples - 1) as f64;
            [0, 1, 2].map(|a| quadratic(|i| line[i][a], line.len(), position))
        })
        .collect();
    if wall.mirrors {
        // Each component is even or odd about the middle; rounding is shared out.
        let twin = |i: usize| samples - 1 - i;
        let signs = [0, 1, 2].map(|a| {
            let overlap: f64 = (0..samples)
                .map(|i| sampled[i][a] * sampled[twin(i)][a])
                .sum();
            if overlap < 0.0 { -1.0 } else { 1.0 }
        });
        for i in 0..samples.div_ceil(2) {
            let (p, q) = (sampled[i], sampled[twin(i)]);
            let mean = [0, 1, 2].map(|a| 0.5 * (p[a] + signs[a] * q[a]));
            sampled[twin(i)] = [0, 1, 2].map(|a| signs[a] * mean[a]);
            sampled[i] = mean;
        }
    }
    sampled
}

/// Length of the strike line, in m.
pub(super) fn path_m(wall: &Wall) -> f64 {
    wall.line
        .windows(2)
        .map(|pair| {
            let [p, q] = [pair[0], pair[1]].map(|node| wall.meridian.nodes_m[node as usize]);
            (q[0] - p[0]).hypot(q[1] - p[1])
        })
        .sum()
}

/// Points and normals of the strike line, in the body's cylindrical frame (r, θ, z) at θ = 0.
pub(super) fn strike_line(wall: &Wall, samples: usize) -> StrikeLine {
    let count = wall.line.len();
    let at = |i: usize| (i as f64) / (samples - 1) as f64;
    let place = |i: usize, a: usize| wall.meridian.nodes_m[wall.line[i] as usize][a];
    StrikeLine::single(
        (0..samples)
            .map(|i| [0, 1].map(|a| quadratic(|k| place(k, a), count, at(i))))
            .map(|[r, z]| [r, 0.0, z])
            .collect(),
        (0..samples)
            .map(|i| [0, 1].map(|a| quadratic(|k| wall.line_normals[k][a], count, at(i))))
            .map(|[r, z]| {
                let length = r.hypot(z);
                [r / length, 0.0, z / length]
            })
            .collect(),
    )
}
