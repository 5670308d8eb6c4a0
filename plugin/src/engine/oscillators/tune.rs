//! From damping to steps: Eq. 9 of O'Brien 2002 while the body rings.

use super::GRID;
use super::heavy;
use super::pack::{HOP, LANES, Pack};
use super::points::{ALL, KINDS, POINTS};
use super::tone::Tone;
use crate::engine::losses::Drain;
use pulp::{Simd, WithSimd};

/// How far a moving decay rate may be off the one that a pack's tables are made for, times the longest
/// time in them: −100 dB of the mode. What a mode has lost by the next hop is always exact.
const STALE: f32 = 1e-5;

/// Greatest loss up to the farthest of a hop's points, and greatest d²T/ω, for which short series do.
const LIGHT: f32 = 0.065;
const STRAIGHT: f32 = 1e-4;

/// How far the points of a hop reach that are samples.
const NEAR: f32 = (HOP - 1) as f32;

// A hop, doubled twice, is a cell.
const _: () = assert!(GRID == 4 * HOP);

/// A task for a kernel: steps for what drains the modes now, at `ratio` times their frequency.
pub(crate) struct Tune<'a> {
    pub(crate) tones: &'a mut [Tone],
    pub(crate) packs: &'a mut [Pack],
    pub(crate) drain: Drain,
    pub(crate) ratio: f64,
    /// Whether that has moved.
    pub(crate) pitch: bool,
    /// Whether gains have moved.
    pub(crate) gains: bool,
    /// Whether the shares of the causes outside the material have moved.
    pub(crate) causes: bool,
    /// Whether no table may stay a hair off.
    pub(crate) exact: bool,
    /// Set if a table is.
    pub(crate) off: &'a mut bool,
    pub(crate) step_s: f64,
}

impl WithSimd for Tune<'_> {
    type Output = ();

    #[inline(always)]
    fn with_simd<S: Simd>(self, s: S) {
        let anew = self.gains || self.pitch;
        let mut all = Extremes::none(s);
        for tone in &mut *self.tones {
            if self.pitch {
                tone.pitch(self.ratio, self.step_s);
            }
            if anew {
                tone.hear();
            }
            if self.causes {
                outside(s, tone, &self.drain);
            }
            decay(s, tone, &self.drain, &mut all);
        }
        let step_s = self.step_s as f32;
        let kind = all.kind(s, step_s);
        let mut tables_too = anew || self.exact || kind.stale;
        for tone in &mut *self.tones {
            if kind.heavy || tone.every_sample {
                let heavy = kind.heavy && Extremes::of(s, tone, tone.reach).kind(s, step_s).heavy;
                if heavy != tone.every_sample {
                    tone.every_sample = heavy;
                    tone.pitch(self.ratio, self.step_s);
                    tone.hear();
                    tables_too = true;
                }
            }
        }
        *self.off |= !tables_too && kind.moved;
        for (tone, pack) in self.tones.iter_mut().zip(self.packs) {
            if tone.every_sample && Extremes::of(s, tone, NEAR).kind(s, step_s).heavy {
                tone.made_for = tone.decay;
                heavy::steps(tone, self.step_s, pack);
                continue;
            }
            let lost = steps(s, tone, step_s, pack);
            if tables_too {
                tone.made_for = tone.decay;
                tables(s, tone, &lost, pack);
            }
        }
    }
}

/// The greatest of all modes, lane by lane: d and how far it is off what the tables are made for, both
/// times the farthest of a hop's points, and d²/ω.
struct Extremes<V> {
    decay: V,
    shifted: V,
    moved: V,
}

/// What that asks for.
struct Kind {
    /// Whether short series do not do.
    heavy: bool,
    /// Whether tables have to be made anew, and whether any is off at all.
    stale: bool,
    moved: bool,
}

impl<V: Copy> Extremes<V> {
    /// Of no modes.
    #[inline(always)]
    fn none<S: Simd<f32s = V>>(s: S) -> Self {
        let zero = s.splat_f32s(0.0);
        Self {
            decay: zero,
            shifted: zero,
            moved: zero,
        }
    }

    /// Takes in a vector of modes that decay at `decay`, for 1/ω and the rates that tables are made for,
    /// which `reach` as many samples.
    #[inline(always)]
    fn see<S: Simd<f32s = V>>(&mut self, s: S, decay: V, (inverse, made_for, reach): (V, V, V)) {
        let square = s.mul_f32s(s.mul_f32s(decay, decay), inverse);
        let moved = s.abs_f32s(s.sub_f32s(decay, made_for));
        self.decay = s.max_f32s(self.decay, s.mul_f32s(decay, reach));
        self.shifted = s.max_f32s(self.shifted, square);
        self.moved = s.max_f32s(self.moved, s.mul_f32s(moved, reach));
    }

