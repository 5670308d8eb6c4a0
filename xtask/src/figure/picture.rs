//! Drawing a body's modes with their axes and legend.

use super::axis::Axis;
use super::dots::{Dot, STRIKE_POSITION, dots};
use super::family::{self, FAMILIES};
use super::names::Taken;
use crate::canvas::{self, Area, Drawing, FAINT, INK, NAME, SMALL, TITLE, extent, line, write};
use crate::note;
use anyhow::{Context, Result};
use modes::{Bank, Body};
use plotters::element::Circle;
use plotters::style::text_anchor::{HPos, VPos};
use plotters::style::{Color, RGBColor};
use std::path::Path;

/// The figure's edges, in pixels.
const LEFT: i32 = 84;
const RIGHT: i32 = 1030;
const TOP: i32 = 64;
const BOTTOM: i32 = 608;
/// The legend's dots, in pixels from the left.
const LEGEND: i32 = 1066;
/// Between two lines of the legend, in pixels.
const LEADING: i32 = 27;

/// Lines at the axes' ticks.
const GRID: RGBColor = RGBColor(36, 38, 48);

/// How far down from the loudest mode dots grow, in dB.
const DEPTH_DB: f64 = 60.0;
/// Levels that the legend shows, in dB.
const LEVELS_DB: [i32; 4] = [0, -20, -40, -60];
/// Radius of the loudest mode and of one at the depth, in pixels.
const RADII: [f64; 2] = [17.0, 3.0];
/// How many modes are named.
const NAMED: usize = 7;

/// Draws the modes of one of a bank's bodies as a PNG.
///
/// # Errors
///
/// If the body has no modes or the file cannot be written.
pub(crate) fn draw(bank: &Bank, body: &Body, path: &Path) -> Result<()> {
    let dots = dots(body, &bank.damping, STRIKE_POSITION);
    let figure = Figure::of(&dots).with_context(|| {
        let (name, key) = (&bank.name, body.key);
        format!("{name}: the body of key {key} has no modes")
    })?;
    let title = format!(
        "{}, {} (key {}): {:.2} Hz",
        bank.title,
        note::name(body.key),
        body.key,
        body.pitch_hz
    );
    canvas::save(path, |area| {
        let at = (LEFT, 30);
        write(area, &title, TITLE, &INK, at, (HPos::Left, VPos::Center))?;
        figure.axes(area)?;
        figure.dots(area)?;
        figure.names(area)?;
        figure.legend(area)
    })
}

/// Dots and the axes that hold them.
struct Figure<'a> {
    /// From the loudest to the softest.
    dots: Vec<&'a Dot>,
    hz: Axis,
    t60_s: Axis,
}

impl<'a> Figure<'a> {
    fn of(dots: &'a [Dot]) -> Option<Self> {
        let hz = Axis::around(dots.iter().map(|dot| dot.hz), 0.05, [LEFT, RIGHT])?;
        let t60_s = Axis::around(dots.iter().map(|dot| dot.t60_s), 0.07, [BOTTOM, TOP])?;
        let mut dots: Vec<_> = dots.iter().collect();
        dots.sort_by(|a, b| b.level_db.total_cmp(&a.level_db));
        Some(Self { dots, hz, t60_s })
    }

    fn place(&self, dot: &Dot) -> [i32; 2] {
        [self.hz.at(dot.hz), self.t60_s.at(dot.t60_s)]
    }

    fn axes(&self, area: &Area<'_>) -> Drawing<()> {
        for hz in self.hz.ticks() {
            let x = self.hz.at(hz);
            line(area, (x, TOP), (x, BOTTOM), &GRID)?;
            let at = (x, BOTTOM + 10);
            write(area, &hertz(hz), SMALL, &INK, at, (HPos::Center, VPos::Top))?;
        }
        for t60_s in self.t60_s.ticks() {
            let y = self.t60_s.at(t60_s);
            line(area, (LEFT, y), (RIGHT, y), &GRID)?;
            let (text, at) = (seconds(t60_s), (LEFT - 10, y));
            write(area, &text, SMALL, &INK, at, (HPos::Right, VPos::Center))?;
        }
        let at = ((LEFT + RIGHT) / 2, BOTTOM + 36);
        let anchor = (HPos::Center, VPos::Top);
        write(area, "frequency in Hz", NAME, &FAINT, at, anchor)?;
        let at = (LEFT - 10, TOP - 16);
        write(
            area,
            "T60 in s",
            NAME,
            &FAINT,
            at,
            (HPos::Center, VPos::Center),
        )
    }

