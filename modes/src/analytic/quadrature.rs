//! Gauss's rule.

use std::f64::consts::PI;
use std::sync::OnceLock;

/// Most points of a rule that is kept.
const KEPT: usize = 512;

/// As [`gauss`], of at least `points` points as far as there are rules of so many, and made once.
pub(crate) fn gauss_kept(points: usize) -> &'static [(f64, f64)] {
    // Of eight times as many points each.
    static RULES: [OnceLock<Vec<(f64, f64)>>; KEPT / 8] = [const { OnceLock::new() }; KEPT / 8];
    let number = points.div_ceil(8).clamp(1, KEPT / 8);
    RULES[number - 1].get_or_init(|| gauss(8 * number))
}

/// Abscissae and weights of Gauss's rule of `points` points on 0…1: exact for polynomials of degree
/// 2 `points` − 1 (DLMF §3.5(v)).
pub(crate) fn gauss(points: usize) -> Vec<(f64, f64)> {
    let n = points as f64;
    (0..points)
        .map(|i| {
            let mut x = (PI * (i as f64 + 0.75) / (n + 0.5)).cos();
            let mut slope = 0.0;
            for _ in 0..20 {
                let (value, below) = legendre(points, x);
                slope = n * (x * value - below) / (x * x - 1.0);
                x -= value / slope;
            }
            (0.5 * (1.0 - x), 1.0 / ((1.0 - x * x) * slope * slope))
        })
        .collect()
}

/// Legendre's polynomial of degree `n`, at least 1, and the one below it.
fn legendre(n: usize, x: f64) -> (f64, f64) {
    (1..n).fold((x, 1.0), |(value, below), k| {
        let k = k as f64;
        (((2.0 * k + 1.0) * x * value - k * below) / (k + 1.0), value)
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rules_that_are_kept_have_enough_points() {
        for points in [0, 1, 8, 9, 100] {
            let rule = gauss_kept(points);
            assert!(rule.len() >= points && rule.len() < points + 8 + 1);
            assert_eq!(rule, gauss(rule.len()));
        }
        assert_eq!(gauss_kept(usize::MAX).len(), KEPT);
    }

    #[test]
    fn powers_up_to_twice_the_points_are_exact() {
        for points in [1, 2, 5, 20, 40] {
            let rule = gauss(points);
            for power in 0..2 * points as i32 {
                let sum: f64 = rule.iter().map(|(x, weight)| weight * x.powi(power)).sum();
                let exact = 1.0 / f64::from(power + 1);
                assert!((sum - exact).abs() < 1e-14, "{points} {power} {sum}");
            }
        }
    }
}
