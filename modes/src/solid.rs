//! Any closed shape as a mesh: a file's triangles repaired, then filled with ten-node tetrahedra, or given a wall of
//! wedges.

mod body;
mod closed;
mod error;
mod features;
mod filling;
mod fit;
pub mod gallery;
mod hollow;
mod lattice;
mod meshing;
mod note;
mod obj;
mod quality;
mod remesh;
mod repair;
mod resolution;
mod sheet;
mod shell;
mod soup;
mod stuffing;
mod thickness;
mod topology;
mod tree;
mod upright;
mod vector;

pub use closed::ClosedSurface;
pub use error::{MeshError, ObjError};
pub use meshing::{Meshed, mesh_solid};
pub use note::Note;
pub use obj::{ObjFile, parse_obj, read_obj, write_obj};
pub use quality::Quality;
pub use repair::{Pieces, Repair, repair};
pub use resolution::{Meshing, Resolution};
pub use soup::{Soup, SoupObject};
pub use upright::upright;

#[cfg(test)]
mod tests;
