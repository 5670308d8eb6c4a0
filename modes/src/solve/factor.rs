//! Sparse factorisations of K − sM: solves for s below the spectrum, sign counts for s within it.

use super::SolveError;
use crate::fem::Pencil;
use faer::dyn_stack::{MemBuffer, MemStack};
use faer::sparse::linalg::SupernodalThreshold;
use faer::sparse::linalg::cholesky::{
    CholeskySymbolicParams, LltRef, SymbolicCholesky, SymbolicCholeskyRaw, SymmetricOrdering,
    factorize_symbolic_cholesky,
};
use faer::sparse::{SparseColMatRef, SymbolicSparseColMatRef};
use faer::{Conj, MatMut, Par, Side};

/// Fill-reducing order and block structure of K − sM for every s.
pub(super) struct Symbolic(SymbolicCholesky<u32>);

/// A Cholesky factor of K − sM.
pub(super) struct Cholesky<'a> {
    symbolic: &'a Symbolic,
    values: Vec<f64>,
}

fn symbolic_matrix(pencil: &Pencil) -> SymbolicSparseColMatRef<'_, u32> {
    let (n, pattern) = (pencil.unknowns(), &pencil.pattern);
    SymbolicSparseColMatRef::new_checked(n, n, &pattern.column_start, None, &pattern.rows)
}

fn shifted(pencil: &Pencil, shift: f64) -> Vec<f64> {
    let entries = pencil.stiffness.iter().zip(&pencil.mass);
    entries.map(|(k, m)| k - shift * m).collect()
}

impl Symbolic {
    pub(super) fn new(pencil: &Pencil) -> Self {
        let params = CholeskySymbolicParams {
            // The inertia count reads pivots from supernodes only.
            supernodal_flop_ratio_threshold: SupernodalThreshold::FORCE_SUPERNODAL,
            ..Default::default()
        };
        let matrix = symbolic_matrix(pencil);
        Self(
            factorize_symbolic_cholesky(matrix, Side::Lower, SymmetricOrdering::Amd, params)
                .expect("the pattern is square and fits in memory"),
        )
    }

    /// Factors K − `shift` M, which must be positive definite; `shift` in (rad/s)².
    pub(super) fn cholesky(&self, pencil: &Pencil, shift: f64) -> Result<Cholesky<'_>, SolveError> {
        let entries = shifted(pencil, shift);
        let matrix = SparseColMatRef::new(symbolic_matrix(pencil), &entries);
        let mut values = vec![0.0; self.0.len_val()];
        let scratch = self
            .0
            .factorize_numeric_llt_scratch::<f64>(Par::Seq, Default::default());
        self.0
            .factorize_numeric_llt(
                &mut values,
                matrix,
                Side::Lower,
                Default::default(),
                Par::Seq,
                MemStack::new(&mut MemBuffer::new(scratch)),
                Default::default(),
            )
            .map_err(|_| SolveError::Indefinite)?;
        Ok(Cholesky {
            symbolic: self,
            values,
        })
    }

    /// Number of eigenvalues below `shift` in (rad/s)²: the negative pivots of K − `shift` M
    /// (Sylvester's law of inertia).
    pub(super) fn count_below(&self, pencil: &Pencil, shift: f64) -> usize {
        let n = pencil.unknowns();
        let entries = shifted(pencil, shift);
        let matrix = SparseColMatRef::new(symbolic_matrix(pencil), &entries);
        let (mut values, mut below) = (vec![0.0; self.0.len_val()], vec![0.0; n]);
        let (mut forward, mut inverse) = (vec![0u32; n], vec![0u32; n]);
        let scratch = self
            .0
            .factorize_numeric_intranode_lblt_scratch::<f64>(Par::Seq, Default::default());
        self.0.factorize_numeric_intranode_lblt(
            &mut values,
            &mut below,
            &mut forward,
            &mut inverse,
            matrix,
            Side::Lower,
            Par::Seq,
            MemStack::new(&mut MemBuffer::new(scratch)),
            Default::default(),
        );
        let SymbolicCholeskyRaw::Supernodal(nodes) = self.0.raw() else {
            unreachable!("supernodes are forced");
        };
        let mut negative = 0;
        for s in 0..nodes.n_supernodes() {
            let columns = nodes.supernode_begin()[s] as usize..nodes.supernode_end()[s] as usize;
            let first = nodes.col_ptr_for_val()[s] as usize;
            let end = nodes.col_ptr_for_val()[s + 1] as usize;
            let height = (end - first) / columns.len();
            let pivots: Vec<f64> = (0..columns.len())
                .map(|i| values[first + i * height + i])
                .collect();
            negative += negative_pivots(&pivots, &below[columns]);
        }
        negative
    }
}

/// Negative eigenvalues of a block-diagonal matrix of 1×1 and 2×2 blocks: `below[i]` is the entry
/// under the diagonal in column i, zero unless a 2×2 block begins there.
fn negative_pivots(diagonal: &[f64], below: &[f64]) -> usize {
    let (mut i, mut negative) = (0, 0);
    while i < diagonal.len() {
        if below[i] != 0.0 && i + 1 < diagonal.len() {
            let determinant = diagonal[i] * diagonal[i + 1] - below[i] * below[i];
            negative += if determinant < 0.0 {
                1
            } else {
                2 * usize::from(diagonal[i] < 0.0)
            };
            i += 2;
        } else {
            negative += usize::from(diagonal[i] < 0.0);
            i += 1;
        }
    }
    negative
}

impl Cholesky<'_> {
    /// Solves (K − sM) X = B in place for the columns of length n that `block` holds back to back.
    pub(super) fn solve(&self, block: &mut [f64]) {
        let symbolic = &self.symbolic.0;
        let n = symbolic.nrows();
        let columns = block.len() / n;
        let scratch = symbolic.solve_in_place_scratch::<f64>(columns, Par::Seq);
        LltRef::<u32, f64>::new(symbolic, &self.values).solve_in_place_with_conj(
            Conj::No,
            MatMut::from_column_major_slice_mut(block, n, columns),
            Par::Seq,
            MemStack::new(&mut MemBuffer::new(scratch)),
        );
    }
}

/// Number of eigenvalues of `pencil` below `hz`, rigid motions included.
#[must_use]
pub fn count_below(pencil: &Pencil, hz: f64) -> usize {
    let omega = std::f64::consts::TAU * hz;
    Symbolic::new(pencil).count_below(pencil, omega * omega)
}
