//! How much timbre changes over a surface (van den Doel & Pai 1998, §5).

mod hearing;
mod map;

pub use hearing::{Hearing, Timbre, a_weighting};
pub use map::SoundMap;
