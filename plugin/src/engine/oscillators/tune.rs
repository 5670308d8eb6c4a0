//! From damping to steps: Eq. 9 of O'Brien 2002 while the body rings.

use super::super::losses::Drain;
use super::GRID;
use super::pack::{HOP, LANES, Pack};
use super::tone::Tone;
use pulp::{Simd, WithSimd};

/// A task for a kernel: steps for what drains the modes now, and, if the pitch has moved, at `ratio`
/// times their frequency.
pub(crate) struct Tune<'a> {
    pub(crate) tones: &'a mut [Tone],
    pub(crate) packs: &'a mut [Pack],
    pub(crate) drain: Drain,
    pub(crate) ratio: Option<f64>,
    /// Whether gains have moved.
    pub(crate) gains: bool,
    /// Whether the shares of the causes outside the material have moved.
    pub(crate) causes: bool,
    pub(crate) step_s: f64,
}

impl WithSimd for Tune<'_> {
    type Output = ();

    #[inline(always)]
    fn with_simd<S: Simd>(self, s: S) {
        let step_s = self.step_s;
        for (tone, pack) in self.tones.iter_mut().zip(self.packs) {
            if let Some(ratio) = self.ratio {
                tone.pitch(ratio, step_s);
            }
            if self.causes {
                outside(s, tone, &self.drain);
            }
            if self.gains || self.ratio.is_some() {
                tone.hear();
                pack.hear[0] = tone.gain;
            }
            let most = decay(s, tone, &self.drain, step_s as f32);
            if most.lost * (GRID as f32) < 0.3 && most.shifted < 1e-4 {
                few(s, tone, step_s as f32, pack);
            } else {
                any(s, tone, step_s, pack);
            }
        }
    }
}

/// The most damped of sixteen modes: dT, and d²T/ω.
struct Most {
    lost: f32,
    shifted: f32,
}

/// What the causes outside the material take of all modes.
#[inline(always)]
fn outside<S: Simd>(s: S, tone: &mut Tone, drain: &Drain) {
    let shares = drain.shares();
    let Tone { rates, outside, .. } = tone;
    *outside = [0.0; LANES];
    for (share, rates) in shares.iter().zip(&*rates) {
        let share = s.splat_f32s(*share as f32);
        let outside = S::as_mut_simd_f32s(outside).0.iter_mut();
        for (outside, rate) in outside.zip(S::as_simd_f32s(rates).0) {
            *outside = s.mul_add_e_f32s(share, *rate, *outside);
        }
    }
}

/// Decay rates of all modes: by the material, from outside, and by hand.
#[inline(always)]
fn decay<S: Simd>(s: S, tone: &mut Tone, drain: &Drain, step_s: f32) -> Most {
    let alpha1 = s.splat_f32s((0.5 * drain.alpha1_s) as f32);
    let loss = s.splat_f32s((0.5 * drain.loss_factor) as f32);
    let even = s.splat_f32s((0.5 * drain.alpha2_per_s + drain.hand_per_s) as f32);
    let omega = S::as_simd_f32s(&tone.played).0;
    let inverse = S::as_simd_f32s(&tone.inverse).0;
    let outside = S::as_simd_f32s(&tone.outside).0;
    let (mut lost, mut shifted) = (s.splat_f32s(0.0), s.splat_f32s(0.0));
    for (v, decay) in S::as_mut_simd_f32s(&mut tone.decay)
        .0
        .iter_mut()
        .enumerate()
    {
        let sum = s.mul_add_e_f32s(alpha1, omega[v], loss);
        let sum = s.mul_add_e_f32s(sum, omega[v], s.add_f32s(even, outside[v]));
        *decay = sum;
        lost = s.max_f32s(lost, sum);
        shifted = s.max_f32s(shifted, s.mul_f32s(s.mul_f32s(sum, sum), inverse[v]));
    }
    Most {
        lost: s.reduce_max_f32s(lost) * step_s,
        shifted: s.reduce_max_f32s(shifted) * step_s,
    }
}

/// x times the polynomial with these terms, the highest first.
#[inline(always)]
fn series<S: Simd, const N: usize>(s: S, x: S::f32s, terms: [f32; N]) -> S::f32s {
    let mut sum = s.splat_f32s(0.0);
    for term in terms {
        sum = s.mul_add_e_f32s(x, sum, s.splat_f32s(term));
    }
    s.mul_f32s(x, sum)
}

