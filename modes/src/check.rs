//! The physics held against theory and published tables, a row for each comparison.

mod bank;
mod beam;
mod bowls_2002;
mod chimes_2002;
mod clamped;
mod converged;
mod decay;
mod heard;
mod mesh;
mod obj_tubes;
mod recorded;
mod retune;
mod row;
mod shapes_1998;
mod shells;
mod special;
mod tetrahedra;
mod vibraphone;

pub use row::Row;

use crate::bar::BarTuneError;
use crate::factory::BuildError;
use crate::revolution::{LAYERS, Wall, bowl};
use crate::shape::Tube;
use crate::solid::MeshError;
use crate::solve::SolveError;
use crate::tube::Fineness;
use crate::{BankError, Material, Recipe, RecipeError, ShapeRecipe, TABLE_1, TuneError};

/// Why a comparison could not be made.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum CheckError {
    /// An eigenproblem was not solved.
    #[error(transparent)]
    Solve(#[from] SolveError),
    /// A surface gave no mesh.
    #[error(transparent)]
    Mesh(#[from] MeshError),
    /// A tube could not be tuned.
    #[error(transparent)]
    Tune(#[from] TuneError),
    /// A bar could not be tuned.
    #[error(transparent)]
    TuneBar(#[from] BarTuneError),
    /// The factory recipe does not parse.
    #[error(transparent)]
    Recipe(#[from] RecipeError),
    /// The factory recipe gave no bank.
    #[error(transparent)]
    Build(#[from] BuildError),
    /// The factory's bank does not read.
    #[error(transparent)]
    Bank(#[from] BankError),
}

/// The chime of Tables 1 and 2 that the paper calls D3.
const CHIME: Tube = Tube::D5;

/// The mesh of the factory's chimes.
const SHIPPED: Fineness = Fineness {
    around: 48,
    max_element_m: 0.006,
};

fn aluminium() -> Material {
    TABLE_1[0].material
}

/// The factory's recipe `name`.
fn factory(name: &str) -> Result<Recipe, CheckError> {
    let found = Recipe::FACTORY.iter().find(|(other, _)| *other == name);
    let (name, text) = found.expect("checks name factory recipes");
    Ok(Recipe::parse(text, name)?)
}

/// The bowl that `recipe` draws, before it is scaled to a pitch, of cells `coarser` times as long.
fn bowl_wall(recipe: &Recipe, coarser: f64) -> Result<Wall, CheckError> {
    let ShapeRecipe::Bowl(shape) = &recipe.shape else {
        unreachable!("{} are bowls", recipe.name)
    };
    let wall = bowl(shape, coarser * recipe.mesh.max_element_m, LAYERS);
    Ok(wall.map_err(TuneError::Profile)?)
}

/// From one pitch to another, in cents, without the sign.
fn cents(hz: f64, reference_hz: f64) -> f64 {
    1200.0 * (hz / reference_hz).log2().abs()
}

/// The greater of two figures; `max` would drop a NaN.
fn greater(worst: f64, figure: f64) -> f64 {
    if figure <= worst { worst } else { figure }
}

/// A group of comparisons.
type Group = fn() -> Result<Vec<Row>, CheckError>;

/// The groups by name, in the order in which they are told.
pub const GROUPS: [(&str, Group); 16] = [
    ("bending of a free tube", beam::rows),
    ("rings and shells", shells::rows),
    ("clamped bars and plates, hollow cubes", clamped::rows),
    ("the chimes of O'Brien 2002", chimes_2002::rows),
    ("decay rates of O'Brien 2002", decay::rows),
    ("the bowls of O'Brien 2002", bowls_2002::rows),
    ("meshes", mesh::rows),
    ("linear tetrahedra", tetrahedra::rows),
    ("special paths", special::rows),
    ("tubes out of OBJ files", obj_tubes::rows),
    ("vibraphone bars", vibraphone::rows),
    ("recordings", recorded::rows),
    ("what is heard", heard::rows),
    ("convergence", converged::rows),
    ("the shapes of van den Doel & Pai 1998", shapes_1998::rows),
    ("the factory banks", bank::rows),
];
