//! Pictures of at most 256 colours, which are smaller files.

use idiophone::editor::Pixels;
use std::collections::HashMap;
use std::fs::{self, File};
use std::io::BufWriter;
use std::path::Path;

type Colour = [u8; 3];

/// Colours to a picture.
const MOST: usize = 256;

/// Some colours, and how many pixels have each.
type Group = Vec<(Colour, usize)>;

/// Writes a picture with the colours that serve it best.
pub(crate) fn write(path: &Path, pixels: &Pixels) {
    let mut many: HashMap<Colour, usize> = HashMap::new();
    for [r, g, b, _] in &pixels.rgba {
        *many.entry([*r, *g, *b]).or_default() += 1;
    }
    let mut all: Group = many.into_iter().collect();
    all.sort_unstable();
    let boxes = median_cut(all);
    let palette: Vec<Colour> = boxes.iter().map(mean).collect();
    let number: HashMap<Colour, u8> = boxes
        .iter()
        .zip(0..=u8::MAX)
        .flat_map(|(colours, number)| colours.iter().map(move |(colour, _)| (*colour, number)))
        .collect();
    fs::create_dir_all(path.parent().unwrap()).unwrap();
    let file = BufWriter::new(File::create(path).unwrap());
    let mut encoder = png::Encoder::new(file, pixels.width as u32, pixels.height as u32);
    encoder.set_color(png::ColorType::Indexed);
    encoder.set_depth(png::BitDepth::Eight);
    encoder.set_palette(palette.concat());
    encoder.set_compression(png::Compression::High);
    // Numbers of colours that are neighbours are not alike.
    encoder.set_filter(png::Filter::NoFilter);
    let numbers: Vec<u8> = pixels
        .rgba
        .iter()
        .map(|[r, g, b, _]| number[&[*r, *g, *b]])
        .collect();
    let mut writer = encoder.write_header().unwrap();
    writer.write_image_data(&numbers).unwrap();
}

/// Parts colours into boxes (P. Heckbert, "Color image quantization for frame buffer display", 1982): that
/// with the greatest error first, across its longest side, so that both halves have as many pixels.
fn median_cut(all: Group) -> Vec<Group> {
    let mut boxes = vec![all];
    while boxes.len() < MOST {
        let cost = |colours: &Group| {
            let pixels: usize = colours.iter().map(|(_, many)| many).sum();
            usize::from(side(colours).1).pow(2) * pixels
        };
        let worst = (0..boxes.len()).max_by_key(|at| cost(&boxes[*at])).unwrap();
        if boxes[worst].len() < 2 {
            break;
        }
        let mut colours = boxes.swap_remove(worst);
        let (axis, _) = side(&colours);
        colours.sort_by_key(|(colour, _)| colour[axis]);
        let half = colours.iter().map(|(_, many)| many).sum::<usize>() / 2;
        let mut passed = 0;
        let before = colours.iter().take_while(|(_, many)| {
            passed += many;
            passed <= half
        });
        let at = before.count().clamp(1, colours.len() - 1);
        let rest = colours.split_off(at);
        boxes.extend([colours, rest]);
    }
    boxes
}

/// The longest side of a box, and its length.
fn side(colours: &Group) -> (usize, u8) {
    let length = |axis: usize| {
        let values = || colours.iter().map(|(colour, _)| colour[axis]);
        values().max().unwrap_or(0) - values().min().unwrap_or(0)
    };
    (0..3)
        .map(|axis| (axis, length(axis)))
        .max_by_key(|side| side.1)
        .unwrap()
}

fn mean(colours: &Group) -> Colour {
    let pixels: usize = colours.iter().map(|(_, many)| many).sum();
    [0, 1, 2].map(|axis| {
        let sum: usize = colours
            .iter()
            .map(|(colour, many)| usize::from(colour[axis]) * many)
            .sum();
        ((sum + pixels / 2) / pixels) as u8
    })
}
