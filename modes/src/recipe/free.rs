//! A recipe for bodies of any shape, from meshes.

mod check;
mod mesh;
mod raw;

pub use mesh::{MeshScale, MeshShape, Up};

use super::raw::from_toml;
use super::{KeyRange, ListenerRecipe, LossRecipe, RecipeError, RecipeFileError, read_text};
use crate::{Damping, Material, SpreadRule};
use raw::Raw;
use std::path::Path;

/// An instrument to be built of meshes. Every number is within its range.
#[derive(Clone, Debug, PartialEq)]
pub struct FreeRecipe {
    /// Name of the instrument, fit for a file.
    pub name: String,
    /// Name of the instrument for people.
    pub title: String,
    /// Pitch of key 69, in Hz.
    pub a4_hz: f64,
    /// Its bodies by rising keys, at least one; no two share a key.
    pub pieces: Vec<Piece>,
    /// Where the listener is.
    pub listener: ListenerRecipe,
    /// The recipe word for word.
    pub text: String,
}

/// One body and the keys that play it.
#[derive(Clone, Debug, PartialEq)]
pub struct Piece {
    /// The keys to play it on.
    pub keys: KeyRange,
    /// How each of them gets its pitch.
    pub tuning: FreeTuning,
    /// The shape.
    pub shape: MeshShape,
    /// What the body is made of.
    pub material: Material,
    /// Inner damping of the material.
    pub damping: Damping,
    /// What supports and felt take.
    pub losses: LossRecipe,
    /// How finely the body is divided, and how far its modes go.
    pub fineness: FreeFineness,
}

/// How one body is tuned to many keys.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FreeTuning {
    /// What changes from key to key.
    pub rule: SpreadRule,
    /// The mode that carries the pitch.
    pub mode: TunedMode,
}

/// Which mode carries the pitch.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum TunedMode {
    /// The lowest.
    Lowest,
    /// The one that a blow where it moves most makes loudest.
    Loudest,
    /// This one, counted from 1 by rising frequency.
    Number(u32),
}

/// How finely a body is divided, and how far its modes go.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FreeFineness {
    /// Nodes of the mesh, about.
    pub nodes: usize,
    /// Highest frequency of a mode on any key, in Hz.
    pub highest_hz: f64,
    /// How many modes at most.
    pub most_modes: usize,
}

impl Default for FreeFineness {
    fn default() -> Self {
        Self {
            nodes: 20_000,
            highest_hz: 20_000.0,
            most_modes: 200,
        }
    }
}

impl FreeRecipe {
    /// The recipe that `text` gives: of one mesh, with `shape = "mesh"` in its body, or of several, each a
    /// `[[piece]]`. `file_name` is what errors call it; the meshes' files are looked for in `folder`.
    ///
    /// # Errors
    ///
    /// If the text is no TOML, has wrong fields, a value is out of its range, or two pieces share a key.
    pub fn parse(text: &str, file_name: &str, folder: &Path) -> Result<Self, RecipeError> {
        from_toml::<Raw>(text)
            .and_then(|raw| raw.check(text, folder))
            .map_err(|fault| fault.into_error(file_name))
    }

    /// The recipe in the file at `path`; the meshes' files are looked for beside it.
    ///
    /// # Errors
    ///
    /// If the file cannot be read as UTF-8 text or [`Self::parse`] refuses it.
    pub fn load(path: impl AsRef<Path>) -> Result<Self, RecipeFileError> {
        let path = path.as_ref();
        let text = read_text(path).map_err(|error| RecipeFileError::Read {
            path: path.to_path_buf(),
            error,
        })?;
        let folder = path.parent().unwrap_or(Path::new(""));
        Ok(Self::parse(&text, &path.display().to_string(), folder)?)
    }

    /// Whether `text` is a recipe of meshes, and none of a tube, a bar or a bowl.
    #[must_use]
    pub fn is_meant(text: &str) -> bool {
        let Ok(table) = toml::from_str::<toml::Table>(text) else {
            return false;
        };
        let shape = || table.get("body")?.as_table()?.get("shape")?.as_str();
        table.contains_key("piece") || shape() == Some("mesh")
    }
}
