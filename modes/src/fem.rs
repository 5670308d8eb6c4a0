//! Element stiffness and mass, and their assembly into Kφ = λMφ.

mod assembly;
mod constrained;
mod cyclic;
mod fourier;
pub(crate) mod gauss;
mod hex20;
mod isotropic;
mod meridian;
mod pencil;
mod tet10;
mod tet4;
mod wedge23;

pub use assembly::assemble;
pub use constrained::Constrained;
pub use cyclic::CyclicTube;
pub use fourier::Harmonic;
pub use hex20::HEX20_NODES;
pub(crate) use hex20::hex20_weights;
pub(crate) use meridian::CELL_NODES;
pub use meridian::Meridian;
pub use pencil::{Pattern, Pencil};
pub use tet4::TetMass;
pub use tet10::TET10_EDGES;
pub(crate) use tet10::{tet10_jacobians, tet10_volume};
pub(crate) use wedge23::{
    CUBIC_NODES, CUBIC_SHARES, WEDGE_NODES, cubic_gradients, wedge23_least_jacobian, wedge23_volume,
};
