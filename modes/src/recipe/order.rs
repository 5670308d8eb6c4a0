//! A recipe of a mesh, written from what somebody has chosen.

use super::{FreeRecipe, RecipeError};
use crate::NAMED_MATERIALS;
use std::fmt::Write as _;
use std::path::Path;

/// What to make of a mesh: each field as recipes have it.
#[derive(Clone, Debug, PartialEq)]
pub struct MeshOrder {
    /// The mesh's file.
    pub file: String,
    /// The one of its objects that is meant; without, all.
    pub object: Option<String>,
    /// What it is made of: a known name, or a part of just one.
    pub material: String,
    /// Longest side of its bounding box, in m; without, the file is in metres.
    pub size_m: Option<f64>,
    /// Thickness of its wall, in m; without, it is solid.
    pub wall_m: Option<f64>,
    /// Lowest and highest MIDI key.
    pub keys: [u8; 2],
    /// What changes from key to key: size, density, stiffness or nothing.
    pub by: String,
    /// The mode that is tuned: lowest, loudest or its number.
    pub tuned: String,
    /// Nodes of the mesh of tetrahedra, about.
    pub nodes: u32,
    /// Modes at most.
    pub most_modes: u32,
}

impl MeshOrder {
    /// The recipe that it amounts to; errors call it `name`.
    ///
    /// # Errors
    ///
    /// If a value is out of its range.
    pub fn recipe(&self, name: &str) -> Result<FreeRecipe, RecipeError> {
        FreeRecipe::parse(&self.text(), name, Path::new(""))
    }

    /// The file's name without its ending: the instrument's for people.
    fn title(&self) -> String {
        let stem = Path::new(&self.file).file_stem().unwrap_or_default();
        stem.to_string_lossy().into_owned()
    }

    /// The instrument's name, fit for a file.
    #[must_use]
    pub fn name(&self) -> String {
        plain(&self.title())
    }

    /// The same in words, for the bank to carry.
    fn text(&self) -> String {
        let mode = match self.tuned.parse::<i64>() {
            Ok(number) => number.to_string(),
            Err(_) => quoted(&self.tuned),
        };
        let [low, high] = self.keys;
        let mut text = format!(
            "name = {}\ntitle = {}\n\n[keys]\nlow = {low}\nhigh = {high}\n\n[tuning]\nby = {}\n\
             mode = {mode}\n\n[body]\nshape = \"mesh\"\nfile = {}\n",
            quoted(&self.name()),
            quoted(&self.title()),
            quoted(&self.by),
            quoted(&self.file),
        );
        // Writing to a string cannot fail.
        if let Some(object) = &self.object {
            let _ = writeln!(text, "object = {}", quoted(object));
        }
        if let Some(size_m) = self.size_m {
            let _ = writeln!(text, "size_m = {size_m:?}");
        }
        if let Some(wall_m) = self.wall_m {
            let _ = writeln!(text, "wall_m = {wall_m:?}");
        }
        let material = quoted(material(&self.material));
        let Self {
            nodes, most_modes, ..
        } = self;
        let _ = write!(
            text,
            "\n[material]\nname = {material}\n\n[mesh]\nnodes = {nodes}\nmost_modes = {most_modes}\n"
        );
        text
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