/// (1 + a)(1 + b) − 1.
#[inline(always)]
fn one_more<S: Simd>(s: S, a: S::f32s, b: S::f32s) -> S::f32s {
    s.mul_add_e_f32s(a, b, s.add_f32s(a, b))
}

/// Steps of modes that lose less than a third in a cell and whose frequency damping hardly shifts.
///
/// With x = −dT, q = d/ω and the shift t = (ω − Ω)T = q²ωT/2 + …: exp(kx − ikt) − 1 for k = 1…4, and for the cell.
#[inline(always)]
fn few<S: Simd>(s: S, tone: &Tone, step_s: f32, pack: &mut Pack) {
    let mut cell = [[0.0; LANES]; 2];
    let (down, cells) = (s.splat_f32s(-step_s), s.splat_f32s(GRID as f32));
    let decays = S::as_simd_f32s(&tone.decay).0;
    let inverse = S::as_simd_f32s(&tone.inverse).0;
    for v in 0..decays.len() {
        let x = s.mul_f32s(decays[v], down);
        let q = s.mul_f32s(decays[v], inverse[v]);
        let square = s.mul_f32s(q, q);
        // (1 − √(1 − q²)) over q²/2.
        let more = s.mul_add_e_f32s(square, s.splat_f32s(5.0 / 64.0), s.splat_f32s(1.0 / 8.0));
        let more = s.mul_add_e_f32s(square, more, s.splat_f32s(0.25));
        let more = s.mul_add_e_f32s(square, more, s.splat_f32s(1.0));
        // −t, as −d is −x/T.
        let turn = s.mul_f32s(s.mul_f32s(x, q), s.mul_f32s(more, s.splat_f32s(0.5)));
        let one = series(s, x, [1.0 / 6.0, 0.5, 1.0]);
        let two = one_more(s, one, one);
        let lost = [one, two, one_more(s, one, two), one_more(s, two, two)];
        for (k, lost) in lost.into_iter().enumerate() {
            let turn = s.mul_f32s(turn, s.splat_f32s((k + 1) as f32));
            put(
                s,
                tone,
                pack,
                (k, v),
                [lost, s.mul_add_e_f32s(turn, lost, turn)],
            );
        }
        let lost = series(
            s,
            s.mul_f32s(x, cells),
            [1.0 / 720.0, 1.0 / 120.0, 1.0 / 24.0, 1.0 / 6.0, 0.5, 1.0],
        );
        let turn = s.mul_f32s(turn, cells);
        let square = s.mul_f32s(turn, turn);
        let left = s.add_f32s(lost, s.splat_f32s(1.0));
        let sine = s.mul_f32s(
            turn,
            s.mul_add_e_f32s(square, s.splat_f32s(-1.0 / 6.0), s.splat_f32s(1.0)),
        );
        let re = s.mul_add_e_f32s(s.mul_f32s(left, square), s.splat_f32s(-0.5), lost);
        S::as_mut_simd_f32s(&mut cell[0]).0[v] = re;
        S::as_mut_simd_f32s(&mut cell[1]).0[v] = s.mul_f32s(left, sine);
    }
    put_cell(s, tone, pack, &cell);
}

