//! A picture of a sound: time across, frequency up, level in colour.

mod colour;
mod picture;
mod recording;
mod stft;

pub use picture::draw;
pub use recording::Recording;
