//! Dense products of tall blocks of vectors: faer's matrix product behind plain slices.

use faer::linalg::matmul::matmul;
use faer::{Accum, MatMut, MatRef, Par};

/// A block of column vectors of length `rows`, back to back.
pub(super) fn view(block: &[f64], rows: usize) -> MatRef<'_, f64> {
    MatRef::from_column_major_slice(block, rows, block.len() / rows)
}

fn view_mut(block: &mut [f64], rows: usize) -> MatMut<'_, f64> {
    let columns = block.len() / rows;
    MatMut::from_column_major_slice_mut(block, rows, columns)
}

/// Xᵀ Y, column by column: entry (i, j) at j·(columns of X) + i.
pub(super) fn inner(x: &[f64], y: &[f64], rows: usize) -> Vec<f64> {
    let (p, q) = (x.len() / rows, y.len() / rows);
    let mut product = vec![0.0; p * q];
    if p > 0 && q > 0 {
        let out = MatMut::from_column_major_slice_mut(&mut product, p, q);
        matmul(
            out,
            Accum::Replace,
            view(x, rows).transpose(),
            view(y, rows),
            1.0,
            Par::Seq,
        );
    }
    product
}

/// Y ← Y + `scale` X C, with C of as many columns as Y has.
pub(super) fn add_product(y: &mut [f64], x: &[f64], c: &[f64], scale: f64, rows: usize) {
    let p = x.len() / rows;
    if p > 0 {
        let c = MatRef::from_column_major_slice(c, p, c.len() / p);
        matmul(
            view_mut(y, rows),
            Accum::Add,
            view(x, rows),
            c,
            scale,
            Par::Seq,
        );
    }
}
