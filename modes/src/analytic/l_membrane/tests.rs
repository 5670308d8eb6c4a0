//! The L of unit squares against published figures.

use super::*;
use crate::analytic::quadrature::gauss;
use std::f64::consts::{FRAC_PI_4, PI};

/// The first eigenvalue (Betcke & Trefethen 2005, §5, of which these are the digits that an f64 tells
/// apart), 2π², and others as in Fox, Henrici & Moler 1967, table 2.
#[test]
fn eigenvalues_are_the_published_ones() {
    let found = LSpectrum::new(8.0);
    let squares: Vec<f64> = found.roots().iter().map(|root| root * root).collect();
    for (found, published, unit) in [
        (squares[0], 9.639_723_844_021_9, 1e-12),
        (squares[1], 15.197_252, 1e-6),
        (squares[2], 2.0 * PI * PI, 1e-13),
        (squares[3], 29.521_481, 1e-6),
        (squares[4], 31.912_636, 1e-6),
    ] {
        // Half of the last digit, and rounding.
        assert!(
            (found - published).abs() < 0.6 * unit,
            "{found} {published}"
        );
    }
}

#[test]
fn a_spectrum_is_kept_until_another_is_asked_for() {
    let first = LSpectrum::kept(4.0);
    assert_eq!(first.roots(), LSpectrum::new(4.0).roots());
    assert_eq!(LSpectrum::kept(5.0).roots(), LSpectrum::new(5.0).roots());
}

/// Weyl's law with its perimeter and corners, A κ²/4π − L κ/4π + Σ (π² − α²)/24πα, is the mean of the
/// count; one mode that is missing or double lifts or lowers the rest of the staircase by one.
#[test]
fn no_mode_is_missing() {
    let spectrum = LSpectrum::new(22.0);
    assert!(spectrum.worst_sine() < 1e-10, "{:e}", spectrum.worst_sine());
    let mean = |root: f64| 3.0 * root * root / (4.0 * PI) - 8.0 * root / (4.0 * PI) + 5.0 / 18.0;
    let roots = spectrum.roots();
    for (i, part) in roots.chunks(33).enumerate() {
        let excess = part.iter().enumerate().map(|(j, &root)| {
            let count = (33 * i + j) as f64 + 0.5;
            count - mean(root)
        });
        let excess = excess.sum::<f64>() / part.len() as f64;
        assert!(excess.abs() < 0.4, "{i}: {excess}");
    }
}

/// Six triangles about the inner corner make up the L; with the cube of a parameter as distance, waves
/// in powers of r^(2/3) are polynomials.
#[test]
fn modes_are_orthonormal() {
    let spectrum = LSpectrum::new(14.0);
    let membrane = LMembrane {
        square_m: 0.2,
        tension_n_m: 3000.0,
        mass_kg_m2: 0.26,
    };
    let modes = membrane.modes(&spectrum, f64::INFINITY);
    assert!(modes.len() > 30);
    let (along, around) = (gauss(36), gauss(24));
    let mut overlaps = vec![0.0; modes.len() * modes.len()];
    for triangle in 0..6 {
        // From the edge at 90°, the nearer side of the square is at a distance of 1.
        let start = FRAC_PI_4 * f64::from(triangle + 2);
        let middle = PI / 2.0 * f64::from((triangle + 3) / 2);
        for (u, across) in &around {
            let angle = start + FRAC_PI_4 * u;
            let far_m = membrane.square_m / (angle - middle).cos();
            for (t, outwards) in &along {
                let r_m = far_m * t.powi(3);
                let area_m2 = FRAC_PI_4 * r_m * 3.0 * far_m * t * t * across * outwards;
                let (sin, cos) = angle.sin_cos();
                let at_m = [cos, sin].map(|way| membrane.square_m + r_m * way);
                let values: Vec<f64> = modes.iter().map(|mode| mode.displacement(at_m)).collect();
                for (i, p) in values.iter().enumerate() {
                    for (j, q) in values.iter().enumerate() {
                        overlaps[i * modes.len() + j] += membrane.mass_kg_m2 * area_m2 * p * q;
                    }
                }
            }
        }
    }
    for (at, overlap) in overlaps.iter().enumerate() {
        let [i, j] = [at / modes.len(), at % modes.len()];
        let identity = if i == j { 1.0 } else { 0.0 };
        assert!((overlap - identity).abs() < 1e-8, "{i} {j}: {overlap}");
    }
}

#[test]
fn the_edge_rests() {
    let spectrum = LSpectrum::new(16.0);
    let membrane = LMembrane {
        square_m: 1.0,
        tension_n_m: 1.0,
        mass_kg_m2: 1.0,
    };
    for mode in membrane.modes(&spectrum, f64::INFINITY) {
        for i in 0..=20 {
            let at = f64::from(i) / 20.0;
            let edge = [
                [0.0, 2.0 * at],
                [2.0 * at, 0.0],
                [2.0, at],
                [at, 2.0],
                [1.0, 1.0 + at],
                [1.0 + at, 1.0],
            ];
            for at_m in edge {
                let moves = mode.displacement(at_m).abs();
                assert!(moves < 1e-8, "{} at {at_m:?}: {moves:e}", mode.label());
            }
        }
    }
}
