//! From the points of a cell to its samples, by least squares over all modes that the points do for.

use super::Buses;
use super::pack::{HOP, HOPS};
use super::points::{ALL, KINDS, POINTS, Points};
use crate::engine::GRID;
use pulp::Simd;
use std::f64::consts::PI;

/// Samples of half a cell: the other half mirrors them.
const HALF: usize = GRID / 2;

/// Frequencies of the modes that the samples are fitted to.
const FITTED: usize = 64;

/// What all points of a kind that is not samples make: pairs about the middle of the cell.
const PAIRS: usize = HOP / 2 * ROWS[ALL];

/// Rows of [`Sums`] before the points of each kind.
const ROWS: [usize; KINDS] = [0, 1, 3];

/// All rows of [`Sums`].
const ALL_ROWS: usize = ROWS[ALL] + HOPS;

/// Sound at the points of all kinds, hop by hop: left, then right.
pub(super) type Sums = [[f64; 2 * HOP]; ALL_ROWS];

/// Nothing at any point.
pub(super) const NO_SUMS: Sums = [[0.0; 2 * HOP]; ALL_ROWS];

/// The hops of points of this kind, `H` of them.
#[inline(always)]
pub(super) fn rows<const H: usize>(sums: &mut Sums, kind: usize) -> &mut [[f64; 2 * HOP]] {
    &mut sums[ROWS[kind]..][..H]
}

/// What the samples of a cell's first half get of each pair of points: of their sum, which is even about
/// the middle of the cell, and of their difference, which is odd.
#[repr(C, align(64))]
pub(crate) struct Between {
    even: [[f64; HALF]; PAIRS],
    odd: [[f64; HALF]; PAIRS],
}

impl Between {
    /// Worked out anew: some hundred thousand operations, for when nothing sounds yet.
    pub(super) fn new() -> Self {
        let mut between = Self {
            even: [[0.0; HALF]; PAIRS],
            odd: [[0.0; HALF]; PAIRS],
        };
        for (points, rows) in POINTS[..ALL].iter().zip(ROWS) {
            let pairs = rows * HOP / 2..rows * HOP / 2 + points.count() / 2;
            fit(points, f64::cos, &mut between.even[pairs.clone()]);
            fit(points, f64::sin, &mut between.odd[pairs]);
        }
        between
    }

    /// The samples of a cell in which the kinds of points that are `used` have sounded.
    #[inline(always)]
    pub(super) fn fill<S: Simd>(
        &self,
        s: S,
        (sums, used): (&Sums, [bool; KINDS]),
        out: &mut Buses,
    ) {
        for (ear, out) in out.iter_mut().enumerate() {
            for (hop, row) in sums[ROWS[ALL]..].iter().enumerate() {
                out[hop * HOP..][..HOP].copy_from_slice(&row[ear * HOP..][..HOP]);
            }
            if used[..ALL] == [false; ALL] {
                continue;
            }
            let (mut even, mut odd) = ([0.0; HALF], [0.0; HALF]);
            for (kind, (points, rows)) in POINTS[..ALL].iter().zip(ROWS).enumerate() {
                if !used[kind] {
                    continue;
                }
                let of_kind = &sums[rows..rows + points.hops];
                for pair in 0..points.count() / 2 {
                    let twin = points.count() - 1 - pair;
                    let at = |point: usize| of_kind[point / HOP][ear * HOP + point % HOP];
                    let number = rows * HOP / 2 + pair;
                    more(s, at(pair) + at(twin), &self.even[number], &mut even);
                    more(s, at(pair) - at(twin), &self.odd[number], &mut odd);
                }
            }
            for n in 0..HALF {
                out[n] += even[n] + odd[n];
                out[GRID - 1 - n] += even[n] - odd[n];
            }
        }
    }
}

/// Adds `share` times `row`.
#[inline(always)]
fn more<S: Simd>(s: S, share: f64, row: &[f64; HALF], sum: &mut [f64; HALF]) {
    let share = s.splat_f64s(share);
    let sum = S::as_mut_simd_f64s(sum).0.iter_mut();
    for (sum, row) in sum.zip(S::as_simd_f64s(row).0) {
        *sum = s.mul_add_e_f64s(share, *row, *sum);
    }
}

