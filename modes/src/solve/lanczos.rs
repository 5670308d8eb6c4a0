//! Block Lanczos on (K − σM)⁻¹M in the M inner product, fully reorthogonalised.
//!
//! Grimes, Lewis & Simon 1994 without their restarts: the bands asked for here need subspaces of a
//! few hundred vectors, which are kept orthonormal outright. A block of several vectors reads the
//! factor once for all of them and finds every member of a degenerate group.

use super::block::{add_product, inner, view};
use super::dense;
use super::factor::Cholesky;
use crate::fem::Pencil;

/// A Krylov basis and the operator projected on it.
pub(super) struct Lanczos<'a> {
    pencil: &'a Pencil,
    factor: &'a Cholesky<'a>,
    /// σ, in (rad/s)².
    shift: f64,
    block: usize,
    /// M-orthonormal vectors, back to back.
    basis: Vec<f64>,
    /// M times each of them.
    mass_basis: Vec<f64>,
    /// Diagonal blocks of the projection, then what couples each to the next, column by column.
    diagonal: Vec<Vec<f64>>,
    coupling: Vec<Vec<f64>>,
    random: SplitMix,
}

/// A vector of the subspace that nearly solves the problem.
pub(super) struct Ritz {
    /// λ, in (rad/s)².
    pub(super) eigenvalue: f64,
    /// Residual of the inverse operator, relative to its eigenvalue.
    pub(super) residual: f64,
    /// Column of the coefficients.
    column: usize,
}

/// What the subspace knows: approximate eigenpairs by rising λ.
pub(super) struct RitzSet {
    pub(super) pairs: Vec<Ritz>,
    coefficients: Vec<f64>,
}

impl<'a> Lanczos<'a> {
    /// Starts from a fixed pseudo-random block.
    pub(super) fn new(
        pencil: &'a Pencil,
        factor: &'a Cholesky<'a>,
        shift: f64,
        block: usize,
    ) -> Self {
        let mut lanczos = Self {
            pencil,
            factor,
            shift,
            block,
            basis: Vec::new(),
            mass_basis: Vec::new(),
            diagonal: Vec::new(),
            coupling: Vec::new(),
            random: SplitMix(0x1d10_f04e),
        };
        let mut start = vec![0.0; pencil.unknowns() * block];
        lanczos.random.fill(&mut start);
        let mut mass = start.clone();
        pencil.multiply(&pencil.mass, &start, &mut mass);
        // One application damps the rough part that no wanted mode has.
        factor.solve(&mut mass);
        lanczos.append(mass);
        lanczos
    }

    /// Vectors in the basis that have been multiplied by the operator.
    pub(super) fn size(&self) -> usize {
        self.diagonal.len() * self.block
    }

    /// Multiplies the newest block by the operator and appends what is new in the product.
    pub(super) fn expand(&mut self) {
        let n = self.pencil.unknowns();
        let mut product = self.mass_basis[self.mass_basis.len() - n * self.block..].to_vec();
        self.factor.solve(&mut product);
        let first = inner(&self.mass_basis, &product, n);
        add_product(&mut product, &self.basis, &first, -1.0, n);
        let second = inner(&self.mass_basis, &product, n);
        add_product(&mut product, &self.basis, &second, -1.0, n);
        let (b, height) = (self.block, self.basis.len() / n);
        let entry = |i: usize, j: usize| {
            let at = j * height + height - b + i;
            first[at] + second[at]
        };
        let diagonal = (0..b * b)
            .map(|at| 0.5 * (entry(at % b, at / b) + entry(at / b, at % b)))
            .collect();
        self.diagonal.push(diagonal);
        let coupling = self.append(product);
        self.coupling.push(coupling);
    }

    /// M-orthonormalises `vectors` among themselves (they are already orthogonal to the basis, or
    /// there is none), appends them, and returns the triangle R with `vectors` = Q R.
    fn append(&mut self, mut vectors: Vec<f64>) -> Vec<f64> {
        let (n, b) = (self.pencil.unknowns(), self.block);
        let mut mass = vec![0.0; vectors.len()];
        self.pencil.multiply(&self.pencil.mass, &vectors, &mut mass);
        let mut triangle = vec![0.0; b * b];
        for j in 0..b {
            let before = dot(&vectors[j * n..][..n], &mass[j * n..][..n])
                .max(0.0)
                .sqrt();
            for _ in 0..2 {
                for i in 0..j {
                    let c = dot(&mass[i * n..][..n], &vectors[j * n..][..n]);
                    subtract(&mut vectors, i, j, n, c);
                    subtract(&mut mass, i, j, n, c);
                    triangle[j * b + i] += c;
                }
            }
            let after = dot(&vectors[j * n..][..n], &mass[j * n..][..n])
                .max(0.0)
                .sqrt();
            if after > 1e-10 * before {
                triangle[j * b + j] = after;
                scale(&mut vectors[j * n..][..n], 1.0 / after);
                scale(&mut mass[j * n..][..n], 1.0 / after);
            } else {
                // Nothing new in this direction: go on with a fresh one, coupled to nothing.
                self.replace(&mut vectors, &mut mass, j);
            }
        }
        self.basis.extend_from_slice(&vectors);
        self.mass_basis.extend_from_slice(&mass);
        triangle
    }

