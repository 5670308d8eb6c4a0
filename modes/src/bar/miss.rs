//! How far a bar's partials are off, and the linear algebra of steps that bring them nearer.

use super::tuning::BarTuning;

/// How far three modes are off, in cents.
pub(super) fn cents(hz: [f64; 3], tuning: &BarTuning) -> [f64; 3] {
    let [second, third] = tuning.ratios;
    let ratios = [1.0, second, third];
    [0, 1, 2].map(|i| 1200.0 * (hz[i] / (ratios[i] * tuning.pitch_hz)).log2())
}

/// Whether the pitch is off by no more than the first figure, the upper modes than the second.
pub(super) fn within(cents: [f64; 3], [pitch, upper]: [f64; 2]) -> bool {
    cents[0].abs() <= pitch && cents[1..].iter().all(|c| c.abs() <= upper)
}

pub(super) fn worst(cents: [f64; 3]) -> f64 {
    cents.iter().fold(0.0, |worst, c| worst.max(c.abs()))
}

/// Turns `slopes` until they foresee `change` where `moved` leads (Broyden 1965).
pub(super) fn improve<const N: usize>(
    slopes: &mut [[f64; N]; 3],
    moved: [f64; N],
    change: [f64; 3],
) {
    let square: f64 = moved.iter().map(|m| m * m).sum();
    if square == 0.0 {
        return;
    }
    for (row, change) in slopes.iter_mut().zip(change) {
        let foreseen: f64 = row.iter().zip(moved).map(|(slope, m)| slope * m).sum();
        for (slope, m) in row.iter_mut().zip(moved) {
            *slope += (change - foreseen) * m / square;
        }
    }
}

/// Derivatives of `cents_off` (rows) at `x`, where it is `cents`.
pub(super) fn slopes<const N: usize, E>(
    cents_off: impl Fn([f64; N]) -> Result<[f64; 3], E>,
    x: [f64; N],
    cents: [f64; 3],
) -> Result<[[f64; N]; 3], E> {
    const DIFFERENCE: f64 = 1e-3;
    let mut slopes = [[0.0; N]; 3];
    for column in 0..N {
        let mut aside = x;
        aside[column] += DIFFERENCE;
        let moved = cents_off(aside)?;
        for row in 0..3 {
            slopes[row][column] = (moved[row] - cents[row]) / DIFFERENCE;
        }
    }
    Ok(slopes)
}

/// x of A x = b by Cramer's rule, rows of A given; `None` if A is singular.
pub(super) fn solved(a: &[[f64; 3]; 3], b: [f64; 3]) -> Option<[f64; 3]> {
    let determinant = |m: &[[f64; 3]; 3]| {
        (0..3)
            .map(|i| {
                let (j, k) = ((i + 1) % 3, (i + 2) % 3);
                m[0][i] * (m[1][j] * m[2][k] - m[1][k] * m[2][j])
            })
            .sum::<f64>()
    };
    let whole = determinant(a);
    let x = [0, 1, 2].map(|column| {
        let mut replaced = *a;
        for row in 0..3 {
            replaced[row][column] = b[row];
        }
        determinant(&replaced) / whole
    });
    x.iter().all(|x| x.is_finite()).then_some(x)
}