/// What the samples of the first half get of the sums of pairs of `points` if modes are cosines about the
/// middle of the cell (`wave`), or of their differences if they are sines.
///
/// Frequencies crowd towards the highest as Chebyshev's do. What single floats leave uncertain, 1e-7 of a
/// point, is made no more of than need be.
fn fit(points: &Points, wave: fn(f64) -> f64, shares: &mut [[f64; HALF]]) {
    let count = shares.len();
    let omega = |i: usize| points.highest * (0.5 * PI * (i as f64 + 0.5) / FITTED as f64).sin();
    let middle = 0.5 * (GRID - 1) as f64;
    let at_pair = |i, pair: usize| {
        2.0 * wave(omega(i) * (points.first() + points.apart * pair as f64 - middle))
    };
    let mean = |f: &dyn Fn(usize) -> f64| (0..FITTED).map(f).sum::<f64>() / FITTED as f64;
    let mut square = vec![0.0; count * count];
    for row in 0..count {
        for column in 0..count {
            square[row * count + column] = mean(&|i| at_pair(i, row) * at_pair(i, column));
        }
        square[row * count + row] += 1e-14;
        for (n, share) in shares[row].iter_mut().enumerate() {
            *share = mean(&|i| at_pair(i, row) * wave(omega(i) * (n as f64 - middle)));
        }
    }
    solve(&mut square, shares);
}

/// Solves a symmetric positive definite system in place by Cholesky's way.
fn solve(square: &mut [f64], shares: &mut [[f64; HALF]]) {
    let count = shares.len();
    for j in 0..count {
        for i in j..count {
            let known: f64 = (0..j)
                .map(|k| square[i * count + k] * square[j * count + k])
                .sum();
            let rest = square[i * count + j] - known;
            square[i * count + j] = if i == j {
                rest.sqrt()
            } else {
                rest / square[j * count + j]
            };
        }
    }
    for i in 0..count {
        for k in 0..i {
            let known = shares[k];
            for (share, known) in shares[i].iter_mut().zip(known) {
                *share -= square[i * count + k] * known;
            }
        }
        shares[i] = shares[i].map(|share| share / square[i * count + i]);
    }
    for i in (0..count).rev() {
        for k in i + 1..count {
            let known = shares[k];
            for (share, known) in shares[i].iter_mut().zip(known) {
                *share -= square[k * count + i] * known;
            }
        }
        shares[i] = shares[i].map(|share| share / square[i * count + i]);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A mode of any frequency that points do for, of any phase, damped as much as tables allow.
    #[test]
    fn samples_are_what_low_modes_make_them() {
        let between = Between::new();
        for (kind, points) in POINTS[..ALL].iter().enumerate() {
            let mut worst = 0.0f64;
            for step in 0..=200 {
                let omega = points.highest * f64::from(step) / 200.0;
                for (loss, phase) in [(0.0, 0.0), (0.0, 1.6), (0.065, 0.8), (0.065, 2.4)] {
                    let decay = loss / points.reach();
                    let mode = |t: f64| (-decay * t).exp() * (omega * t + phase).cos();
                    let mut sums = NO_SUMS;
                    for point in 0..points.count() {
                        let row = &mut sums[ROWS[kind] + point / HOP];
                        row[point % HOP] = mode(points.first() + points.apart * point as f64);
                    }
                    let mut out = [[0.0; GRID]; 2];
                    between.fill(pulp::Scalar, (&sums, [true; KINDS]), &mut out);
                    for (n, heard) in out[0].iter().enumerate() {
                        worst = worst.max((heard - mode(n as f64)).abs());
                    }
                    assert_eq!(out[1], [0.0; GRID]);
                }
            }
            let db = 20.0 * worst.log10();
            println!("{} points: {db:.1} dB off", points.count());
            assert!(db < -120.0, "{} points: {db} dB", points.count());
        }
    }

    /// Rounding of single floats at the points must not grow on the way to the samples.
    #[test]
    fn rounding_is_not_made_much_of() {
        let between = Between::new();
        for (points, rows) in POINTS[..ALL].iter().zip(ROWS) {
            let pairs = rows * HOP / 2..rows * HOP / 2 + points.count() / 2;
            let worst = (0..HALF).fold(0.0f64, |worst, n| {
                let square = |rows: &[[f64; HALF]]| rows.iter().map(|r| r[n] * r[n]).sum::<f64>();
                worst
                    .max(square(&between.even[pairs.clone()]) + square(&between.odd[pairs.clone()]))
            });
            let gain = (2.0 * worst).sqrt();
            println!("{} points: {gain:.2}", points.count());
            assert!(gain < 4.0, "{} points: {gain}", points.count());
        }
    }
}
