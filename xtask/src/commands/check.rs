//! `check`: the physics beside theory and published tables.

use crate::figure;
use crate::progress;
use crate::table::Table;
use crate::whole::whole;
use anyhow::{Context, Result, bail};
use clap::Args;
use modes::analytic::square_1998;
use modes::check::{GROUPS, Row};
use serde::Serialize;
use std::path::{Path, PathBuf};

/// Arguments of `check`.
#[derive(Args, Debug)]
pub struct Check {
    /// Write JSON
    #[arg(long, conflicts_with = "markdown")]
    pub json: bool,
    /// Write a table in Markdown, as without any option
    #[arg(long)]
    pub markdown: bool,
    /// Draw Figs. 5 to 7 of van den Doel & Pai 1998 from our amplitudes into this folder
    #[arg(long, value_name = "FOLDER")]
    pub figures: Option<PathBuf>,
}

#[derive(Serialize)]
struct Rows<'a> {
    rows: &'a [Row],
}

impl Check {
    pub(super) fn run(&self) -> Result<()> {
        if let Some(folder) = &self.figures {
            draw_figures(folder)?;
        }
        let rows = progress::with_bar("checks", |bar| -> Result<Vec<Row>> {
            let mut rows = Vec::new();
            for (done, (name, group)) in GROUPS.iter().enumerate() {
                rows.extend(group().with_context(|| (*name).to_owned())?);
                let _ = bar.advance(done + 1, GROUPS.len());
            }
            Ok(rows)
        })?;
        if self.json {
            println!("{}", serde_json::to_string_pretty(&Rows { rows: &rows })?);
        } else {
            print!("{}", markdown(&rows));
        }
        let wrong: Vec<_> = rows.iter().filter(|row| !row.ok).collect();
        if let Some(first) = wrong.first() {
            bail!(
                "{} of {} comparisons are out of bounds, first: {}",
                wrong.len(),
                rows.len(),
                first.name
            );
        }
        Ok(())
    }
}

/// The square membrane after its three strikes, a PNG for each.
fn draw_figures(folder: &Path) -> Result<()> {
    std::fs::create_dir_all(folder)
        .with_context(|| format!("{}: cannot make the folder", folder.display()))?;
    for (number, at) in (5..).zip(square_1998::STRIKES_M) {
        let [x, y] = at;
        let title = format!("1998, Fig. {number}: square membrane struck at ({x}, {y})");
        let path = folder.join(format!("square-membrane-figure-{number}.png"));
        figure::draw_stems(&title, &square_1998::struck(at), &path)?;
        eprintln!("{}", path.display());
    }
    Ok(())
}

fn markdown(rows: &[Row]) -> String {
    let mut table = Table::new([
        "what",
        "reference",
        "computed",
        "unit",
        "error",
        "bound",
        "ok",
        "source",
    ]);
    for row in rows {
        table.push([
            row.name.clone(),
            number(row.reference),
            number(row.value),
            row.unit.to_owned(),
            number(row.error),
            number(row.bound),
            if row.ok { "yes" } else { "**no**" }.to_owned(),
            row.source.to_owned(),
        ]);
    }
    table.text(true)
        + "\nErrors of frequencies and lengths are fractions of the reference, others are in the row's unit.\n"
}

/// Six significant digits, without an exponent where that is as short.
fn number(value: f64) -> String {
    if !value.is_finite() {
        return "–".to_owned();
    }
    let magnitude = value.abs();
    if magnitude != 0.0 && !(1e-3..1e7).contains(&magnitude) {
        return format!("{value:.2e}");
    }
    let whole_digits = whole(magnitude.max(1.0).log10()) + 1;
    let text = format!("{value:.*}", 6usize.saturating_sub(whole_digits));
    if text.contains('.') {
        return text.trim_end_matches('0').trim_end_matches('.').to_owned();
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_short() {
        for (value, text) in [
            (587.330_1, "587.33"),
            (0.0, "0"),
            (-0.25, "-0.25"),
            (1e-9, "1.00e-9"),
            (18796.0, "18796"),
            (f64::NAN, "–"),
        ] {
            assert_eq!(number(value), text);
        }
    }

    #[test]
    fn the_figures_of_1998_are_drawn() {
        let dir = tempfile::tempdir().unwrap();
        let folder = dir.path().join("figures");
        draw_figures(&folder).unwrap();
        for number in 5..=7 {
            let png =
                std::fs::read(folder.join(format!("square-membrane-figure-{number}.png"))).unwrap();
            assert!(png.starts_with(b"\x89PNG"));
        }
    }

    #[test]
    fn json_has_the_shape_that_scripts_read() {
        let row = Row {
            name: "a".to_owned(),
            reference: 1.0,
            value: 2.0,
            unit: "Hz",
            error: 1.0,
            bound: 0.1,
            ok: false,
            source: "b",
        };
        let json = serde_json::to_value(Rows { rows: &[row] }).unwrap();
        let expected = serde_json::json!({"rows": [{
            "name": "a", "reference": 1.0, "value": 2.0, "unit": "Hz",
            "error": 1.0, "bound": 0.1, "ok": false, "source": "b",
        }]});
        assert_eq!(json, expected);
    }
}
