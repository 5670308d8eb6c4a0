//! Sixteen modes as the bank gives them, and what the player makes of them.

use super::GRID;
use super::pack::{HOP, Heard, LANES};
use super::points::{ALL, POINTS, Points, fewest};
use std::f64::consts::PI;

/// Modes from this share of half the sample rate on are silent, not aliased.
pub(super) const HIGHEST: f64 = 0.99;

/// Causes of decay outside the material: radiation, supports, resonator and felt.
pub(crate) const CAUSES: usize = 4;

/// Real and imaginary parts of sixteen numbers.
type Complex<T> = [[T; LANES]; 2];

/// What is needed to tune sixteen modes anew.
#[derive(Clone, Debug)]
#[repr(C, align(64))]
pub(crate) struct Tone {
    /// Undamped angular frequency as built, in rad/s.
    pub(crate) omega: [f64; LANES],
    /// Decay rates in 1/s that the causes give when they count once.
    pub(crate) rates: [[f32; LANES]; CAUSES],
    /// What of x and y reaches the left and the right ear.
    pub(crate) gain: [[[f32; LANES]; 2]; 2],
    /// exp(iωT), or 0 for a mode that is never heard.
    turn: Complex<f32>,
    /// exp(iωTt) for the times t of the first hop's points, in samples, or 0.
    turns: [Complex<f32>; HOP],
    /// Whether all modes are heard at every sample because they are damped too much for fewer points.
    pub(super) every_sample: bool,
    /// At which of [`POINTS`] they are heard.
    pub(super) points: usize,
    /// The farthest of a hop's points, in samples, if they are as few as pitch alone allows.
    pub(super) reach: f32,
    /// What would be heard of each mode over a hop if nothing were damped.
    pub(super) undamped: [Heard; LANES],
    /// Decay rate that the pack's tables are made for, in 1/s.
    pub(super) made_for: [f32; LANES],
    // From here on, side by side, lies what moving damping reads.
    /// Undamped angular frequency as played, in rad/s.
    pub(super) played: [f32; LANES],
    /// Its inverse, in s.
    pub(super) inverse: [f32; LANES],
    /// Decay rate from outside the material, in 1/s.
    pub(super) outside: [f32; LANES],
    /// Decay rate as played, in 1/s.
    pub(crate) decay: [f32; LANES],
    /// exp(iωT) to the power of a hop's samples.
    pub(super) hop: Complex<f32>,
    /// exp(iωT) to the power of a cell's samples.
    pub(super) cell: Complex<f64>,
}

/// (a + ib)(c + id), lane by lane.
#[inline(always)]
fn product(p: &Complex<f64>, q: &Complex<f64>) -> Complex<f64> {
    let mut out = [[0.0; LANES]; 2];
    for i in 0..LANES {
        out[0][i] = p[0][i] * q[0][i] - p[1][i] * q[1][i];
        out[1][i] = p[0][i] * q[1][i] + p[1][i] * q[0][i];
    }
    out
}

/// Turns of modes of so many rad a sample to the first of `points`, and from one to the next.
#[inline(always)]
fn between(points: &Points, angles: &[f64; LANES]) -> (Complex<f64>, Complex<f64>) {
    let (mut first, mut step) = ([[0.0; LANES]; 2], [[0.0; LANES]; 2]);
    let side = points.first().signum();
    for (i, angle) in angles.iter().enumerate() {
        let (sin, cos) = turned(angle * points.first().abs());
        (first[0][i], first[1][i]) = (cos, side * sin);
        let (sin, cos) = turned(angle * points.apart);
        (step[0][i], step[1][i]) = (cos, sin);
    }
    (first, step)
}

/// To a power of two.
#[inline(always)]
fn to_the(mut power: Complex<f64>, exponent: usize) -> Complex<f64> {
    let mut reached = 1;
    while reached < exponent {
        power = product(&power, &power);
        reached *= 2;
    }
    power
}

/// In single floats.
#[inline(always)]
fn rounded(p: &Complex<f64>) -> Complex<f32> {
    let mut out = [[0.0; LANES]; 2];
    for i in 0..LANES {
        out[0][i] = p[0][i] as f32;
        out[1][i] = p[1][i] as f32;
    }
    out
}

