//! A picture as a PNG of at most 256 colours, a third of the size of one of all colours.

use anyhow::{Context, Result};
use std::cmp::Reverse;
use std::collections::HashMap;

/// What a byte can tell apart.
const COLOURS: usize = 256;

type Colour = [u8; 3];

/// Encodes `pixels`, three bytes each, row by row.
///
/// The colours that are met most often are kept; the rest, which is at the edges of letters and
/// dots, becomes the nearest of them.
pub(super) fn png(pixels: &[u8], width: u32, height: u32) -> Result<Vec<u8>> {
    let (pixels, _) = pixels.as_chunks::<3>();
    let palette = palette(pixels);
    let mut known: HashMap<Colour, u8> = HashMap::new();
    let indices: Vec<u8> = pixels
        .iter()
        .map(|colour| {
            *known
                .entry(*colour)
                .or_insert_with(|| nearest(&palette, *colour))
        })
        .collect();
    let mut png = Vec::new();
    let mut encoder = png::Encoder::new(&mut png, width, height);
    encoder.set_color(png::ColorType::Indexed);
    encoder.set_depth(png::BitDepth::Eight);
    encoder.set_palette(palette.concat());
    encoder.set_compression(png::Compression::High);
    // Neighbouring indices are no neighbouring colours.
    encoder.set_filter(png::Filter::NoFilter);
    encoder
        .write_header()
        .and_then(|mut writer| writer.write_image_data(&indices))
        .context("cannot encode PNG")?;
    Ok(png)
}

/// The most frequent colours, the most frequent first.
fn palette(pixels: &[Colour]) -> Vec<Colour> {
    let mut counts: HashMap<Colour, usize> = HashMap::new();
    for colour in pixels {
        *counts.entry(*colour).or_default() += 1;
    }
    let mut colours: Vec<_> = counts.into_iter().collect();
    // Of equally many the darker first, so that the same picture is the same file.
    colours.sort_by_key(|&(colour, count)| (Reverse(count), colour));
    colours.truncate(COLOURS);
    colours.into_iter().map(|(colour, _)| colour).collect()
}

fn nearest(palette: &[Colour], wanted: Colour) -> u8 {
    let distance = |colour: &Colour| -> u32 {
        let parts = colour.iter().zip(wanted);
        parts.map(|(&a, b)| u32::from(a.abs_diff(b)).pow(2)).sum()
    };
    let found = (0..palette.len()).min_by_key(|&index| distance(&palette[index]));
    found.unwrap_or(0) as u8
}

#[cfg(test)]
mod tests {
    use super::*;

    fn decoded(png: &[u8]) -> Vec<u8> {
        let mut decoder = png::Decoder::new(std::io::Cursor::new(png));
        decoder.set_transformations(png::Transformations::EXPAND);
        let mut reader = decoder.read_info().unwrap();
        let mut pixels = vec![0; reader.output_buffer_size().unwrap()];
        reader.next_frame(&mut pixels).unwrap();
        pixels
    }

    #[test]
    fn few_colours_stay_as_they_are() {
        let pixels: Vec<u8> = (0..64).flat_map(|i: u8| [4 * i; 3]).collect();
        assert_eq!(decoded(&png(&pixels, 8, 8).unwrap()), pixels);
    }

    #[test]
    fn a_rare_colour_becomes_the_nearest_frequent_one() {
        // Every blue twice, and once a red next to the blue of 200.
        let blues = (0..=255).flat_map(|i: u8| [0, 0, i, 0, 0, i]);
        let mut pixels: Vec<u8> = blues.collect();
        pixels.extend([1, 0, 200]);
        let shown = decoded(&png(&pixels, 27, 19).unwrap());
        assert_eq!(shown[..3 * 512], pixels[..3 * 512]);
        assert_eq!(shown[3 * 512..], [0, 0, 200]);
    }
}
