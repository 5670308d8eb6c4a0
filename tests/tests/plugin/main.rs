//! The built plug-in in a CLAP host.

mod parameters;
mod playing;
mod scan;
mod silence;
mod state;
mod storm;
