//! Matrix Market files of a pencil.

use crate::output;
use anyhow::{Context, Result};
use modes::fem::{Pattern, Pencil};
use std::fmt::Write;
use std::fs;
use std::path::Path;

/// Writes `PREFIXK.mtx` and `PREFIXM.mtx` to `dir`; `of` says in them whose matrices they are.
///
/// # Errors
///
/// If a file cannot be written.
pub(crate) fn write(pencil: &Pencil, dir: &Path, prefix: &str, of: &str) -> Result<()> {
    fs::create_dir_all(dir).with_context(|| format!("{}: cannot write", dir.display()))?;
    for (letter, what, values) in [
        ("K", "stiffness, N/m", &pencil.stiffness),
        ("M", "mass, kg", &pencil.mass),
    ] {
        let path = dir.join(format!("{prefix}{letter}.mtx"));
        let text = matrix_market(&format!("{of}: {what}"), &pencil.pattern, values);
        output::write_whole(&path, text.as_bytes())?;
        println!("{}: {} unknowns", path.display(), pencil.unknowns());
    }
    Ok(())
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
