//! `tuning`: what a scale and a keyboard map make of the keys.

use crate::note;
use crate::table::Table;
use anyhow::Result;
use clap::Args;
use modes::tuning;
use std::path::PathBuf;

/// Arguments of `tuning`.
#[derive(Args, Debug)]
pub struct Tuning {
    /// Scala scale
    #[arg(value_name = "SCALE.scl")]
    pub scale: PathBuf,
    /// Scala keyboard map; without it, 1/1 is on key 60 (C4), one degree to a key, key 69 at 440 Hz
    #[arg(long, value_name = "MAP.kbm")]
    pub keyboard: Option<PathBuf>,
}

impl Tuning {
    pub(super) fn run(&self) -> Result<()> {
        let tuning = tuning::Tuning::load(Some(&self.scale), self.keyboard.as_deref())?;
        print!("{}", table(&tuning).text(false));
        Ok(())
    }
}

/// Every key, its pitch, and its distance from equal temperament with A4 at 440 Hz; dashes where it
/// is silent.
fn table(tuning: &tuning::Tuning) -> Table<4> {
    let mut table = Table::new(["key", "note", "Hz", "cents"]);
    for key in 0..128 {
        let silent = || "-".to_owned();
        let hz = tuning.hz(key).map(|hz| format!("{hz:.4}"));
        let semitones = tuning.offset_semitones(key);
        // Adding 0 rids rounded numbers of the sign of nothing.
        let cents = semitones.map(|by| format!("{:+.3}", (1e5 * by).round() / 1e3 + 0.0));
        table.push([
            key.to_string(),
            note::name(key),
            hz.unwrap_or_else(silent),
            cents.unwrap_or_else(silent),
        ]);
    }
    table
}

#[cfg(test)]
mod tests {
    use super::table;
    use modes::tuning::{KeyboardMap, Scale, Tuning};

    #[test]
    fn keys_are_listed_with_their_pitch() {
        let scale = Scale::parse(b"\n2\n3/2\n2/1").unwrap();
        let map = KeyboardMap::parse(b"3\n0\n69\n67\n69\n660\n2\n0\nx\n1\n").unwrap();
        let text = table(&Tuning::new(&scale, &map)).text(false);
        let row = |key: usize| -> Vec<&str> {
            let line = text.lines().nth(2 + key).unwrap();
            line.split_whitespace().collect()
        };
        assert_eq!(text.lines().count(), 2 + 128);
        assert_eq!(row(67), ["67", "G4", "440.0000", "+200.000"]);
        assert_eq!(row(68), ["68", "A♭4", "-", "-"]);
        assert_eq!(row(69), ["69", "A4", "660.0000", "+701.955"]);
        assert_eq!(row(70), ["70", "B♭4", "-", "-"]);
        let plain = table(&Tuning::default()).text(false);
        assert!(plain.lines().skip(2).all(|line| line.ends_with(" +0.000")));
    }
}
