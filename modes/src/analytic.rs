//! Closed forms that the finite elements are held against.

mod timoshenko;

pub use timoshenko::{TimoshenkoBeam, hutchinson_shear_coefficient, rectangle_shear_coefficient};
