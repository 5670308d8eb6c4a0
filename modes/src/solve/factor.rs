//! Sparse factorisations of K − sM: solves for s below the spectrum, sign counts for s within it.

use super::order::order;
use super::{SolveError, substitution};
use crate::fem::Pencil;
use faer::dyn_stack::{MemBuffer, MemStack};
use faer::perm::PermRef;
use faer::sparse::linalg::SupernodalThreshold;
use faer::sparse::linalg::cholesky::supernodal::SymbolicSupernodalCholesky;
use faer::sparse::linalg::cholesky::{
    CholeskySymbolicParams, SymbolicCholesky, SymbolicCholeskyRaw, SymmetricOrdering,
    factorize_symbolic_cholesky,
};
use faer::sparse::{SparseColMatRef, SymbolicSparseColMatRef};
use faer::{Par, Side};

/// Fill-reducing order and block structure of K − sM for every s.
pub(super) struct Symbolic(SymbolicCholesky<u32>);

/// Where a factor's entries go; a second factor may take the place of a first.
pub(super) struct Room(Vec<f64>);

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
        let (forward, inverse) = order(&pencil.pattern);
        let order = PermRef::new_checked(&forward, &inverse, pencil.unknowns());
        Self(
            factorize_symbolic_cholesky(
                matrix,
                Side::Lower,
                SymmetricOrdering::Custom(order),
                params,
            )
            .expect("the pattern is square and fits in memory"),
        )
    }

    fn nodes(&self) -> &SymbolicSupernodalCholesky<u32> {
        match self.0.raw() {
            SymbolicCholeskyRaw::Supernodal(nodes) => nodes,
            SymbolicCholeskyRaw::Simplicial(_) => unreachable!("supernodes are forced"),
        }
    }

    /// The unknowns in the order of the factor.
    pub(super) fn order(&self) -> &[u32] {
        self.permutation().arrays().0
    }

    /// Where the factor puts each unknown.
    pub(super) fn place(&self) -> &[u32] {
        self.permutation().arrays().1
    }

    fn permutation(&self) -> PermRef<'_, u32> {
        self.0.perm().expect("the order is never the pencil's own")
    }

    /// Room for one factor.
    pub(super) fn room(&self) -> Room {
        Room(vec![0.0; self.0.len_val()])
    }

    /// Factors K − `shift` M, which must be positive definite; `shift` in (rad/s)².
    pub(super) fn cholesky(
        &self,
        pencil: &Pencil,
        shift: f64,
        Room(mut values): Room,
    ) -> Result<Cholesky<'_>, SolveError> {
        let entries = shifted(pencil, shift);
        let matrix = SparseColMatRef::new(symbolic_matrix(pencil), &entries);
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
    pub(super) fn count_below(
        &self,
        pencil: &Pencil,
        shift: f64,
        Room(values): &mut Room,
    ) -> usize {
        let n = pencil.unknowns();
        let entries = shifted(pencil, shift);
        let matrix = SparseColMatRef::new(symbolic_matrix(pencil), &entries);
        let mut below = vec![0.0; n];
        let (mut forward, mut inverse) = (vec![0u32; n], vec![0u32; n]);
        let scratch = self
            .0
            .factorize_numeric_intranode_lblt_scratch::<f64>(Par::Seq, Default::default());
        self.0.factorize_numeric_intranode_lblt(
            values,
            &mut below,
            &mut forward,
            &mut inverse,
            matrix,
            Side::Lower,
            Par::Seq,
            MemStack::new(&mut MemBuffer::new(scratch)),
            Default::default(),
        );
        let nodes = self.nodes();
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
    /// Number of unknowns.
    pub(super) fn unknowns(&self) -> usize {
        self.symbolic.0.nrows()
    }

    /// Solves (K − sM) X = B in place for a panel in the order of the factor.
    pub(super) fn solve(&self, panel: &mut [f64]) {
        substitution::solve(self.symbolic.nodes(), &self.values, panel);
    }
}

/// Number of eigenvalues of `pencil` below `hz`, rigid motions included.
#[must_use]
pub fn count_below(pencil: &Pencil, hz: f64) -> usize {
    let omega = std::f64::consts::TAU * hz;
    let symbolic = Symbolic::new(pencil);
    symbolic.count_below(pencil, omega * omega, &mut symbolic.room())
}

#[cfg(test)]
mod tests {
    use super::super::panel::{WIDTH, columns, from_columns, reorder};
    use super::*;
    use crate::TABLE_1;
    use crate::fem::{TetMass, assemble};
    use crate::mesh::{TubeGrid, tube_tet4};
    use crate::shape::Tube;

    /// On meshes ordered by minimum degree and by dissection.
    #[test]
    fn solving_undoes_multiplying() {
        for along in [10, 30] {
            let grid = TubeGrid { around: 40, along };
            let mesh = tube_tet4(&Tube::D5, grid, 1);
            let material = &TABLE_1[0].material;
            let pencil = assemble(&mesh, material, TetMass::Consistent).unwrap();
            let n = pencil.unknowns();
            let shift = -1e9;
            let symbolic = Symbolic::new(&pencil);
            let factor = symbolic.cholesky(&pencil, shift, symbolic.room()).unwrap();
            let x: Vec<f64> = (0..n * WIDTH).map(|i| (i as f64).sin()).collect();
            let mut product = vec![0.0; x.len()];
            pencil.multiply(&shifted(&pencil, shift), &x, &mut product);
            let panel = from_columns(&product, n).remove(0);
            let mut panel = reorder(&panel, symbolic.order());
            factor.solve(&mut panel);
            let back = columns(&reorder(&panel, symbolic.place())).concat();
            for (found, expected) in back.iter().zip(&x) {
                assert!((found - expected).abs() < 1e-7, "{found} {expected}");
            }
        }
    }
}
