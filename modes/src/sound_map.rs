//! How much timbre changes over a surface (van den Doel & Pai 1998, §5).

mod body;
#[cfg(test)]
mod body_tests;
mod hearing;
mod map;

pub use body::BodyMap;
pub use hearing::{Hearing, Timbre, a_weighting};
pub use map::SoundMap;
