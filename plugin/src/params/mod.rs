//! Everything a host can automate.

mod controls;
mod spec;
mod state;
mod text;

pub use controls::Controls;
pub use spec::{
    ALPHA1, ALPHA2, INSTRUMENT, LOSS_FACTOR, MALLET_HARDNESS, MOTOR_DEPTH, MOTOR_PHASE,
    MOTOR_SPEED, NOTE_OFF, OUTPUT_GAIN, OWN_DAMPING, POSITION_SCATTER, RADIATION, SPECS,
    STRIKE_POSITION, SUPPORTS, Spec, VELOCITY_RANGE, VELOCITY_TO_POSITION, WIDTH,
};
pub use state::heal;
