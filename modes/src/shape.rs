//! The shapes that bodies are made in.

mod bar;
mod tube;

pub use bar::{Bar, Undercut};
pub use tube::Tube;
