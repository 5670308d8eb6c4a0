//! The lowest few frequencies, for loops that tune.

use super::SolveError;
use super::band::known_below_hz;
use super::factor::Symbolic;
use super::lanczos::Lanczos;
use super::shift::{SHIFT, TOLERANCE, largest_subspace};
use super::sparse::Mass;
use crate::fem::Pencil;
use std::f64::consts::TAU;

/// Frequency in Hz of the `index`th elastic mode of `pencil`, counted from 0 above the rigid motions.
///
/// # Errors
///
/// As [`lowest_of`].
pub fn lowest(pencil: &Pencil, index: usize) -> Result<f64, SolveError> {
    Ok(lowest_of(pencil, index + 1)?[index])
}

/// Frequencies in Hz of the first `count` elastic modes of `pencil`, ascending.
///
/// # Errors
///
/// [`SolveError::NotConverged`] or [`SolveError::Indefinite`].
pub fn lowest_of(pencil: &Pencil, count: usize) -> Result<Vec<f64>, SolveError> {
    let symbolic = Symbolic::new(pencil);
    let factor = symbolic.cholesky(pencil, SHIFT, symbolic.room())?;
    let mass = Mass::new(pencil, symbolic.place());
    let mut lanczos = Lanczos::new(&factor, &mass, SHIFT);
    let wanted = pencil.rigid + count;
    let largest = largest_subspace(wanted);
    loop {
        lanczos.expand();
        let size = lanczos.size();
        if size < wanted + 2 {
            continue;
        }
        let ritz = lanczos.ritz();
        let converged = ritz.converged(TOLERANCE);
        if converged >= wanted {
            let elastic = &ritz.pairs[pencil.rigid..wanted];
            let hz = |eigenvalue: f64| eigenvalue.max(0.0).sqrt() / TAU;
            return Ok(elastic.iter().map(|pair| hz(pair.eigenvalue)).collect());
        }
        if size > largest {
            return Err(SolveError::NotConverged {
                converged,
                wanted,
                subspace: size,
                known_below_hz: known_below_hz(pencil, &symbolic, &ritz, converged),
            });
        }
    }
}
