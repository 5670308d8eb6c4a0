//! Forward and back substitution with a supernodal Cholesky factor, a panel at a time.

use super::panel::{Kernel, Row, WIDTH, rows_mut, run};
use faer::sparse::linalg::cholesky::supernodal::SymbolicSupernodalCholesky;
use pulp::Simd;

/// Columns of the factor that go together.
const STRIP: usize = 4;

/// Solves L Lᵀ X = B in place for the panel `x` in the order of the factor.
pub(super) fn solve(nodes: &SymbolicSupernodalCholesky<u32>, values: &[f64], x: &mut [f64]) {
    let tallest = (0..nodes.n_supernodes())
        .map(|s| Supernode::new(nodes, values, s).height())
        .max()
        .unwrap_or(0);
    let mut work = vec![0.0; tallest * WIDTH];
    run(Solve {
        nodes,
        values,
        x,
        work: &mut work,
    });
}

/// Neighbouring columns of the factor with one pattern.
struct Supernode<'a> {
    first: usize,
    columns: usize,
    /// Rows below the triangle.
    below: &'a [u32],
    /// Columns back to back, triangle on top.
    values: &'a [f64],
}

impl<'a> Supernode<'a> {
    fn new(nodes: &'a SymbolicSupernodalCholesky<u32>, values: &'a [f64], s: usize) -> Self {
        let first = nodes.supernode_begin()[s] as usize;
        let start = nodes.col_ptr_for_val()[s] as usize;
        Self {
            first,
            columns: nodes.supernode_end()[s] as usize - first,
            below: nodes.supernode(s).pattern(),
            values: &values[start..nodes.col_ptr_for_val()[s + 1] as usize],
        }
    }

    fn height(&self) -> usize {
        self.columns + self.below.len()
    }

    /// Columns from `j` on, from their `j`-th row down.
    fn strip<const C: usize>(&self, j: usize) -> [&'a [f64]; C] {
        let height = self.height();
        std::array::from_fn(|k| &self.values[(j + k) * height + j..(j + k + 1) * height])
    }
}

struct Solve<'a> {
    nodes: &'a SymbolicSupernodalCholesky<u32>,
    values: &'a [f64],
    x: &'a mut [f64],
    work: &'a mut [f64],
}

impl Kernel for Solve<'_> {
    #[inline(always)]
    fn run<S: Simd, const N: usize>(self, simd: S) {
        let x = rows_mut::<S, N>(self.x);
        let work = rows_mut::<S, N>(self.work);
        for s in 0..self.nodes.n_supernodes() {
            let node = Supernode::new(self.nodes, self.values, s);
            forward(simd, &node, x, &mut work[..node.height()]);
        }
        for s in (0..self.nodes.n_supernodes()).rev() {
            let node = Supernode::new(self.nodes, self.values, s);
            backward(simd, &node, x, &mut work[..node.height()]);
        }
    }
}

#[inline(always)]
fn forward<S: Simd, const N: usize>(
    simd: S,
    node: &Supernode<'_>,
    x: &mut [Row<S, N>],
    work: &mut [Row<S, N>],
) {
    let own = node.first..node.first + node.columns;
    work[..node.columns].copy_from_slice(&x[own.clone()]);
    work[node.columns..].fill([simd.splat_f64s(0.0); N]);
    let mut j = 0;
    while j + STRIP <= node.columns {
        forward_strip(simd, node.strip::<STRIP>(j), &mut work[j..]);
        j += STRIP;
    }
    while j < node.columns {
        forward_strip(simd, node.strip::<1>(j), &mut work[j..]);
        j += 1;
    }
    x[own].copy_from_slice(&work[..node.columns]);
    for (&row, sum) in node.below.iter().zip(&work[node.columns..]) {
        let x = &mut x[row as usize];
        for v in 0..N {
            x[v] = simd.add_f64s(x[v], sum[v]);
        }
    }
}

#[inline(always)]
fn forward_strip<S: Simd, const N: usize, const C: usize>(
    simd: S,
    columns: [&[f64]; C],
    work: &mut [Row<S, N>],
) {
    let (own, rest) = work.split_at_mut(C);
    let mut negative = [[simd.splat_f64s(0.0); N]; C];
    for k in 0..C {
        let inverse = simd.splat_f64s(1.0 / columns[k][k]);
        for v in 0..N {
            let mut sum = own[k][v];
            for m in 0..k {
                let l = simd.splat_f64s(columns[m][k]);
                sum = simd.mul_add_e_f64s(l, negative[m][v], sum);
            }
            own[k][v] = simd.mul_f64s(sum, inverse);
            negative[k][v] = simd.neg_f64s(own[k][v]);
        }
    }
    let columns = columns.map(|column| &column[C..][..rest.len()]);
    for (i, sum) in rest.iter_mut().enumerate() {
        for k in 0..C {
            let l = simd.splat_f64s(columns[k][i]);
            for v in 0..N {
                sum[v] = simd.mul_add_e_f64s(l, negative[k][v], sum[v]);
            }
        }
    }
}

#[inline(always)]
fn backward<S: Simd, const N: usize>(
    simd: S,
    node: &Supernode<'_>,
    x: &mut [Row<S, N>],
    work: &mut [Row<S, N>],
) {
    let own = node.first..node.first + node.columns;
    work[..node.columns].copy_from_slice(&x[own.clone()]);
    for (&row, known) in node.below.iter().zip(&mut work[node.columns..]) {
        *known = x[row as usize];
    }
    let mut j = node.columns;
    while !j.is_multiple_of(STRIP) {
        j -= 1;
        backward_strip(simd, node.strip::<1>(j), &mut work[j..]);
    }
    while j > 0 {
        j -= STRIP;
        backward_strip(simd, node.strip::<STRIP>(j), &mut work[j..]);
    }
    x[own].copy_from_slice(&work[..node.columns]);
}

#[inline(always)]
fn backward_strip<S: Simd, const N: usize, const C: usize>(
    simd: S,
    columns: [&[f64]; C],
    work: &mut [Row<S, N>],
) {
    let (own, rest) = work.split_at_mut(C);
    let mut sums = [[simd.splat_f64s(0.0); N]; C];
    let below = columns.map(|column| &column[C..][..rest.len()]);
    for (i, known) in rest.iter().enumerate() {
        for k in 0..C {
            let l = simd.splat_f64s(below[k][i]);
            for v in 0..N {
                sums[k][v] = simd.mul_add_e_f64s(l, known[v], sums[k][v]);
            }
        }
    }
    for k in (0..C).rev() {
        let inverse = simd.splat_f64s(1.0 / columns[k][k]);
        for v in 0..N {
            let mut sum = sums[k][v];
            for m in k + 1..C {
                sum = simd.mul_add_e_f64s(simd.splat_f64s(columns[k][m]), own[m][v], sum);
            }
            own[k][v] = simd.mul_f64s(simd.sub_f64s(own[k][v], sum), inverse);
        }
    }
}
