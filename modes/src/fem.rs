//! Element stiffness and mass, and their assembly into Kφ = λMφ.

mod assembly;
mod cyclic;
mod fourier;
mod hex20;
mod isotropic;
mod meridian;
mod pencil;
mod tet4;

pub use assembly::assemble;
pub use cyclic::CyclicTube;
pub use fourier::Harmonic;
pub use hex20::HEX20_NODES;
pub use meridian::Meridian;
pub use pencil::{Pattern, Pencil};
pub use tet4::TetMass;
