//! Pictures that are kept, and whether new ones look the same.
//!
//! With `UPDATE_SNAPSHOTS` in the environment what is drawn becomes what is kept.

use idiophone::editor::Pixels;
use std::fs::{self, File};
use std::io::{BufReader, BufWriter};
use std::path::{Path, PathBuf};

/// Difference of a colour out of 255 that nobody sees.
const UNSEEN: u8 = 12;
/// Share of the pixels that may differ by more: rounding moves the edges of letters.
const FEW: f64 = 0.001;

fn folder() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/editor/snapshots")
}

fn write(path: &Path, pixels: &Pixels) {
    let file = BufWriter::new(File::create(path).unwrap());
    let mut encoder = png::Encoder::new(file, pixels.width as u32, pixels.height as u32);
    encoder.set_color(png::ColorType::Rgb);
    encoder.set_depth(png::BitDepth::Eight);
    encoder.set_compression(png::Compression::High);
    let rgb: Vec<u8> = pixels
        .rgba
        .iter()
        .flat_map(|[r, g, b, _]| [*r, *g, *b])
        .collect();
    encoder
        .write_header()
        .unwrap()
        .write_image_data(&rgb)
        .unwrap();
}

fn read(path: &Path) -> Option<Pixels> {
    let mut reader = png::Decoder::new(BufReader::new(File::open(path).ok()?))
        .read_info()
        .unwrap();
    let mut bytes = vec![0; reader.output_buffer_size().unwrap()];
    let info = reader.next_frame(&mut bytes).unwrap();
    Some(Pixels {
        width: info.width as usize,
        height: info.height as usize,
        rgba: bytes
            .chunks_exact(3)
            .map(|rgb| [rgb[0], rgb[1], rgb[2], 255])
            .collect(),
    })
}

/// Holds what is drawn beside the picture of that name.
pub(crate) fn check(name: &str, drawn: &Pixels) {
    let path = folder().join(format!("{name}.png"));
    if std::env::var_os("UPDATE_SNAPSHOTS").is_some() {
        write(&path, drawn);
        return;
    }
    let kept = read(&path).unwrap_or_else(|| panic!("there is no {}", path.display()));
    assert_eq!((kept.width, kept.height), (drawn.width, drawn.height));
    let differs = |(a, b): &(&[u8; 4], &[u8; 4])| (0..3).any(|k| a[k].abs_diff(b[k]) > UNSEEN);
    let many = kept.rgba.iter().zip(&drawn.rgba).filter(differs).count();
    let share = many as f64 / kept.rgba.len() as f64;
    if share > FEW {
        let new = Path::new(env!("CARGO_TARGET_TMPDIR")).join(format!("{name}.png"));
        fs::create_dir_all(env!("CARGO_TARGET_TMPDIR")).unwrap();
        write(&new, drawn);
        panic!(
            "{:.2} % of {name} looks otherwise: {}",
            100.0 * share,
            new.display()
        );
    }
}
