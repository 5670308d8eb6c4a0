//! `export`: a body's matrices for other solvers.

use crate::{banks, matrix_market};
use anyhow::Result;
use clap::Args;
use std::path::{Path, PathBuf};

/// Arguments of `export`.
#[derive(Args, Debug)]
pub struct Export {
    /// Name of the bank, or a recipe's file
    #[arg(value_name = "NAME")]
    pub name: String,
    /// MIDI key of the body
    #[arg(long, value_name = "N")]
    pub key: u8,
    /// Folder to write `NAME-N-K.mtx` and `NAME-N-M.mtx` to
    #[arg(value_name = "DIR")]
    pub dir: PathBuf,
}

impl Export {
    pub(super) fn run(&self) -> Result<()> {
        let pencil = banks::matrices(&self.name, self.key)?;
        let stem = Path::new(&self.name).file_stem().unwrap_or_default();
        let stem = stem.to_string_lossy();
        let prefix = format!("{stem}-{}-", self.key);
        matrix_market::write(
            &pencil,
            &self.dir,
            &prefix,
            &format!("{stem} key {}", self.key),
        )
    }
}
