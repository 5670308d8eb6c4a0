//! The free-ringing kernel in plain arithmetic: its clear twin, and what machines without fused
//! multiply-add run.

use super::GRID;
use super::pack::{HOP, HOPS, LANES, Pack};
use super::ring::Ring;

/// What is heard on both buses, sample by sample, lane by lane.
type Sums = [[[f32; LANES]; 2]; GRID];

/// Twin of the vectors in [`super::ring`].
pub(super) fn ring(task: Ring<'_>) {
    let mut sums = [[[0.0f32; LANES]; 2]; GRID];
    for number in task.ranges.iter().rev().flat_map(Clone::clone) {
        let pack = &mut task.packs[number];
        cell(pack, &mut sums);
        if task.advance {
            for i in 0..LANES {
                let (re, im) = (pack.cell_re[i], pack.cell_im[i]);
                let (x, y) = (pack.x[i], pack.y[i]);
                (pack.x[i], pack.y[i]) = (re * x - im * y, re * y + im * x);
            }
        }
    }
    for (n, sums) in sums.iter().enumerate() {
        for (bus, sums) in task.out.iter_mut().zip(sums) {
            bus[n] = f64::from(sums.iter().sum::<f32>());
        }
    }
}

/// Adds a cell of a pack to `sums`.
fn cell(pack: &Pack, sums: &mut Sums) {
    let tiny = |z: f64| if z.abs() < 1e-30 { 0.0 } else { z as f32 };
    let (mut x, mut y) = (pack.x.map(tiny), pack.y.map(tiny));
    for hop in 0..HOPS {
        for j in 0..HOP {
            let [left, right] = &mut sums[hop * HOP + j];
            let [[left_x, left_y], [right_x, right_y]] = &pack.hear[j];
            for i in 0..LANES {
                left[i] += left_x[i] * x[i] + left_y[i] * y[i];
                right[i] += right_x[i] * x[i] + right_y[i] * y[i];
            }
        }
        for i in 0..LANES {
            let (re, im) = (pack.hop_re[i], pack.hop_im[i]);
            (x[i], y[i]) = (re * x[i] - im * y[i], re * y[i] + im * x[i]);
        }
    }
}
