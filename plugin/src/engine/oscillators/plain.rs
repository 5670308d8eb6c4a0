//! The free-ringing kernel in plain arithmetic: its clear twin, and what machines without fused
//! multiply-add run.

use super::GRID;
use super::pack::{HOP, HOPS, LANES, Pack};
use super::ring::{Ring, Sound, single};

/// Twin of the vectors in [`super::ring`].
pub(super) fn ring(task: Ring<'_>) {
    *task.out = [[0.0; GRID]; 2];
    for number in task.ranges.iter().rev().flat_map(Clone::clone) {
        let pack = &mut task.packs[number];
        cell(pack).add_to(task.out);
        if task.advance {
            for i in 0..LANES {
                let (re, im) = (pack.cell_re[i], pack.cell_im[i]);
                let (x, y) = (pack.x[i], pack.y[i]);
                (pack.x[i], pack.y[i]) = (re * x - im * y, re * y + im * x);
            }
        }
    }
}

/// The sound of a pack over a cell.
fn cell(pack: &Pack) -> Sound {
    let mut sound = Sound([[0.0; 2 * HOP]; HOPS]);
    let (mut x, mut y) = (single(&pack.x), single(&pack.y));
    for hop in &mut sound.0 {
        for (i, heard) in pack.heard.iter().enumerate() {
            let [of_x, of_y] = &heard.0;
            for k in 0..2 * HOP {
                hop[k] += x[i] * of_x[k] + y[i] * of_y[k];
            }
        }
        for i in 0..LANES {
            let (re, im) = (pack.hop_re[i], pack.hop_im[i]);
            (x[i], y[i]) = (re * x[i] - im * y[i], re * y[i] + im * x[i]);
        }
    }
    sound
}
