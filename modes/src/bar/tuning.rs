//! What a bar is cut from and tuned to, and why it cannot be.

use crate::SolveError;

/// What a bar is cut from.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BarStock {
    /// Length, in m.
    pub length_m: f64,
    /// Width, in m.
    pub width_m: f64,
    /// Thickness, in m.
    pub thickness_m: f64,
}

impl BarStock {
    /// The same stock with all its dimensions times `factor`.
    #[must_use]
    pub fn scaled(&self, factor: f64) -> Self {
        Self {
            length_m: factor * self.length_m,
            width_m: factor * self.width_m,
            thickness_m: factor * self.thickness_m,
        }
    }
}

/// What a bar is to be tuned to.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BarTuning {
    /// Pitch, in Hz: that of the first bending mode.
    pub pitch_hz: f64,
    /// The second and the third bending mode as multiples of the first.
    pub ratios: [f64; 2],
    /// How far the pitch may be off, in cents; the other two modes may be ten times as far.
    pub tolerance_cents: f64,
}

/// Why a bar cannot be tuned.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum BarTuneError {
    /// No arch, and no length near the stock's, has the partials.
    #[error(
        "ratios 1 : {second:.3} : {third:.3} at {pitch_hz:.2} Hz are out of reach of stock \
         {length_m:.3} m long and {thickness_m:.4} m thick; the nearest within reach are \
         1 : {nearest_second:.3} : {nearest_third:.3} at {nearest_hz:.2} Hz"
    )]
    OutOfReach {
        /// The pitch asked for, in Hz.
        pitch_hz: f64,
        /// The second mode asked for, as a multiple of the first.
        second: f64,
        /// The third mode asked for.
        third: f64,
        /// Length of the stock, in m.
        length_m: f64,
        /// Thickness of the stock, in m.
        thickness_m: f64,
        /// Pitch of the nearest bar that a beam could be, in Hz.
        nearest_hz: f64,
        /// Its second mode.
        nearest_second: f64,
        /// Its third mode.
        nearest_third: f64,
    },
    /// The search stopped short of the tolerance.
    #[error(
        "the bar's partials stay {:.3}, {:.3} and {:.3} cents off those of {pitch_hz:.2} Hz; shorter elements \
         or a wider tolerance may do",
        cents[0], cents[1], cents[2]
    )]
    NotTuned {
        /// The pitch asked for, in Hz.
        pitch_hz: f64,
        /// How far the three modes are off.
        cents: [f64; 3],
    },
    /// The eigenproblem was not solved.
    #[error(transparent)]
    Solve(#[from] SolveError),
}
