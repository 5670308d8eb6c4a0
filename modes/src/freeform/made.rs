//! From a recipe of a mesh to its bank: the file read, repaired, filled and solved.

use super::{FreeError, free_bank};
use crate::factory::Progress;
use crate::solid::{
    MeshError, Meshing, Note, ObjError, Repair, Resolution, mesh_solid, read_obj, repair,
};
use crate::{Bank, FreeRecipe};
use std::ops::ControlFlow;

/// An instrument made of a mesh.
#[derive(Clone, Debug, PartialEq)]
pub struct Made {
    /// The instrument.
    pub bank: Bank,
    /// What its owner should know of the mesh.
    pub notes: Vec<Note>,
}

/// Why a recipe of a mesh gave no instrument.
#[derive(Debug, thiserror::Error)]
pub enum MadeError {
    /// The file is no mesh.
    #[error(transparent)]
    Obj(#[from] ObjError),
    /// The mesh is no solid.
    #[error("{file}: {error}")]
    Mesh {
        /// The mesh's file.
        file: String,
        /// Why not.
        error: MeshError,
    },
    /// The solid gives no bank.
    #[error("{file}: {error}")]
    Free {
        /// The mesh's file.
        file: String,
        /// Why not.
        error: FreeError,
    },
}

/// Steps of work that are told, and those of them that meshing takes.
const STEPS: usize = 100;
const MESHING: usize = 15;

/// Makes the instrument of `recipe`.
///
/// # Errors
///
/// [`MadeError`]; [`MeshError::Cancelled`] or [`crate::SolveError::Cancelled`] in it when `progress`
/// breaks.
pub fn make(recipe: &FreeRecipe, progress: &dyn Progress) -> Result<Made, MadeError> {
    let file = || recipe.shape.file.display().to_string();
    let mesh_error = |error| MadeError::Mesh {
        file: file(),
        error,
    };
    let obj = read_obj(&recipe.shape.file)?;
    let soup = match &recipe.shape.object {
        Some(name) => obj.soup.object(name).map_err(mesh_error)?,
        None => obj.soup,
    };
    let surface = repair(
        &soup,
        &Repair {
            size_m: recipe.shape.size_m,
            ..Repair::default()
        },
    );
    let meshing = Meshing {
        wall_m: recipe.shape.wall_m,
        resolution: Resolution::Nodes(recipe.fineness.nodes),
        ..Meshing::default()
    };
    let meshed = surface.and_then(|surface| mesh_solid(&surface, &meshing, &First(progress)));
    let meshed = meshed.map_err(mesh_error)?;
    let watch = |converged: usize, wanted: usize| {
        let share = (STEPS - MESHING) * converged / wanted.max(1);
        progress.advance(MESHING + share.min(STEPS - MESHING), STEPS)
    };
    let bank = free_bank(recipe, &meshed.mesh, &watch);
    let bank = bank.map_err(|error| MadeError::Free {
        file: file(),
        error,
    })?;
    let mut notes = obj.notes;
    notes.extend(meshed.notes);
    Ok(Made { bank, notes })
}

/// Told of the first steps.
struct First<'a>(&'a dyn Progress);

impl Progress for First<'_> {
    fn advance(&self, done: usize, total: usize) -> ControlFlow<()> {
        self.0.advance(MESHING * done / total.max(1), STEPS)
    }
}
