//! Structured meshes of a bar.

use super::{Mesh, cells_hex20};
use crate::shape::Bar;

/// How many cells a quarter of a bar is cut into.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct BarGrid {
    /// Cells along half the length.
    pub along: usize,
    /// Cells across half the width.
    pub across: usize,
    /// Cells through the thickness.
    pub through: usize,
}

impl BarGrid {
    /// Cells about twice as long and wide.
    pub(crate) fn coarse(self) -> Self {
        Self {
            along: self.along.div_ceil(2),
            across: self.across.div_ceil(2),
            through: self.through,
        }
    }
}

/// How much of a bar is meshed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum BarPart {
    /// All of it.
    Whole,
    /// What of it has x ≥ 0 and y ≥ 0.
    Quarter,
}

/// Twenty-node hexahedra of `bar`, with mid-side nodes on the arch; cells through the thickness
/// follow each other first, upwards, then cells across, then cells along.
#[must_use]
pub fn bar_hex20(bar: &Bar, grid: BarGrid, part: BarPart) -> Mesh {
    let halves = match part {
        BarPart::Whole => 2,
        BarPart::Quarter => 1,
    };
    // Place of a half step as a share of half the bar, from its middle.
    let share = |step: usize, half: usize| {
        let from_middle = step as f64 - ((halves - 1) * 2 * half) as f64;
        from_middle / (2 * half) as f64
    };
    cells_hex20(
        [halves * grid.along, halves * grid.across, grid.through],
        |_| true,
        |[i, j, k]| {
            let x_m = 0.5 * bar.length_m * share(i, grid.along);
            let y_m = 0.5 * bar.width_m * share(j, grid.across);
            let below = 1.0 - k as f64 / (2 * grid.through) as f64;
            [x_m, y_m, -below * bar.thickness_at_m(x_m)]
        },
    )
}
