//! The shapes that bodies are made in.

mod bar;
mod bowl;
mod closed;
mod profile;
mod tube;

pub use bar::{Bar, Undercut};
pub use bowl::Bowl;
pub use closed::{BarEnds, ClosedShape};
pub use profile::ProfileError;
pub use tube::Tube;
