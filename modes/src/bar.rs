//! Free bars with an arch cut from below: tuned, and solved for every audible mode.

mod air;
mod beam;
mod body;
mod dimensions;
mod miss;
mod quarter;
mod ratios;
mod reach;
#[cfg(test)]
mod tests;
mod tune;
mod tuning;

pub use body::{BarPartials, bar_modes, bar_partials};
pub use ratios::{stretched, vibraphone_ratios, vibraphone_stock};
pub use tune::{TunedBar, retune_bar, tune_bar};
pub use tuning::{BarStock, BarTuneError, BarTuning};

use crate::mesh::BarGrid;
use crate::shape::Bar;

/// Cells along half a bar at least: fewer do not follow its arch.
const LEAST_ALONG: usize = 6;

/// How finely a bar is cut.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BarFineness {
    /// Longest cell along the bar, in m; where that is too coarse for an arch, they are shorter.
    pub max_element_m: f64,
    /// Cells across half the width.
    pub across: usize,
    /// Cells through the thickness.
    pub through: usize,
}

impl BarFineness {
    /// The grid that cuts `bar` this finely.
    #[must_use]
    pub fn grid(&self, bar: &Bar) -> BarGrid {
        #[expect(clippy::cast_sign_loss, reason = "lengths are positive")]
        let along = (0.5 * bar.length_m / self.max_element_m).ceil().max(1.0) as usize;
        BarGrid {
            along: along.max(LEAST_ALONG),
            across: self.across,
            through: self.through,
        }
    }
}
