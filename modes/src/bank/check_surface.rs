//! Whether a body's surface is one that can be drawn.

use super::check::positive;
use super::{BankError, Surface};

/// Bounds within which single precision stays finite.
const MAX_M: f32 = 1e6;
const MAX_STEP: f32 = 1e7;

pub(super) fn check_surface(surface: &Surface) -> Result<(), BankError> {
    positive("surface length_m", surface.length_m)?;
    let points = surface.points_m.len();
    let far = |x: &&f32| !(-MAX_M..=MAX_M).contains(*x);
    if let Some(x) = surface.points_m.iter().flatten().find(far) {
        return Err(BankError::inconsistent("surface points", x, "-1e6 to 1e6"));
    }
    let missing = |corner: &&u32| **corner as usize >= points;
    if let Some(corner) = surface.triangles.iter().flatten().find(missing) {
        let allowed = "below the number of the surface's points";
        return Err(BankError::inconsistent(
            "surface triangles",
            corner,
            allowed,
        ));
    }
    check_motions(surface.motions.len())?;
    for motion in &surface.motions {
        if !(0.0..=MAX_STEP).contains(&motion.step) {
            let step = motion.step;
            return Err(BankError::inconsistent("surface step", step, "0 to 1e7"));
        }
        if motion.points.len() != points {
            let allowed = "one for each point of the surface";
            let count = format!("of {} points", motion.points.len());
            return Err(BankError::inconsistent("surface motion", count, allowed));
        }
    }
    Ok(())
}

/// Whether a surface may move in so many modes.
pub(super) fn check_motions(count: usize) -> Result<(), BankError> {
    if count > Surface::MOST_MODES {
        return Err(BankError::inconsistent(
            "surface motions",
            count,
            "at most 128",
        ));
    }
    Ok(())
}
