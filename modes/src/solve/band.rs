//! All modes of a band: solved and counted.

use super::dense;
use super::factor::Symbolic;
use super::lanczos::{Lanczos, RitzSet};
use super::panel::{self, WIDTH};
use super::shift::{SHIFT, TOLERANCE, largest_subspace};
use super::sparse::Mass;
use super::verify::{Found, verify};
use super::{SolveError, Watch};
use crate::fem::Pencil;
use std::f64::consts::TAU;
use std::ops::ControlFlow;

/// Undamped frequencies to look for.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Band {
    /// Lowest, in Hz.
    pub low_hz: f64,
    /// Highest, in Hz.
    pub high_hz: f64,
}

impl Band {
    /// What people hear.
    pub const AUDIBLE: Self = Self {
        low_hz: 20.0,
        high_hz: 20_000.0,
    };
}

/// One solution of Kφ = λMφ.
#[derive(Clone, Debug, PartialEq)]
pub struct Eigenmode {
    /// √λ / 2π, in Hz.
    pub hz: f64,
    /// ‖Kφ − λMφ‖ / ‖Kφ‖.
    pub residual: f64,
    /// φ, mass-normalised, in kg^(−1/2).
    pub vector: Vec<f64>,
}

/// How a pencil was solved.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Solver {
    /// All eigenvalues, by dense reduction.
    Dense,
    /// Shift-invert block Lanczos with a subspace of so many vectors.
    Lanczos {
        /// Vectors in the subspace.
        subspace: usize,
    },
}

/// All modes of a band.
#[derive(Clone, Debug, PartialEq)]
pub struct Solution {
    /// The modes, by rising frequency.
    pub modes: Vec<Eigenmode>,
    /// Eigenvalues below the band's upper end by the inertia of K − λM, rigid motions included;
    /// as many were found.
    pub counted: usize,
    /// Largest entry of |ΦᵀMΦ − I| over all of them.
    pub orthonormality: f64,
    /// How it was done.
    pub solver: Solver,
}

/// Pencils of fewer unknowns than this are solved densely.
const DENSE_BELOW: usize = 300;

/// Every mode of `pencil` in `band`; none is missed: their number is checked against the inertia of
/// K − λM at the band's upper end.
///
/// # Errors
///
/// [`SolveError::NotConverged`], [`SolveError::Indefinite`], [`SolveError::Inaccurate`], or
/// [`SolveError::RigidMotions`] if the number of near-zero eigenvalues is not the pencil's.
pub fn modes_in_band(pencil: &Pencil, band: Band) -> Result<Solution, SolveError> {
    modes_in_band_with(pencil, band, &())
}

/// [`modes_in_band`], told to `watch` as it goes.
///
/// # Errors
///
/// As [`modes_in_band`], and [`SolveError::Cancelled`] when `watch` says so.
pub fn modes_in_band_with(
    pencil: &Pencil,
    band: Band,
    watch: &dyn Watch,
) -> Result<Solution, SolveError> {
    if pencil.unknowns() < DENSE_BELOW {
        return densely(pencil, band);
    }
    sparsely(pencil, band, watch, largest_subspace)
}

fn densely(pencil: &Pencil, band: Band) -> Result<Solution, SolveError> {
    let n = pencil.unknowns();
    let (mut values, vectors) = dense::generalised(pencil)?;
    let top = (TAU * band.high_hz).powi(2);
    values.truncate(values.partition_point(|&value| value < top));
    let found = Found {
        panels: panel::from_columns(&vectors[..values.len() * n], n),
        values,
        solver: Solver::Dense,
    };
    verify(pencil, band, found, &|residual| residual.fill(0.0))
}

