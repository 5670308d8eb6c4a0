//! From a shape and a material to a bank of vibration modes.
//!
//! A recipe names a shape, a material and the keys to tune; finite elements
//! turn each into natural frequencies and mode shapes; a [`Bank`] carries
//! them to whoever makes them sound.

mod bank;
mod damping;
#[cfg(feature = "solve")]
pub mod fem;
mod label;
mod material;
#[cfg(feature = "solve")]
pub mod mesh;
#[cfg(feature = "solve")]
pub mod shape;
#[cfg(feature = "solve")]
pub mod solve;
mod strike_line;

pub use bank::{Bank, Body, Mode, Provenance};
pub use damping::{Motion, Rayleigh, t60_s};
pub use label::{Family, Member, ModeLabel};
pub use material::Material;
#[cfg(feature = "solve")]
pub use solve::SolveError;
pub use strike_line::{Stencil, StrikeLine};
