//! The isotropic elastic kernel that every element shares.

use crate::Material;

/// Adds `weight` times the 3×3 stiffness block between shape functions of gradients `gi`, `gj`:
/// λ gᵢ gⱼᵀ + μ gⱼ gᵢᵀ + μ gᵢ·gⱼ I (O'Brien 2002, Eq. 12 without its factor ½; see Hughes 1987,
/// §2.8).
pub(super) fn add_block(
    block: &mut [[f64; 3]; 3],
    material: &Material,
    weight: f64,
    gi: &[f64; 3],
    gj: &[f64; 3],
) {
    let (lambda, mu) = (weight * material.lambda_pa, weight * material.mu_pa);
    let trace = mu * (gi[0] * gj[0] + gi[1] * gj[1] + gi[2] * gj[2]);
    for a in 0..3 {
        for b in 0..3 {
            block[a][b] += lambda * gi[a] * gj[b] + mu * gi[b] * gj[a];
        }
        block[a][a] += trace;
    }
}

/// Gradients by x, y, z of the shape functions of an element with these `nodes`, from their gradients
/// by its `local` coordinates, and the Jacobian's determinant; `None` unless that is positive.
pub(super) fn physical_gradients<const N: usize>(
    local: &[[f64; 3]; N],
    nodes: &[[f64; 3]; N],
) -> Option<([[f64; 3]; N], f64)> {
    let mut jacobian = [[0.0; 3]; 3];
    for (slope, position) in local.iter().zip(nodes) {
        for (row, d) in jacobian.iter_mut().zip(slope) {
            for (entry, coordinate) in row.iter_mut().zip(position) {
                *entry += d * coordinate;
            }
        }
    }
    let det = determinant(&jacobian);
    if det.is_nan() || det <= 0.0 {
        return None;
    }
    let inv = inverse(&jacobian, det);
    let gradients = local.map(|slope| {
        [0, 1, 2].map(|a| inv[a][0] * slope[0] + inv[a][1] * slope[1] + inv[a][2] * slope[2])
    });
    Some((gradients, det))
}

/// Determinant of a 3×3 matrix.
pub(super) fn determinant(m: &[[f64; 3]; 3]) -> f64 {
    m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1])
        - m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0])
        + m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0])
}

/// Inverse of a 3×3 matrix of known determinant.
pub(super) fn inverse(m: &[[f64; 3]; 3], determinant: f64) -> [[f64; 3]; 3] {
    let cofactor = |r0: usize, c0: usize, r1: usize, c1: usize| {
        (m[r0][c0] * m[r1][c1] - m[r0][c1] * m[r1][c0]) / determinant
    };
    [
        [
            cofactor(1, 1, 2, 2),
            -cofactor(0, 1, 2, 2),
            cofactor(0, 1, 1, 2),
        ],
        [
            -cofactor(1, 0, 2, 2),
            cofactor(0, 0, 2, 2),
            -cofactor(0, 0, 1, 2),
        ],
        [
            cofactor(1, 0, 2, 1),
            -cofactor(0, 0, 2, 1),
            cofactor(0, 0, 1, 1),
        ],
    ]
}
