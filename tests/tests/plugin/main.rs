//! The built plug-in in a CLAP host.

#![expect(clippy::unwrap_used, reason = "tests fail by panicking")]

mod guard;
mod hands;
mod modulation;
mod outputs;
mod own;
mod parameters;
mod partials;
mod playing;
mod rough;
mod scan;
mod silence;
mod state;
mod storm;
mod tuning;
