//! Bodies of revolution: their meridians, and their modes by harmonics around the axis.

mod bell;
mod bowl;
mod modes;
mod wall;

pub use bell::{Bell, bell};
pub use bowl::bowl;
pub use modes::{Imperfection, revolution_modes};
pub use wall::Wall;
