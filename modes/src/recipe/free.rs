//! A recipe for a body of any shape, from a mesh.

use super::check::{
    check_keys, check_listener, check_matter, check_name, check_title, given, within,
};
use super::error::Fault;
use super::raw::{RawDamping, RawKeys, RawListener, RawMaterial, from_toml};
use super::{KeyRange, ListenerRecipe, LossRecipe, RecipeError, RecipeFileError, read_text};
use crate::{Damping, Material, SpreadRule};
use serde::Deserialize;
use std::path::{Path, PathBuf};

/// An instrument to be built of a mesh. Every number is within its range.
#[derive(Clone, Debug, PartialEq)]
pub struct FreeRecipe {
    /// Name of the instrument, fit for a file.
    pub name: String,
    /// Name of the instrument for people.
    pub title: String,
    /// The keys to play it on.
    pub keys: KeyRange,
    /// How each key gets its pitch.
    pub tuning: FreeTuning,
    /// The shape.
    pub shape: MeshShape,
    /// What the body is made of.
    pub material: Material,
    /// Inner damping of the material.
    pub damping: Damping,
    /// What supports and felt take.
    pub losses: LossRecipe,
    /// Where the listener is.
    pub listener: ListenerRecipe,
    /// How finely the body is divided, and how far its modes go.
    pub fineness: FreeFineness,
    /// The recipe word for word.
    pub text: String,
}

/// How one body is tuned to many keys.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FreeTuning {
    /// What changes from key to key.
    pub rule: SpreadRule,
    /// Pitch of key 69, in Hz.
    pub a4_hz: f64,
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

/// A shape out of a file.
#[derive(Clone, Debug, PartialEq)]
pub struct MeshShape {
    /// The file, in Wavefront's OBJ format.
    pub file: PathBuf,
    /// The one of its objects that is meant; without, all.
    pub object: Option<String>,
    /// Longest side of its bounding box, in m; without, the file's units are metres.
    pub size_m: Option<f64>,
    /// Thickness of its wall, in m; without, it is solid.
    pub wall_m: Option<f64>,
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

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Raw {
    name: String,
    title: Option<String>,
    keys: RawKeys,
    #[serde(default)]
    tuning: RawTuning,
    body: RawBody,
    material: RawMaterial,
    damping: Option<RawDamping>,
    #[serde(default)]
    listener: RawListener,
    #[serde(default)]
    mesh: RawMesh,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields, default)]
struct RawTuning {
    a4_hz: f64,
    by: String,
    mode: RawMode,
}

#[derive(Deserialize)]
#[serde(untagged)]
enum RawMode {
    Number(i64),
    Name(String),
}

impl Default for RawTuning {
    fn default() -> Self {
        Self {
            a4_hz: 440.0,
            by: "size".into(),
            mode: RawMode::Name("lowest".into()),
        }
    }
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct RawBody {
    shape: String,
    file: Option<String>,
    object: Option<String>,
    size_m: Option<f64>,
    wall_m: Option<f64>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields, default)]
struct RawMesh {
    nodes: i64,
    highest_hz: f64,
    most_modes: i64,
}

impl Default for RawMesh {
    fn default() -> Self {
        let FreeFineness {
            nodes,
            highest_hz,
            most_modes,
        } = FreeFineness::default();
        Self {
            nodes: nodes as i64,
            highest_hz,
            most_modes: most_modes as i64,
        }
    }
}

impl FreeRecipe {
    /// The recipe that `text` gives, with `shape = "mesh"` in its body. `file_name` is what errors call
    /// it; the mesh's file is looked for in `folder`.
    ///
    /// # Errors
    ///
    /// If the text is no TOML, has wrong fields, or a value is out of its range.
    pub fn parse(text: &str, file_name: &str, folder: &Path) -> Result<Self, RecipeError> {
        from_toml::<Raw>(text)
            .and_then(|raw| raw.check(text, folder))
            .map_err(|fault| fault.into_error(file_name))
    }

