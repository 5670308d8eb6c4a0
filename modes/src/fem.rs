//! Element stiffness and mass, and their assembly into Kφ = λMφ.

mod assembly;
mod cyclic;
mod hex20;
mod isotropic;
mod pencil;
mod tet10;
mod tet4;

pub use assembly::assemble;
pub use cyclic::CyclicTube;
pub use hex20::HEX20_NODES;
pub use pencil::{Pattern, Pencil};
pub use tet4::TetMass;
pub use tet10::TET10_EDGES;
