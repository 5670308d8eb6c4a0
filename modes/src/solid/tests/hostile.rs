//! Meshes as people have them: each is repaired with a note or refused with a reason.

mod broken;
mod files;
mod large;
mod random;
mod spoilt;

use super::*;
use crate::solid::{gallery, write_obj};
use files::*;
use std::time::Duration;

/// What becomes of a mesh.
enum Fate {
    /// A solid of so many edge lengths cubed, and a note with these words.
    Solid(f64, &'static str),
    /// An error with these words.
    Refused(&'static str),
}
use Fate::{Refused, Solid};

/// A name, a text and what becomes of it.
type Case = (&'static str, String, Fate);

fn cases() -> Vec<(&'static str, Vec<u8>, Fate)> {
    let mut cases = spoilt::texts(cube(), thirds(&faces(1)));
    cases.extend(broken::broken());
    let text = |(name, text, fate): Case| (name, text.into_bytes(), fate);
    let mut cases: Vec<_> = cases.into_iter().map(text).collect();
    let mut latin = b"o Gl\xf6ckchen\n".to_vec();
    latin.extend(cube().into_bytes());
    cases.push(("a name in Latin 1", latin, Solid(1.0, "UTF-8")));
    cases.push((
        "bytes",
        (0..=255).cycle().take(9999).collect(),
        Refused("no faces"),
    ));
    let (points, mut triangles) = gallery::sphere(0.5, 4).into_parts();
    triangles.retain(|t| t[0] % 3 == 0);
    let torn = write_obj(&Soup::single(points, triangles)).into_bytes();
    cases.push(("torn", torn, Refused("holes, each of them small, make")));
    let mut ended = cube().into_bytes();
    ended.extend([0; 64]);
    cases.push(("zeros at the end", ended, Solid(1.0, ANY)));
    cases
}

/// Volume in edge lengths of the file cubed, and the notes.
fn fate(content: &[u8]) -> Result<(f64, String), String> {
    let here = std::env::temp_dir();
    let file = parse_obj(content, "a.obj", Some(&here)).map_err(|error| error.to_string())?;
    let how = Repair {
        size_m: Some(0.1),
        ..Repair::default()
    };
    let surface = repair(&file.soup, &how).map_err(|error| error.to_string())?;
    let meshed = mesh_solid(&surface, &nodes(2_000), &Silent).map_err(|error| error.to_string())?;
    let kept: Vec<[f64; 3]> = file
        .soup
        .triangles
        .iter()
        .flatten()
        .map(|&i| file.soup.points[i as usize])
        .collect();
    let (low, high) = vector::bounds(kept);
    let longest = (0..3).map(|a| high[a] - low[a]).fold(0.0, f64::max);
    let notes: Vec<String> = file
        .notes
        .iter()
        .chain(&meshed.notes)
        .map(Note::to_string)
        .collect();
    let volume = meshed.quality.volume_m3 / 1e-3 * longest.powi(3);
    assert!(
        meshed.quality.min_dihedral_deg > 5.0,
        "{:?}",
        meshed.quality
    );
    Ok((volume, notes.join("; ")))
}

#[test]
fn each_is_repaired_or_refused() {
    let cases = cases();
    assert!(cases.len() >= 50, "{}", cases.len());
    let mut wrong = Vec::new();
    for (name, content, expected) in cases {
        let start = Instant::now();
        let found = fate(&content);
        let right = match (&expected, &found) {
            (Solid(volume, words), Ok((found, notes))) => {
                let unit = match name {
                    "in kilometres" => 1e9,
                    "in nanometres" => 1e-27,
                    _ => 1.0,
                };
                (found / (volume * unit) - 1.0).abs() < 0.03 && notes.contains(words)
            }
            (Refused(words), Err(error)) => error.contains(words),
            _ => false,
        };
        if !right || start.elapsed() > Duration::from_secs(20) {
            wrong.push(format!("{name}: {found:?} in {:?}", start.elapsed()));
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}
