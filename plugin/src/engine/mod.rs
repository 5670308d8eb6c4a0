//! From a key to sound: strikes on bodies that ring until physics lets them stop.

mod body;
mod cell;
mod contact;
mod damper;
mod glide;
mod glides;
mod hertz;
mod instrument;
mod level;
mod losses;
mod mallet;
mod motor;
mod oscillators;
mod settings;
mod source;
mod touch;

pub use instrument::{Engine, OUTPUT_BOUND};
pub use losses::Losses;
pub use mallet::Mallet;
pub use motor::Discs;
pub use oscillators::Vectors;
pub use settings::{Settings, range};

/// Samples between two looks at the parameters, at what still sounds and at what has ended.
///
/// Counted from the last reset, so that no decision depends on how a host cuts its blocks.
pub const GRID: usize = 32;