impl Tone {
    /// No modes, but a frequency, lest anything be divided by zero.
    pub(crate) const NONE: Self = Self {
        omega: [1e4; LANES],
        rates: [[0.0; LANES]; CAUSES],
        gain: [[[0.0; LANES]; 2]; 2],
        turn: [[0.0; LANES]; 2],
        turns: [[[0.0; LANES]; 2]; HOP],
        every_sample: false,
        points: ALL,
        reach: 0.0,
        undamped: [Heard::NONE; LANES],
        made_for: [0.0; LANES],
        played: [1e4; LANES],
        inverse: [1e-4; LANES],
        outside: [0.0; LANES],
        decay: [0.0; LANES],
        hop: [[0.0; LANES]; 2],
        cell: [[0.0; LANES]; 2],
    };

    /// Plays the modes at `ratio` times their frequency, sampled every `step_s`.
    ///
    /// No call to a library: sine and cosine of a quarter of the angle are short series.
    #[inline(always)]
    pub(crate) fn pitch(&mut self, ratio: f64, step_s: f64) {
        let mut turn = [[0.0; LANES]; 2];
        let mut power = [[0.0; LANES]; 2];
        let mut angles = [0.0; LANES];
        for i in 0..LANES {
            let omega = self.omega[i] * ratio;
            let angle = omega * step_s;
            let (sin, cos) = turned(angle.min(HIGHEST * PI));
            let heard = angle < HIGHEST * PI;
            turn[0][i] = if heard { cos } else { 0.0 };
            turn[1][i] = if heard { sin } else { 0.0 };
            power[0][i] = if heard { 1.0 } else { 0.0 };
            angles[i] = angle;
            self.played[i] = omega as f32;
            self.inverse[i] = (1.0 / omega) as f32;
        }
        self.turn = rounded(&turn);
        self.choose(&angles);
        let mut step = turn;
        if self.points != ALL {
            (power, step) = between(&POINTS[self.points], &angles);
        }
        for turns in &mut self.turns {
            *turns = rounded(&power);
            power = product(&power, &step);
        }
        self.hop = rounded(&to_the(step, HOP));
        self.cell = to_the(turn, GRID);
    }

    /// Chooses the points for modes of so many rad a sample.
    #[inline(always)]
    fn choose(&mut self, angles: &[f64; LANES]) {
        let mut highest = 0.0;
        for angle in angles {
            highest = f64::max(highest, *angle);
        }
        let fewest = fewest(highest);
        self.reach = POINTS[fewest].reach() as f32;
        self.points = if self.every_sample { ALL } else { fewest };
    }

    /// Takes up gains or a pitch that have moved.
    #[inline(always)]
    pub(super) fn hear(&mut self) {
        for (k, [re, im]) in self.turns.iter().enumerate() {
            for (ear, [x, y]) in self.gain.iter().enumerate() {
                for i in 0..LANES {
                    let [of_x, of_y] = &mut self.undamped[i].0;
                    of_x[ear * HOP + k] = x[i] * re[i] + y[i] * im[i];
                    of_y[ear * HOP + k] = y[i] * re[i] - x[i] * im[i];
                }
            }
        }
    }

    /// Real and imaginary part of exp(iωT).
    pub(crate) fn turn(&self) -> &[[f32; LANES]; 2] {
        &self.turn
    }

    /// Whether the mode is too high to be heard at this sample rate.
    pub(crate) fn is_silent(&self, lane: usize) -> bool {
        self.turn[0][lane] == 0.0 && self.turn[1][lane] == 0.0
    }
}

/// Sine and cosine of an angle of 0…4, to a few parts in 10¹⁶.
#[inline(always)]
pub(crate) fn turned(angle: f64) -> (f64, f64) {
    let quarter = 0.25 * angle;
    let t = quarter * quarter;
    let (mut sin, mut cos) = (1.0, 1.0);
    for k in [16.0, 14.0, 12.0, 10.0, 8.0, 6.0, 4.0, 2.0] {
        // The compiler works out the inverses: a division at every step would take the longest of all.
        sin = 1.0 - t * (1.0 / (k * (k + 1.0))) * sin;
        cos = 1.0 - t * (1.0 / (k * (k - 1.0))) * cos;
    }
    sin *= quarter;
    for _ in 0..2 {
        (sin, cos) = (2.0 * sin * cos, cos * cos - sin * sin);
    }
    (sin, cos)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn turns_are_sine_and_cosine() {
        for i in 0..=1000 {
            let angle = f64::from(i) / 250.0;
            let (sin, cos) = turned(angle);
            assert!((sin - angle.sin()).abs() < 2e-15, "{angle}");
            assert!((cos - angle.cos()).abs() < 2e-15, "{angle}");
        }
    }
}
