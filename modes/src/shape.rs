//! The shapes that bodies are made in.

mod bar;
mod bowl;
mod profile;
mod tube;

pub use bar::{Bar, Undercut};
pub use bowl::Bowl;
pub use profile::ProfileError;
pub use tube::Tube;
