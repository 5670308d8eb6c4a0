//! What all pictures share: size, colours, font, and the file they end in.

mod finer;
mod indexed;

use crate::output;
use anyhow::{Result, anyhow};
use finer::FINER;
use plotters::coord::Shift;
use plotters::element::Circle;
use plotters::prelude::*;
use plotters::style::register_font;
use plotters::style::text_anchor::{HPos, Pos, VPos};
use std::path::Path;

/// Width of a picture, in pixels.
const WIDTH: u32 = 1200;
/// Height of a picture, in pixels.
const HEIGHT: u32 = 675;

/// Behind everything.
const PAPER: RGBColor = RGBColor(14, 14, 20);
/// Text to be read first.
pub(crate) const INK: RGBColor = RGBColor(226, 228, 234);
/// Text and lines to be found when looked for.
pub(crate) const FAINT: RGBColor = RGBColor(128, 132, 148);

/// Size of a title's letters, in pixels.
pub(crate) const TITLE: i32 = 24;
/// Size of an axis name's letters, in pixels.
pub(crate) const NAME: i32 = 18;
/// Size of all other letters, in pixels.
pub(crate) const SMALL: i32 = 16;

const FONT: &str = "sans-serif";

pub(crate) type Drawing<T> = std::result::Result<T, Box<dyn std::error::Error>>;

/// A dark sheet to draw on, measured in pixels from its left top corner.
pub(crate) struct Canvas<'a>(DrawingArea<BitMapBackend<'a>, Shift>);

/// Writes what `paint` draws as a PNG.
pub(crate) fn save(path: &Path, paint: impl FnOnce(&Canvas<'_>) -> Drawing<()>) -> Result<()> {
    // Carried along, so that no font has to be installed.
    let font = epaint_default_fonts::UBUNTU_LIGHT;
    register_font(FONT, FontStyle::Normal, font).map_err(|_| anyhow!("the font is broken"))?;
    let fine = [WIDTH, HEIGHT].map(|length| length * FINER as u32);
    let mut pixels = vec![0; (3 * fine[0] * fine[1]) as usize];
    paint_on(&mut pixels, fine, paint).map_err(|error| anyhow!("cannot draw: {error}"))?;
    let pixels = finer::shrunk(&pixels, fine[0] as usize);
    output::write_whole(path, &indexed::png(&pixels, WIDTH, HEIGHT)?)
}

fn paint_on(
    pixels: &mut [u8],
    [width, height]: [u32; 2],
    paint: impl FnOnce(&Canvas<'_>) -> Drawing<()>,
) -> Drawing<()> {
    let canvas = Canvas(BitMapBackend::with_buffer(pixels, (width, height)).into_drawing_area());
    canvas.0.fill(&PAPER)?;
    paint(&canvas)?;
    Ok(canvas.0.present()?)
}

impl Canvas<'_> {
    /// Fills the pixels from `from` to `to`, both included.
    pub(crate) fn fill(&self, from: [i32; 2], to: [i32; 2], colour: RGBColor) -> Drawing<()> {
        let fine = |axis: usize| FINER * from[axis]..FINER * (to[axis] + 1);
        for y in fine(1) {
            for x in fine(0) {
                self.0.draw_pixel((x, y), &colour)?;
            }
        }
        Ok(())
    }

    /// Draws a disc through which what is behind can be seen, and its edge.
    pub(crate) fn disc(&self, at: [i32; 2], radius: f64, colour: RGBColor) -> Drawing<()> {
        let [x, y] = fine(at);
        let inside = colour.mix(0.4).filled();
        self.0
            .draw(&Circle::new((x, y), fine_length(radius), inside))?;
        self.ring(at, radius, colour)
    }

    /// Draws a circle.
    pub(crate) fn ring(&self, at: [i32; 2], radius: f64, colour: RGBColor) -> Drawing<()> {
        let ([x, y], style) = (fine(at), colour.stroke_width(FINER as u32));
        Ok(self
            .0
            .draw(&Circle::new((x, y), fine_length(radius), style))?)
    }

    /// Writes `text` so that its anchor (`h`, `v`) is at `at`.
    pub(crate) fn write(
        &self,
        text: &str,
        size: i32,
        colour: RGBColor,
        at: [i32; 2],
        (h, v): (HPos, VPos),
    ) -> Drawing<()> {
        let ([x, mut y], font) = (fine(at), (FONT, FINER * size).into_font());
        if matches!(v, VPos::Center) {
            // Most letters have nothing below their line: half of them is not where half of a line is.
            y += FINER * size / 10;
        }
        let style = font.color(&colour).pos(Pos::new(h, v));
        Ok(self.0.draw_text(text, &style, (x, y))?)
    }

    /// Width and height that `text` takes, in pixels.
    pub(crate) fn extent(&self, text: &str, size: i32) -> Drawing<[i32; 2]> {
        let style = (FONT, FINER * size).into_font().color(&INK);
        let (width, height) = self.0.estimate_text_size(text, &style)?;
        Ok([width, height].map(|length| length.cast_signed() / FINER + 1))
    }
}

fn fine(at: [i32; 2]) -> [i32; 2] {
    at.map(|length| FINER * length + FINER / 2)
}

fn fine_length(length: f64) -> i32 {
    (f64::from(FINER) * length).round() as i32
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_picture_is_a_png_of_its_size() {
        let dir = tempfile::tempdir().unwrap();
        let path = dir.path().join("a.png");
        let anchor = (HPos::Left, VPos::Top);
        save(&path, |canvas| {
            canvas.write("a", TITLE, INK, [100, 100], anchor)?;
            canvas.fill([0, 0], [0, 0], INK)
        })
        .unwrap();
        let file = std::io::BufReader::new(std::fs::File::open(&path).unwrap());
        let reader = png::Decoder::new(file).read_info().unwrap();
        assert_eq!(reader.info().size(), (WIDTH, HEIGHT));
    }
}
