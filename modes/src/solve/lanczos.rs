//! Block Lanczos on (K − σM)⁻¹M in the M inner product, fully reorthogonalised.
//!
//! Grimes, Lewis & Simon 1994 without their restarts: the bands asked for here need subspaces of a
//! few hundred vectors, which are kept orthonormal outright. A block of several vectors reads the
//! factor once for all of them and finds every member of a degenerate group.

use super::dense;
use super::factor::Cholesky;
use super::orthonormal::{Triangle, cholesky_qr};
use super::panel::{WIDTH, add_products, inner, inner_with, subtract_product};
use super::sparse::Mass;

/// Part of a vector that must be new for it to count as a direction of its own.
const NEW: f64 = 1e-10;

/// A Krylov basis and the operator projected on it. Everything is in the order of the factor.
pub(super) struct Lanczos<'a> {
    mass: &'a Mass,
    factor: &'a Cholesky<'a>,
    /// σ, in (rad/s)².
    shift: f64,
    /// M-orthonormal panels, back to back.
    basis: Vec<f64>,
    /// M times the newest panel.
    mass_newest: Vec<f64>,
    /// Room for panels on the way.
    product: Vec<f64>,
    inertia: Vec<f64>,
    spare: Vec<f64>,
    /// Whether rounding is still to be taken out of the newest panel.
    unclean: bool,
    /// Diagonal blocks of the projection, then what couples each to the next, row by row.
    diagonal: Vec<Triangle>,
    coupling: Vec<Triangle>,
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

impl RitzSet {
    /// Pairs from the lowest on whose residuals are below `tolerance`.
    pub(super) fn converged(&self, tolerance: f64) -> usize {
        let good = |pair: &&Ritz| pair.residual < tolerance;
        self.pairs.iter().take_while(good).count()
    }

    /// Pairs whose λ is below `top`.
    pub(super) fn below(&self, top: f64) -> usize {
        self.pairs.partition_point(|pair| pair.eigenvalue < top)
    }
}

impl<'a> Lanczos<'a> {
    /// Starts from a fixed pseudo-random panel.
    pub(super) fn new(factor: &'a Cholesky<'a>, mass: &'a Mass, shift: f64) -> Self {
        let panel = factor.unknowns() * WIDTH;
        let mut lanczos = Self {
            mass,
            factor,
            shift,
            basis: Vec::new(),
            mass_newest: vec![0.0; panel],
            product: vec![0.0; panel],
            inertia: vec![0.0; panel],
            spare: vec![0.0; panel],
            unclean: false,
            diagonal: Vec::new(),
            coupling: Vec::new(),
            random: SplitMix(0x1d10_f04e),
        };
        lanczos.fresh();
        mass.multiply(&lanczos.product, &mut lanczos.inertia);
        let gram = inner(&lanczos.product, &lanczos.inertia);
        lanczos.append(&gram, &[0.0; WIDTH]);
        lanczos
    }

    /// Vectors in the basis that have been multiplied by the operator.
    pub(super) fn size(&self) -> usize {
        self.diagonal.len() * WIDTH
    }

    fn panel(&self) -> usize {
        self.factor.unknowns() * WIDTH
    }

    /// Sets the product to pseudo-random vectors without the rough part that no wanted mode has.
    fn fresh(&mut self) {
        self.random.fill(&mut self.inertia);
        self.mass.multiply(&self.inertia, &mut self.product);
        self.factor.solve(&mut self.product);
    }

