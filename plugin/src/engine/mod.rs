//! From a key to sound: strikes on bodies that ring until physics lets them stop.

mod body;
mod bow;
mod cell;
mod contact;
mod damper;
mod friction;
mod glide;
mod glides;
mod grain;
mod grips;
mod hertz;
mod hold;
mod instrument;
mod level;
mod limiter;
mod listener;
mod losses;
mod mallet;
mod motor;
mod oscillators;
mod outputs;
mod partial;
mod pulse;
pub mod range;
mod routes;
mod settings;
mod source;
mod split;
mod swing;
mod sympathy;
mod touch;
mod trims;
mod tweak;

pub use bow::Bow;
pub use hold::{Hit, Hold};
pub use instrument::{Engine, Held, OUTPUT_BOUND, Struck};
pub(crate) use limiter::Limiter;
pub use listener::Listener;
pub use losses::Losses;
pub use mallet::Mallet;
pub use motor::Discs;
pub use oscillators::Vectors;
pub(crate) use outputs::Room;
pub use outputs::{OUTPUTS, Outputs};
pub use partial::{Partial, contact_s};
pub use pulse::Pulse;
pub use settings::Settings;
pub use split::Split;
pub(crate) use touch::chance;
pub use trims::{MOST_TRIMS, Trim, Trims};
pub use tweak::Tweak;

/// Samples between two looks at the parameters, at what still sounds and at what has ended.
///
/// Counted from the last reset, so that no decision depends on how a host cuts its blocks.
pub const GRID: usize = 32;
