//! Where a body is struck: points on its surface, and how to go between them.

mod grid;
mod line;
mod motions;
mod stencil;
mod tables;

pub use grid::{Spot, StrikeGrid};
pub use line::StrikeLine;
pub use motions::Motions;
pub use stencil::{Across, Stencil};
pub use tables::ShapeTables;
