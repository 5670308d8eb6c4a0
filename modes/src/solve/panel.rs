//! Blocks of eight vectors, row by row: what is read once serves eight vectors.

use pulp::{Arch, Simd, WithSimd};

/// Vectors in a panel.
pub(super) const WIDTH: usize = 8;

/// Entries of the product of two panels.
const SQUARE: usize = WIDTH * WIDTH;

/// Rows multiplied at once: a piece of two panels stays in the first-level cache.
const ROWS: usize = 256;

/// One row of a panel in registers: a power of two of them, by the processor's width.
pub(super) type Row<S, const N: usize> = [<S as Simd>::f64s; N];

/// The rows of a panel, or of several back to back.
pub(super) fn rows<S: Simd, const N: usize>(panel: &[f64]) -> &[Row<S, N>] {
    S::as_simd_f64s(panel).0.as_chunks().0
}

/// As [`rows`].
pub(super) fn rows_mut<S: Simd, const N: usize>(panel: &mut [f64]) -> &mut [Row<S, N>] {
    S::as_mut_simd_f64s(panel).0.as_chunks_mut().0
}

/// Work on panels, written once for every number of registers to a row.
pub(super) trait Kernel {
    /// Runs with `N` registers of `simd` to a row.
    fn run<S: Simd, const N: usize>(self, simd: S);
}

struct Sized<K>(K);

impl<K: Kernel> WithSimd for Sized<K> {
    type Output = ();

    #[inline(always)]
    fn with_simd<S: Simd>(self, simd: S) {
        match S::F64_LANES {
            8 => self.0.run::<S, 1>(simd),
            4 => self.0.run::<S, 2>(simd),
            2 => self.0.run::<S, 4>(simd),
            _ => self.0.run::<S, 8>(simd),
        }
    }
}

/// Runs `kernel` with the widest registers there are.
pub(super) fn run(kernel: impl Kernel) {
    Arch::new().dispatch(Sized(kernel));
}

/// XᵀY of every panel of `x` with the panel `y`: entry (i, j) of the p-th product at (8p + i)·8 + j.
pub(super) fn inner(x: &[f64], y: &[f64]) -> Vec<f64> {
    let [products] = inner_with(x, [y]);
    products
}

/// [`inner`] with each of several panels, reading `x` once.
pub(super) fn inner_with<const Y: usize>(x: &[f64], ys: [&[f64]; Y]) -> [Vec<f64>; Y] {
    let mut products = ys.map(|y| vec![0.0; x.len() / y.len() * SQUARE]);
    run(Inner {
        x,
        ys: &ys,
        products: &mut products,
    });
    products
}

struct Inner<'a> {
    x: &'a [f64],
    ys: &'a [&'a [f64]],
    products: &'a mut [Vec<f64>],
}

impl Kernel for Inner<'_> {
    #[inline(always)]
    fn run<S: Simd, const N: usize>(self, simd: S) {
        let length = self.ys[0].len();
        for start in (0..length).step_by(ROWS * WIDTH) {
            let piece = start..length.min(start + ROWS * WIDTH);
            for (p, x) in self.x.chunks_exact(length).enumerate() {
                let x = x[piece.clone()].as_chunks::<WIDTH>().0;
                for (y, products) in self.ys.iter().zip(&mut *self.products) {
                    let y = rows::<S, N>(&y[piece.clone()]);
                    let product = &mut products[p * SQUARE..][..SQUARE];
                    // Four rows of the product fill half of sixteen registers of four lanes.
                    for (half, out) in product.chunks_exact_mut(SQUARE / 2).enumerate() {
                        let out = rows_mut::<S, N>(out);
                        let mut sums = [out[0], out[1], out[2], out[3]];
                        for (x, y) in x.iter().zip(y) {
                            for i in 0..4 {
                                let x = simd.splat_f64s(x[4 * half + i]);
                                for v in 0..N {
                                    sums[i][v] = simd.mul_add_e_f64s(x, y[v], sums[i][v]);
                                }
                            }
                        }
                        out.copy_from_slice(&sums);
                    }
                }
            }
        }
    }
}

/// Y ← Y − X C, with C as [`inner`] gives it.
pub(super) fn subtract_product(y: &mut [f64], x: &[f64], c: &[f64]) {
    let c: Vec<f64> = c.iter().map(|c| -c).collect();
    add_product(y, x, &c);
}

/// Y ← Y + X C, with C as [`inner`] gives it.
pub(super) fn add_product(y: &mut [f64], x: &[f64], c: &[f64]) {
    add_products(&mut [y], x, &[c]);
}

/// [`add_product`] to each of several panels, reading `x` once.
pub(super) fn add_products(ys: &mut [&mut [f64]], x: &[f64], cs: &[&[f64]]) {
    run(AddProducts { ys, x, cs });
}

