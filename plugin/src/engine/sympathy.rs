//! Bodies that hang from one support: what sounds moves it, and it moves what is silent.

use super::GRID;
use super::oscillators::{LANES, Pack};
use pulp::{Simd, WithSimd};

/// How the lowest modes of one body hang on the support.
///
/// A mode that the supports damp at d 1/s moves them by r = √(2d) times its velocity, and their motion
/// drives it by as much again. What the support returns of the bodies' motion is at most what it takes
/// from them on the average, so that together they never gain energy.
#[derive(Clone, Debug)]
pub(crate) struct Strand {
    /// r of each mode, in s^(−1/2).
    hold: [f32; LANES],
    /// What the body does to the support, sample by sample.
    pub(crate) moves: [f32; GRID],
    /// What the support has done to the modes by the end of the cell, in √(2 J).
    pub(crate) answer: [[f32; LANES]; 2],
}

impl Strand {
    /// Of modes that the supports damp at these rates, in 1/s.
    pub(crate) fn new(support_per_s: &[f32; LANES]) -> Self {
        Self {
            hold: support_per_s.map(|rate| (2.0 * rate).max(0.0).sqrt()),
            moves: [0.0; GRID],
            answer: [[0.0; LANES]; 2],
        }
    }

    /// Forgets what the support has done.
    pub(crate) fn hush(&mut self) {
        self.answer = [[0.0; LANES]; 2];
    }

    /// Gives the modes what the support has done to them.
    pub(crate) fn take(&mut self, pack: &mut Pack) {
        for i in 0..LANES {
            pack.x[i] += f64::from(self.answer[0][i]);
            pack.y[i] += f64::from(self.answer[1][i]);
        }
        self.hush();
    }
}

/// A task for a kernel: how a body moves the support in the next cell, its modes turning by `turn` a
/// sample.
pub(crate) struct Feel<'a> {
    pub(crate) strand: &'a mut Strand,
    pub(crate) pack: &'a Pack,
    pub(crate) turn: &'a [[f32; LANES]; 2],
}

impl WithSimd for Feel<'_> {
    type Output = ();

    #[inline(always)]
    fn with_simd<S: Simd>(self, _: S) {
        let (mut x, mut y) = ([0.0; LANES], [0.0; LANES]);
        for i in 0..LANES {
            x[i] = self.pack.x[i] as f32;
            y[i] = self.pack.y[i] as f32;
        }
        let [re, im] = self.turn;
        for moves in &mut self.strand.moves {
            let mut sums = [0.0; LANES];
            for i in 0..LANES {
                sums[i] = self.strand.hold[i] * x[i];
                (x[i], y[i]) = (re[i] * x[i] - im[i] * y[i], re[i] * y[i] + im[i] * x[i]);
            }
            *moves = sums.iter().sum();
        }
    }
}

/// A task for a kernel: what the support does to a body's modes in a cell in which all bodies together
/// move it by `all`; each impulse times `share`.
pub(crate) struct Answer<'a> {
    pub(crate) strand: &'a mut Strand,
    pub(crate) turn: &'a [[f32; LANES]; 2],
    pub(crate) all: &'a [f32; GRID],
    pub(crate) share: f32,
}

impl WithSimd for Answer<'_> {
    type Output = ();

    #[inline(always)]
    fn with_simd<S: Simd>(self, _: S) {
        let [re, im] = self.turn;
        let (mut x, mut y) = ([0.0f32; LANES], [0.0f32; LANES]);
        for (all, own) in self.all.iter().zip(&self.strand.moves) {
            let push = self.share * (all - own);
            for i in 0..LANES {
                let pushed = x[i] + push * self.strand.hold[i];
                (x[i], y[i]) = (re[i] * pushed - im[i] * y[i], re[i] * y[i] + im[i] * pushed);
            }
        }
        self.strand.answer = [x, y];
    }
}
