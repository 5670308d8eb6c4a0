//! Drawing a spectrogram with its axes.

use super::{Recording, colour, stft};
use crate::output;
use anyhow::{Context, Result, anyhow};
use plotters::coord::Shift;
use plotters::prelude::*;
use plotters::style::register_font;
use plotters::style::text_anchor::{HPos, Pos, VPos};
use std::path::Path;

const WIDTH: u32 = 1600;
const HEIGHT: u32 = 900;
/// The spectrogram's edges, in pixels.
const LEFT: i32 = 100;
const RIGHT: i32 = 1456;
const TOP: i32 = 84;
const BOTTOM: i32 = 812;
/// The colour scale's edges, in pixels.
const SCALE: [i32; 2] = [1482, 1504];

/// Lowest and highest frequency shown, in Hz.
const RANGE_HZ: [f64; 2] = [50.0, 20_000.0];
/// How far down from the greatest level is shown, in dB.
const DEPTH_DB: i32 = 90;
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

const PAPER: RGBColor = RGBColor(14, 14, 20);
const INK: RGBColor = RGBColor(226, 228, 234);
const FAINT: RGBColor = RGBColor(120, 124, 140);
const FONT: &str = "sans-serif";

type Area<'a> = DrawingArea<BitMapBackend<'a>, Shift>;
type Drawing<T> = std::result::Result<T, Box<dyn std::error::Error>>;

/// Draws `recording` as a PNG.
///
/// # Errors
///
/// If the file cannot be written.
pub fn draw(recording: &Recording, title: &str, path: &Path) -> Result<()> {
    // Carried along, so that no font has to be installed.
    let font = epaint_default_fonts::UBUNTU_LIGHT;
    register_font(FONT, FontStyle::Normal, font).map_err(|_| anyhow!("the font is broken"))?;
    let mut pixels = vec![0; (3 * WIDTH * HEIGHT) as usize];
    paint(&mut pixels, recording, title).map_err(|error| anyhow!("cannot draw: {error}"))?;
    let mut png = Vec::new();
    let mut encoder = png::Encoder::new(&mut png, WIDTH, HEIGHT);
    encoder.set_color(png::ColorType::Rgb);
    encoder.set_depth(png::BitDepth::Eight);
    encoder
        .write_header()
        .and_then(|mut writer| writer.write_image_data(&pixels))
        .context("cannot encode PNG")?;
    output::write_whole(path, &png)
}

fn paint(pixels: &mut [u8], recording: &Recording, title: &str) -> Drawing<()> {
    let area = BitMapBackend::with_buffer(pixels, (WIDTH, HEIGHT)).into_drawing_area();
    area.fill(&PAPER)?;
    write(
        &area,
        title,
        32,
        &INK,
        (LEFT, 42),
        (HPos::Left, VPos::Center),
    )?;
    let top_db = levels(&area, recording)?;
    frequency_axis(&area)?;
    time_axis(&area, recording.seconds())?;
    level_scale(&area, top_db)?;
    area.present()?;
    Ok(())
}

/// Paints the levels; returns the level of the lightest colour, in dB.
fn levels(area: &Area<'_>, recording: &Recording) -> Drawing<i32> {
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
            let share = 1.0 + (f64::from(level) - f64::from(top_db)) / f64::from(DEPTH_DB);
            let [r, g, b] = colour::of_level(share);
            area.draw_pixel((x, y), &RGBColor(r, g, b))?;
        }
    }
    Ok(top_db)
}

fn frequency_axis(area: &Area<'_>) -> Drawing<()> {
    for (hz, text) in TICKS_HZ {
        let y = y_of(hz);
        line(area, (LEFT - 8, y), (LEFT - 2, y), &FAINT)?;
        write(
            area,
            text,
            21,
            &INK,
            (LEFT - 14, y),
            (HPos::Right, VPos::Center),
        )?;
    }
    let at = (LEFT - 14, TOP - 26);
    write(area, "Hz", 25, &FAINT, at, (HPos::Right, VPos::Center))
}

fn time_axis(area: &Area<'_>, seconds: f64) -> Drawing<()> {
    let step = tick_step(seconds);
    let mut tick = 0.0;
    while tick <= seconds {
        let x = LEFT + (tick / seconds * f64::from(RIGHT - LEFT)).round() as i32;
        line(area, (x, BOTTOM + 2), (x, BOTTOM + 8), &FAINT)?;
        let at = (x, BOTTOM + 14);
        write(
            area,
            &tick.to_string(),
            21,
            &INK,
            at,
            (HPos::Center, VPos::Top),
        )?;
        tick += step;
    }
    let at = ((LEFT + RIGHT) / 2, BOTTOM + 46);
    write(area, "time in s", 25, &FAINT, at, (HPos::Center, VPos::Top))
}

fn level_scale(area: &Area<'_>, top_db: i32) -> Drawing<()> {
    let [left, right] = SCALE;
    let height = f64::from(BOTTOM - TOP);
    for y in TOP..BOTTOM {
        let [r, g, b] = colour::of_level(1.0 - (f64::from(y - TOP) + 0.5) / height);
        line(area, (left, y), (right, y), &RGBColor(r, g, b))?;
    }
    for down in (0..=DEPTH_DB).step_by(2 * LEVEL_STEP_DB as usize) {
        let y = TOP + (height * f64::from(down) / f64::from(DEPTH_DB)).round() as i32;
        line(area, (right + 2, y), (right + 8, y), &FAINT)?;
        let text = (top_db - down).to_string().replace('-', "−");
        write(
            area,
            &text,
            21,
            &INK,
            (right + 14, y),
            (HPos::Left, VPos::Center),
        )?;
    }
    let at = (right + 14, TOP - 26);
    write(area, "dBFS", 25, &FAINT, at, (HPos::Left, VPos::Center))
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

fn line(area: &Area<'_>, from: (i32, i32), to: (i32, i32), colour: &RGBColor) -> Drawing<()> {
    Ok(area.draw(&PathElement::new([from, to], colour))?)
}

fn write(
    area: &Area<'_>,
    text: &str,
    size: i32,
    colour: &RGBColor,
    at: (i32, i32),
    (h, v): (HPos, VPos),
) -> Drawing<()> {
    let style = (FONT, size).into_font().color(colour).pos(Pos::new(h, v));
    Ok(area.draw_text(text, &style, at)?)
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

    #[test]
    fn a_picture_is_a_png() {
        let dir = tempfile::tempdir().unwrap();
        let path = dir.path().join("a.png");
        let recording = Recording {
            rate_hz: 8000.0,
            samples: (0..800).map(|i| (0.1 * i as f32).sin()).collect(),
        };
        draw(&recording, "a", &path).unwrap();
        let decoder =
            png::Decoder::new(std::io::BufReader::new(std::fs::File::open(&path).unwrap()));
        let reader = decoder.read_info().unwrap();
        assert_eq!(reader.info().size(), (WIDTH, HEIGHT));
    }
}
