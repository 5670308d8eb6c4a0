//! All modes of a band: solved, counted, checked.

use super::SolveError;
use super::dense;
use super::factor::Symbolic;
use super::lanczos::Lanczos;
use super::panel::{self, WIDTH};
use super::sparse::{Mass, forces_and_inertias};
use crate::fem::Pencil;
use std::f64::consts::TAU;

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

/// Largest residual of the inverse operator that counts as converged, relative to its eigenvalue.
const TOLERANCE: f64 = 4e-9;

/// Shift below the spectrum, as the frequency whose −ω² it is: near the lowest modes, yet far enough
/// from the rigid motions for K − σM to be well conditioned and for them not to outweigh the rest.
const SHIFT_HZ: f64 = 1000.0;

/// Largest relative residual that a mode may have. Rounding alone leaves some 10⁻¹⁶ times the ratio
/// of the mesh's highest eigenvalue to the mode's: 3·10⁻⁷ for the lowest mode of a tube of 1.5 m.
const MAX_RESIDUAL: f64 = 1e-5;

/// Relative residual above which rounding is taken out of a mode once more.
const ROUGH: f64 = 1e-9;

/// An eigenvalue is a rigid motion's if its frequency is below this.
const RIGID_HZ: f64 = 1.0;

/// Every mode of `pencil` in `band`; none is missed: their number is checked against the inertia of
/// K − λM at the band's upper end.
///
/// # Errors
///
/// [`SolveError::NotConverged`], [`SolveError::Indefinite`], [`SolveError::Inaccurate`], or
/// [`SolveError::RigidMotions`] if the number of near-zero eigenvalues is not the pencil's.
pub fn modes_in_band(pencil: &Pencil, band: Band) -> Result<Solution, SolveError> {
    let top = (TAU * band.high_hz).powi(2);
    if pencil.unknowns() < DENSE_BELOW {
        let (values, vectors) = dense::generalised(pencil)?;
        let counted = values.partition_point(|&value| value < top);
        let panels =
            panel::from_columns(&vectors[..counted * pencil.unknowns()], pencil.unknowns());
        // Nothing is left outside all the modes.
        let correct = |residual: &mut [f64]| residual.fill(0.0);
        return finish(
            pencil,
            band,
            (&values[..counted], panels),
            &correct,
            Solver::Dense,
        );
    }
    let symbolic = Symbolic::new(pencil);
    let mut room = symbolic.room();
    let counted = symbolic.count_below(pencil, top, &mut room);
    if counted == 0 {
        let solver = Solver::Lanczos { subspace: 0 };
        return finish(pencil, band, (&[], Vec::new()), &|_| {}, solver);
    }
    let shift = -(TAU * SHIFT_HZ).powi(2);
    let factor = symbolic.cholesky(pencil, shift, room)?;
    let mass = Mass::new(pencil, symbolic.place());
    let mut lanczos = Lanczos::new(&factor, &mass, shift);
    let largest = (4 * counted + 60).min(pencil.unknowns());
    loop {
        lanczos.expand();
        let size = lanczos.size();
        // Fewer vectors than modes cannot do.
        if size < counted + WIDTH {
            continue;
        }
        let ritz = lanczos.ritz();
        let converged = ritz
            .pairs
            .iter()
            .take_while(|pair| pair.eigenvalue < top && pair.residual < TOLERANCE)
            .count();
        if converged >= counted {
            let found = lanczos.vectors(&ritz, counted);
            let panels = found.chunks_exact(pencil.unknowns() * WIDTH);
            let panels = panels
                .map(|panel| panel::reorder(panel, symbolic.place()))
                .collect();
            let values: Vec<f64> = ritz.pairs[..counted].iter().map(|p| p.eigenvalue).collect();
            let solver = Solver::Lanczos { subspace: size };
            let correct = |residual: &mut [f64]| {
                let mut panel = panel::reorder(residual, symbolic.order());
                lanczos.solve_outside(&mut panel, &found);
                residual.copy_from_slice(&panel::reorder(&panel, symbolic.place()));
            };
            return finish(pencil, band, (&values, panels), &correct, solver);
        }
        if size + 2 * WIDTH > largest {
            return Err(SolveError::NotConverged {
                converged,
                wanted: counted,
                subspace: size,
            });
        }
    }
}

/// Frequency in Hz of the `index`th elastic mode of `pencil`, counted from 0 above the rigid motions.
///
/// # Errors
///
/// As [`modes_in_band`].
pub fn lowest(pencil: &Pencil, index: usize) -> Result<f64, SolveError> {
    Ok(lowest_of(pencil, index + 1)?[index])
}

