//! `presets`: what there is, and how loud.

use crate::loudness::integrated_lufs;
use crate::table::Table;
use anyhow::{Context, Result, bail};
use clap::Args;
use idiophone::presets::{Note, Preset, audition, factory};
use std::fs;
use std::num::NonZeroUsize;
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::thread;

/// How far from the median a preset may lie, in LU.
const APART_LU: f64 = 3.0;
const RATE_HZ: f64 = 48e3;
/// Length of the phrase, in s.
const PHRASE_S: f64 = 5.0;
/// MIDI velocity 100.
const VELOCITY: f32 = 100.0 / 127.0;
/// Three keys one after another and then together: what is struck, from when and until when, in s.
const PHRASE: [(u8, f64, f64); 6] = [
    (60, 0.0, 0.9),
    (64, 1.0, 1.9),
    (67, 2.0, 2.9),
    (60, 3.0, 4.9),
    (64, 3.0, 4.9),
    (67, 3.0, 4.9),
];

/// Arguments of `presets`.
#[derive(Args, Debug)]
pub struct Presets {
    /// Presets of your own, to be held beside the factory's; without any, the factory's
    #[arg(value_name = "PRESET.toml")]
    pub files: Vec<PathBuf>,
    /// Play a phrase with each at velocity 100; say how loud it is (ITU-R BS.1770-4) and its peak, and
    /// fail if one clips or lies more than 3 LU from the median
    #[arg(long)]
    pub check: bool,
    /// Write the table in Markdown
    #[arg(long)]
    pub markdown: bool,
}

/// How loud a preset is.
#[derive(Clone, Copy, Default)]
struct Level {
    lufs: f64,
    peak_dbfs: f64,
}

impl Presets {
    pub(super) fn run(&self) -> Result<()> {
        let mine = self.files.iter().map(|path| read(path));
        let mine = mine.collect::<Result<Vec<_>>>()?;
        if self.check {
            return check(&mine, self.markdown);
        }
        let presets = if mine.is_empty() { factory() } else { &mine };
        let mut table = Table::new(["preset", "instrument", "category", "tags", "why"]);
        for preset in presets {
            table.push([
                preset.card.name.clone(),
                preset.instrument().to_owned(),
                preset.card.category.clone(),
                preset.card.tags_text(),
                preset.card.about.clone(),
            ]);
        }
        print!("{}", table.text(self.markdown));
        Ok(())
    }
}

fn read(path: &Path) -> Result<Arc<Preset>> {
    let file = path.display().to_string();
    let text = fs::read_to_string(path).with_context(|| file.clone())?;
    let preset = Preset::read(&text, &file)?;
    for notice in &preset.notices {
        eprintln!("{file}, line {}: {}", notice.line, notice.what);
    }
    Ok(Arc::new(preset))
}

/// Holds presets, or else the factory's, beside the median of the factory's.
fn check(mine: &[Arc<Preset>], markdown: bool) -> Result<()> {
    let all = levels(factory());
    let median = median(all.iter().map(|level| level.lufs));
    let (presets, levels) = if mine.is_empty() {
        (factory(), all)
    } else {
        (mine, levels(mine))
    };
    let mut table = Table::new(["preset", "instrument", "LUFS", "LU", "peak, dBFS"]);
    let mut wrong = Vec::new();
    for (preset, level) in presets.iter().zip(&levels) {
        let Level { lufs, peak_dbfs } = *level;
        let apart = lufs - median;
        if let Some(fault) = fault(apart, peak_dbfs) {
            wrong.push(format!("{}: {fault}", preset.card.name));
        }
        table.push([
            preset.card.name.clone(),
            preset.instrument().to_owned(),
            format!("{lufs:.1}"),
            format!("{apart:+.1}"),
            format!("{peak_dbfs:.1}"),
        ]);
    }
    print!("{}", table.text(markdown));
    println!("\n{} presets, median {median:.1} LUFS", levels.len());
    if !wrong.is_empty() {
        bail!("{}; turn the gain in its file", wrong.join("; "));
    }
    Ok(())
}

/// What is wrong with a level, if anything is.
fn fault(apart_lu: f64, peak_dbfs: f64) -> Option<String> {
    if peak_dbfs >= 0.0 {
        return Some(format!("peaks at {peak_dbfs:+.1} dBFS"));
    }
    // Written so that no number is a fault too.
    let near = apart_lu.abs() <= APART_LU;
    (!near).then(|| format!("{apart_lu:+.1} LU from the median, allowed is {APART_LU:.0} LU"))
}

fn levels(presets: &[Arc<Preset>]) -> Vec<Level> {
    let workers = thread::available_parallelism().map_or(1, NonZeroUsize::get);
    let next = AtomicUsize::new(0);
    let work = || {
        let take = || {
            let index = next.fetch_add(1, Ordering::Relaxed);
            Some((index, level(presets.get(index)?)))
        };
        std::iter::from_fn(take).collect::<Vec<_>>()
    };
    let mut levels = vec![Level::default(); presets.len()];
    thread::scope(|scope| {
        let all: Vec<_> = (0..workers).map(|_| scope.spawn(work)).collect();
        for worker in all {
            for (index, level) in worker.join().unwrap_or_default() {
                levels[index] = level;
            }
        }
    });
    levels
}

fn level(preset: &Preset) -> Level {
    let notes = PHRASE.map(|(key, from_s, until_s)| Note {
        key,
        velocity: VELOCITY,
        from_s,
        until_s,
    });
    let [left, right] = audition(preset, &notes, PHRASE_S, RATE_HZ);
    let both = left.iter().chain(&right);
    let peak = both.fold(0f32, |most, sample| most.max(sample.abs()));
    Level {
        lufs: integrated_lufs([&left, &right], RATE_HZ),
        peak_dbfs: 20.0 * f64::from(peak).log10(),
    }
}

fn median(values: impl Iterator<Item = f64>) -> f64 {
    let mut values: Vec<f64> = values.collect();
    values.sort_by(f64::total_cmp);
    let middle = values.len() / 2;
    match values.len() {
        0 => f64::NAN,
        odd if odd % 2 == 1 => values[middle],
        _ => 0.5 * (values[middle - 1] + values[middle]),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_factory_s_presets_are_of_one_loudness_and_none_clips() {
        check(&[], false).unwrap();
    }

    #[test]
    fn what_is_too_loud_too_soft_or_silent_is_found() {
        assert_eq!(fault(0.0, -1.0), None);
        assert!(fault(0.0, 0.1).is_some());
        assert!(fault(3.1, -1.0).is_some());
        assert!(fault(-3.1, -1.0).is_some());
        assert!(fault(f64::NEG_INFINITY, f64::NEG_INFINITY).is_some());
        assert!(fault(f64::NAN, -1.0).is_some());
    }

    #[test]
    fn medians_lie_in_the_middle() {
        assert_eq!(median([3.0, 1.0, 2.0].into_iter()), 2.0);
        assert_eq!(median([4.0, 1.0, 2.0, 3.0].into_iter()), 2.5);
    }

    #[test]
    fn a_louder_preset_measures_louder() {
        let at = |gain: &str| {
            let text = format!("name = \"A\"\n[sound]\ngain = \"{gain}\"\n");
            level(&Preset::read(&text, "a").unwrap())
        };
        let (soft, loud) = (at("0 dB"), at("10 dB"));
        assert!((loud.lufs - soft.lufs - 10.0).abs() < 0.05);
        assert!((loud.peak_dbfs - soft.peak_dbfs - 10.0).abs() < 0.05);
    }
}
