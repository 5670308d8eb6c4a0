//! Steps of modes however damped, in doubles.

use super::GRID;
use super::pack::{HOP, Heard, LANES, Pack};
use super::tone::Tone;
use std::f64::consts::PI;

/// A number less 1: (a, b) is a + ib = e^z − 1.
type Less = (f64, f64);

/// e^(2z) − 1.
#[inline(always)]
fn double((a, b): Less) -> Less {
    (a * (2.0 + a) - b * b, 2.0 * b * (1.0 + a))
}

/// e^(z + w) − 1.
#[inline(always)]
fn both(p: Less, q: Less) -> Less {
    (
        p.0 + q.0 + p.0 * q.0 - p.1 * q.1,
        p.1 + q.1 + p.0 * q.1 + p.1 * q.0,
    )
}

/// Writes all that `pack` needs of modes that decay as `tone` says and are heard at every sample, one
/// `step_s` after the other; those with
/// Ω < ω/10, and those above half the sample rate, for which the series do not hold, are silenced.
///
/// exp((−d − i(ω−Ω))T) − 1 is a short series of an eighth of the exponent, doubled thrice.
#[inline(always)]
pub(super) fn steps(tone: &Tone, step_s: f64, pack: &mut Pack) {
    pack.points = tone.points;
    for i in 0..LANES {
        let (omega, decay) = (f64::from(tone.played[i]), f64::from(tone.decay[i]));
        let square = (omega - decay) * (omega + decay);
        if square <= 0.01 * omega * omega || omega * step_s > PI {
            silence(pack, i);
            continue;
        }
        let damped = square.sqrt();
        let eighth = 0.125 * step_s;
        let (re, im) = (-decay * eighth, -decay * decay / (omega + damped) * eighth);
        let (mut a, mut b) = (1.0, 0.0);
        for k in [12.0, 11.0, 10.0, 9.0, 8.0, 7.0, 6.0, 5.0, 4.0, 3.0, 2.0] {
            let part = 1.0 / k;
            (a, b) = (1.0 + (re * a - im * b) * part, (re * b + im * a) * part);
        }
        let one = double(double(double((re * a - im * b, re * b + im * a))));
        let mut power = (0.0, 0.0);
        for k in 0..HOP {
            let (a, b) = (power.0 as f32, power.1 as f32);
            let (undamped, heard) = (&tone.undamped[i].0, &mut pack.heard[i].0);
            for at in [k, HOP + k] {
                let (x, y) = (undamped[0][at], undamped[1][at]);
                heard[0][at] = x + x * a + y * b;
                heard[1][at] = y + y * a - x * b;
            }
            power = both(power, one);
        }
        let (a, b) = (power.0 as f32, power.1 as f32);
        let (re, im) = (tone.hop[0][i], tone.hop[1][i]);
        pack.hop_re[i] = re + re * a - im * b;
        pack.hop_im[i] = im + re * b + im * a;
        let mut samples = HOP;
        while samples < GRID {
            power = double(power);
            samples *= 2;
        }
        let ((a, b), re, im) = (power, tone.cell[0][i], tone.cell[1][i]);
        pack.cell_re[i] = re + (re * a - im * b);
        pack.cell_im[i] = im + (re * b + im * a);
    }
}

fn silence(pack: &mut Pack, i: usize) {
    pack.heard[i] = Heard::NONE;
    (pack.hop_re[i], pack.hop_im[i]) = (0.0, 0.0);
    (pack.cell_re[i], pack.cell_im[i]) = (0.0, 0.0);
}
