//! Bricks against Rayleigh and Ritz's method on polynomials (Demarest, J. Acoust. Soc. Am. 49, 1971;
//! Visscher et al., the same 90, 1991).

use super::{material, modes_hz, worst};
use crate::fem::{Pattern, Pencil};
use crate::mesh::brick_tet10;
use crate::solve::{Band, modes_in_band};
use std::sync::Arc;

/// Greatest sum of the polynomials' degrees.
const DEGREE: usize = 8;

/// Legendre polynomials normalised on −1…1 have derivatives dᵢ = Σ D(i, j) pⱼ with
/// D(i, j) = √((2i + 1)(2j + 1)) for i − j odd and positive, else 0.
fn slope(i: usize, j: usize) -> f64 {
    if i > j && (i - j) % 2 == 1 {
        (((2 * i + 1) * (2 * j + 1)) as f64).sqrt()
    } else {
        0.0
    }
}

/// Frequencies in Hz of a brick of `sides_m` below `highest_hz`.
fn ritz_hz(sides_m: [f64; 3], highest_hz: f64) -> Vec<f64> {
    let degrees = 0..=DEGREE;
    let all = degrees.clone().flat_map(|i| {
        let degrees = degrees.clone();
        degrees
            .clone()
            .flat_map(move |j| degrees.clone().map(move |k| [i, j, k]))
    });
    let basis: Vec<[usize; 3]> = all.filter(|d| d.iter().sum::<usize>() <= DEGREE).collect();
    let same = |i: usize, j: usize| f64::from(u8::from(i == j));
    // ∫ ∂ₐf ∂_b g of two products of polynomials, lengths in half sides.
    let product = |f: &[usize; 3], g: &[usize; 3], a: usize, b: usize| -> f64 {
        (0..3)
            .map(|axis| {
                let (i, j) = (f[axis], g[axis]);
                match (axis == a, axis == b) {
                    (false, false) => same(i, j),
                    (true, false) => slope(i, j),
                    (false, true) => slope(j, i),
                    (true, true) => (0..DEGREE).map(|k| slope(i, k) * slope(j, k)).sum(),
                }
            })
            .product::<f64>()
            * 4.0
            / (sides_m[a] * sides_m[b])
    };
    let material = material();
    let (lambda, mu) = (material.lambda_pa, material.mu_pa);
    let unknowns = 3 * basis.len();
    let (mut columns, mut stiffness, mut mass) = (Vec::new(), Vec::new(), Vec::new());
    for column in 0..unknowns {
        let (g, b) = (&basis[column / 3], column % 3);
        let mut rows = Vec::new();
        for row in column..unknowns {
            let (f, a) = (&basis[row / 3], row % 3);
            let mut entry = lambda * product(f, g, a, b) + mu * product(f, g, b, a);
            if a == b {
                entry += mu * (0..3).map(|c| product(f, g, c, c)).sum::<f64>();
            }
            rows.push(u32::try_from(row).unwrap());
            stiffness.push(entry);
            mass.push(material.density_kg_m3 * same(row, column));
        }
        columns.push(rows);
    }
    let pencil = Pencil {
        pattern: Arc::new(Pattern::from_columns(&columns)),
        stiffness,
        mass,
        rigid: 6,
    };
    let band = Band {
        low_hz: 20.0,
        high_hz: highest_hz,
    };
    let solution = modes_in_band(&pencil, band).unwrap();
    solution.modes.iter().map(|mode| mode.hz).collect()
}

/// A cube's mode in which it shears without changing its volume: √2 c_t/2L whatever Poisson's ratio
/// (Lamé 1852).
fn lame_hz(side_m: f64) -> f64 {
    let material = material();
    (material.mu_pa / material.density_kg_m3).sqrt() / (2f64.sqrt() * side_m)
}

#[test]
fn polynomials_find_lame_s_mode() {
    let expected = lame_hz(0.1);
    let found = ritz_hz([0.1; 3], 1.2 * expected);
    let nearest = found.iter().map(|hz| (hz / expected - 1.0).abs());
    let nearest = nearest.fold(f64::INFINITY, f64::min);
    assert!(nearest < 1e-6, "{nearest:e}");
}

#[test]
fn a_cube_has_demarest_s_modes() {
    let expected = ritz_hz([0.1; 3], 30e3);
    let coarse = worst(
        &modes_hz(&brick_tet10([0.1; 3], [3; 3]), 30e3),
        &expected,
        20,
    );
    let fine = worst(
        &modes_hz(&brick_tet10([0.1; 3], [4; 3]), 30e3),
        &expected,
        20,
    );
    println!("cube: {coarse:.2e}, {fine:.2e}");
    assert!(coarse < 0.01 && fine < 0.003, "{coarse} {fine}");
}

#[test]
fn a_brick_of_three_sides_has_its_modes() {
    let sides_m = [0.1, 0.07, 0.045];
    let expected = ritz_hz(sides_m, 50e3);
    let found = modes_hz(&brick_tet10(sides_m, [5, 4, 3]), 50e3);
    let worst = worst(&found, &expected, 10);
    println!("brick: {worst:.2e}");
    assert!(worst < 0.003, "{worst}");
}
