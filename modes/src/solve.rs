//! The symmetric generalised eigenproblem Kφ = λMφ over a band of frequencies.

mod angle;
mod band;
mod dense;
mod dissection;
mod error;
mod factor;
mod graph;
mod lanczos;
mod lowest;
mod order;
mod orthonormal;
mod panel;
mod shift;
mod sparse;
mod substitution;
mod verify;
mod watch;

pub(crate) use angle::{SmallestAngle, smallest_angle};
pub use band::{Band, Eigenmode, Solution, Solver, modes_in_band, modes_in_band_with};
pub use error::SolveError;
pub use factor::count_below;
pub use lowest::{lowest, lowest_of};
pub use watch::Watch;
