//! Why a mesh does not become a solid.

use std::io;
use std::path::PathBuf;
use thiserror::Error;

/// Why a file is no mesh.
#[derive(Debug, Error)]
pub enum ObjError {
    /// The file cannot be read.
    #[error("{}: cannot read the mesh: {error}", path.display())]
    Read {
        /// The file.
        path: PathBuf,
        /// What the system says.
        error: io::Error,
    },
    /// A line is not what it should be.
    #[error("{file}:{line}: {fault}")]
    Line {
        /// The file.
        file: String,
        /// Line, counted from 1.
        line: usize,
        /// What is wrong, and what is right.
        fault: String,
    },
    /// More than is read.
    #[error(
        "{file}: {found} {what}, and at most {allowed} are read: simplify the mesh and export it again"
    )]
    TooLarge {
        /// The file.
        file: String,
        /// Bytes, points or triangles.
        what: &'static str,
        /// How many there are.
        found: usize,
        /// How many there may be.
        allowed: usize,
    },
    /// No face in the whole file.
    #[error("{file}: no faces: export the shape as a polygon mesh in Wavefront's OBJ format")]
    Empty {
        /// The file.
        file: String,
    },
}

/// Why triangles become no solid, or a solid no mesh.
#[derive(Clone, Debug, PartialEq, Error)]
pub enum MeshError {
    /// Not one of the file's objects.
    #[error("there is no object \"{name}\"; there are {}", listed(names))]
    NoSuchObject {
        /// What was asked for.
        name: String,
        /// What there is.
        names: Vec<String>,
    },
    /// A coordinate is not a number, or a triangle names no point.
    #[error("triangle {triangle} has a corner that is no point in space")]
    BadTriangle {
        /// Its number.
        triangle: usize,
    },
    /// Too few faces to enclose anything.
    #[error("{faces} faces with an area: a solid has at least four")]
    TooFewFaces {
        /// How many are left after repair.
        faces: usize,
    },
    /// Open where no small hole is.
    #[error(
        "the surface is open: a rim of {edges} edges near ({:.4}, {:.4}, {:.4}) leaves a hole of {:.0} % of \
         the surface; close it, or give the sheet a thickness (\"solidify\")", near[0], near[1], near[2], 100.0 * share
    )]
    Open {
        /// Edges of the rim.
        edges: usize,
        /// Its area over that of the surface.
        share: f64,
        /// A point of the rim, in the file's units.
        near: [f64; 3],
    },
    /// Open all over.
    #[error(
        "the surface is open: {holes} holes, each of them small, make {:.0} % of it together; close them", 100.0 * share
    )]
    Torn {
        /// How many holes.
        holes: usize,
        /// Their area over that of the surface with them.
        share: f64,
    },
    /// Encloses nothing.
    #[error(
        "the surface is flat: it encloses no volume; give the sheet a thickness (\"solidify\")"
    )]
    Flat,
    /// A Möbius strip or a Klein bottle.
    #[error("the surface has only one side, so nothing is inside it")]
    OneSided,
    /// A size or a wall that is not a length.
    #[error("{what} is {value_m} m, but must be between {least_m} and {most_m} m")]
    Length {
        /// Size or wall.
        what: &'static str,
        /// What was asked, in m.
        value_m: f64,
        /// The least, in m.
        least_m: f64,
        /// The most, in m.
        most_m: f64,
    },
    /// Parts too thin for the most nodes allowed.
    #[error(
        "parts are {:.2} mm thick: that takes about {nodes} nodes, and {allowed} are allowed; thicken \
         them, make the body smaller or allow more", 1e3 * thin_m
    )]
    TooThin {
        /// Thickness of the thin parts, in m.
        thin_m: f64,
        /// Nodes it would take.
        nodes: usize,
        /// Nodes allowed.
        allowed: usize,
    },
    /// Nothing of the body is thick enough to hold an element.
    #[error("the body is thinner than the elements everywhere: allow more nodes")]
    NoElements,
    /// The caller asked to stop.
    #[error("cancelled")]
    Cancelled,
}

fn listed(names: &[String]) -> String {
    let quoted: Vec<String> = names.iter().take(20).map(|n| format!("\"{n}\"")).collect();
    quoted.join(", ")
}
