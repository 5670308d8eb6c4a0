//! The modes of a mesh, up to a frequency or a number.

use crate::fem::{Pencil, TetMass, assemble};
use crate::mesh::Mesh;
use crate::solve::{Band, Solution, Watch, count_below, lowest_of, modes_in_band_with};
use crate::{Material, SolveError};
use std::ops::ControlFlow;

/// Which modes of a body are wanted: from the lowest elastic one up.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Limits {
    /// Highest frequency, in Hz.
    pub highest_hz: f64,
    /// How many at most; then the highest frequency is lowered.
    pub most: usize,
    /// A mode, counted from 1, and the frequency in Hz that it will be tuned to at the lowest: the highest
    /// frequency is then one of the body so tuned. Without, of the body as it is.
    pub tuned: Option<(usize, f64)>,
}

/// Lowest elastic frequency that is looked for, in Hz: a mesh's size may be changed later.
const LOWEST_HZ: f64 = 1.0;

/// Part of [`Limits::most`] that is near enough to it, and the one aimed at.
const ENOUGH: f64 = 0.7;
const AIM: f64 = 0.85;

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
    let told = || match watch.converged(0, 0) {
        ControlFlow::Continue(()) => Ok(()),
        ControlFlow::Break(()) => Err(SolveError::Cancelled),
    };
    let count = |hz: f64| {
        told()?;
        Ok(count_below(pencil, hz).saturating_sub(pencil.rigid))
    };
    let mut lowest_hz = None;
    let mut top_hz = limits.highest_hz;
    if let Some((number, hz)) = limits.tuned {
        told()?;
        let modes_hz = lowest_of(pencil, number)?;
        lowest_hz = Some(modes_hz[0]);
        top_hz *= modes_hz[number - 1] / hz;
    }
    let all = count(top_hz)?;
    if all <= limits.most {
        return Ok(top_hz);
    }
    let lowest_hz = match lowest_hz {
        Some(hz) => hz,
        None => lowest_of(pencil, 1)?[0],
    };
    let wanted = limits.most as f64;
    // Below the one there are few enough, below the other too many.
    let (mut few, mut many) = ((lowest_hz, 1), (top_hz, all));
    for _ in 0..TRIES {
        if few.1 as f64 >= ENOUGH * wanted {
            break;
        }
        let (low, high) = (few.1 as f64, many.1 as f64);
        let share = ((AIM * wanted / low).ln() / (high / low).ln()).clamp(0.05, 0.95);
        let hz = few.0 * (many.0 / few.0).powf(share);
        let found = count(hz)?;
        if found > limits.most {
            many = (hz, found);
        } else {
            few = (hz, found.max(1));
        }
    }
    // A little above the lowest, which is there in any case.
    Ok(few.0.max(1.000_1 * lowest_hz))
}
