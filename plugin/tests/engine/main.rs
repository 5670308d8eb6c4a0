//! The engine against closed forms, and against itself.

mod hands;
mod motor;
mod partials;
mod real_time;
mod ringing;
mod strikes;
mod support;
mod trims;
