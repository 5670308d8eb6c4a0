//! The modes of a mesh, up to a frequency or a number.

use crate::fem::{Pencil, TetMass, assemble};
use crate::mesh::Mesh;
use crate::solve::{Band, Solution, Watch, count_below, modes_in_band_with};
use crate::{Material, SolveError};

/// Which modes of a body are wanted: from the lowest elastic one up.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Limits {
    /// Highest frequency, in Hz.
    pub highest_hz: f64,
    /// How many at most; then the highest frequency is lowered.
    pub most: usize,
}

/// Lowest elastic frequency that is looked for, in Hz: a mesh's size may be changed later.
const LOWEST_HZ: f64 = 1.0;

/// Part of [`Limits::most`] that is near enough to it.
const ENOUGH: f64 = 0.8;

/// Frequencies tried to find one with few enough modes below it.
const TRIES: usize = 8;

/// Every elastic mode of `mesh` within `limits`, and its pencil.
pub(super) fn solve(
    mesh: &Mesh,
    material: &Material,
    limits: Limits,
    watch: &dyn Watch,
) -> Result<(Pencil, Solution), SolveError> {
    let pencil = assemble(mesh, material, TetMass::Consistent)?;
    let band = Band {
        low_hz: LOWEST_HZ,
        high_hz: highest_hz(&pencil, limits, watch)?,
    };
    let solution = modes_in_band_with(&pencil, band, watch)?;
    Ok((pencil, solution))
}

/// Mass of the body in kg: what a shift of one along x weighs.
pub(super) fn mass_kg(pencil: &Pencil) -> f64 {
    let shift: Vec<f64> = (0..pencil.unknowns())
        .map(|unknown| f64::from(u8::from(unknown.is_multiple_of(3))))
        .collect();
    let mut inertia = vec![0.0; shift.len()];
    pencil.multiply(&pencil.mass, &shift, &mut inertia);
    shift.iter().zip(&inertia).map(|(x, y)| x * y).sum()
}

/// The highest frequency in Hz below which there are no more modes than wanted, nearly as many of
/// them if there are more above. The number of a solid's modes goes with the cube of the frequency, of a
/// plate's with the first power: the power is taken from what has been counted.
fn highest_hz(pencil: &Pencil, limits: Limits, watch: &dyn Watch) -> Result<f64, SolveError> {
    let count = |hz: f64| {
        if watch.converged(0, 0).is_break() {
            return Err(SolveError::Cancelled);
        }
        Ok(count_below(pencil, hz).saturating_sub(pencil.rigid))
    };
    let all = count(limits.highest_hz)?;
    if all <= limits.most {
        return Ok(limits.highest_hz);
    }
    let wanted = limits.most as f64;
    // Below the one there are few enough, below the other too many.
    let (mut few, mut many) = ((LOWEST_HZ, 0), (limits.highest_hz, all));
    for _ in 0..TRIES {
        if few.1 as f64 >= ENOUGH * wanted {
            break;
        }
        let (low, high) = ((few.1 as f64).max(0.5), many.1 as f64);
        let share = ((0.9 * wanted / low).ln() / (high / low).ln()).clamp(0.05, 0.95);
        let hz = few.0 * (many.0 / few.0).powf(share);
        let found = count(hz)?;
        if found > limits.most {
            many = (hz, found);
        } else {
            few = (hz, found);
        }
    }
    Ok(few.0.max(2.0 * LOWEST_HZ))
}
