//! Drawing a spectrogram with its axes.

use super::{Recording, colour, stft};
use crate::canvas::{self, Canvas, Drawing, FAINT, INK, NAME, SMALL, TITLE};
use anyhow::Result;
use plotters::style::RGBColor;
use plotters::style::text_anchor::{HPos, VPos};
use std::path::Path;

/// The spectrogram's edges, in pixels.
const LEFT: i32 = 76;
const RIGHT: i32 = 1092;
const TOP: i32 = 64;
const BOTTOM: i32 = 608;
/// The colour scale's edges, in pixels.
const SCALE: [i32; 2] = [1112, 1128];

/// Lowest and highest frequency shown, in Hz.
const RANGE_HZ: [f64; 2] = [50.0, 20_000.0];
/// How far down from the greatest level is shown, in dB.
const DEPTH_DB: i32 = 80;
/// Steps of level that are written at the colour scale, in dB.
const LEVEL_STEP_DB: i32 = 10;
/// Frequencies that are written at the axis, in Hz.
const TICKS_HZ: [(f64, &str); 9] = [
    (50.0, "50"),
    (100.0, "100"),
    (200.0, "200"),
    (500.0, "500"),
    (1e3, "1 k"),
    (2e3, "2 k"),
    (5e3, "5 k"),
    (10e3, "10 k"),
    (20e3, "20 k"),
];

/// Draws `recording` as a PNG.
///
/// # Errors
///
/// If the file cannot be written.
pub fn draw(recording: &Recording, title: &str, path: &Path) -> Result<()> {
    canvas::save(path, |canvas| {
        canvas.write(title, TITLE, INK, [LEFT, 30], (HPos::Left, VPos::Center))?;
        let top_db = levels(canvas, recording)?;
        frequency_axis(canvas)?;
        time_axis(canvas, recording.seconds())?;
        level_scale(canvas, top_db)
    })
}

/// Paints the levels; returns the level of the lightest colour, in dB.
fn levels(canvas: &Canvas<'_>, recording: &Recording) -> Drawing<i32> {
    let columns = f64::from(RIGHT - LEFT);
    let moments: Vec<f64> = (LEFT..RIGHT)
        .map(|x| recording.seconds() * (f64::from(x - LEFT) + 0.5) / columns)
        .collect();
    let frequencies: Vec<f64> = (TOP..BOTTOM)
        .rev()
        .map(|y| hz_at(f64::from(y) + 0.5))
        .collect();
    let levels = stft::levels(recording, &moments, &frequencies);
    let greatest = levels.iter().flatten().copied().fold(f32::MIN, f32::max);
    let top_db = (greatest / LEVEL_STEP_DB as f32).ceil() as i32 * LEVEL_STEP_DB;
    for (x, column) in (LEFT..RIGHT).zip(&levels) {
        for (y, &level) in (TOP..BOTTOM).rev().zip(column) {
            let colour = colour_of(f64::from(top_db) - f64::from(level));
            canvas.fill([x, y], [x, y], colour)?;
        }
    }
    Ok(top_db)
}

/// The colour of a level so far down, in whole decibels: as many colours as a small file can hold.
fn colour_of(down_db: f64) -> RGBColor {
    let [r, g, b] = colour::of_level(1.0 - down_db.round() / f64::from(DEPTH_DB));
    RGBColor(r, g, b)
}

fn frequency_axis(canvas: &Canvas<'_>) -> Drawing<()> {
    let anchor = (HPos::Right, VPos::Center);
    for (hz, text) in TICKS_HZ {
        let y = y_of(hz);
        canvas.fill([LEFT - 7, y], [LEFT - 3, y], FAINT)?;
        canvas.write(text, SMALL, INK, [LEFT - 12, y], anchor)?;
    }
    canvas.write("Hz", NAME, FAINT, [LEFT - 12, TOP - 20], anchor)
}

fn time_axis(canvas: &Canvas<'_>, seconds: f64) -> Drawing<()> {
    let anchor = (HPos::Center, VPos::Top);
    let step = tick_step(seconds);
    let mut tick = 0.0;
    while tick <= seconds {
        let x = LEFT + (tick / seconds * f64::from(RIGHT - LEFT)).round() as i32;
        canvas.fill([x, BOTTOM + 2], [x, BOTTOM + 6], FAINT)?;
        canvas.write(&tick.to_string(), SMALL, INK, [x, BOTTOM + 12], anchor)?;
        tick += step;
    }
    let at = [(LEFT + RIGHT) / 2, BOTTOM + 36];
    canvas.write("time in s", NAME, FAINT, at, anchor)
}

fn level_scale(canvas: &Canvas<'_>, top_db: i32) -> Drawing<()> {
    let anchor = (HPos::Left, VPos::Center);
    let [left, right] = SCALE;
    let height = f64::from(BOTTOM - TOP);
    for y in TOP..BOTTOM {
        let down_db = (f64::from(y - TOP) + 0.5) / height * f64::from(DEPTH_DB);
        canvas.fill([left, y], [right, y], colour_of(down_db))?;
    }
    for down in (0..=DEPTH_DB).step_by(2 * LEVEL_STEP_DB as usize) {
        let y = TOP + (height * f64::from(down) / f64::from(DEPTH_DB)).round() as i32;
        canvas.fill([right + 3, y], [right + 7, y], FAINT)?;
        let text = (top_db - down).to_string().replace('-', "−");
        canvas.write(&text, SMALL, INK, [right + 12, y], anchor)?;
    }
    canvas.write("dBFS", NAME, FAINT, [right + 12, TOP - 20], anchor)
}

/// The greatest round step that gives at least six ticks.
fn tick_step(seconds: f64) -> f64 {
    const STEPS: [f64; 11] = [
        60.0, 30.0, 20.0, 10.0, 5.0, 2.0, 1.0, 0.5, 0.25, 0.125, 0.0625,
    ];
    let fits = STEPS.into_iter().find(|step| seconds / step >= 6.0);
    fits.unwrap_or(seconds)
}

fn hz_at(y: f64) -> f64 {
    let [low, high] = RANGE_HZ;
    low * (high / low).powf((f64::from(BOTTOM) - y) / f64::from(BOTTOM - TOP))
}

fn y_of(hz: f64) -> i32 {
    let [low, high] = RANGE_HZ;
    BOTTOM - ((hz / low).ln() / (high / low).ln() * f64::from(BOTTOM - TOP)).round() as i32
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_frequency_axis_goes_both_ways() {
        assert_eq!(y_of(RANGE_HZ[0]), BOTTOM);
        assert_eq!(y_of(RANGE_HZ[1]), TOP);
        for (hz, _) in TICKS_HZ {
            assert!((hz_at(f64::from(y_of(hz))) / hz).ln().abs() < 0.005);
        }
    }

    #[test]
    fn time_has_a_handful_of_ticks() {
        for seconds in [0.5, 1.0, 7.0, 30.0, 200.0] {
            let ticks = seconds / tick_step(seconds);
            assert!((6.0..=16.0).contains(&ticks), "{seconds} s: {ticks}");
        }
    }
}
