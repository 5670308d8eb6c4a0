//! A mesh to a bank, by options or by a recipe.

use crate::progress;
use anyhow::{Context, Result, bail};
use clap::Args;
use modes::freeform::{Made, make};
use modes::{FreeRecipe, NAMED_MATERIALS};
use std::fmt::Write as _;
use std::path::{Path, PathBuf};

/// What to make of a mesh.
#[derive(Args, Debug, Default)]
pub struct MeshOptions {
    /// Make a bank of the shape in this OBJ file
    #[arg(long, value_name = "FILE", conflicts_with = "name")]
    pub mesh: Option<PathBuf>,
    /// Only the object of this name in the file
    #[arg(long, value_name = "NAME", requires = "mesh")]
    pub object: Option<String>,
    /// What it is made of
    #[arg(long, value_name = "NAME", requires = "mesh")]
    pub material: Option<String>,
    /// Longest side of its bounding box, in m; without, the file is in metres
    #[arg(
        long,
        value_name = "M",
        requires = "mesh",
        allow_negative_numbers = true
    )]
    pub size: Option<f64>,
    /// Thickness of its wall, in m; without, it is solid
    #[arg(
        long,
        value_name = "M",
        requires = "mesh",
        allow_negative_numbers = true
    )]
    pub wall: Option<f64>,
    /// Lowest and highest MIDI key
    #[arg(long, value_names = ["LOW", "HIGH"], num_args = 2, default_values_t = [36, 96])]
    pub keys: Vec<u8>,
    /// What changes from key to key: size, density, stiffness or nothing
    #[arg(long, value_name = "WHAT", default_value = "size")]
    pub by: String,
    /// The mode that is tuned: lowest, loudest or its number
    #[arg(long, value_name = "MODE", default_value = "lowest")]
    pub tuned: String,
    /// Nodes of the mesh of tetrahedra, about: more are slower and nearer to the truth
    #[arg(long, value_name = "N", default_value_t = 20_000)]
    pub nodes: u32,
    /// File to write; without, the mesh's or recipe's name with `.bank`, here
    #[arg(short, long, value_name = "FILE")]
    pub output: Option<PathBuf>,
}

/// Named when no other material is.
const USUAL: &str = "bell bronze";

impl MeshOptions {
    /// The recipe that the options amount to, if they name a mesh.
    pub(crate) fn recipe(&self) -> Result<Option<FreeRecipe>> {
        let Some(mesh) = &self.mesh else {
            return Ok(None);
        };
        let text = self.text(mesh)?;
        Ok(Some(FreeRecipe::parse(&text, "--mesh", Path::new(""))?))
    }

    /// The same in words, for the bank to carry.
    fn text(&self, mesh: &Path) -> Result<String> {
        let Some(file) = mesh.to_str() else {
            bail!("{}: name the file in Unicode", mesh.display());
        };
        let stem = mesh.file_stem().unwrap_or_default().to_string_lossy();
        let material = material(self.material.as_deref().unwrap_or(USUAL));
        let mode = match self.tuned.parse::<i64>() {
            Ok(number) => number.to_string(),
            Err(_) => quoted(&self.tuned)?,
        };
        let [low, high] = [self.keys[0], self.keys[1]];
        let mut text = format!(
            "name = {}\ntitle = {}\n\n[keys]\nlow = {low}\nhigh = {high}\n\n[tuning]\nby = {}\n\
             mode = {mode}\n\n[body]\nshape = \"mesh\"\nfile = {}\n",
            quoted(&plain(&stem))?,
            quoted(&stem)?,
            quoted(&self.by)?,
            quoted(file)?,
        );
        // Writing to a string cannot fail.
        if let Some(object) = &self.object {
            let _ = writeln!(text, "object = {}", quoted(object)?);
        }
        if let Some(size_m) = self.size {
            let _ = writeln!(text, "size_m = {size_m:?}");
        }
        if let Some(wall_m) = self.wall {
            let _ = writeln!(text, "wall_m = {wall_m:?}");
        }
        let (material, nodes) = (quoted(material)?, self.nodes);
        let _ = write!(
            text,
            "\n[material]\nname = {material}\n\n[mesh]\nnodes = {nodes}\n"
        );
        Ok(text)
    }

    /// Makes the bank and writes it; the file, and what was made.
    pub(crate) fn make(&self, recipe: &FreeRecipe) -> Result<(PathBuf, Made)> {
        let own = || PathBuf::from(format!("{}.bank", recipe.name));
        let path = self.output.clone().unwrap_or_else(own);
        let made = progress::with_bar(&recipe.name, |bar| make(recipe, bar))?;
        made.bank.save(&path)?;
        Ok((path, made))
    }
}

/// The recipe in the file of this name, if it is one of a mesh.
pub(crate) fn recipe(name: &str) -> Result<Option<FreeRecipe>> {
    let path = Path::new(name);
    if path.extension().is_none_or(|extension| extension != "toml") {
        return Ok(None);
    }
    let text = std::fs::read_to_string(path).with_context(|| format!("{name}: cannot read"))?;
    if !FreeRecipe::is_meant(&text) {
        return Ok(None);
    }
    Ok(Some(FreeRecipe::load(path)?))
}

/// A text as TOML quotes it: as JSON does.
fn quoted(text: &str) -> Result<String> {
    Ok(serde_json::to_string(text)?)
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

#[cfg(test)]
mod tests {
    use super::*;

    fn options() -> MeshOptions {
        MeshOptions {
            mesh: Some("shapes/My \"Bell\".obj".into()),
            material: Some("bronze".into()),
            size: Some(0.2),
            wall: Some(0.004),
            keys: vec![48, 84],
            by: "size".into(),
            tuned: "2".into(),
            nodes: 5000,
            ..MeshOptions::default()
        }
    }

    #[test]
    fn options_amount_to_a_recipe() {
        let recipe = options().recipe().unwrap().unwrap();
        assert_eq!(recipe.name, "my--bell-");
        assert_eq!(recipe.title, "My \"Bell\"");
        assert_eq!(recipe.shape.file, Path::new("shapes/My \"Bell\".obj"));
        assert_eq!(recipe.shape.size_m, Some(0.2));
        assert_eq!(recipe.tuning.mode, modes::TunedMode::Number(2));
        let bronze = modes::Material::named("bell bronze").unwrap();
        assert_eq!(recipe.material, bronze);
        assert!(MeshOptions::default().recipe().unwrap().is_none());
    }

    #[test]
    fn options_out_of_range_are_named() {
        let wrong = MeshOptions {
            by: "weight".into(),
            ..options()
        };
        let error = wrong.recipe().unwrap_err().to_string();
        assert!(
            error.contains("tuning.by is \"weight\", but must be"),
            "{error}"
        );
        let unknown = MeshOptions {
            material: Some("cheese".into()),
            ..options()
        };
        let error = unknown.recipe().unwrap_err().to_string();
        assert!(error.contains("material.name is \"cheese\""), "{error}");
    }
}
