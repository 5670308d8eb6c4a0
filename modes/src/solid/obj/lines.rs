//! Every line checked, and what is not a point, a face or an object's name left out, so that what is
//! wrong can be said with its line.

use super::super::ObjError;
use super::within;
use std::fmt::Write;

/// Points that are read at most.
const MOST_POINTS: usize = 4_000_000;

/// Triangles that are read at most.
const MOST_TRIANGLES: usize = 2_000_000;

/// A file that holds no more than points, faces and the names of objects, every index from 1 on.
pub(super) struct Tidy {
    pub(super) text: String,
    /// Libraries of materials named.
    pub(super) libraries: Vec<String>,
    /// Lines, points and curves left out.
    pub(super) not_faces: usize,
    /// Lines of the file.
    pub(super) lines: usize,
}

/// The highest point a face names, and where.
#[derive(Default)]
struct Highest {
    point: usize,
    line: usize,
}

pub(super) fn tidy(text: &str, file: &str) -> Result<Tidy, ObjError> {
    // Groups divide a file only where objects do not.
    let divider = match text.lines().any(|line| word(line) == Some("o")) {
        true => "o",
        false => "g",
    };
    let mut tidy = Tidy {
        text: String::with_capacity(text.len()),
        libraries: Vec::new(),
        not_faces: 0,
        lines: text.lines().count(),
    };
    let (mut points, mut triangles, mut highest) = (0, 0, Highest::default());
    let mut lines = text.lines().enumerate();
    while let Some((at, line)) = lines.next() {
        let mut line = std::borrow::Cow::Borrowed(line);
        while line.ends_with('\\') {
            let kept = line.len() - 1;
            let next = lines.next().map_or("", |(_, next)| next);
            line = format!("{} {next}", &line[..kept]).into();
        }
        let fault = |fault: String| ObjError::Line {
            file: file.to_owned(),
            line: at + 1,
            fault,
        };
        let mut words = line.split_whitespace();
        match words.next() {
            Some("v") => {
                points += 1;
                within(file, "points", points, MOST_POINTS)?;
                point(words, &mut tidy.text).map_err(fault)?;
            }
            Some("f") => {
                let (corners, top) = face(words, points, &mut tidy.text).map_err(fault)?;
                triangles += corners.saturating_sub(2);
                within(file, "triangles", triangles, MOST_TRIANGLES)?;
                if top > highest.point {
                    highest = Highest {
                        point: top,
                        line: at + 1,
                    };
                }
            }
            Some(kind) if kind == divider => {
                let name = line.trim_start()[1..].trim();
                let _ = writeln!(tidy.text, "o {name}");
            }
            Some("mtllib") => {
                let name = line.trim_start()["mtllib".len()..].trim();
                tidy.libraries.push(name.to_owned());
            }
            Some("l" | "p" | "curv" | "curv2" | "surf") => tidy.not_faces += 1,
            _ => {}
        }
    }
    if highest.point > points {
        return Err(ObjError::Line {
            file: file.to_owned(),
            line: highest.line,
            fault: format!(
                "a face uses point {}, but there are {points}",
                highest.point
            ),
        });
    }
    Ok(tidy)
}

fn word(line: &str) -> Option<&str> {
    line.split_whitespace().next()
}

/// Writes a point; what follows the three coordinates is weight or colour.
fn point<'a>(mut words: impl Iterator<Item = &'a str>, text: &mut String) -> Result<(), String> {
    text.push('v');
    for _ in 0..3 {
        let word = words.next().ok_or("a point has three coordinates")?;
        match word.parse::<f64>() {
            Ok(x) if x.is_finite() => {
                text.push(' ');
                text.push_str(word);
            }
            _ => {
                return Err(format!(
                    "\"{word}\" is no coordinate: it must be a finite number"
                ));
            }
        }
    }
    text.push('\n');
    Ok(())
}

/// Writes a face with its points counted from 1; returns how many corners it has and its highest
/// point.
fn face<'a>(
    words: impl Iterator<Item = &'a str>,
    points: usize,
    text: &mut String,
) -> Result<(usize, usize), String> {
    let (start, mut corners, mut highest) = (text.len(), 0, 0);
    text.push('f');
    for word in words {
        let first = word.split('/').next().unwrap_or_default();
        let at: i64 = first
            .parse()
            .map_err(|_| format!("\"{word}\" is no corner: points are counted from 1"))?;
        let back = usize::try_from(at.unsigned_abs()).unwrap_or(usize::MAX);
        let number = match at {
            1.. => back,
            _ if at < 0 && back <= points => points + 1 - back,
            _ => {
                return Err(format!(
                    "a face uses point {at}, but {points} precede it, counted from 1 or back from −1"
                ));
            }
        };
        corners += 1;
        highest = highest.max(number);
        let _ = write!(text, " {number}");
    }
    text.push('\n');
    if corners < 3 {
        text.truncate(start);
    }
    Ok((corners, highest))
}
