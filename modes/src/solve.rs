//! The symmetric generalised eigenproblem Kφ = λMφ over a band of frequencies.

mod band;
mod block;
mod dense;
mod error;
mod factor;
mod lanczos;

pub use band::{Band, Eigenmode, Solution, Solver, lowest, lowest_of, modes_in_band};
pub use error::SolveError;
pub use factor::count_below;