/// Steps of modes however damped; those with Ω < ω/10 are silenced.
///
/// exp((−d − i(ω−Ω))T) − 1 is a short series of an eighth of the exponent, doubled thrice, and five
/// times more for the cell: E ← E (2 + E).
#[inline(always)]
fn any<S: Simd>(s: S, tone: &Tone, step_s: f64, pack: &mut Pack) {
    let mut hop = [[[0.0; LANES]; 2]; HOP];
    let mut cell = [[0.0; LANES]; 2];
    for i in 0..LANES {
        let (omega, decay) = (f64::from(tone.played[i]), f64::from(tone.decay[i]));
        let square = (omega - decay) * (omega + decay);
        let heard = square > 0.01 * omega * omega;
        let decay = decay.min(omega);
        let damped = square.max(0.01 * omega * omega).sqrt();
        let eighth = 0.125 * step_s;
        let (re, im) = (-decay * eighth, -decay * decay / (omega + damped) * eighth);
        let (mut a, mut b) = (1.0, 0.0);
        for k in [12.0, 11.0, 10.0, 9.0, 8.0, 7.0, 6.0, 5.0, 4.0, 3.0, 2.0] {
            let part = 1.0 / k;
            (a, b) = (1.0 + (re * a - im * b) * part, (re * b + im * a) * part);
        }
        let (mut a, mut b) = (re * a - im * b, re * b + im * a);
        let double = |a: f64, b: f64| (a * (2.0 + a) - b * b, 2.0 * b * (1.0 + a));
        for _ in 0..3 {
            (a, b) = double(a, b);
        }
        let one = (a, b);
        let mut power = one;
        for k in 0..HOP {
            let (re, im) = if heard { power } else { (-1.0, 0.0) };
            (hop[k][0][i], hop[k][1][i]) = (re as f32, im as f32);
            power = (
                power.0 + one.0 + power.0 * one.0 - power.1 * one.1,
                power.1 + one.1 + power.0 * one.1 + power.1 * one.0,
            );
        }
        let mut samples = 1;
        while samples < GRID {
            (a, b) = double(a, b);
            samples *= 2;
        }
        let (re, im) = if heard { (a, b) } else { (-1.0, 0.0) };
        (cell[0][i], cell[1][i]) = (re as f32, im as f32);
    }
    for (k, hop) in hop.iter().enumerate() {
        let (a, b) = (S::as_simd_f32s(&hop[0]).0, S::as_simd_f32s(&hop[1]).0);
        for v in 0..a.len() {
            put(s, tone, pack, (k, v), [a[v], b[v]]);
        }
    }
    put_cell(s, tone, pack, &cell);
}

/// One vector `v` of a pack, k + 1 samples on, given what damping makes of the turns: what a sample hears,
/// or the step to the next hop.
///
/// What is heard of z(1 + a + ib) is what was heard of z, turned: its real part with x, its imaginary
/// part with y.
#[inline(always)]
fn put<S: Simd>(s: S, tone: &Tone, pack: &mut Pack, (k, v): (usize, usize), lost: [S::f32s; 2]) {
    let [a, b] = lost;
    if k + 1 == HOP {
        let [re, im] = &tone.turns[k];
        let (re, im) = (S::as_simd_f32s(re).0[v], S::as_simd_f32s(im).0[v]);
        S::as_mut_simd_f32s(&mut pack.hop_re).0[v] =
            s.negate_mul_add_e_f32s(im, b, s.mul_add_e_f32s(re, a, re));
        S::as_mut_simd_f32s(&mut pack.hop_im).0[v] =
            s.mul_add_e_f32s(re, b, s.mul_add_e_f32s(im, a, im));
        return;
    }
    for (heard, undamped) in pack.hear[k + 1].iter_mut().zip(&tone.undamped[k]) {
        let [x, y] = undamped;
        let (x, y) = (S::as_simd_f32s(x).0[v], S::as_simd_f32s(y).0[v]);
        let [hear_x, hear_y] = heard;
        S::as_mut_simd_f32s(hear_x).0[v] = s.mul_add_e_f32s(y, b, s.mul_add_e_f32s(x, a, x));
        S::as_mut_simd_f32s(hear_y).0[v] = s.negate_mul_add_e_f32s(x, b, s.mul_add_e_f32s(y, a, y));
    }
}

/// The step of a pack over a cell, given what damping makes of the turns.
#[inline(always)]
fn put_cell<S: Simd>(s: S, tone: &Tone, pack: &mut Pack, lost: &[[f32; LANES]; 2]) {
    let mut wide = [[0.0; LANES]; 2];
    for (wide, lost) in wide.iter_mut().zip(lost) {
        for i in 0..LANES {
            wide[i] = f64::from(lost[i]);
        }
    }
    let (a, b) = (S::as_simd_f64s(&wide[0]).0, S::as_simd_f64s(&wide[1]).0);
    let (re, im) = (
        S::as_simd_f64s(&tone.cell[0]).0,
        S::as_simd_f64s(&tone.cell[1]).0,
    );
    let cell_re = S::as_mut_simd_f64s(&mut pack.cell_re).0;
    let cell_im = S::as_mut_simd_f64s(&mut pack.cell_im).0;
    for v in 0..a.len() {
        let along = s.mul_add_e_f64s(re[v], a[v], re[v]);
        cell_re[v] = s.negate_mul_add_e_f64s(im[v], b[v], along);
        let across = s.mul_add_e_f64s(im[v], a[v], im[v]);
        cell_im[v] = s.mul_add_e_f64s(re[v], b[v], across);
    }
}
