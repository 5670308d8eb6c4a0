//! `figure`: the modes of one body as a picture.

use crate::{banks, figure};
use anyhow::{Context, Result};
use clap::Args;
use modes::Body;
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
    /// MIDI key of the body; without it, 60 (C4), or the middle key if that is not there
    #[arg(long, value_name = "K")]
    pub key: Option<u8>,
}

impl Figure {
    pub(super) fn run(&self) -> Result<()> {
        let bank = banks::precompute(&self.instrument, false)?.bank;
        let body = match self.key {
            Some(key) => banks::body(&bank, key)?,
            None => common(&bank.bodies).with_context(|| format!("{}: has no body", bank.name))?,
        };
        figure::draw(&bank, body, &self.output)?;
        println!("{}", self.output.display());
        Ok(())
    }
}

/// The body of middle C, which most instruments have; else the middle one.
fn common(bodies: &[Body]) -> Option<&Body> {
    const MIDDLE_C: u8 = 60;
    let middle = || bodies.get(bodies.len() / 2);
    bodies
        .iter()
        .find(|body| body.key == MIDDLE_C)
        .or_else(middle)
}
