//! The shapes that bodies are made in.

mod bowl;
mod tube;

pub use bowl::{Bowl, ProfileError};
pub use tube::Tube;
