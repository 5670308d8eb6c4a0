//! Structured meshes of a bar.

use super::{Elements, Mesh};
use crate::fem::HEX20_NODES;
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

/// How much of a bar is meshed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum BarPart {
    /// All of it.
    Whole,
    /// What of it has x ≥ 0 and y ≥ 0.
    Quarter,
}

fn number(index: usize) -> u32 {
    u32::try_from(index).expect("meshes have fewer than 2^32 nodes")
}

/// Twenty-node hexahedra of `bar`, with mid-side nodes on the arch; cells through the thickness
/// follow each other first, upwards, then cells across, then cells along.
#[must_use]
pub fn bar_hex20(bar: &Bar, grid: BarGrid, part: BarPart) -> Mesh {
    let halves = match part {
        BarPart::Whole => 2,
        BarPart::Quarter => 1,
    };
    let cells = [halves * grid.along, halves * grid.across, grid.through];
    let steps = cells.map(|count| 2 * count + 1);
    let slot = |[i, j, k]: [usize; 3]| (i * steps[1] + j) * steps[2] + k;
    // Half cells from the middle of the bar.
    let from_middle = |index: usize, half: usize| index as f64 - ((halves - 1) * 2 * half) as f64;
    let mut ids = vec![u32::MAX; steps.iter().product()];
    let mut nodes = Vec::new();
    for i in 0..steps[0] {
        let x_m = 0.5 * bar.length_m * from_middle(i, grid.along) / (2 * grid.along) as f64;
        for j in 0..steps[1] {
            let y_m = 0.5 * bar.width_m * from_middle(j, grid.across) / (2 * grid.across) as f64;
            for k in 0..steps[2] {
                // Serendipity nodes are corners and edge middles: at most one odd index.
                if i % 2 + j % 2 + k % 2 > 1 {
                    continue;
                }
                ids[slot([i, j, k])] = number(nodes.len());
                let below = 1.0 - k as f64 / (steps[2] - 1) as f64;
                nodes.push([x_m, y_m, -below * bar.thickness_at_m(x_m)]);
            }
        }
    }
    let mut hexes = Vec::with_capacity(cells.iter().product());
    for i in 0..cells[0] {
        for j in 0..cells[1] {
            for k in 0..cells[2] {
                hexes.push(HEX20_NODES.map(|local| {
                    let step = |a: usize, cell: usize| match local[a] {
                        -1.0 => 2 * cell,
                        0.0 => 2 * cell + 1,
                        _ => 2 * cell + 2,
                    };
                    ids[slot([step(0, i), step(1, j), step(2, k)])]
                }));
            }
        }
    }
    Mesh {
        nodes,
        elements: Elements::Hex20(hexes),
    }
}
