//! The free-ringing kernel in plain arithmetic: its clear twin, and what machines without fused
//! multiply-add run.

use super::GRID;
use super::pack::{HOP, HOPS, LANES};
use super::ring::Ring;

/// Twin of the vectors in [`super::ring`].
pub(super) fn ring(task: Ring<'_>) {
    let mut sums = [[[0.0f32; LANES]; 2]; GRID];
    for pack in task.ranges.iter().flat_map(Clone::clone) {
        let pack = &mut task.packs[pack];
        let tiny = |z: f64| if z.abs() < 1e-30 { 0.0 } else { z as f32 };
        let (mut x, mut y) = (pack.x.map(tiny), pack.y.map(tiny));
        for hop in 0..HOPS {
            for (j, hear) in pack.hear.iter().enumerate() {
                let sums = &mut sums[hop * HOP + j];
                for (sums, [from_x, from_y]) in sums.iter_mut().zip(hear) {
                    for i in 0..LANES {
                        sums[i] += from_x[i] * x[i] + from_y[i] * y[i];
                    }
                }
            }
            for i in 0..LANES {
                let (re, im) = (pack.hop_re[i], pack.hop_im[i]);
                (x[i], y[i]) = (re * x[i] - im * y[i], re * y[i] + im * x[i]);
            }
        }
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
