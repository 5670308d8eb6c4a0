//! Spheres, solid and hollow, against the roots of their frequency equations (Lamb, On the vibrations
//! of an elastic sphere, Proc. London Math. Soc. 13, 1882; in the form of Eringen & Suhubi,
//! Elastodynamics II, 1975, §8.14).

use super::{material, modes_hz, worst};
use crate::mesh::{ball_tet10, hollow_ball_tet10};
use std::f64::consts::TAU;

/// Spherical Bessel function of the first (0) or second kind (1), by recurrence from order 0; upwards
/// for the second, downwards for the first.
fn bessel(kind: usize, n: usize, x: f64) -> f64 {
    if kind == 1 {
        let (mut before, mut now) = (-x.cos() / x, -x.cos() / (x * x) - x.sin() / x);
        for order in 1..=n {
            (before, now) = (now, (2.0 * order as f64 + 1.0) / x * now - before);
        }
        return before;
    }
    let (mut above, mut now, mut wanted) = (0.0, 1e-30, 0.0);
    for order in (0..n + 40).rev() {
        // `now` is of order + 1.
        if order + 1 == n {
            wanted = now;
        }
        (above, now) = (now, (2.0 * order as f64 + 3.0) / x * now - above);
    }
    if n == 0 {
        wanted = now;
    }
    wanted / now * x.sin() / x
}

/// Tractions over radius² of the two waves that shear and press, radial then tangential, times constants;
/// α = ωr/c_l, β = ωr/c_t.
fn spheroidal(kind: usize, n: usize, alpha: f64, beta: f64) -> [[f64; 2]; 2] {
    let order = n as f64;
    let [a, a1] = [n, n + 1].map(|n| bessel(kind, n, alpha));
    let [b, b1] = [n, n + 1].map(|n| bessel(kind, n, beta));
    [
        [
            (order * order - order - 0.5 * beta * beta) * a + 2.0 * alpha * a1,
            order * (order + 1.0) * ((order - 1.0) * b - beta * b1),
        ],
        [
            (order - 1.0) * a - alpha * a1,
            (order * order - 1.0 - 0.5 * beta * beta) * b + beta * b1,
        ],
    ]
}

/// Traction over radius of the wave that twists.
fn torsional(kind: usize, n: usize, beta: f64) -> f64 {
    (n as f64 - 1.0) * bessel(kind, n, beta) - beta * bessel(kind, n + 1, beta)
}

/// By rows with pivots.
fn determinant(mut m: Vec<Vec<f64>>) -> f64 {
    let mut product = 1.0;
    for k in 0..m.len() {
        let pivot = (k..m.len()).max_by(|&i, &j| m[i][k].abs().total_cmp(&m[j][k].abs()));
        let pivot = pivot.unwrap();
        if pivot != k {
            m.swap(pivot, k);
            product = -product;
        }
        product *= m[k][k];
        let above = m[k].clone();
        for row in &mut m[k + 1..] {
            let factor = row[k] / above[k];
            for (x, above) in row.iter_mut().zip(&above).skip(k) {
                *x -= factor * above;
            }
        }
    }
    product
}

/// Angular frequencies below `top` at which `of` vanishes.
fn roots(of: impl Fn(f64) -> f64, top: f64) -> Vec<f64> {
    let steps = 4000;
    let at = |i: i32| top * (f64::from(i) + 0.5) / f64::from(steps);
    let mut found = Vec::new();
    for i in 0..steps - 1 {
        let (mut low, mut high) = (at(i), at(i + 1));
        if of(low) * of(high) >= 0.0 {
            continue;
        }
        for _ in 0..60 {
            let middle = 0.5 * (low + high);
            if of(low) * of(middle) <= 0.0 {
                high = middle;
            } else {
                low = middle;
            }
        }
        found.push(low);
    }
    found
}

/// Frequencies in Hz below `highest_hz` of what is between `inner_m` (0 for a solid ball) and `outer_m`,
/// each as often as it occurs.
pub(super) fn exact_hz(inner_m: f64, outer_m: f64, highest_hz: f64) -> Vec<f64> {
    let material = material();
    let stiffness = material.lambda_pa + 2.0 * material.mu_pa;
    let [long, shear] = [stiffness, material.mu_pa].map(|c| (c / material.density_kg_m3).sqrt());
    let radii: Vec<f64> = [outer_m, inner_m]
        .into_iter()
        .filter(|r| *r > 0.0)
        .collect();
    let top = TAU * highest_hz;
    let mut all = Vec::new();
    for n in 0..12 {
        let twist = |omega: f64| {
            let row = |r: &f64| -> Vec<f64> {
                let kinds = 0..radii.len();
                kinds
                    .map(|kind| torsional(kind, n, omega * r / shear))
                    .collect()
            };
            determinant(radii.iter().map(row).collect())
        };
        let press = |omega: f64| {
            let rows = |r: &f64| {
                let both = (0..radii.len())
                    .map(|kind| spheroidal(kind, n, omega * r / long, omega * r / shear));
                let both: Vec<_> = both.collect();
                // Without waves to twist into, order 0 has but the radial traction.
                let width = if n == 0 { 1 } else { 2 };
                (0..width)
                    .map(|i| both.iter().flat_map(|m| m[i][..width].to_vec()).collect())
                    .collect::<Vec<Vec<f64>>>()
            };
            determinant(radii.iter().flat_map(rows).collect())
        };
        let mut found = roots(press, top);
        if n > 0 {
            found.extend(roots(twist, top));
        }
        for omega in found {
            all.extend(std::iter::repeat_n(omega / TAU, 2 * n + 1));
        }
    }
    all.sort_by(f64::total_cmp);
    all
}

/// Of ν = 1/4: k_t a = 2.501 for the lowest twist and 2.640 for the lowest squeeze (Love, A Treatise on
/// the Mathematical Theory of Elasticity, 1927, §195).
#[test]
fn the_equations_have_the_published_roots() {
    let near = |found: f64, expected: f64| assert!((found - expected).abs() < 1e-3, "{found}");
    near(roots(|beta| torsional(0, 2, beta), 4.0)[0], 2.501);
    let squeeze = |beta: f64| {
        let m = spheroidal(0, 2, beta / 3f64.sqrt(), beta);
        m[0][0] * m[1][1] - m[0][1] * m[1][0]
    };
    near(roots(squeeze, 4.0)[0], 2.640);
}

#[test]
fn a_solid_ball_has_lamb_s_modes() {
    let exact = exact_hz(0.0, 0.05, 60e3);
    let coarse = worst(&modes_hz(&ball_tet10(0.05, 2, 1), 60e3), &exact, 10);
    let fine = worst(&modes_hz(&ball_tet10(0.05, 3, 2), 60e3), &exact, 10);
    println!("ball: {coarse:.2e}, {fine:.2e}");
    assert!(coarse < 0.01 && fine < 0.003, "{coarse} {fine}");
}

#[test]
fn a_hollow_ball_has_its_modes() {
    let exact = exact_hz(0.04, 0.05, 40e3);
    let coarse = worst(
        &modes_hz(&hollow_ball_tet10([0.04, 0.05], 3, 1), 40e3),
        &exact,
        16,
    );
    let fine = worst(
        &modes_hz(&hollow_ball_tet10([0.04, 0.05], 5, 1), 40e3),
        &exact,
        16,
    );
    println!("hollow ball: {coarse:.2e}, {fine:.2e}");
    assert!(coarse < 0.01 && fine < 0.003, "{coarse} {fine}");
}