    fn replace(&mut self, vectors: &mut [f64], mass: &mut [f64], j: usize) {
        let n = self.pencil.unknowns();
        let mut fresh = vec![0.0; n];
        let mut product = vec![0.0; n];
        self.random.fill(&mut fresh);
        self.pencil
            .multiply(&self.pencil.mass, &fresh, &mut product);
        self.factor.solve(&mut product);
        fresh.copy_from_slice(&product);
        for _ in 0..2 {
            let c = inner(&self.mass_basis, &fresh, n);
            add_product(&mut fresh, &self.basis, &c, -1.0, n);
            let c = inner(&mass[..j * n], &fresh, n);
            add_product(&mut fresh, &vectors[..j * n], &c, -1.0, n);
        }
        self.pencil
            .multiply(&self.pencil.mass, &fresh, &mut product);
        let norm = dot(&fresh, &product).sqrt();
        scale(&mut fresh, 1.0 / norm);
        scale(&mut product, 1.0 / norm);
        vectors[j * n..][..n].copy_from_slice(&fresh);
        mass[j * n..][..n].copy_from_slice(&product);
    }

    /// Approximate eigenpairs of what has been expanded so far.
    pub(super) fn ritz(&self) -> RitzSet {
        let (b, m) = (self.block, self.size());
        let mut projected = vec![0.0; m * m];
        for (k, diagonal) in self.diagonal.iter().enumerate() {
            for at in 0..b * b {
                projected[(k * b + at / b) * m + k * b + at % b] = diagonal[at];
            }
            if (k + 1) * b < m {
                for at in 0..b * b {
                    let (row, column) = ((k + 1) * b + at % b, k * b + at / b);
                    projected[column * m + row] = self.coupling[k][at];
                    projected[row * m + column] = self.coupling[k][at];
                }
            }
        }
        let (values, coefficients) = dense::symmetric(&projected, m);
        let last = &self.coupling[self.coupling.len() - 1];
        let mut pairs: Vec<Ritz> = (0..m)
            .rev()
            .filter(|&column| values[column] > 0.0)
            .map(|column| {
                let tail = &coefficients[column * m + m - b..][..b];
                let leak: f64 = (0..b)
                    .map(|i| {
                        (0..b)
                            .map(|j| last[j * b + i] * tail[j])
                            .sum::<f64>()
                            .powi(2)
                    })
                    .sum();
                Ritz {
                    eigenvalue: 1.0 / values[column] + self.shift,
                    residual: leak.sqrt() / values[column],
                    column,
                }
            })
            .collect();
        pairs.sort_by(|p, q| p.eigenvalue.total_cmp(&q.eigenvalue));
        RitzSet {
            pairs,
            coefficients,
        }
    }

    /// The vectors in space of the first `count` of `ritz`, back to back, M-orthonormal.
    pub(super) fn vectors(&self, ritz: &RitzSet, count: usize) -> Vec<f64> {
        let (n, m) = (self.pencil.unknowns(), self.size());
        let coefficients = view(&ritz.coefficients, m);
        let chosen: Vec<f64> = ritz.pairs[..count]
            .iter()
            .flat_map(|pair| (0..m).map(|i| coefficients[(i, pair.column)]))
            .collect();
        let mut vectors = vec![0.0; n * count];
        add_product(&mut vectors, &self.basis[..n * m], &chosen, 1.0, n);
        vectors
    }
}

fn dot(x: &[f64], y: &[f64]) -> f64 {
    x.iter().zip(y).map(|(x, y)| x * y).sum()
}

fn scale(x: &mut [f64], factor: f64) {
    for x in x {
        *x *= factor;
    }
}

/// Subtracts `c` times column `i` from column `j > i`.
fn subtract(columns: &mut [f64], i: usize, j: usize, n: usize, c: f64) {
    let (left, right) = columns.split_at_mut(j * n);
    for (y, x) in right[..n].iter_mut().zip(&left[i * n..][..n]) {
        *y -= c * x;
    }
}

/// Steele, Lea & Flood 2014: start vectors that are the same on every machine.
struct SplitMix(u64);

impl SplitMix {
    fn fill(&mut self, values: &mut [f64]) {
        for value in values {
            self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
            let mut z = self.0;
            z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
            z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
            *value = ((z ^ (z >> 31)) >> 11) as f64 / (1u64 << 52) as f64 - 1.0;
        }
    }
}
