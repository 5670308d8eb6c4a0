//! `export`: a body's matrices for other solvers.

use crate::{banks, output};
use anyhow::{Context, Result};
use clap::Args;
use modes::fem::Pattern;
use std::fmt::Write;
use std::fs;
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
        fs::create_dir_all(&self.dir)
            .with_context(|| format!("{}: cannot write", self.dir.display()))?;
        let stem = Path::new(&self.name).file_stem().unwrap_or_default();
        let stem = stem.to_string_lossy();
        for (letter, what, values) in [
            ("K", "stiffness, N/m", &pencil.stiffness),
            ("M", "mass, kg", &pencil.mass),
        ] {
            let path = self.dir.join(format!("{stem}-{}-{letter}.mtx", self.key));
            let comment = format!("{stem} key {}: {what}", self.key);
            let text = matrix_market(&comment, &pencil.pattern, values);
            output::write_whole(&path, text.as_bytes())?;
            println!("{}: {} unknowns", path.display(), pencil.unknowns());
        }
        Ok(())
    }
}

/// A symmetric matrix, given by its lower triangle, in NIST's exchange format.
///
/// Boisvert, Pozo and Remington, *The Matrix Market Exchange Formats*, NISTIR 5935, 1996.
fn matrix_market(comment: &str, pattern: &Pattern, values: &[f64]) -> String {
    let n = pattern.unknowns();
    let entries = values.iter().filter(|value| **value != 0.0).count();
    let mut text = format!(
        "%%MatrixMarket matrix coordinate real symmetric\n% {comment}\n{n} {n} {entries}\n"
    );
    for column in 0..n {
        let range = pattern.column(column);
        for (row, value) in pattern.rows[range.clone()].iter().zip(&values[range]) {
            if *value != 0.0 {
                // `{:e}` is the shortest text that reads back to the same bits.
                let _ = writeln!(text, "{} {} {value:e}", row + 1, column + 1);
            }
        }
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn entries_count_from_one_and_keep_their_bits() {
        let third = 1.0 / 3.0;
        let pattern = Pattern {
            column_start: vec![0, 2, 3],
            rows: vec![0, 1, 1],
        };
        let text = matrix_market("a", &pattern, &[2.0, -third, 0.0]);
        let lines: Vec<_> = text.lines().collect();
        assert_eq!(lines[0], "%%MatrixMarket matrix coordinate real symmetric");
        assert_eq!(lines[2..4], ["2 2 2", "1 1 2e0"]);
        let value: f64 = lines[4].split(' ').nth(2).unwrap().parse().unwrap();
        assert_eq!(value.to_bits(), (-third).to_bits());
    }
}
