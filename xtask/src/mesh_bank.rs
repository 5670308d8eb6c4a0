//! A mesh to a bank, by options or by a recipe.

use crate::progress;
use anyhow::{Context, Result, bail};
use clap::Args;
use modes::freeform::{Made, make};
use modes::{FreeFineness, FreeRecipe, MeshOrder, PieceOrder, Up};
use std::path::{Path, PathBuf};

/// What to make of a mesh.
#[derive(Args, Debug, Default)]
pub struct MeshOptions {
    /// Make a bank of the shape in this OBJ file
    #[arg(long, value_name = "FILE", conflicts_with = "name")]
    pub mesh: Option<PathBuf>,
    /// Only the object of this name in the file; of several, all together are one body
    #[arg(long, value_name = "NAME", requires = "mesh")]
    pub object: Vec<String>,
    /// What it is made of
    #[arg(long, value_name = "NAME", requires = "mesh")]
    pub material: Option<String>,
    /// Longest side of its bounding box, in m; without, the unit tells the size
    #[arg(
        long,
        value_name = "M",
        requires = "mesh",
        allow_negative_numbers = true
    )]
    pub size: Option<f64>,
    /// What one of the file's units is, in m; without either, the file is in metres
    #[arg(long, value_name = "M", requires = "mesh", conflicts_with = "size")]
    pub unit: Option<f64>,
    /// Which of the file's axes points up: x, y or z
    #[arg(long, value_name = "AXIS", requires = "mesh", default_value = "z", value_parser = axis)]
    pub up: Up,
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
        let Some(file) = mesh.to_str() else {
            bail!("{}: name the file in Unicode", mesh.display());
        };
        let piece = PieceOrder {
            file: file.to_owned(),
            objects: self.object.clone(),
            material: self.material.clone().unwrap_or_else(|| USUAL.to_owned()),
            size_m: self.size,
            unit_m: self.unit,
            wall_m: self.wall,
            up: self.up,
            keys: [self.keys[0], self.keys[1]],
            by: self.by.clone(),
            tuned: self.tuned.clone(),
        };
        let order = MeshOrder {
            title: None,
            pieces: vec![piece],
            nodes: self.nodes,
            most_modes: FreeFineness::default().most_modes as u32,
        };
        Ok(Some(order.recipe("--mesh")?))
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

fn axis(name: &str) -> Result<Up, String> {
    Up::named(name).ok_or_else(|| "give x, y or z".to_owned())
}

/// The recipe in the file of this name, if it is one of meshes.
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

#[cfg(test)]
mod tests {
    use super::*;

    fn options() -> MeshOptions {
        MeshOptions {
            mesh: Some("shapes/My \"Bell\".obj".into()),
            material: Some("bronze".into()),
            object: vec!["bell".into(), "loop".into()],
            size: Some(0.2),
            up: Up::Y,
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
        let piece = &recipe.pieces[0];
        assert_eq!(piece.shape.file, Path::new("shapes/My \"Bell\".obj"));
        assert_eq!(piece.shape.objects, ["bell", "loop"]);
        assert_eq!(piece.shape.scale, modes::MeshScale::Longest(0.2));
        assert_eq!(piece.shape.up, Up::Y);
        assert_eq!(piece.tuning.mode, modes::TunedMode::Number(2));
        let bronze = modes::Material::named("bell bronze").unwrap();
        assert_eq!(piece.material, bronze);
        assert!(MeshOptions::default().recipe().unwrap().is_none());
    }

    #[test]
    fn the_kit_that_people_are_shown_is_a_recipe() {
        let read_me = include_str!("../../README.md");
        let mut blocks = read_me.split("```toml\n").skip(1);
        let kit = blocks.find(|block| block.contains("[[piece]]")).unwrap();
        let text = kit.split("```").next().unwrap();
        assert!(FreeRecipe::is_meant(text));
        let recipe = FreeRecipe::parse(text, "kit.toml", Path::new("")).unwrap();
        assert_eq!(recipe.pieces.len(), 2);
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
