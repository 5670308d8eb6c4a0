//! How far modes are from orthonormal, by quadrature: for tests.

use super::ClosedMode;
use super::quadrature::gauss;

/// Greatest |∫φᵢφⱼ dm − δᵢⱼ| over a patch that `place` draws from the unit square: the point in m and
/// dm/du dv in kg, with `points` of Gauss's points each way.
pub(super) fn worst_overlap<M: ClosedMode>(
    modes: &[M],
    points: usize,
    place: impl Fn(f64, f64) -> ([f64; 2], f64),
) -> f64 {
    let rule = gauss(points);
    let mut overlaps = vec![0.0; modes.len() * modes.len()];
    for (u, along) in &rule {
        for (v, across) in &rule {
            let (at_m, mass_kg) = place(*u, *v);
            let values: Vec<f64> = modes.iter().map(|m| m.displacement(at_m)).collect();
            for (i, p) in values.iter().enumerate() {
                for (j, q) in values.iter().enumerate() {
                    overlaps[i * modes.len() + j] += along * across * mass_kg * p * q;
                }
            }
        }
    }
    let identity = |at: usize| {
        if at.is_multiple_of(modes.len() + 1) {
            1.0
        } else {
            0.0
        }
    };
    let errors = overlaps.iter().enumerate();
    errors
        .map(|(at, overlap)| (overlap - identity(at)).abs())
        .fold(0.0, f64::max)
}
