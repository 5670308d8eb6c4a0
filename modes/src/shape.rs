//! The shapes that bodies are made in.

mod bar;
mod bowl;
mod tube;

pub use bar::{Bar, Undercut};
pub use bowl::{Bowl, ProfileError};
pub use tube::Tube;
