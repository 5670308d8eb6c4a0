//! A recipe of meshes, written from what somebody has chosen.

use super::{FreeRecipe, RecipeError, Up};
use crate::NAMED_MATERIALS;
use std::fmt::{self, Write as _};
use std::path::Path;

/// What to make of meshes: each field as recipes have it.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct MeshOrder {
    /// Name for people; without, that of the first piece's file.
    pub title: Option<String>,
    /// The bodies.
    pub pieces: Vec<PieceOrder>,
    /// Nodes of each mesh of tetrahedra, about.
    pub nodes: u32,
    /// Modes of each body at most.
    pub most_modes: u32,
}

/// What to make of one mesh.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct PieceOrder {
    /// The mesh's file.
    pub file: String,
    /// Those of its objects that are meant, together one body; all if none is named.
    pub objects: Vec<String>,
    /// What it is made of: a known name, or a part of just one.
    pub material: String,
    /// Longest side of its bounding box, in m; without, the unit tells the size.
    pub size_m: Option<f64>,
    /// What one of the file's units is, in m; without either, one metre.
    pub unit_m: Option<f64>,
    /// Thickness of its wall, in m; without, it is solid.
    pub wall_m: Option<f64>,
    /// Which of the file's axes points up.
    pub up: Up,
    /// Lowest and highest MIDI key.
    pub keys: [u8; 2],
    /// What changes from key to key: size, density, stiffness or nothing.
    pub by: String,
    /// The mode that is tuned: lowest, loudest or its number.
    pub tuned: String,
}

impl MeshOrder {
    /// The recipe that it amounts to; errors call it `name`.
    ///
    /// # Errors
    ///
    /// If a value is out of its range, or two pieces share a key.
    pub fn recipe(&self, name: &str) -> Result<FreeRecipe, RecipeError> {
        FreeRecipe::parse(&self.text(), name, Path::new(""))
    }

    /// The instrument's name for people.
    fn title(&self) -> String {
        if let Some(title) = &self.title {
            return title.clone();
        }
        let first = self.pieces.first();
        let stem = first.and_then(|piece| Path::new(&piece.file).file_stem());
        stem.unwrap_or_default().to_string_lossy().into_owned()
    }

    /// The instrument's name, fit for a file.
    #[must_use]
    pub fn name(&self) -> String {
        plain(&self.title())
    }

    /// The same in words, for the bank to carry.
    fn text(&self) -> String {
        let mut text = format!(
            "name = {}\ntitle = {}\n",
            quoted(&self.name()),
            quoted(&self.title())
        );
        // Writing to a string cannot fail.
        let _ = match &self.pieces[..] {
            [only] => only.write(&mut text, ""),
            several => several.iter().try_for_each(|piece| {
                writeln!(text, "\n[[piece]]")?;
                piece.write(&mut text, "piece.")
            }),
        };
        let Self {
            nodes, most_modes, ..
        } = self;
        let _ = write!(
            text,
            "\n[mesh]\nnodes = {nodes}\nmost_modes = {most_modes}\n"
        );
        text
    }
}

impl PieceOrder {
    /// Its tables, each named with `within` in front.
    fn write(&self, text: &mut String, within: &str) -> fmt::Result {
        let mode = match self.tuned.parse::<i64>() {
            Ok(number) => number.to_string(),
            Err(_) => quoted(&self.tuned),
        };
        let [low, high] = self.keys;
        write!(
            text,
            "\n[{within}keys]\nlow = {low}\nhigh = {high}\n\n[{within}tuning]\nby = {}\n\
             mode = {mode}\n\n[{within}body]\nshape = \"mesh\"\nfile = {}\n",
            quoted(&self.by),
            quoted(&self.file),
        )?;
        if !self.objects.is_empty() {
            let names: Vec<String> = self.objects.iter().map(|name| quoted(name)).collect();
            writeln!(text, "objects = [{}]", names.join(", "))?;
        }
        let lengths_m = [
            ("size_m", self.size_m),
            ("unit_m", self.unit_m),
            ("wall_m", self.wall_m),
        ];
        for (field, length_m) in lengths_m {
            if let Some(length_m) = length_m {
                writeln!(text, "{field} = {length_m:?}")?;
            }
        }
        writeln!(text, "up = {}", quoted(self.up.name()))?;
        let material = quoted(material(&self.material));
        write!(text, "\n[{within}material]\nname = {material}\n")
    }
}

/// A text as TOML quotes it: as JSON does.
fn quoted(text: &str) -> String {
    serde_json::Value::from(text).to_string()
}

/// A name fit for a bank.
fn plain(stem: &str) -> String {
    let letter = |c: char| {
        let c = c.to_ascii_lowercase();
        if c.is_ascii_lowercase() || c.is_ascii_digit() || c == '-' || c == '_' {
            c
        } else {
            '-'
        }
    };
    let name: String = stem.chars().take(64).map(letter).collect();
    if name.is_empty() { "mesh".into() } else { name }
}

/// The known material of that name, or the only one whose name has it in it.
fn material(name: &str) -> &str {
    let wanted = name.trim().to_lowercase();
    let mut names = NAMED_MATERIALS.iter().map(|entry| entry.name);
    if names.any(|known| known.to_lowercase() == wanted) {
        return name;
    }
    let mut parts = NAMED_MATERIALS
        .iter()
        .filter(|entry| entry.name.to_lowercase().contains(&wanted));
    match (parts.next(), parts.next()) {
        (Some(only), None) => only.name,
        _ => name,
    }
}