/// By Lanczos, in a subspace of at most so many vectors to the modes counted.
fn sparsely(
    pencil: &Pencil,
    band: Band,
    watch: &dyn Watch,
    largest: impl Fn(usize) -> usize,
) -> Result<Solution, SolveError> {
    let tell = |converged, wanted| match watch.converged(converged, wanted) {
        ControlFlow::Continue(()) => Ok(()),
        ControlFlow::Break(()) => Err(SolveError::Cancelled),
    };
    let top = (TAU * band.high_hz).powi(2);
    let symbolic = Symbolic::new(pencil);
    tell(0, 0)?;
    let mut room = symbolic.room();
    let counted = symbolic.count_below(pencil, top, &mut room);
    tell(0, counted)?;
    if counted == 0 {
        let found = Found {
            values: Vec::new(),
            panels: Vec::new(),
            solver: Solver::Lanczos { subspace: 0 },
        };
        return verify(pencil, band, found, &|_| {});
    }
    let factor = symbolic.cholesky(pencil, SHIFT, room)?;
    let mass = Mass::new(pencil, symbolic.place());
    let mut lanczos = Lanczos::new(&factor, &mass, SHIFT);
    let largest = largest(counted).min(pencil.unknowns());
    // Fewer vectors than modes cannot do.
    let (mut converged, mut next_look) = (0, counted + WIDTH);
    loop {
        tell(converged, counted)?;
        lanczos.expand();
        let size = lanczos.size();
        let full = size + 2 * WIDTH > largest;
        if size < next_look && !full {
            continue;
        }
        let ritz = lanczos.ritz();
        converged = ritz.converged(TOLERANCE).min(ritz.below(top));
        if converged >= counted {
            let vectors = lanczos.vectors(&ritz, counted);
            let panels = vectors.chunks_exact(pencil.unknowns() * WIDTH);
            let panels = panels.map(|panel| panel::reorder(panel, symbolic.place()));
            let found = Found {
                values: ritz.pairs[..counted].iter().map(|p| p.eigenvalue).collect(),
                panels: panels.collect(),
                solver: Solver::Lanczos { subspace: size },
            };
            return verify(pencil, band, found, &|residual| {
                let mut panel = panel::reorder(residual, symbolic.order());
                lanczos.solve_outside(&mut panel, &vectors);
                residual.copy_from_slice(&panel::reorder(&panel, symbolic.place()));
            });
        }
        if full {
            return Err(SolveError::NotConverged {
                converged,
                wanted: counted,
                subspace: size,
                known_below_hz: known_below_hz(pencil, &symbolic, &ritz, converged),
            });
        }
        // A panel seldom settles as many modes as it has vectors.
        next_look = size + (counted - converged) / 2;
    }
}

/// Frequency below which the first `converged` of `ritz`, or fewer, are all modes that there are.
pub(super) fn known_below_hz(
    pencil: &Pencil,
    symbolic: &Symbolic,
    ritz: &RitzSet,
    mut converged: usize,
) -> f64 {
    let mut room = symbolic.room();
    while converged > 0 {
        let last = ritz.pairs[converged - 1].eigenvalue;
        let next = ritz.pairs.get(converged).map_or(last, |p| p.eigenvalue);
        let between = 0.5 * (last + next);
        if symbolic.count_below(pencil, between, &mut room) == converged {
            return between.max(0.0).sqrt() / TAU;
        }
        converged /= 2;
    }
    0.0
}

#[cfg(test)]
mod tests {
    use super::super::dense;
    use super::*;
    use crate::TABLE_1;
    use crate::fem::{Pencil, TetMass, assemble};
    use crate::mesh::{TubeGrid, tube_hex20};
    use crate::shape::Tube;
    use crate::solve::lowest;
    use std::cell::{Cell, RefCell};

    fn coarse_chime() -> Pencil {
        let grid = TubeGrid {
            around: 8,
            along: 4,
        };
        let mesh = tube_hex20(&Tube::D5, grid);
        assemble(&mesh, &TABLE_1[0].material, TetMass::Consistent).unwrap()
    }

    #[test]
    fn lanczos_finds_what_dense_reduction_finds() {
        let pencil = coarse_chime();
        let (values, _) = dense::generalised(&pencil).unwrap();
        let solution = modes_in_band(&pencil, Band::AUDIBLE).unwrap();
        assert!(matches!(solution.solver, Solver::Lanczos { .. }));
        let below = values.partition_point(|v| v.max(0.0).sqrt() / TAU < 20_000.0);
        assert_eq!(solution.counted, below);
        assert_eq!(solution.modes.len(), below - 6);
        for (mode, value) in solution.modes.iter().zip(&values[6..]) {
            // Dense reduction leaves the rounding of the highest eigenvalue on the lowest.
            let error = mode.hz / (value.sqrt() / TAU) - 1.0;
            assert!(error.abs() < 1e-8, "{} Hz: {error:e}", mode.hz);
            assert!(mode.residual < 1e-6, "{} Hz: {:e}", mode.hz, mode.residual);
        }
        assert!(solution.orthonormality < 1e-12);
    }

    #[test]
    fn inertia_counts_dense_eigenvalues() {
        let pencil = coarse_chime();
        let (values, _) = dense::generalised(&pencil).unwrap();
        for hz in [10.0, 600.0, 2_000.0, 5_000.0, 12_345.0, 40_000.0, 200_000.0] {
            let below = values.partition_point(|v| v.max(0.0).sqrt() / TAU < hz);
            assert_eq!(
                crate::solve::count_below(&pencil, hz),
                below,
                "below {hz} Hz"
            );
        }
    }

