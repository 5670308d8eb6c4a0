//! Which pitch each key has: Scala's scales and keyboard maps, and what follows from them.
//!
//! The files are those that the Scala program reads and writes, after their descriptions by Manuel
//! Op de Coul: <https://www.huygens-fokker.org/scala/scl_format.html> for scales and
//! <https://www.huygens-fokker.org/scala/help.htm#mappings> for keyboard maps.

mod error;
mod keyboard;
mod lines;
mod load;
mod nearest;
mod pitch;
mod scale;
mod table;

pub use error::{ScalaError, TuningFileError};
pub use keyboard::KeyboardMap;
pub use nearest::nearest_body;
pub use scale::Scale;
pub use table::Tuning;

#[cfg(test)]
mod tests;
