//! The shapes that bodies are made in.

mod tube;

pub use tube::Tube;
