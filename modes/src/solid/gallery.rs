//! Shapes of our own making, as triangles.

mod extrude;
mod round;

pub use extrude::{cuboid, prism};
pub use round::{cylinder, revolve, sphere, torus};