    /// Of one pack whose decay rates are known, in a hop whose points reach so many samples.
    #[inline(always)]
    fn of<S: Simd<f32s = V>>(s: S, tone: &Tone, reach: f32) -> Self {
        let mut all = Self::none(s);
        let decays = S::as_simd_f32s(&tone.decay).0;
        let inverse = S::as_simd_f32s(&tone.inverse).0;
        let made_for = S::as_simd_f32s(&tone.made_for).0;
        let reach = s.splat_f32s(reach);
        for v in 0..decays.len() {
            all.see(s, decays[v], (inverse[v], made_for[v], reach));
        }
        all
    }

    #[inline(always)]
    fn kind<S: Simd<f32s = V>>(&self, s: S, step_s: f32) -> Kind {
        let light = s.reduce_max_f32s(self.decay) * step_s < LIGHT
            && s.reduce_max_f32s(self.shifted) * step_s < STRAIGHT;
        let moved = s.reduce_max_f32s(self.moved);
        Kind {
            heavy: !light,
            stale: moved * step_s > STALE,
            moved: moved > 0.0,
        }
    }
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
fn decay<S: Simd>(s: S, tone: &mut Tone, drain: &Drain, all: &mut Extremes<S::f32s>) {
    let alpha1 = s.splat_f32s((0.5 * drain.alpha1_s) as f32);
    let loss = s.splat_f32s((0.5 * drain.loss_factor) as f32);
    let even = s.splat_f32s((0.5 * drain.alpha2_per_s + drain.hand_per_s) as f32);
    let omega = S::as_simd_f32s(&tone.played).0;
    let inverse = S::as_simd_f32s(&tone.inverse).0;
    let outside = S::as_simd_f32s(&tone.outside).0;
    let made_for = S::as_simd_f32s(&tone.made_for).0;
    let reach = s.splat_f32s(tone.reach);
    let decays = S::as_mut_simd_f32s(&mut tone.decay).0;
    for (v, decay) in decays.iter_mut().enumerate() {
        let sum = s.mul_add_e_f32s(alpha1, omega[v], loss);
        *decay = s.mul_add_e_f32s(sum, omega[v], s.add_f32s(even, outside[v]));
        all.see(s, *decay, (inverse[v], made_for[v], reach));
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

/// What each mode loses in a sample: x = −dT, and −t with t = (ω − Ω)T.
#[repr(C, align(64))]
struct Lost {
    x: [f32; LANES],
    turn: [f32; LANES],
}

/// Steps over a hop and a cell of modes that lose less than a third in a cell and whose frequency damping
/// hardly shifts: exp(kx − ikt) − 1, with q = d/ω and t = q²ωT/2 + ….
#[inline(always)]
fn steps<S: Simd>(s: S, tone: &Tone, step_s: f32, pack: &mut Pack) -> Lost {
    let mut lost = Lost {
        x: [0.0; LANES],
        turn: [0.0; LANES],
    };
    let mut cell = [[0.0; LANES]; 2];
    let samples = s.splat_f32s((POINTS[tone.points].apart * HOP as f64) as f32);
    let decays = S::as_simd_f32s(&tone.decay).0;
    let inverse = S::as_simd_f32s(&tone.inverse).0;
    let (re, im) = (
        S::as_simd_f32s(&tone.hop[0]).0,
        S::as_simd_f32s(&tone.hop[1]).0,
    );
    for v in 0..decays.len() {
        let x = s.mul_f32s(decays[v], s.splat_f32s(-step_s));
        let q = s.mul_f32s(decays[v], inverse[v]);
        let square = s.mul_f32s(q, q);
        // (1 − √(1 − q²)) over q²/2.
        let more = s.mul_add_e_f32s(square, s.splat_f32s(5.0 / 64.0), s.splat_f32s(1.0 / 8.0));
        let more = s.mul_add_e_f32s(square, more, s.splat_f32s(0.25));
        let more = s.mul_add_e_f32s(square, more, s.splat_f32s(1.0));
        let turn = s.mul_f32s(s.mul_f32s(x, q), s.mul_f32s(more, s.splat_f32s(0.5)));
        S::as_mut_simd_f32s(&mut lost.x).0[v] = x;
        S::as_mut_simd_f32s(&mut lost.turn).0[v] = turn;
        let eight = over(s, x, turn, s.splat_f32s(HOP as f32));
        let [a, b] = if tone.points == ALL {
            eight
        } else {
            over(s, x, turn, samples)
        };
        S::as_mut_simd_f32s(&mut pack.hop_re).0[v] =
            s.negate_mul_add_e_f32s(im[v], b, s.mul_add_e_f32s(re[v], a, re[v]));
        S::as_mut_simd_f32s(&mut pack.hop_im).0[v] =
            s.mul_add_e_f32s(re[v], b, s.mul_add_e_f32s(im[v], a, im[v]));
        let [a, b] = double(s, double(s, eight));
        S::as_mut_simd_f32s(&mut cell[0]).0[v] = a;
        S::as_mut_simd_f32s(&mut cell[1]).0[v] = b;
    }
    put_cell(s, tone, pack, &cell);
    lost
}

/// exp(kx + i k·turn) − 1 for as many samples.
#[inline(always)]
fn over<S: Simd>(s: S, x: S::f32s, turn: S::f32s, samples: S::f32s) -> [S::f32s; 2] {
    let x = s.mul_f32s(x, samples);
    let lost = series(s, x, [1.0 / 120.0, 1.0 / 24.0, 1.0 / 6.0, 0.5, 1.0]);
    let turn = s.mul_f32s(turn, samples);
    let half = s.mul_f32s(turn, s.splat_f32s(-0.5));
    [
        s.mul_add_e_f32s(turn, half, lost),
        s.mul_add_e_f32s(turn, lost, turn),
    ]
}

/// e^(2z) − 1 from e^z − 1.
#[inline(always)]
fn double<S: Simd>(s: S, [a, b]: [S::f32s; 2]) -> [S::f32s; 2] {
    let two = s.splat_f32s(2.0);
    let square = s.mul_add_e_f32s(a, a, s.mul_f32s(a, two));
    let twice = s.mul_f32s(b, two);
    [
        s.negate_mul_add_e_f32s(b, b, square),
        s.mul_add_e_f32s(twice, a, twice),
    ]
}

/// When each point of the first hop is, in samples, for both ears.
#[repr(C, align(64))]
struct Times([f32; 2 * HOP]);

const TIMES: [Times; KINDS] = {
    let mut times = [const { Times([0.0; 2 * HOP]) }; KINDS];
    let mut kind = 0;
    while kind < KINDS {
        let mut k = 0;
        while k < 2 * HOP {
            let points = &POINTS[kind];
            times[kind].0[k] = (points.first() + points.apart * (k % HOP) as f64) as f32;
            k += 1;
        }
        kind += 1;
    }
    times
};

/// What each point of a hop hears of the modes: what it would hear undamped, times (1 + a + ib). The real
/// part of what z becomes is heard as x was, its imaginary part as y was.
#[inline(always)]
fn tables<S: Simd>(s: S, tone: &Tone, lost: &Lost, pack: &mut Pack) {
    pack.points = tone.points;
    let times = S::as_simd_f32s(&TIMES[tone.points].0).0;
    for (i, (heard, undamped)) in pack.heard.iter_mut().zip(&tone.undamped).enumerate() {
        let (x, turn) = (s.splat_f32s(lost.x[i]), s.splat_f32s(lost.turn[i]));
        let (of_x, of_y) = (
            S::as_simd_f32s(&undamped.0[0]).0,
            S::as_simd_f32s(&undamped.0[1]).0,
        );
        let [to_x, to_y] = &mut heard.0;
        let (to_x, to_y) = (S::as_mut_simd_f32s(to_x).0, S::as_mut_simd_f32s(to_y).0);
        for v in 0..times.len() {
            let a = series(
                s,
                s.mul_f32s(x, times[v]),
                [1.0 / 24.0, 1.0 / 6.0, 0.5, 1.0],
            );
            let turn = s.mul_f32s(turn, times[v]);
            let b = s.mul_add_e_f32s(turn, a, turn);
            let (x, y) = (of_x[v], of_y[v]);
            to_x[v] = s.mul_add_e_f32s(y, b, s.mul_add_e_f32s(x, a, x));
            to_y[v] = s.negate_mul_add_e_f32s(x, b, s.mul_add_e_f32s(y, a, y));
        }
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
