//! The smallest angle between two families of functions: the generalised singular value that the
//! method of particular solutions looks for (Betcke & Trefethen 2005, SIAM Review 47, p. 469).

use faer::Mat;

/// How nearly a combination of functions vanishes where it should.
pub(crate) struct SmallestAngle {
    /// Size on the boundary of the combination of unit size on all points that is least there.
    pub(crate) sine: f64,
    /// Its coefficients.
    pub(crate) coefficients: Vec<f64>,
}

/// The combination of functions that is least on the first `boundary` of `points`. `values` holds the
/// functions' values at the points, function by function.
///
/// All values are orthogonalised (QR), which keeps combinations that vanish everywhere out of the
/// search; the angle's sine is the smallest singular value of what belongs to the boundary.
pub(crate) fn smallest_angle(values: &[f64], points: usize, boundary: usize) -> SmallestAngle {
    let functions = values.len() / points;
    // Functions of one size: their own differ by hundreds of decades.
    let sizes: Vec<f64> = values
        .chunks_exact(points)
        .map(|function| function.iter().map(|v| v * v).sum::<f64>().sqrt())
        .collect();
    let scaled = Mat::from_fn(points, functions, |i, j| values[j * points + i] / sizes[j]);
    let qr = scaled.qr();
    let orthogonal = qr.compute_thin_Q();
    let on_boundary = orthogonal.get(..boundary, ..);
    let svd = on_boundary.thin_svd();
    let svd = svd.expect("a finite matrix has singular values");
    let least = functions - 1;
    let mut column = Mat::from_fn(functions, 1, |i, _| svd.V()[(i, least)]);
    qr.thin_R().solve_upper_triangular_in_place(column.as_mut());
    SmallestAngle {
        sine: svd.S()[least],
        coefficients: (0..functions).map(|j| column[(j, 0)] / sizes[j]).collect(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// On the first two of four points (1, 0, 1, 0) and (0, 1, 0, 2): the second is least there, by
    /// 1/√5.
    #[test]
    fn the_least_of_two_orthogonal_functions() {
        let values = [1.0, 0.0, 1.0, 0.0, 0.0, 1.0, 0.0, 2.0];
        let found = smallest_angle(&values, 4, 2);
        assert!((found.sine - 1.0 / 5f64.sqrt()).abs() < 1e-15);
        let [first, second] = [found.coefficients[0], found.coefficients[1]];
        assert!(first.abs() < 1e-15 && (second.abs() - 1.0 / 5f64.sqrt()).abs() < 1e-15);
    }
}