struct AddProducts<'a, 'b> {
    ys: &'a mut [&'b mut [f64]],
    x: &'a [f64],
    cs: &'a [&'a [f64]],
}

impl Kernel for AddProducts<'_, '_> {
    #[inline(always)]
    fn run<S: Simd, const N: usize>(self, simd: S) {
        let length = self.ys.first().map_or(0, |y| y.len());
        for start in (0..length).step_by(ROWS * WIDTH) {
            let piece = start..length.min(start + ROWS * WIDTH);
            for (p, x) in self.x.chunks_exact(length).enumerate() {
                let x = x[piece.clone()].as_chunks::<WIDTH>().0;
                for (y, c) in self.ys.iter_mut().zip(self.cs) {
                    let y = rows_mut::<S, N>(&mut y[piece.clone()]);
                    let c = &c[p * SQUARE..][..SQUARE];
                    for (half, c) in c.chunks_exact(SQUARE / 2).enumerate() {
                        let c = rows::<S, N>(c);
                        let c = [c[0], c[1], c[2], c[3]];
                        for (x, y) in x.iter().zip(&mut *y) {
                            for i in 0..4 {
                                let x = simd.splat_f64s(x[4 * half + i]);
                                for v in 0..N {
                                    y[v] = simd.mul_add_e_f64s(x, c[i][v], y[v]);
                                }
                            }
                        }
                    }
                }
            }
        }
    }
}

/// Panels from columns of length `n` back to back; the last is filled up with zeros.
pub(super) fn from_columns(columns: &[f64], n: usize) -> Vec<Vec<f64>> {
    columns
        .chunks(n * WIDTH)
        .map(|columns| {
            let mut panel = vec![0.0; n * WIDTH];
            for (c, column) in columns.chunks_exact(n).enumerate() {
                for (i, value) in column.iter().enumerate() {
                    panel[i * WIDTH + c] = *value;
                }
            }
            panel
        })
        .collect()
}

/// The eight columns of a panel.
pub(super) fn columns(panel: &[f64]) -> [Vec<f64>; WIDTH] {
    let rows = panel.as_chunks::<WIDTH>().0;
    let mut columns = [(); WIDTH].map(|()| Vec::with_capacity(rows.len()));
    for row in rows {
        for (column, value) in columns.iter_mut().zip(row) {
            column.push(*value);
        }
    }
    columns
}

/// The panel whose i-th row is the `place[i]`-th of `panel`.
pub(super) fn reorder(panel: &[f64], place: &[u32]) -> Vec<f64> {
    let rows = panel.as_chunks::<WIDTH>().0;
    place.iter().flat_map(|&i| rows[i as usize]).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// More rows than are multiplied at once, and not a whole number of pieces.
    const N: usize = ROWS + 44;

    fn panels(count: usize, seed: usize) -> Vec<f64> {
        let entry = |i: usize| ((i * 7919 + seed) % 1009) as f64 / 1009.0 - 0.5;
        (0..count * N * WIDTH).map(entry).collect()
    }

    #[test]
    fn products_are_those_of_plain_loops() {
        let (x, y, z) = (panels(3, 1), panels(1, 2), panels(1, 3));
        let at = |panels: &[f64], i: usize, column: usize| {
            panels[(column / WIDTH * N + i) * WIDTH + column % WIDTH]
        };
        let products = inner_with(&x, [&y, &z]);
        for (product, y) in products.iter().zip([&y, &z]) {
            for i in 0..3 * WIDTH {
                for j in 0..WIDTH {
                    let expected: f64 = (0..N).map(|k| at(&x, k, i) * at(y, k, j)).sum();
                    assert!((product[i * WIDTH + j] - expected).abs() < 1e-12, "{i} {j}");
                }
            }
        }
        let mut sum = y.clone();
        subtract_product(&mut sum, &x, &products[0]);
        for k in 0..N {
            for j in 0..WIDTH {
                let known = (0..3 * WIDTH).map(|i| at(&x, k, i) * products[0][i * WIDTH + j]);
                let expected = at(&y, k, j) - known.sum::<f64>();
                assert!((at(&sum, k, j) - expected).abs() < 1e-11, "{k} {j}");
            }
        }
    }

    #[test]
    fn columns_come_back() {
        let columns: Vec<f64> = (0..11 * 5).map(f64::from).collect();
        let panels = from_columns(&columns, 5);
        assert_eq!(panels.len(), 2);
        let back = panels.iter().flat_map(|panel| super::columns(panel));
        assert_eq!(back.take(11).flatten().collect::<Vec<_>>(), columns);
    }
}
