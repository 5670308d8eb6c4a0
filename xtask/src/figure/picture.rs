//! Drawing a body's modes with their axes and legend.

use super::axis::Axis;
use super::dots::{Dot, STRIKE_POSITION, WINDOW_S, dots};
use super::family::{self, FAMILIES};
use super::names::Taken;
use crate::canvas::{self, Canvas, Drawing, FAINT, INK, NAME, SMALL, TITLE};
use crate::note;
use crate::whole::whole;
use anyhow::{Context, Result};
use modes::{Bank, Body};
use plotters::style::RGBColor;
use plotters::style::text_anchor::{HPos, VPos};
use std::collections::HashSet;
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
const DEPTH_DB: f64 = 80.0;
/// Levels that the legend shows, in dB.
const LEVELS_DB: [i32; 5] = [0, -20, -40, -60, -80];
/// Radius of the loudest mode and of one at the depth or below, in pixels.
const RADII: [f64; 2] = [15.0, 3.0];
/// How many modes are named.
const NAMED: usize = 7;

/// Draws the modes of one of a bank's bodies as a PNG.
///
/// # Errors
///
/// If the body has no modes or the file cannot be written.
pub(crate) fn draw(bank: &Bank, body: &Body, path: &Path) -> Result<()> {
    let dots = dots(body, &bank.matter_of(body).damping, STRIKE_POSITION);
    let figure = Figure::of(&dots).with_context(|| {
        let (name, key) = (&bank.name, body.key);
        format!("{name}: the body of key {key} has no modes")
    })?;
    let title = format!(
        "{}, {} (key {}): {:.2} Hz",
        bank.title,
        // The font has no musical signs.
        note::name(body.key).replace('♯', "#").replace('♭', "b"),
        body.key,
        body.pitch_hz
    );
    canvas::save(path, |canvas| {
        canvas.write(&title, TITLE, INK, [LEFT, 30], (HPos::Left, VPos::Center))?;
        figure.axes(canvas)?;
        figure.dots(canvas)?;
        figure.names(canvas)?;
        figure.legend(canvas)
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

    fn axes(&self, canvas: &Canvas<'_>) -> Drawing<()> {
        let (below, beside) = ((HPos::Center, VPos::Top), (HPos::Right, VPos::Center));
        for hz in self.hz.ticks() {
            let x = self.hz.at(hz);
            canvas.fill([x, TOP], [x, BOTTOM], GRID)?;
            canvas.write(&hertz(hz), SMALL, INK, [x, BOTTOM + 10], below)?;
        }
        for t60_s in self.t60_s.ticks() {
            let y = self.t60_s.at(t60_s);
            canvas.fill([LEFT, y], [RIGHT, y], GRID)?;
            canvas.write(&seconds(t60_s), SMALL, INK, [LEFT - 10, y], beside)?;
        }
        let at = [(LEFT + RIGHT) / 2, BOTTOM + 36];
        canvas.write("frequency in Hz", NAME, FAINT, at, below)?;
        let at = [LEFT - 10, TOP - 22];
        canvas.write("T60 in s", NAME, FAINT, at, (HPos::Right, VPos::Center))
    }

    fn dots(&self, canvas: &Canvas<'_>) -> Drawing<()> {
        for dot in &self.dots {
            let (colour, _) = family::look(dot.label.family);
            paint(canvas, self.place(dot), dot.level_db, colour)?;
        }
        Ok(())
    }

    /// Names the lowest modes that are heard, each pair once.
    fn names(&self, canvas: &Canvas<'_>) -> Drawing<()> {
        let mut taken = Taken::none([LEFT + 4, TOP, RIGHT - 4, BOTTOM]);
        for dot in &self.dots {
            taken.dot(self.place(dot), radius(dot.level_db).ceil() as i32);
        }
        let heard = self.dots.iter().filter(|dot| is_heard(dot.level_db));
        let mut heard: Vec<_> = heard.collect();
        heard.sort_by(|a, b| a.hz.total_cmp(&b.hz));
        let mut named = HashSet::new();
        for dot in heard {
            let name = family::name(dot.label);
            if named.len() == NAMED || !named.insert(name.clone()) {
                continue;
            }
            let size = canvas.extent(&name, SMALL)?;
            let radius = radius(dot.level_db).ceil() as i32;
            if let Some(place) = taken.name(self.place(dot), radius, size) {
                canvas.write(&name, SMALL, INK, place, (HPos::Left, VPos::Top))?;
            }
        }
        Ok(())
    }

    fn legend(&self, canvas: &Canvas<'_>) -> Drawing<()> {
        let mut y = TOP + 14;
        let is_there = |kind| self.dots.iter().any(|dot| dot.label.family == kind);
        for kind in FAMILIES.into_iter().filter(|kind| is_there(*kind)) {
            let (colour, name) = family::look(kind);
            entry(canvas, y, -40.0, colour, name)?;
            y += LEADING;
        }
        y += LEADING;
        let anchor = (HPos::Left, VPos::Center);
        let heading = format!("level, first {WINDOW_S} s");
        canvas.write(&heading, SMALL, FAINT, [LEGEND - 12, y], anchor)?;
        y += LEADING / 2;
        for level_db in LEVELS_DB {
            let text = format!("{level_db} dB").replace('-', "−");
            let level_db = f64::from(level_db);
            y += radius(level_db) as i32;
            entry(canvas, y, level_db, FAINT, &text)?;
            y += radius(level_db) as i32 + LEADING / 3;
        }
        if self.dots.iter().any(|dot| !is_heard(dot.level_db)) {
            entry(canvas, y + LEADING / 3, f64::NEG_INFINITY, FAINT, "below")?;
        }
        Ok(())
    }
}

/// A line of the legend.
fn entry(canvas: &Canvas<'_>, y: i32, level_db: f64, colour: RGBColor, text: &str) -> Drawing<()> {
    paint(canvas, [LEGEND, y], level_db, colour)?;
    let anchor = (HPos::Left, VPos::Center);
    canvas.write(text, SMALL, INK, [LEGEND + 24, y], anchor)
}

fn is_heard(level_db: f64) -> bool {
    level_db >= -DEPTH_DB
}

/// Radius of a dot, in pixels.
fn radius(level_db: f64) -> f64 {
    let share = (1.0 + level_db / DEPTH_DB).clamp(0.0, 1.0);
    RADII[1] + share * (RADII[0] - RADII[1])
}

/// A disc that lets others be seen through it; a circle for a mode that is hardly heard.
fn paint(canvas: &Canvas<'_>, at: [i32; 2], level_db: f64, colour: RGBColor) -> Drawing<()> {
    if is_heard(level_db) {
        canvas.disc(at, radius(level_db), colour)
    } else {
        canvas.ring(at, radius(level_db), colour)
    }
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
    let digits = whole(-s.log10().floor());
    format!("{s:.digits$}")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn louder_dots_are_larger_down_to_the_depth() {
        let radii = [0.0, -40.0, -80.0, -90.0, f64::NEG_INFINITY].map(radius);
        assert_eq!(radii, [15.0, 9.0, 3.0, 3.0, 3.0]);
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