    fn dots(&self, area: &Area<'_>) -> Drawing<()> {
        for dot in &self.dots {
            let (colour, _) = family::look(dot.label.family);
            paint(area, self.place(dot), dot.level_db, colour)?;
        }
        Ok(())
    }

    /// Names the lowest modes that are heard, each pair once.
    fn names(&self, area: &Area<'_>) -> Drawing<()> {
        let mut taken = Taken::none([LEFT + 4, TOP, RIGHT - 4, BOTTOM]);
        for dot in &self.dots {
            taken.dot(self.place(dot), radius(dot.level_db));
        }
        let mut heard: Vec<_> = self
            .dots
            .iter()
            .filter(|dot| is_heard(dot.level_db))
            .collect();
        heard.sort_by(|a, b| a.hz.total_cmp(&b.hz));
        heard.dedup_by_key(|dot| family::name(dot.label));
        for dot in heard.into_iter().take(NAMED) {
            let name = family::name(dot.label);
            let size = extent(area, &name, SMALL)?;
            let place = taken.name(self.place(dot), radius(dot.level_db), size);
            if let Some([x, y]) = place {
                write(area, &name, SMALL, &INK, (x, y), (HPos::Left, VPos::Top))?;
            }
        }
        Ok(())
    }

    fn legend(&self, area: &Area<'_>) -> Drawing<()> {
        let mut y = TOP + 14;
        let mut entry = |level_db: f64, colour, text: &str| {
            paint(area, [LEGEND, y], level_db, colour)?;
            let at = (LEGEND + 26, y);
            write(area, text, SMALL, &INK, at, (HPos::Left, VPos::Center))?;
            y += LEADING;
            Drawing::Ok(y)
        };
        for kind in FAMILIES {
            if self.dots.iter().any(|dot| dot.label.family == kind) {
                let (colour, name) = family::look(kind);
                entry(-20.0, colour, name)?;
            }
        }
        y += LEADING;
        let mut entry = |level_db: f64, text: &str| {
            paint(area, [LEGEND, y], level_db, FAINT)?;
            let at = (LEGEND + 26, y);
            write(area, text, SMALL, &INK, at, (HPos::Left, VPos::Center))?;
            y += LEADING + 4;
            Drawing::Ok(())
        };
        for level_db in LEVELS_DB {
            let text = format!("{level_db} dB").replace('-', "−");
            entry(f64::from(level_db), &text)?;
        }
        if self.dots.iter().any(|dot| !is_heard(dot.level_db)) {
            entry(f64::NEG_INFINITY, "below")?;
        }
        Ok(())
    }
}

fn is_heard(level_db: f64) -> bool {
    level_db >= -DEPTH_DB
}

/// Radius of a dot, in pixels.
fn radius(level_db: f64) -> i32 {
    let share = (1.0 + level_db / DEPTH_DB).clamp(0.0, 1.0);
    (RADII[1] + share * (RADII[0] - RADII[1])).round() as i32
}

/// A disc that lets others be seen through it; a ring for a mode that is hardly heard.
fn paint(area: &Area<'_>, [x, y]: [i32; 2], level_db: f64, colour: RGBColor) -> Drawing<()> {
    let radius = radius(level_db);
    if is_heard(level_db) {
        area.draw(&Circle::new((x, y), radius, colour.mix(0.45).filled()))?;
        area.draw(&Circle::new((x, y), radius, colour))?;
    } else {
        area.draw(&Circle::new((x, y), radius, colour.mix(0.6)))?;
    }
    Ok(())
}

/// A frequency at its axis.
fn hertz(hz: f64) -> String {
    if hz < 999.5 {
        format!("{hz:.0}")
    } else {
        format!("{:.0} k", hz / 1e3)
    }
}

/// A time at its axis, without zeros that say nothing.
fn seconds(s: f64) -> String {
    let digits = (-s.log10().floor()).max(0.0) as usize;
    format!("{s:.digits$}")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn louder_dots_are_larger_down_to_the_depth() {
        assert_eq!(radius(0.0), 17);
        assert_eq!(radius(-30.0), 10);
        assert_eq!(radius(-60.0), 3);
        assert_eq!(radius(f64::NEG_INFINITY), 3);
    }

    #[test]
    fn ticks_are_written_short() {
        assert_eq!([50.0, 1e3, 2e4].map(hertz), ["50", "1 k", "20 k"]);
        assert_eq!(
            [0.005, 0.2, 1.0, 50.0].map(seconds),
            ["0.005", "0.2", "1", "50"]
        );
    }
}
