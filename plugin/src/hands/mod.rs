//! What the player's hands do: notes, wheels, pedals, fingers and MPE, and what each of them moves.
//!
//! Events go into [`Hands`]; out come, for each key, how what rings there is moved ([`KeyHands`]), how
//! it is struck ([`TouchHands`]), and what is done to the whole ([`WholeHands`]). Between the two stands
//! the table of [`Assignment`]s. No host and no engine is known here.

mod address;
mod assignment;
mod bend;
mod controllers;
mod curve;
mod matrix;
mod outputs;
mod reading;
mod rpn;
mod settings;
mod slot;
mod source;
mod state;
mod strip;
mod tame;
mod target;
mod zones;

pub use address::{Address, Note};
pub use assignment::{Assignment, SLOTS};
pub use bend::bend_of_share;
pub use curve::Curve;
pub use outputs::{KeyHands, TouchHands, WholeHands};
pub use settings::{BEND_RANGE_MOST, Settings};
pub use slot::{Expression, Modulated};
pub use source::Source;
pub use state::Hands;
pub use target::Target;
pub use zones::Mpe;
