//! Where a body is struck: points on its surface, and how to go between them.

mod grid;
mod line;
mod stencil;

pub use grid::{Spot, StrikeGrid};
pub use line::StrikeLine;
pub use stencil::{Across, Stencil};
