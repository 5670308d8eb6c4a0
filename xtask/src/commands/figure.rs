//! `figure`: the modes of one body as a picture.

use crate::{banks, figure};
use anyhow::{Context, Result};
use clap::Args;
use std::path::PathBuf;

/// Arguments of `figure`.
#[derive(Args, Debug)]
pub struct Figure {
    /// Name of the instrument, or a recipe's file (.toml)
    #[arg(value_name = "INSTRUMENT")]
    pub instrument: String,
    /// PNG file to write
    #[arg(value_name = "OUT.png")]
    pub output: PathBuf,
    /// MIDI key of the body; without it, the middle one
    #[arg(long, value_name = "K")]
    pub key: Option<u8>,
}

impl Figure {
    pub(super) fn run(&self) -> Result<()> {
        let bank = banks::precompute(&self.instrument, false)?.bank;
        let body = match self.key {
            Some(key) => banks::body(&bank, key)?,
            None => bank
                .bodies
                .get(bank.bodies.len() / 2)
                .with_context(|| format!("{}: has no bodies", bank.name))?,
        };
        figure::draw(&bank, body, &self.output)?;
        println!("{}", self.output.display());
        Ok(())
    }
}
