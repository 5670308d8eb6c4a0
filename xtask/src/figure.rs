//! A picture of a body's modes: frequency across, T60 up, level as size, kind of motion as colour.

mod axis;
mod dots;
mod family;
mod names;
mod picture;

pub use dots::STRIKE_POSITION;
pub(crate) use dots::pressure_pa;
pub(crate) use picture::draw;
