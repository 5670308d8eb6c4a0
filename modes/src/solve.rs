//! The symmetric generalised eigenproblem Kφ = λMφ over a band of frequencies.

mod band;
mod dense;
mod dissection;
mod error;
mod factor;
mod graph;
mod lanczos;
mod order;
mod orthonormal;
mod panel;
mod sparse;
mod substitution;

pub use band::{Band, Eigenmode, Solution, Solver, lowest, lowest_of, modes_in_band};
pub use error::SolveError;
pub use factor::count_below;
