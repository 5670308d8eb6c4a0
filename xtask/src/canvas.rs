//! What all pictures share: size, colours, font, and the file they end in.

mod indexed;

use crate::output;
use anyhow::{Result, anyhow};
use plotters::coord::Shift;
use plotters::prelude::*;
use plotters::style::register_font;
use plotters::style::text_anchor::{HPos, Pos, VPos};
use std::path::Path;

/// Width of a picture, in pixels.
pub(crate) const WIDTH: u32 = 1200;
/// Height of a picture, in pixels.
pub(crate) const HEIGHT: u32 = 675;

/// Behind everything.
pub(crate) const PAPER: RGBColor = RGBColor(14, 14, 20);
/// Text to be read first.
pub(crate) const INK: RGBColor = RGBColor(226, 228, 234);
/// Text and lines to be found when looked for.
pub(crate) const FAINT: RGBColor = RGBColor(120, 124, 140);

/// Size of a title's letters, in pixels.
pub(crate) const TITLE: i32 = 24;
/// Size of an axis name's letters, in pixels.
pub(crate) const NAME: i32 = 19;
/// Size of all other letters, in pixels.
pub(crate) const SMALL: i32 = 16;

const FONT: &str = "sans-serif";

pub(crate) type Area<'a> = DrawingArea<BitMapBackend<'a>, Shift>;
pub(crate) type Drawing<T> = std::result::Result<T, Box<dyn std::error::Error>>;

/// Writes what `paint` draws as a PNG.
pub(crate) fn save(path: &Path, paint: impl FnOnce(&Area<'_>) -> Drawing<()>) -> Result<()> {
    // Carried along, so that no font has to be installed.
    let font = epaint_default_fonts::UBUNTU_LIGHT;
    register_font(FONT, FontStyle::Normal, font).map_err(|_| anyhow!("the font is broken"))?;
    let mut pixels = vec![0; (3 * WIDTH * HEIGHT) as usize];
    paint_on(&mut pixels, paint).map_err(|error| anyhow!("cannot draw: {error}"))?;
    output::write_whole(path, &indexed::png(&pixels, WIDTH, HEIGHT)?)
}

fn paint_on(pixels: &mut [u8], paint: impl FnOnce(&Area<'_>) -> Drawing<()>) -> Drawing<()> {
    let area = BitMapBackend::with_buffer(pixels, (WIDTH, HEIGHT)).into_drawing_area();
    area.fill(&PAPER)?;
    paint(&area)?;
    Ok(area.present()?)
}

/// Draws a line one pixel wide.
pub(crate) fn line(
    area: &Area<'_>,
    from: (i32, i32),
    to: (i32, i32),
    colour: &RGBColor,
) -> Drawing<()> {
    Ok(area.draw(&PathElement::new([from, to], colour))?)
}

/// Writes `text` so that its anchor (`h`, `v`) is at `at`.
pub(crate) fn write(
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

/// Width and height that `text` takes, in pixels.
pub(crate) fn extent(area: &Area<'_>, text: &str, size: i32) -> Drawing<[i32; 2]> {
    let style = (FONT, size).into_font().color(&INK);
    let (width, height) = area.estimate_text_size(text, &style)?;
    Ok([width.cast_signed(), height.cast_signed()])
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_picture_is_a_png_of_its_size() {
        let dir = tempfile::tempdir().unwrap();
        let path = dir.path().join("a.png");
        let at = (100, 100);
        let anchor = (HPos::Left, VPos::Top);
        save(&path, |area| write(area, "a", TITLE, &INK, at, anchor)).unwrap();
        let file = std::io::BufReader::new(std::fs::File::open(&path).unwrap());
        let reader = png::Decoder::new(file).read_info().unwrap();
        assert_eq!(reader.info().size(), (WIDTH, HEIGHT));
    }
}
