//! Everything a host can automate.

mod controls;
mod spec;
mod state;
mod text;

pub use controls::Controls;
pub use spec::{
    ALPHA1, ALPHA2, MALLET_HARDNESS, NOTE_OFF, OUTPUT_GAIN, POSITION_SCATTER, SPECS,
    STRIKE_POSITION, Spec, VELOCITY_RANGE, VELOCITY_TO_POSITION, WIDTH,
};
pub use state::heal;
