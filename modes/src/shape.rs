//! The shapes that bodies are made in.

mod bowl;
mod tube;

pub use bowl::{Bowl, ProfileError};
mod bar;
mod tube;

pub use bar::{Bar, Undercut};
pub use tube::Tube;