    /// Multiplies the newest panel by the operator and appends what is new in the product.
    pub(super) fn expand(&mut self) {
        let newest = self.basis.len() - self.panel();
        let (product, inertia) = (&mut self.product, &mut self.inertia);
        product.copy_from_slice(&self.mass_newest);
        self.factor.solve(product);
        let mut lengths = [0.0; WIDTH];
        // The operator couples to the last two panels only ...
        if let Some(coupling) = self.coupling.last() {
            let back: Triangle =
                std::array::from_fn(|at| coupling[at % WIDTH * WIDTH + at / WIDTH]);
            let previous = &self.basis[newest - product.len()..newest];
            subtract_product(product, previous, &back);
            add_squares(&mut lengths, &back);
        }
        let local = inner(&self.mass_newest, product);
        subtract_product(product, &self.basis[newest..], &local);
        add_squares(&mut lengths, &local);
        // ... and what rounding leaves on the others goes from two panels at a time, so that the
        // basis is read half as often.
        self.mass.multiply(product, inertia);
        let gram = inner(product, inertia);
        let last = inner(&self.basis[newest..], inertia);
        subtract_product(product, &self.basis[newest..], &last);
        if self.unclean {
            let (known, newest) = self.basis.split_at_mut(newest);
            let rest = inner_with(known, [&self.mass_newest, inertia]);
            let rest = rest.map(|rest| rest.iter().map(|c| -c).collect::<Vec<_>>());
            add_products(&mut [newest, product], known, &[&rest[0], &rest[1]]);
        }
        self.unclean = !self.unclean;
        let entry = |at: usize| local[at] + last[at];
        self.diagonal.push(std::array::from_fn(|at| {
            0.5 * (entry(at) + entry(at % WIDTH * WIDTH + at / WIDTH))
        }));
        let coupling = self.append(&gram, &lengths.map(f64::sqrt));
        self.coupling.push(coupling);
    }

    /// M-orthonormalises the product in itself (it is already orthogonal to the basis, or there is
    /// none), appends it, and returns the triangle R with product = Q R. `lengths` are the vectors'
    /// before the basis was taken out of them, `gram` their inner products to a few digits.
    fn append(&mut self, gram: &[f64], lengths: &[f64; WIDTH]) -> Triangle {
        let coupling = cholesky_qr(
            self.mass,
            &mut self.product,
            (gram, &lengths.map(|length| NEW * length)),
            &mut self.mass_newest,
            [&mut self.spare, &mut self.inertia],
        )
        .unwrap_or_else(|| self.gram_schmidt(lengths));
        self.basis.extend_from_slice(&self.product);
        coupling
    }

    /// As [`Self::append`], vector by vector; where one has nothing new in it a fresh one, coupled to
    /// nothing, takes its place.
    fn gram_schmidt(&mut self, lengths: &[f64; WIDTH]) -> Triangle {
        let mut triangle = [0.0; WIDTH * WIDTH];
        for j in 0..WIDTH {
            let before = self.dots(j)[j].max(0.0).sqrt();
            self.clear(j, &mut triangle);
            let mut length = self.dots(j)[j].max(0.0).sqrt();
            if length > NEW * before.max(lengths[j]) {
                triangle[j * WIDTH + j] = length;
            } else {
                self.spare.copy_from_slice(&self.product);
                self.fresh();
                for (row, fresh) in rows(&mut self.spare).zip(self.product.as_chunks().0) {
                    let fresh: &[f64; WIDTH] = fresh;
                    row[j] = fresh[j];
                }
                std::mem::swap(&mut self.product, &mut self.spare);
                for _ in 0..2 {
                    self.mass.multiply(&self.product, &mut self.inertia);
                    let mut known = inner(&self.basis, &self.inertia);
                    for row in rows(&mut known) {
                        *row = std::array::from_fn(|c| if c == j { row[c] } else { 0.0 });
                    }
                    subtract_product(&mut self.product, &self.basis, &known);
                    self.clear(j, &mut [0.0; WIDTH * WIDTH]);
                }
                length = self.dots(j)[j].sqrt();
            }
            for row in rows(&mut self.product) {
                row[j] /= length;
            }
        }
        self.mass.multiply(&self.product, &mut self.mass_newest);
        triangle
    }

    /// Takes the vectors of the product before the `j`th out of it, twice; adds what they were to
    /// `triangle`.
    fn clear(&mut self, j: usize, triangle: &mut Triangle) {
        for _ in 0..2 {
            let known = self.dots(j);
            for row in rows(&mut self.product) {
                row[j] -= (0..j).map(|i| known[i] * row[i]).sum::<f64>();
            }
            for i in 0..j {
                triangle[i * WIDTH + j] += known[i];
            }
        }
    }