    #[test]
    fn both_of_each_degenerate_pair_are_found() {
        let solution = modes_in_band(&coarse_chime(), Band::AUDIBLE).unwrap();
        let [a, b] = [0, 1].map(|i| &solution.modes[i]);
        assert!((a.hz / b.hz - 1.0).abs() < 1e-9, "{} {}", a.hz, b.hz);
    }

    #[test]
    fn lowest_agrees_with_the_band() {
        let pencil = coarse_chime();
        let solution = modes_in_band(&pencil, Band::AUDIBLE).unwrap();
        for index in [0, 2, 6] {
            let hz = lowest(&pencil, index).unwrap();
            let error = hz / solution.modes[index].hz - 1.0;
            assert!(error.abs() < 1e-9, "{error:e}");
        }
    }

    #[test]
    fn a_held_body_is_told_from_a_free_one() {
        let mut pencil = coarse_chime();
        // A spring on one unknown takes one rigid motion away.
        let first = pencil.pattern.column(0).start;
        pencil.stiffness[first] *= 2.0;
        let error = modes_in_band(&pencil, Band::AUDIBLE).unwrap_err();
        assert!(
            matches!(error, SolveError::RigidMotions { expected: 6, .. }),
            "{error}"
        );
    }

    /// Uncoupled springs, whose Krylov space ends long before the modes do.
    #[test]
    fn a_frequency_shared_by_many_modes_is_found_whole() {
        let n = 400u32;
        let omega = |i: u32| match i {
            0..6 => 0.0,
            6..36 => TAU * 1_000.0,
            _ => TAU * 50_000.0,
        };
        let columns: Vec<_> = (0..n).map(|i| vec![i]).collect();
        let pencil = Pencil {
            pattern: std::sync::Arc::new(crate::fem::Pattern::from_columns(&columns)),
            stiffness: (0..n).map(|i| 2.0 * omega(i).powi(2)).collect(),
            mass: vec![2.0; n as usize],
            rigid: 6,
        };
        let solution = modes_in_band(&pencil, Band::AUDIBLE).unwrap();
        assert_eq!(solution.modes.len(), 30);
        for mode in &solution.modes {
            assert!((mode.hz / 1_000.0 - 1.0).abs() < 1e-12, "{}", mode.hz);
        }
        assert!(solution.orthonormality < 1e-12);
    }

    #[test]
    fn whoever_watches_is_told_and_may_cancel() {
        let pencil = coarse_chime();
        let told = RefCell::new(Vec::new());
        let listen = |converged: usize, wanted: usize| {
            told.borrow_mut().push((converged, wanted));
            ControlFlow::Continue(())
        };
        let solution = modes_in_band_with(&pencil, Band::AUDIBLE, &listen).unwrap();
        let told = told.into_inner();
        assert_eq!(told[0], (0, 0));
        assert!(told[1..].iter().all(|&(_, w)| w == solution.counted));
        assert!(told.is_sorted());
        assert!(told.iter().any(|&(converged, _)| converged > 0));
        for allowed in 0..told.len() {
            let calls = Cell::new(0);
            let cancel = |_: usize, _: usize| {
                calls.set(calls.get() + 1);
                if calls.get() > allowed {
                    ControlFlow::Break(())
                } else {
                    ControlFlow::Continue(())
                }
            };
            let error = modes_in_band_with(&pencil, Band::AUDIBLE, &cancel).unwrap_err();
            assert_eq!(error, SolveError::Cancelled);
        }
    }

    #[test]
    fn stopping_short_tells_what_is_safe() {
        let pencil = coarse_chime();
        let all = modes_in_band(&pencil, Band::AUDIBLE).unwrap();
        let error = sparsely(&pencil, Band::AUDIBLE, &(), |counted| 2 * counted).unwrap_err();
        let text = error.to_string();
        let SolveError::NotConverged {
            converged,
            wanted,
            known_below_hz,
            ..
        } = error
        else {
            panic!("{text}");
        };
        assert_eq!(wanted, all.counted);
        let known = all.modes.partition_point(|mode| mode.hz < known_below_hz);
        assert!(known > 0 && known + 6 <= converged, "{text}");
        assert!(text.contains(&format!("{known_below_hz:.1} Hz")), "{text}");
    }

    #[test]
    fn small_pencils_are_solved_densely() {
        let grid = TubeGrid {
            around: 6,
            along: 1,
        };
        let mesh = crate::mesh::tube_tet4(&Tube::D5, grid, 1);
        for mass in [TetMass::Consistent, TetMass::Lumped] {
            let pencil = assemble(&mesh, &TABLE_1[0].material, mass).unwrap();
            let solution = modes_in_band(&pencil, Band::AUDIBLE).unwrap();
            assert_eq!(solution.solver, Solver::Dense);
            assert_eq!(solution.counted, solution.modes.len() + 6);
            assert!(solution.orthonormality < 1e-10);
        }
    }
}
