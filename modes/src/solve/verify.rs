//! Whether what was found solves the problem.

use super::SolveError;
use super::band::{Band, Eigenmode, Solution, Solver};
use super::panel::{self, WIDTH};
use super::sparse::forces_and_inertias;
use crate::fem::Pencil;
use std::f64::consts::TAU;

/// Largest relative residual that a mode may have. Rounding alone leaves some 10⁻¹⁶ times the ratio
/// of the mesh's highest eigenvalue to the mode's: 3·10⁻⁷ for the lowest mode of a tube of 1.5 m.
const MAX_RESIDUAL: f64 = 1e-5;

/// Relative residual above which rounding is taken out of a mode once more.
const ROUGH: f64 = 5e-9;

/// An eigenvalue is a rigid motion's if its frequency is below this.
const RIGID_HZ: f64 = 1.0;

/// What was found: panels of M-orthonormal vectors in the pencil's order and their rising λ.
pub(super) struct Found {
    pub(super) values: Vec<f64>,
    pub(super) panels: Vec<Vec<f64>>,
    pub(super) solver: Solver,
}

/// Drops rigid motions and what lies below the band; measures residuals and orthonormality. Where
/// rounding left a mode too rough, takes away what `correct` makes of its residual: (K − σM)⁻¹ at
/// right angles to all that was found.
pub(super) fn verify(
    pencil: &Pencil,
    band: Band,
    found: Found,
    correct: &dyn Fn(&mut [f64]),
) -> Result<Solution, SolveError> {
    let Found {
        values,
        mut panels,
        solver,
    } = found;
    let rigid_top = (TAU * RIGID_HZ).powi(2);
    let rigid = values.partition_point(|&value| value < rigid_top);
    if rigid != pencil.rigid {
        return Err(SolveError::RigidMotions {
            found: rigid,
            expected: pencil.rigid,
        });
    }
    let bottom = (TAU * band.low_hz).powi(2);
    let (mut modes, mut orthonormality) = (Vec::new(), 0.0f64);
    let mut forces = vec![0.0; pencil.unknowns() * WIDTH];
    let mut inertias = forces.clone();
    for (p, values) in values.chunks(WIDTH).enumerate() {
        forces_and_inertias(pencil, &panels[p], &mut forces, &mut inertias);
        let mut left = residuals(&forces, &inertias, values);
        let mut elastic = left.iter().zip(values).filter(|(_, v)| **v >= rigid_top);
        if elastic.any(|(residual, _)| *residual > ROUGH) {
            let mut rough = excess(&forces, &inertias, values);
            correct(&mut rough);
            for (entry, rough) in panels[p].iter_mut().zip(rough) {
                *entry -= rough;
            }
            forces_and_inertias(pencil, &panels[p], &mut forces, &mut inertias);
            left = residuals(&forces, &inertias, values);
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
        let columns = panel::columns(&panels[p]);
        for ((&value, residual), vector) in values.iter().zip(left).zip(columns) {
            if value >= bottom.max(rigid_top) {
                modes.push(Eigenmode {
                    hz: value.sqrt() / TAU,
                    residual,
                    vector,
                });
            }
        }
    }
    let good = |mode: &Eigenmode| mode.residual <= MAX_RESIDUAL;
    if let Some(index) = modes.iter().position(|mode| !good(mode)) {
        let mode = &modes[index];
        return Err(SolveError::Inaccurate {
            good: index,
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
    use crate::fem::{TetMass, assemble};
    use crate::mesh::{TubeGrid, tube_tet4};
    use crate::shape::Tube;

    #[test]
    fn a_mode_that_is_none_is_told_with_the_good_ones_below_it() {
        const GOOD: usize = 3;
        let grid = TubeGrid {
            around: 6,
            along: 1,
        };
        let mesh = tube_tet4(&Tube::D5, grid, 1);
        let pencil = assemble(&mesh, &TABLE_1[0].material, TetMass::Consistent).unwrap();
        let n = pencil.unknowns();
        let (mut values, mut vectors) = dense::generalised(&pencil).unwrap();
        values.truncate(pencil.rigid + GOOD + 2);
        vectors.truncate(values.len() * n);
        vectors[(pencil.rigid + GOOD) * n] *= 1.01;
        let found = Found {
            panels: panel::from_columns(&vectors, n),
            values: values.clone(),
            solver: Solver::Dense,
        };
        let error = verify(&pencil, Band::AUDIBLE, found, &|left| left.fill(0.0)).unwrap_err();
        let SolveError::Inaccurate { hz, good, .. } = error else {
            panic!("{error}");
        };
        assert_eq!(good, GOOD);
        assert_eq!(hz, values[pencil.rigid + GOOD].sqrt() / TAU);
    }
}
