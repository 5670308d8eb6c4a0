//! From a recipe of meshes to its bank: the files read, repaired, filled and solved.

use super::bank::{FreeError, SolvedPiece, free_bank, solved_piece};
use crate::factory::Progress;
use crate::solid::{
    MeshError, Meshing, Note, ObjError, ObjFile, Repair, Resolution, mesh_solid, read_obj, repair,
};
use crate::{Bank, FreeRecipe, MeshScale, MeshShape, Piece};
use std::fmt::{self, Display, Formatter};
use std::ops::ControlFlow;
use std::path::Path;

/// An instrument made of meshes.
#[derive(Clone, Debug, PartialEq)]
pub struct Made {
    /// The instrument.
    pub bank: Bank,
    /// What its owner should know of the meshes.
    pub notes: Vec<Noted>,
}

/// A note on one of the meshes.
#[derive(Clone, Debug, PartialEq)]
pub struct Noted {
    /// The file's name, with the objects if some are named; none where there is but one mesh.
    pub place: Option<String>,
    /// The note.
    pub note: Note,
}

impl Display for Noted {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        match &self.place {
            Some(place) => write!(f, "{place}: {}", self.note),
            None => write!(f, "{}", self.note),
        }
    }
}

/// Why a recipe of meshes gave no instrument.
#[derive(Debug, thiserror::Error)]
pub enum MadeError {
    /// The file is no mesh.
    #[error(transparent)]
    Obj(#[from] ObjError),
    /// The mesh is no solid.
    #[error("{file}: {error}")]
    Mesh {
        /// The mesh's file, with the objects if some are named.
        file: String,
        /// Why not.
        error: MeshError,
    },
    /// The solid gives no bank.
    #[error("{file}: {error}")]
    Free {
        /// The mesh's file, with the objects if some are named.
        file: String,
        /// Why not.
        error: FreeError,
    },
}

/// Steps of work on a piece that are told, and those of them that meshing takes.
const STEPS: usize = 100;
const MESHING: usize = 15;

/// Makes the instrument of `recipe`: its pieces one after the other.
///
/// # Errors
///
/// [`MadeError`]; [`MeshError::Cancelled`] or [`crate::SolveError::Cancelled`] in it when `progress`
/// breaks.
pub fn make(recipe: &FreeRecipe, progress: &dyn Progress) -> Result<Made, MadeError> {
    let count = recipe.pieces.len();
    let mut files: Vec<(&Path, ObjFile)> = Vec::new();
    let (mut solved, mut notes) = (Vec::with_capacity(count), Vec::new());
    for (number, piece) in recipe.pieces.iter().enumerate() {
        let path = piece.shape.file.as_path();
        let known = files.iter().position(|(known, _)| *known == path);
        let known = match known {
            Some(known) => known,
            None => {
                let obj = read_obj(path)?;
                let place = (count > 1).then(|| name(path));
                notes.extend(noted(place.as_deref(), &obj.notes));
                files.push((path, obj));
                files.len() - 1
            }
        };
        let watch = |done: usize| progress.advance(STEPS * number + done, STEPS * count);
        let (piece, found) = solve(recipe, number, &files[known].1, &watch)?;
        let place = (count > 1).then(|| place(&recipe.pieces[number].shape));
        notes.extend(noted(place.as_deref(), &found));
        solved.push(piece);
    }
    Ok(Made {
        bank: free_bank(recipe, solved),
        notes,
    })
}

/// The piece of that number out of its file; `watch` is told how many of [`STEPS`] are done.
fn solve(
    recipe: &FreeRecipe,
    number: usize,
    obj: &ObjFile,
    watch: &(dyn Fn(usize) -> ControlFlow<()> + Sync),
) -> Result<(SolvedPiece, Vec<Note>), MadeError> {
    let Piece {
        shape, fineness, ..
    } = &recipe.pieces[number];
    let mesh_error = |error| MadeError::Mesh {
        file: shape.to_string(),
        error,
    };
    let chosen = match &shape.objects[..] {
        [] => None,
        names => Some(obj.soup.only(names).map_err(mesh_error)?),
    };
    let surface = repair(chosen.as_ref().unwrap_or(&obj.soup), &how(shape.scale));
    let surface = surface.map_err(mesh_error)?.turned(shape.up);
    let meshing = Meshing {
        wall_m: shape.wall_m,
        resolution: Resolution::Nodes(fineness.nodes),
        ..Meshing::default()
    };
    let meshed = mesh_solid(&surface, &meshing, &First(watch)).map_err(mesh_error)?;
    let watch = |converged: usize, wanted: usize| {
        let share = (STEPS - MESHING) * converged / wanted.max(1);
        watch(MESHING + share.min(STEPS - MESHING))
    };
    let solved = solved_piece(recipe, number, &meshed.mesh, &watch);
    let solved = solved.map_err(|error| MadeError::Free {
        file: shape.to_string(),
        error,
    })?;
    Ok((solved, meshed.notes))
}

fn how(scale: MeshScale) -> Repair {
    let usual = Repair::default();
    match scale {
        MeshScale::Longest(size_m) => Repair {
            size_m: Some(size_m),
            ..usual
        },
        MeshScale::Unit(unit_m) => Repair { unit_m, ..usual },
    }
}

fn noted(place: Option<&str>, notes: &[Note]) -> impl Iterator<Item = Noted> {
    notes.iter().map(move |note| Noted {
        place: place.map(str::to_owned),
        note: note.clone(),
    })
}

/// The file's name without its folder.
fn name(path: &Path) -> String {
    let name = path.file_name().unwrap_or_default();
    name.to_string_lossy().into_owned()
}

/// The same with the objects, if some are named.
fn place(shape: &MeshShape) -> String {
    let file = name(&shape.file).into();
    MeshShape {
        file,
        ..shape.clone()
    }
    .to_string()
}

/// Told of the first steps.
struct First<'a>(&'a (dyn Fn(usize) -> ControlFlow<()> + Sync));

impl Progress for First<'_> {
    fn advance(&self, done: usize, total: usize) -> ControlFlow<()> {
        (self.0)(MESHING * done / total.max(1))
    }
}
