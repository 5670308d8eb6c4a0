//! Closed forms: what the finite elements are held against, and instruments of their own.

mod beam;
mod bessel;
mod circular_membrane;
mod circular_plate;
mod closed_mode;
mod impact;
mod l_membrane;
#[cfg(test)]
mod overlaps;
mod quadrature;
mod rectangular_membrane;
mod rigid_bar;
mod roots;
mod round;
mod string;
mod timoshenko;

pub use circular_membrane::{CircularMembrane, CircularMode, bessel_zeros};
pub use circular_plate::{ClampedPlate, PlateMode, clamped_plate_roots};
pub use closed_mode::{ClosedMode, ProductMode};
pub use impact::{Struck, impact, square_1998};
pub use l_membrane::{LMembrane, LMode, LSpectrum};
pub(crate) use quadrature::{gauss, gauss_kept};
pub use rectangular_membrane::{RectangularMembrane, RectangularMode};
pub use rigid_bar::{BarMode, RigidBar};
pub use string::{StringMode, TautString};
pub use timoshenko::{TimoshenkoBeam, hutchinson_shear_coefficient, rectangle_shear_coefficient};
