//! `spectrogram`: a WAV file as a picture.

use crate::spectrogram::{self, Recording};
use anyhow::Result;
use clap::Args;
use std::path::PathBuf;

/// Arguments of `spectrogram`.
#[derive(Args, Debug)]
pub struct Spectrogram {
    /// WAV file to show
    #[arg(value_name = "IN.wav")]
    pub input: PathBuf,
    /// PNG file to write
    #[arg(value_name = "OUT.png")]
    pub output: PathBuf,
    /// Title; without it, the name of the WAV file
    #[arg(long, value_name = "TEXT")]
    pub title: Option<String>,
}

impl Spectrogram {
    pub(super) fn run(&self) -> Result<()> {
        let recording = Recording::read(&self.input)?;
        let name = || {
            let name = self.input.file_stem().unwrap_or_default();
            name.to_string_lossy().into_owned()
        };
        let title = self.title.clone().unwrap_or_else(name);
        spectrogram::draw(&recording, &title, &self.output)?;
        println!("{}", self.output.display());
        Ok(())
    }
}