    /// Inner products of all vectors of the product with the `j`th.
    fn dots(&mut self, j: usize) -> [f64; WIDTH] {
        self.mass.multiply(&self.product, &mut self.inertia);
        let mut dots = [0.0; WIDTH];
        let inertia = self.inertia.chunks_exact(WIDTH);
        for (x, y) in self.product.chunks_exact(WIDTH).zip(inertia) {
            for (dot, x) in dots.iter_mut().zip(x) {
                *dot += x * y[j];
            }
        }
        dots
    }

    /// Approximate eigenpairs of what has been expanded so far.
    pub(super) fn ritz(&self) -> RitzSet {
        let m = self.size();
        let mut projected = vec![0.0; m * m];
        for (k, diagonal) in self.diagonal.iter().enumerate() {
            for at in 0..WIDTH * WIDTH {
                projected[(k * WIDTH + at % WIDTH) * m + k * WIDTH + at / WIDTH] = diagonal[at];
            }
            if (k + 1) * WIDTH < m {
                for at in 0..WIDTH * WIDTH {
                    let (row, column) = ((k + 1) * WIDTH + at / WIDTH, k * WIDTH + at % WIDTH);
                    projected[column * m + row] = self.coupling[k][at];
                    projected[row * m + column] = self.coupling[k][at];
                }
            }
        }
        let (values, coefficients) = dense::symmetric(&projected, m);
        let mut pairs: Vec<Ritz> = (0..m)
            .rev()
            .filter(|&column| values[column] > 0.0)
            .map(|column| {
                let leak = self.leak(&coefficients[column * m..][..m]);
                let squares: f64 = leak.iter().map(|c| c * c).sum();
                Ritz {
                    eigenvalue: 1.0 / values[column] + self.shift,
                    residual: squares.sqrt() / values[column],
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

    /// What the operator makes of the vector with these coefficients outside the subspace, in terms
    /// of the newest panel.
    fn leak(&self, coefficients: &[f64]) -> [f64; WIDTH] {
        let last = &self.coupling[self.coupling.len() - 1];
        let tail = &coefficients[coefficients.len() - WIDTH..];
        std::array::from_fn(|i| (0..WIDTH).map(|j| last[i * WIDTH + j] * tail[j]).sum())
    }

    /// The operator's image of the first `count` vectors of `ritz`, which is nearer to the modes
    /// than they are (Ericsson & Ruhe 1980): panels back to back in the order of the factor,
    /// M-orthonormal, the last filled up with zeros.
    pub(super) fn vectors(&self, ritz: &RitzSet, count: usize) -> Vec<f64> {
        let m = self.size();
        let chosen: Vec<Vec<f64>> = ritz.pairs[..count]
            .chunks(WIDTH)
            .map(|pairs| {
                let mut chosen = vec![0.0; (m + WIDTH) * WIDTH];
                for (c, pair) in pairs.iter().enumerate() {
                    let coefficients = &ritz.coefficients[pair.column * m..][..m];
                    let gain = pair.eigenvalue - self.shift;
                    let leak = self.leak(coefficients).map(|c| gain * c);
                    for (i, value) in coefficients.iter().chain(&leak).enumerate() {
                        chosen[i * WIDTH + c] = *value;
                    }
                }
                chosen
            })
            .collect();
        let mut panels = vec![0.0; chosen.len() * self.panel()];
        add_products(
            &mut panels.chunks_exact_mut(self.panel()).collect::<Vec<_>>(),
            &self.basis,
            &chosen.iter().map(Vec::as_slice).collect::<Vec<_>>(),
        );
        panels
    }

    /// (K − σM)⁻¹ of a panel, less what of it is in `found`, M-orthonormal panels.
    pub(super) fn solve_outside(&self, panel: &mut [f64], found: &[f64]) {
        self.factor.solve(panel);
        let mut inertia = vec![0.0; panel.len()];
        self.mass.multiply(panel, &mut inertia);
        let known = inner(found, &inertia);
        subtract_product(panel, found, &known);
    }
}

fn rows(panel: &mut [f64]) -> impl Iterator<Item = &mut [f64; WIDTH]> {
    panel.as_chunks_mut().0.iter_mut()
}

/// Adds the squares of each column.
fn add_squares(sums: &mut [f64; WIDTH], square: &[f64]) {
    for row in square.as_chunks::<WIDTH>().0 {
        for (sum, entry) in sums.iter_mut().zip(row) {
            *sum += entry * entry;
        }
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
