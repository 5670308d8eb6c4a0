//! Wavefront's OBJ format, as far as faces go.

mod lines;
mod polygon;
mod write;

pub(super) use polygon::cut_polygon;
pub use write::write_obj;

use super::{Note, ObjError, Soup, SoupObject};
use lines::Tidy;
use std::fs;
use std::path::Path;
use tobj::LoadOptions;

/// Bytes of a file that are read at most.
const MOST_BYTES: usize = 256 << 20;

/// The triangles of a file, and what was noticed.
#[derive(Clone, Debug, PartialEq)]
pub struct ObjFile {
    /// The triangles, in the file's units.
    pub soup: Soup,
    /// What the owner should know.
    pub notes: Vec<Note>,
}

/// The file at `path`.
///
/// # Errors
///
/// [`ObjError`] names the file and the line.
pub fn read_obj(path: &Path) -> Result<ObjFile, ObjError> {
    let read = |error| ObjError::Read {
        path: path.to_owned(),
        error,
    };
    let file = path.display().to_string();
    let bytes = usize::try_from(fs::metadata(path).map_err(read)?.len()).unwrap_or(usize::MAX);
    within(&file, "bytes", bytes, MOST_BYTES)?;
    let content = fs::read(path).map_err(read)?;
    parse_obj(&content, &file, path.parent())
}

/// The content of a file called `file`; libraries of materials are looked for in `folder`.
///
/// # Errors
///
/// [`ObjError`] names the file and the line.
pub fn parse_obj(content: &[u8], file: &str, folder: Option<&Path>) -> Result<ObjFile, ObjError> {
    within(file, "bytes", content.len(), MOST_BYTES)?;
    let text = String::from_utf8_lossy(content);
    let tidy = lines::tidy(&text, file)?;
    let mut notes = Vec::new();
    if matches!(text, std::borrow::Cow::Owned(_)) {
        notes.push(Note::NotUtf8);
    }
    let there = |name: &str| folder.is_none_or(|folder| folder.join(name).is_file());
    let missing = tidy.libraries.iter().filter(|name| !there(name));
    notes.extend(missing.map(|name| Note::NoMaterials { name: name.clone() }));
    if tidy.not_faces > 0 {
        notes.push(Note::NotFaces {
            lines: tidy.not_faces,
        });
    }
    let (soup, polygons) = triangles(&tidy, file)?;
    if polygons > 0 {
        notes.push(Note::Cut { polygons });
    }
    Ok(ObjFile { soup, notes })
}

/// The triangles of checked lines, and how many polygons were cut.
fn triangles(tidy: &Tidy, file: &str) -> Result<(Soup, usize), ObjError> {
    let options = LoadOptions {
        triangulate: false,
        single_index: true,
        ..LoadOptions::default()
    };
    let nothing = |_: &Path| Ok((Vec::new(), std::collections::HashMap::default()));
    let empty = || ObjError::Empty {
        file: file.to_owned(),
    };
    let (models, _) =
        tobj::load_obj_buf(&mut tidy.text.as_bytes(), &options, nothing).map_err(|error| {
            ObjError::Line {
                file: file.to_owned(),
                line: tidy.lines,
                fault: error.to_string(),
            }
        })?;
    let (mut soup, mut polygons) = (Soup::default(), 0);
    for model in models {
        let first = soup.triangles.len();
        let shift = u32::try_from(soup.points.len()).map_err(|_| empty())?;
        soup.points.extend(model.mesh.positions.as_chunks().0);
        let mut rest = &model.mesh.indices[..];
        let mut arities = model.mesh.face_arities.iter();
        while !rest.is_empty() {
            let corners = arities.next().map_or(3, |&arity| arity as usize);
            let (face, others) = rest.split_at(corners.clamp(1, rest.len()));
            rest = others;
            polygons += usize::from(face.len() > 3);
            let face: Vec<u32> = face.iter().map(|&i| i + shift).collect();
            soup.triangles.extend(cut_polygon(&face, &soup.points));
        }
        if soup.triangles.len() > first {
            soup.objects.push(SoupObject {
                name: model.name,
                triangles: first..soup.triangles.len(),
            });
        }
    }
    if soup.triangles.is_empty() {
        return Err(empty());
    }
    Ok((soup, polygons))
}

fn within(file: &str, what: &'static str, found: usize, allowed: usize) -> Result<(), ObjError> {
    if found <= allowed {
        return Ok(());
    }
    Err(ObjError::TooLarge {
        file: file.to_owned(),
        what,
        found,
        allowed,
    })
}

#[cfg(test)]
mod tests;