    /// The recipe in the file at `path`; the mesh's file is looked for beside it.
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

    /// Whether `text` is a recipe of a mesh, and none of a tube, a bar or a bowl.
    #[must_use]
    pub fn is_meant(text: &str) -> bool {
        let table: Result<toml::Table, _> = toml::from_str(text);
        let shape = table.ok().and_then(|table| {
            let body = table.get("body")?.as_table()?;
            Some(body.get("shape")?.as_str()? == "mesh")
        });
        shape.unwrap_or(false)
    }
}

impl Raw {
    fn check(self, text: &str, folder: &Path) -> Result<FreeRecipe, Fault> {
        let (material, damping, losses) = check_matter(&self.material, self.damping.as_ref())?;
        Ok(FreeRecipe {
            title: check_title(self.title.unwrap_or_else(|| self.name.clone()))?,
            name: check_name(self.name)?,
            keys: check_keys(&self.keys)?,
            tuning: self.tuning.check()?,
            shape: self.body.check(folder)?,
            material,
            damping,
            losses,
            listener: check_listener(&self.listener)?,
            fineness: self.mesh.check()?,
            text: text.to_owned(),
        })
    }
}

impl RawTuning {
    fn check(&self) -> Result<FreeTuning, Fault> {
        let rule = match self.by.as_str() {
            "size" => SpreadRule::Size,
            "density" => SpreadRule::Density,
            "stiffness" => SpreadRule::Stiffness,
            "nothing" => SpreadRule::Fixed,
            other => {
                let allowed = "\"size\", \"density\", \"stiffness\" or \"nothing\"";
                return Err(Fault::field("tuning.by", format!("{other:?}"), allowed));
            }
        };
        let refused = |value: String| {
            let allowed = "\"lowest\", \"loudest\" or a number from 1 to 1000";
            Err(Fault::field("tuning.mode", value, allowed))
        };
        let mode = match &self.mode {
            RawMode::Name(name) if name == "lowest" => TunedMode::Lowest,
            RawMode::Name(name) if name == "loudest" => TunedMode::Loudest,
            RawMode::Name(other) => return refused(format!("{other:?}")),
            RawMode::Number(number) => match u32::try_from(*number) {
                Ok(number @ 1..=1000) => TunedMode::Number(number),
                _ => return refused(number.to_string()),
            },
        };
        Ok(FreeTuning {
            rule,
            a4_hz: within("tuning.a4_hz", self.a4_hz, 300.0..=600.0)?,
            mode,
        })
    }
}

impl RawBody {
    fn check(self, folder: &Path) -> Result<MeshShape, Fault> {
        if self.shape != "mesh" {
            let value = format!("{:?}", self.shape);
            return Err(Fault::field(
                "body.shape",
                value,
                "\"mesh\" in a recipe of a mesh",
            ));
        }
        let file = given("body.file", self.file)?;
        let size_m = self.size_m;
        let size_m = size_m.map(|size_m| within("body.size_m", size_m, 0.001..=10.0));
        let wall_m = self.wall_m;
        let wall_m = wall_m.map(|wall_m| within("body.wall_m", wall_m, 0.0002..=1.0));
        Ok(MeshShape {
            file: folder.join(file),
            object: self.object,
            size_m: size_m.transpose()?,
            wall_m: wall_m.transpose()?,
        })
    }
}

impl RawMesh {
    fn check(&self) -> Result<FreeFineness, Fault> {
        let count = |field, x: i64, least: i64, most: i64| {
            if (least..=most).contains(&x) {
                return Ok(usize::try_from(x).unwrap_or_default());
            }
            let allowed = format!("a whole number from {least} to {most}");
            Err(Fault::field(field, x, allowed))
        };
        Ok(FreeFineness {
            nodes: count("mesh.nodes", self.nodes, 500, 200_000)?,
            highest_hz: within("mesh.highest_hz", self.highest_hz, 1e3..=20e3)?,
            most_modes: count("mesh.most_modes", self.most_modes, 1, 1000)?,
        })
    }
}
