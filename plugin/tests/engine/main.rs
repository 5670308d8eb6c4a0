//! The engine against closed forms, and against itself.

mod across;
mod hands;
mod kits;
mod motor;
mod outputs;
mod partials;
mod real_time;
mod ringing;
mod strikes;
mod support;
mod trims;
