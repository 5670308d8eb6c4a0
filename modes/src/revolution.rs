//! Bodies of revolution: their meridians, and their modes by harmonics around the axis.

mod bell;
mod bowl;
mod line;
mod modes;
mod patches;
mod solved;
mod wall;

pub use bell::{Bell, bell};
pub use bowl::bowl;
pub use modes::{Imperfection, revolution_modes};
pub use solved::SolvedWall;
pub use wall::{LAYERS, Wall};
