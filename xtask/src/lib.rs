//! Commands over the solver and the plug-in, and the CLAP host that they and the tests share.

pub mod commands;
pub mod figure;
pub mod host;
pub mod midi;
pub mod settings;
pub mod spectrogram;

mod banks;
mod canvas;
mod faust;
mod loudness;
mod matrix_market;
mod mesh_bank;
mod note;
mod output;
mod progress;
mod table;
mod whole;
mod workspace;

pub use workspace::target_dir;
