//! The lowest few frequencies, for loops that tune.

use super::SolveError;
use super::band::known_below_hz;
use super::factor::Symbolic;
use super::lanczos::Lanczos;
use super::shift::{SHIFT, TOLERANCE};
use super::sparse::Mass;
use crate::fem::Pencil;
use std::f64::consts::TAU;

/// Frequency in Hz of the `index`th elastic mode of `pencil`, counted from 0 above the rigid motions.
///
/// # Errors
///
/// [`SolveError::NotConverged`] or [`SolveError::Indefinite`].
pub fn lowest(pencil: &Pencil, index: usize) -> Result<f64, SolveError> {
    let symbolic = Symbolic::new(pencil);
    let factor = symbolic.cholesky(pencil, SHIFT, symbolic.room())?;
    let mass = Mass::new(pencil, symbolic.place());
    let mut lanczos = Lanczos::new(&factor, &mass, SHIFT);
    let wanted = pencil.rigid + index + 1;
    let largest = 4 * wanted + 60;
    loop {
        lanczos.expand();
        let size = lanczos.size();
        if size < wanted + 2 {
            continue;
        }
        let ritz = lanczos.ritz();
        let converged = ritz.converged(TOLERANCE);
        if converged >= wanted {
            return Ok(ritz.pairs[wanted - 1].eigenvalue.max(0.0).sqrt() / TAU);
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
