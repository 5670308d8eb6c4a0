//! The oscillators in plain arithmetic, for machines without fused multiply-add.

use super::{Buses, LANES, Oscillators, Push};

/// Twin of [`super::vector::Ring`].
pub(super) fn ring(oscillators: &mut Oscillators, samples: usize, out: &mut Buses) {
    for n in 0..samples {
        let mut sums = [[0.0; LANES]; 3];
        for first in (0..oscillators.live).step_by(LANES) {
            for lane in 0..LANES {
                let i = first + lane;
                for (sums, heard) in sums.iter_mut().zip(heard(oscillators, i)) {
                    sums[lane] += heard;
                }
                let (x, y) = (oscillators.x[i], oscillators.y[i]);
                let (re, im) = (oscillators.step_re[i], oscillators.step_im[i]);
                oscillators.x[i] = re * x - im * y;
                oscillators.y[i] = re * y + im * x;
            }
        }
        for (bus, sums) in out.iter_mut().zip(sums) {
            bus[n] = sums.iter().sum();
        }
    }
}

/// Twin of [`super::vector::RingPushed`].
pub(super) fn ring_pushed(
    oscillators: &mut Oscillators,
    push: Push<'_>,
    samples: usize,
    out: &mut Buses,
) {
    for n in 0..samples {
        for bus in out.iter_mut() {
            bus[n] = 0.0;
        }
        for i in 0..oscillators.live {
            let (mut along, mut across) = (0.0, 0.0);
            for contact in push.each() {
                let taken = |k: usize| contact.gain[i] * push.uptake[k][i] * contact.moments[k][n];
                along += taken(0) + taken(2);
                across += taken(1) + taken(3);
            }
            for (bus, heard) in out.iter_mut().zip(heard(oscillators, i)) {
                bus[n] += heard;
            }
            let (x, y) = (oscillators.x[i], oscillators.y[i]);
            let (re, im) = (oscillators.step_re[i], oscillators.step_im[i]);
            let (half_re, half_im) = (oscillators.half_re[i], oscillators.half_im[i]);
            oscillators.x[i] = re * x - im * y + (half_re * along - half_im * across);
            oscillators.y[i] = re * y + im * x + (half_re * across + half_im * along);
        }
    }
}

/// What mode `i` sends to the three buses now.
fn heard(oscillators: &Oscillators, i: usize) -> [f64; 3] {
    let (x, y) = (oscillators.x[i], oscillators.y[i]);
    let hear = |k: usize| oscillators.hear[k][i];
    [
        hear(0) * y + hear(1) * x,
        hear(2) * y + hear(3) * x,
        hear(4) * y,
    ]
}
