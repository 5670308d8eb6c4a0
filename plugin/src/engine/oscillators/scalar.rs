//! The oscillators in plain arithmetic, for machines without fused multiply-add.

use super::{LANES, Oscillators, Push};

/// Twin of [`super::vector::Ring`].
pub(super) fn ring(oscillators: &mut Oscillators, out: &mut [f64]) {
    for sample in out {
        let mut sums = [0.0; LANES];
        for first in (0..oscillators.live).step_by(LANES) {
            for (lane, sum) in sums.iter_mut().enumerate() {
                let i = first + lane;
                let (x, y) = (oscillators.x[i], oscillators.y[i]);
                let (re, im) = (oscillators.step_re[i], oscillators.step_im[i]);
                *sum += y;
                oscillators.x[i] = re * x - im * y;
                oscillators.y[i] = re * y + im * x;
            }
        }
        *sample = sums.iter().sum();
    }
}

/// Twin of [`super::vector::RingPushed`].
pub(super) fn ring_pushed(oscillators: &mut Oscillators, push: Push<'_>, out: &mut [f64]) {
    for (n, sample) in out.iter_mut().enumerate() {
        *sample = 0.0;
        for i in 0..oscillators.live {
            let (mut along, mut across) = (0.0, 0.0);
            for contact in push.each() {
                let taken = |k: usize| contact.gain[i] * push.uptake[k][i] * contact.moments[k][n];
                along += taken(0) + taken(2);
                across += taken(1) + taken(3);
            }
            let (x, y) = (oscillators.x[i], oscillators.y[i]);
            let (re, im) = (oscillators.step_re[i], oscillators.step_im[i]);
            let (half_re, half_im) = (oscillators.half_re[i], oscillators.half_im[i]);
            *sample += y;
            oscillators.x[i] = re * x - im * y + (half_re * along - half_im * across);
            oscillators.y[i] = re * y + im * x + (half_re * across + half_im * along);
        }
    }
}
