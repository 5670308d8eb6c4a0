//! `export`: a body's matrices for other solvers.

use crate::banks::{self, Matrices};
use crate::output;
use anyhow::{Context, Result};
use clap::Args;
use std::fmt::Write;
use std::fs;
use std::path::PathBuf;

/// Arguments of `export`.
#[derive(Args, Debug)]
pub struct Export {
    /// Name of the bank
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
        let Matrices {
            rows,
            stiffness,
            mass,
        } = banks::matrices(&self.name, self.key)?;
        fs::create_dir_all(&self.dir)
            .with_context(|| format!("{}: cannot write", self.dir.display()))?;
        for (letter, what, entries) in [("K", "stiffness, N/m", stiffness), ("M", "mass, kg", mass)]
        {
            let path = self
                .dir
                .join(format!("{}-{}-{letter}.mtx", self.name, self.key));
            let comment = format!("{} key {}: {what}", self.name, self.key);
            output::write_whole(&path, matrix_market(&comment, rows, &entries).as_bytes())?;
            println!("{}: {rows} rows, {} entries", path.display(), entries.len());
        }
        Ok(())
    }
}

/// A symmetric matrix, given by its lower triangle, in NIST's exchange format.
///
/// Boisvert, Pozo and Remington, *The Matrix Market Exchange Formats*, NISTIR 5935, 1996.
fn matrix_market(comment: &str, rows: usize, lower: &[(usize, usize, f64)]) -> String {
    let mut text = format!(
        "%%MatrixMarket matrix coordinate real symmetric\n% {comment}\n{rows} {rows} {}\n",
        lower.len()
    );
    for &(row, column, value) in lower {
        // `{:e}` is the shortest text that reads back to the same bits.
        let _ = writeln!(text, "{} {} {value:e}", row + 1, column + 1);
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn entries_count_from_one_and_keep_their_bits() {
        let third = 1.0 / 3.0;
        let text = matrix_market("a", 2, &[(0, 0, 2.0), (1, 0, -third)]);
        let lines: Vec<_> = text.lines().collect();
        assert_eq!(lines[0], "%%MatrixMarket matrix coordinate real symmetric");
        assert_eq!(lines[2..4], ["2 2 2", "1 1 2e0"]);
        let value: f64 = lines[4].split(' ').nth(2).unwrap().parse().unwrap();
        assert_eq!(value.to_bits(), (-third).to_bits());
    }
}
