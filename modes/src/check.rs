//! The physics held against theory and published tables, a row for each comparison.

mod bank;
mod beam;
mod chimes_2002;
mod decay;
mod mesh;
mod row;
mod tetrahedra;
mod vibraphone;

pub use row::Row;

use crate::bar::BarTuneError;
use crate::factory::BuildError;
use crate::shape::Tube;
use crate::solve::SolveError;
use crate::tube::Fineness;
use crate::{Material, RecipeError, TABLE_1, TuneError};

/// Why a comparison could not be made.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum CheckError {
    /// An eigenproblem was not solved.
    #[error(transparent)]
    Solve(#[from] SolveError),
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

/// A group of comparisons.
type Group = fn() -> Result<Vec<Row>, CheckError>;

/// The groups by name, in the order in which they are told.
pub const GROUPS: [(&str, Group); 7] = [
    ("bending of a free tube", beam::rows),
    ("the chimes of O'Brien 2002", chimes_2002::rows),
    ("decay rates of O'Brien 2002", decay::rows),
    ("meshes", mesh::rows),
    ("linear tetrahedra", tetrahedra::rows),
    ("vibraphone bars", vibraphone::rows),
    ("the chimes bank", bank::rows),
];
