//! Orthonormal panels in the inner product of M.

use super::panel::{WIDTH, add_product, inner};
use super::sparse::Mass;

/// Pivots of a Gram matrix, relative to its diagonal, above which two Cholesky rounds leave nothing
/// but rounding (Yamamoto et al. 2015).
const SAFE_PIVOT: f64 = 1e-10;

/// A triangle R, row by row.
pub(super) type Triangle = [f64; WIDTH * WIDTH];

/// Replaces the panel W by Q with W = Q R, QᵀMQ = I; sets `mass_q` to MQ and returns R. `None`, with
/// W as it was, if its vectors are nearly dependent or what is new in one is no longer than in
/// `shortest`. `gram` is WᵀMW; the last are two panels to work in.
pub(super) fn cholesky_qr(
    mass: &Mass,
    w: &mut [f64],
    (gram, shortest): (&[f64], &[f64; WIDTH]),
    mass_q: &mut [f64],
    [q, product]: [&mut [f64]; 2],
) -> Option<Triangle> {
    let first = cholesky(gram)?;
    q.fill(0.0);
    add_product(q, w, &inverse(&first));
    mass.multiply(q, product);
    let second = cholesky(&inner(q, product))?;
    let triangle = multiply(&second, &first);
    if (0..WIDTH).any(|j| triangle[j * WIDTH + j] <= shortest[j]) {
        return None;
    }
    // The second triangle is nearly the identity.
    let correction = inverse(&second);
    w.fill(0.0);
    add_product(w, q, &correction);
    mass_q.fill(0.0);
    add_product(mass_q, product, &correction);
    Some(triangle)
}

/// R with RᵀR = G, if the pivots are safe.
fn cholesky(gram: &[f64]) -> Option<Triangle> {
    let mut r: Triangle = [0.0; WIDTH * WIDTH];
    for i in 0..WIDTH {
        for j in i..WIDTH {
            let known: f64 = (0..i).map(|k| r[k * WIDTH + i] * r[k * WIDTH + j]).sum();
            let rest = gram[i * WIDTH + j] - known;
            if i != j {
                r[i * WIDTH + j] = rest / r[i * WIDTH + i];
            } else if rest > SAFE_PIVOT * gram[i * WIDTH + i] {
                r[i * WIDTH + i] = rest.sqrt();
            } else {
                return None;
            }
        }
    }
    Some(r)
}

fn inverse(r: &Triangle) -> Triangle {
    let mut inverse = [0.0; WIDTH * WIDTH];
    for j in 0..WIDTH {
        for i in (0..=j).rev() {
            let known: f64 = (i + 1..=j)
                .map(|k| r[i * WIDTH + k] * inverse[k * WIDTH + j])
                .sum();
            inverse[i * WIDTH + j] = (f64::from(u8::from(i == j)) - known) / r[i * WIDTH + i];
        }
    }
    inverse
}

fn multiply(a: &Triangle, b: &Triangle) -> Triangle {
    std::array::from_fn(|at| {
        let (i, j) = (at / WIDTH, at % WIDTH);
        (i..=j).map(|k| a[i * WIDTH + k] * b[k * WIDTH + j]).sum()
    })
}
