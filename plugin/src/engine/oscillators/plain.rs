//! The free-ringing kernel in plain arithmetic: its clear twin, and what machines without fused
//! multiply-add run.

use super::between::{NO_SUMS, rows};
use super::pack::{HOP, HOPS, LANES, Pack};
use super::points::KINDS;
use super::ring::{Ring, single};

/// Twin of the vectors in [`super::ring`].
pub(super) fn ring(task: Ring<'_>) {
    let sums = &mut task.room.sums;
    *sums = NO_SUMS;
    for number in task.ranges.iter().rev().flat_map(Clone::clone) {
        let pack = &mut task.packs[number];
        match pack.points {
            0 => add(pack, rows::<1>(sums, 0)),
            1 => add(pack, rows::<2>(sums, 1)),
            _ => add(pack, rows::<HOPS>(sums, 2)),
        }
        if task.advance {
            for i in 0..LANES {
                let (re, im) = (pack.cell_re[i], pack.cell_im[i]);
                let (x, y) = (pack.x[i], pack.y[i]);
                (pack.x[i], pack.y[i]) = (re * x - im * y, re * y + im * x);
            }
        }
    }
    task.room
        .between
        .fill(pulp::Scalar, (sums, [true; KINDS]), task.out);
}

/// Adds the sound of a pack at its points.
fn add(pack: &Pack, sums: &mut [[f64; 2 * HOP]]) {
    let (mut x, mut y) = (single(&pack.x), single(&pack.y));
    for sums in sums {
        let mut sound = [0.0f32; 2 * HOP];
        for (i, heard) in pack.heard.iter().enumerate() {
            let [of_x, of_y] = &heard.0;
            for k in 0..2 * HOP {
                sound[k] += x[i] * of_x[k] + y[i] * of_y[k];
            }
        }
        for (sum, sound) in sums.iter_mut().zip(sound) {
            *sum += f64::from(sound);
        }
        for i in 0..LANES {
            let (re, im) = (pack.hop_re[i], pack.hop_im[i]);
            (x[i], y[i]) = (re * x[i] - im * y[i], re * y[i] + im * x[i]);
        }
    }
}
