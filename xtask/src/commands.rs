//! The commands, one to a file.

mod bank;
mod bundle;
mod check;
mod demo;
mod export;
mod figure;
mod install;
mod params;
mod pencil;
mod precompute;
mod presets;
mod render;
mod spectrogram;
mod tuning;

pub use bank::Bank;
pub use bundle::Bundle;
pub use check::Check;
pub use demo::Demo;
pub use export::Export;
pub use figure::Figure;
pub use install::Install;
pub use params::Params;
pub use pencil::Pencil;
pub use precompute::Precompute;
pub use presets::Presets;
pub use render::Render;
pub use spectrogram::Spectrogram;
pub use tuning::Tuning;

use anyhow::Result;
use clap::Subcommand;

/// What `cargo xtask` can be asked to do.
#[derive(Debug, Subcommand)]
pub enum Command {
    /// Do all of it: compute, bundle, play a short piece on each instrument, draw pictures
    Demo(Demo),
    /// Compute the banks that are missing or out of date
    Precompute(Precompute),
    /// Build the plug-in as CLAP and VST3
    Bundle(Bundle),
    /// Bundle, and copy into the plug-in folders of this user
    Install(Install),
    /// Play a MIDI file through the plug-in into a WAV file (32-bit float, stereo)
    Render(Render),
    /// List the plug-in's parameters
    Params(Params),
    /// List the factory's presets, or hold their loudness against each other's
    Presets(Presets),
    /// Show what is in a bank
    Bank(Bank),
    /// Write a body's stiffness and mass matrices as Matrix Market files
    Export(Export),
    /// Write or solve a chime's matrices on a mesh of a kind, to hold the solver beside others
    Pencil(Pencil),
    /// Compare the physics with theory and with published tables
    Check(Check),
    /// Draw a WAV file's spectrogram
    Spectrogram(Spectrogram),
    /// Draw the modes of one of an instrument's bodies
    Figure(Figure),
    /// List the keys' pitches in a Scala scale, on a keyboard map
    Tuning(Tuning),
}

impl Command {
    /// Does it.
    ///
    /// # Errors
    ///
    /// One line that says what is wrong, where, and what is allowed.
    pub fn run(&self) -> Result<()> {
        match self {
            Self::Demo(command) => command.run(),
            Self::Precompute(command) => command.run(),
            Self::Bundle(command) => command.run(),
            Self::Install(command) => command.run(),
            Self::Render(command) => command.run(),
            Self::Params(command) => command.run(),
            Self::Presets(command) => command.run(),
            Self::Bank(command) => command.run(),
            Self::Export(command) => command.run(),
            Self::Pencil(command) => command.run(),
            Self::Check(command) => command.run(),
            Self::Spectrogram(command) => command.run(),
            Self::Figure(command) => command.run(),
            Self::Tuning(command) => command.run(),
        }
    }
}
