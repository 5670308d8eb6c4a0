//! The engine against closed forms, and against itself.

mod partials;
mod real_time;
mod strikes;
mod support;
