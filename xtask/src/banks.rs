//! Banks by name: their recipes, the folder that keeps them, the matrices they came from.

use crate::{progress, workspace};
use anyhow::{Context, Result, bail};
use modes::fem::{Pencil, TetMass, assemble};
use modes::mesh::tube_hex20;
use modes::shape::Tube;
use modes::tube::Fineness;
use modes::{Recipe, ShapeRecipe, factory};
use std::path::{Path, PathBuf};
use std::time::Instant;

/// A bank that lies ready.
#[derive(Debug)]
pub(crate) struct Built {
    /// The bank.
    pub(crate) bank: modes::Bank,
    /// Its file.
    pub(crate) path: PathBuf,
    /// What it took to compute, in s; `None` if it lay ready.
    pub(crate) seconds: Option<f64>,
}

/// Names of the recipes that come with the repository.
pub(crate) fn names() -> Result<Vec<String>> {
    let folder = workspace::recipes();
    let entries =
        std::fs::read_dir(&folder).with_context(|| format!("{}: cannot read", folder.display()))?;
    let mut names: Vec<_> = entries
        .filter_map(|entry| {
            let path = entry.ok()?.path();
            let is_recipe = path.extension()? == "toml";
            is_recipe.then(|| path.file_stem()?.to_str().map(str::to_owned))?
        })
        .collect();
    names.sort();
    Ok(names)
}

/// The recipe of this name, or in the file of this name if it ends in `.toml`.
pub(crate) fn recipe(name: &str) -> Result<Recipe> {
    let file = Path::new(name);
    if file
        .extension()
        .is_some_and(|extension| extension == "toml")
    {
        return Ok(Recipe::load(file)?);
    }
    let names = names()?;
    if !names.iter().any(|known| known == name) {
        bail!(
            "no bank `{name}`; allowed: {}, or a recipe's file",
            names.join(", ")
        );
    }
    let file = workspace::recipes().join(format!("{name}.toml"));
    Ok(Recipe::load(file)?)
}

/// Computes a bank under a bar, unless it lies ready from the same recipe and the same code.
pub(crate) fn precompute(name: &str, force: bool) -> Result<Built> {
    let recipe = recipe(name)?;
    let folder = workspace::banks()?;
    let start = Instant::now();
    let built = progress::with_bar(&recipe.name, |bar| {
        factory::cached(&recipe, &folder, force, bar)
    })
    .with_context(|| name.to_owned())?;
    Ok(Built {
        bank: built.bank.spread_out(),
        path: built.path,
        seconds: (!built.found).then(|| start.elapsed().as_secs_f64()),
    })
}

/// Stiffness and mass of one of a bank's bodies, free in space.
pub(crate) fn matrices(name: &str, key: u8) -> Result<Pencil> {
    let recipe = recipe(name)?;
    let bank = precompute(name, false)?.bank;
    let length_m = body(&bank, key)?.length_m;
    let ShapeRecipe::Tube {
        outer_radius_m,
        wall_m,
        ..
    } = recipe.shape
    else {
        bail!("{name}: only the matrices of tubes can be exported; allowed: chimes");
    };
    let tube = Tube {
        outer_radius_m,
        wall_m,
        length_m,
    };
    let fineness = Fineness {
        around: usize::from(recipe.mesh.around),
        max_element_m: recipe.mesh.max_element_m,
    };
    let mesh = tube_hex20(&tube, fineness.grid(&tube));
    Ok(assemble(&mesh, &recipe.material, TetMass::Consistent)?)
}

/// The body of a key.
pub(crate) fn body(bank: &modes::Bank, key: u8) -> Result<&modes::Body> {
    let end = |body: Option<&modes::Body>| body.map_or(0, |body| body.key);
    let found = bank.bodies.iter().find(|body| body.key == key);
    found.with_context(|| {
        format!(
            "--key {key}: not in the bank {}; allowed: {}…{}",
            bank.name,
            end(bank.bodies.first()),
            end(bank.bodies.last())
        )
    })
}
