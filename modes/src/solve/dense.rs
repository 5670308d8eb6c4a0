//! Dense eigenproblems: small pencils whole, and the projected problem of Lanczos.

use super::SolveError;
use crate::fem::Pencil;
use faer::{MatMut, MatRef, Side};

/// Eigenvalues, rising, and eigenvectors (columns back to back) of a symmetric matrix of order n
/// given column by column.
pub(super) fn symmetric(matrix: &[f64], n: usize) -> (Vec<f64>, Vec<f64>) {
    // faer 0.24's divide and conquer loses all accuracy on entries of 10¹⁵: scale them to 1.
    let largest = matrix.iter().fold(0.0f64, |m, entry| m.max(entry.abs()));
    let scale = if largest > 0.0 { largest } else { 1.0 };
    let scaled: Vec<f64> = matrix.iter().map(|entry| entry / scale).collect();
    let eigen = MatRef::from_column_major_slice(&scaled, n, n)
        .self_adjoint_eigen(Side::Lower)
        .expect("a finite symmetric matrix has eigenvalues");
    let values = (0..n).map(|i| scale * eigen.S()[i]).collect();
    let vectors = (0..n)
        .flat_map(|j| (0..n).map(move |i| (i, j)))
        .map(|at| eigen.U()[at])
        .collect();
    (values, vectors)
}

/// All eigenpairs of `pencil`: λ rising, vectors M-orthonormal. O(n³).
pub(super) fn generalised(pencil: &Pencil) -> Result<(Vec<f64>, Vec<f64>), SolveError> {
    let n = pencil.unknowns();
    let full = |values: &[f64]| {
        let mut matrix = vec![0.0; n * n];
        for j in 0..n {
            for at in pencil.pattern.column(j) {
                let i = pencil.pattern.rows[at] as usize;
                matrix[j * n + i] = values[at];
                matrix[i * n + j] = values[at];
            }
        }
        matrix
    };
    reduced(&full(&pencil.stiffness), &full(&pencil.mass), n)
}

/// All eigenpairs of the pencil of two symmetric matrices of order n, given column by column: λ
/// rising, vectors orthonormal in the second.
///
/// As in O'Brien 2002, Eqs. 4–5: M = LLᵀ, then L⁻¹KL⁻ᵀ = VΛVᵀ, and the modes are L⁻ᵀV.
pub(super) fn reduced(
    stiffness: &[f64],
    mass: &[f64],
    n: usize,
) -> Result<(Vec<f64>, Vec<f64>), SolveError> {
    let mass = MatRef::from_column_major_slice(mass, n, n);
    let cholesky = mass.llt(Side::Lower).map_err(|_| SolveError::Indefinite)?;
    let lower = cholesky.L();
    let mut half = MatRef::from_column_major_slice(stiffness, n, n).to_owned();
    lower.solve_lower_triangular_in_place(half.as_mut());
    let mut whole = half.transpose().to_owned();
    lower.solve_lower_triangular_in_place(whole.as_mut());
    let balanced: Vec<f64> = (0..n * n)
        .map(|at| 0.5 * (whole[(at % n, at / n)] + whole[(at / n, at % n)]))
        .collect();
    let (values, mut vectors) = symmetric(&balanced, n);
    lower
        .transpose()
        .solve_upper_triangular_in_place(MatMut::from_column_major_slice_mut(&mut vectors, n, n));
    Ok((values, vectors))
}

#[cfg(test)]
mod tests {
    use super::symmetric;

    /// Second differences of order n: eigenvalues 2 − 2 cos(kπ/(n + 1)).
    #[test]
    fn eigenvalues_of_a_chain_at_any_scale() {
        let n = 60;
        for scale in [1e-15, 1.0, 1e15] {
            let mut matrix = vec![0.0; n * n];
            for i in 0..n {
                matrix[i * n + i] = 2.0 * scale;
                if i > 0 {
                    matrix[i * n + i - 1] = -scale;
                    matrix[(i - 1) * n + i] = -scale;
                }
            }
            let (values, vectors) = symmetric(&matrix, n);
            for (k, value) in values.iter().enumerate() {
                let angle = (k + 1) as f64 * std::f64::consts::PI / (n + 1) as f64;
                let expected = scale * (2.0 - 2.0 * angle.cos());
                assert!((value - expected).abs() < 1e-14 * scale, "{k}");
                let vector = &vectors[k * n..(k + 1) * n];
                let residual = 2.0 * vector[0] - vector[1] - value / scale * vector[0];
                assert!(residual.abs() < 1e-14, "{k}: {residual:e}");
            }
        }
    }
}