/// Frequencies in Hz of the first `count` elastic modes of `pencil`, rising.
///
/// # Errors
///
/// As [`modes_in_band`].
pub fn lowest_of(pencil: &Pencil, count: usize) -> Result<Vec<f64>, SolveError> {
    let symbolic = Symbolic::new(pencil);
    let shift = -(TAU * SHIFT_HZ).powi(2);
    let factor = symbolic.cholesky(pencil, shift, symbolic.room())?;
    let mass = Mass::new(pencil, symbolic.place());
    let mut lanczos = Lanczos::new(&factor, &mass, shift);
    let wanted = pencil.rigid + count;
    let largest = 4 * wanted + 60;
    loop {
        lanczos.expand();
        let size = lanczos.size();
        if size < wanted + 2 {
            continue;
        }
        let ritz = lanczos.ritz();
        if ritz.pairs.len() >= wanted && ritz.pairs[..wanted].iter().all(|p| p.residual < 1e-9) {
            let elastic = &ritz.pairs[pencil.rigid..wanted];
            return Ok(elastic
                .iter()
                .map(|pair| pair.eigenvalue.max(0.0).sqrt() / TAU)
                .collect());
        }
        if size > largest {
            let converged = ritz.pairs.iter().take_while(|p| p.residual < 1e-9).count();
            return Err(SolveError::NotConverged {
                converged,
                wanted,
                subspace: size,
            });
        }
    }
}

/// Drops rigid motions and what lies below the band; measures residuals and orthonormality. Where
/// rounding left a mode too rough, takes away what `correct`, (K − σM)⁻¹ beside the modes, makes of its residual.
fn finish(
    pencil: &Pencil,
    band: Band,
    (values, mut panels): (&[f64], Vec<Vec<f64>>),
    correct: &dyn Fn(&mut [f64]),
    solver: Solver,
) -> Result<Solution, SolveError> {
    let rigid_top = (TAU * RIGID_HZ).powi(2);
    let found = values.partition_point(|&value| value < rigid_top);
    if found != pencil.rigid {
        return Err(SolveError::RigidMotions {
            found,
            expected: pencil.rigid,
        });
    }
    let bottom = (TAU * band.low_hz).powi(2);
    let (mut modes, mut orthonormality) = (Vec::new(), 0.0f64);
    let mut forces = vec![0.0; pencil.unknowns() * WIDTH];
    let mut inertias = forces.clone();
    for (p, values) in values.chunks(WIDTH).enumerate() {
        forces_and_inertias(pencil, &panels[p], &mut forces, &mut inertias);
        if residuals(&forces, &inertias, values)
            .iter()
            .zip(values)
            .any(|(residual, value)| *value >= rigid_top && *residual > ROUGH)
        {
            let mut rough = excess(&forces, &inertias, values);
            correct(&mut rough);
            for (entry, rough) in panels[p].iter_mut().zip(rough) {
                *entry -= rough;
            }
            forces_and_inertias(pencil, &panels[p], &mut forces, &mut inertias);
        }
        for (q, other) in panels[..=p].iter().enumerate() {
            for (at, entry) in panel::inner(other, &inertias).into_iter().enumerate() {
                let (i, j) = (at / WIDTH, at % WIDTH);
                if j < values.len() {
                    let expected = f64::from(u8::from(p == q && i == j));
                    orthonormality = orthonormality.max((entry - expected).abs());
                }
            }
        }
        let residuals = residuals(&forces, &inertias, values);
        let columns = panel::columns(&panels[p]);
        for ((&value, residual), vector) in values.iter().zip(residuals).zip(columns) {
            if value >= bottom.max(rigid_top) {
                modes.push(Eigenmode {
                    hz: value.sqrt() / TAU,
                    residual,
                    vector,
                });
            }
        }
    }
    if let Some(mode) = modes.iter().find(|mode| mode.residual > MAX_RESIDUAL) {
        return Err(SolveError::Inaccurate {
            hz: mode.hz,
            residual: mode.residual,
            allowed: MAX_RESIDUAL,
        });
    }
    Ok(Solution {
        modes,
        counted: values.len(),
        orthonormality,
        solver,
    })
}

/// Kφ − λMφ for the vectors of a panel; zero where there is none.
fn excess(forces: &[f64], inertias: &[f64], values: &[f64]) -> Vec<f64> {
    let entry = |at: usize| {
        values
            .get(at % WIDTH)
            .map_or(0.0, |value| forces[at] - value * inertias[at])
    };
    (0..forces.len()).map(entry).collect()
}

/// ‖Kφ − λMφ‖ / ‖Kφ‖ of the vectors of a panel.
fn residuals(forces: &[f64], inertias: &[f64], values: &[f64]) -> [f64; WIDTH] {
    let mut sums = [(0.0, 0.0); WIDTH];
    for (force, inertia) in forces.chunks_exact(WIDTH).zip(inertias.chunks_exact(WIDTH)) {
        for (c, &value) in values.iter().enumerate() {
            sums[c].0 += (force[c] - value * inertia[c]).powi(2);
            sums[c].1 += force[c] * force[c];
        }
    }
    sums.map(|(error, force): (f64, f64)| (error / force).sqrt())
}

#[cfg(test)]
mod tests {
    use super::super::dense;
    use super::*;
    use crate::TABLE_1;
    use crate::fem::{Pencil, TetMass, assemble};
    use crate::mesh::{TubeGrid, tube_hex20};
    use crate::shape::Tube;

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
