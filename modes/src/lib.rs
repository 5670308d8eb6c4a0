//! From a shape and a material to a bank of vibration modes.
//!
//! A recipe names a shape, a material and the keys to tune; finite elements
//! turn each into natural frequencies and mode shapes; a [`Bank`] carries
//! them to whoever makes them sound.

mod bank;
mod damping;
mod label;
mod material;
mod strike_line;

pub use bank::{Bank, Body, Mode, Provenance};
pub use damping::{Motion, Rayleigh, t60_s};
pub use label::{Family, Member, ModeLabel};
pub use material::Material;
pub use strike_line::{Stencil, StrikeLine};
