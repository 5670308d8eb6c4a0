//! What was done to a mesh on its way to a solid.

use std::fmt::{self, Display, Formatter};

/// Something the owner of a mesh should know.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum Note {
    /// The file's names are in no known encoding.
    NotUtf8,
    /// A library of materials is named but not there.
    NoMaterials {
        /// What the file calls it.
        name: String,
    },
    /// Lines, points, curves and the like.
    NotFaces {
        /// How many lines of the file.
        lines: usize,
    },
    /// Faces of more than three corners were cut.
    Cut {
        /// How many.
        polygons: usize,
    },
    /// Points at the same place were made one.
    Welded {
        /// How many points went.
        points: usize,
    },
    /// Faces without area were dropped.
    NoArea {
        /// How many.
        faces: usize,
    },
    /// Faces that lie on another were dropped.
    Doubled {
        /// How many.
        faces: usize,
    },
    /// Pairs of faces back to back, as between two boxes that touch, were dropped.
    InnerWalls {
        /// How many faces.
        faces: usize,
    },
    /// Faces were turned to agree with their neighbours.
    Turned {
        /// How many.
        faces: usize,
    },
    /// Pieces were inside out.
    InsideOut {
        /// How many.
        pieces: usize,
    },
    /// A hole was closed.
    HoleClosed {
        /// Edges of its rim.
        edges: usize,
        /// Its area over that of the surface.
        share: f64,
        /// A point of its rim, in the file's units.
        near: [f64; 3],
    },
    /// Edges at which more than two faces meet.
    ManyFaced {
        /// How many.
        edges: usize,
    },
    /// Other pieces were left out.
    PiecesLeft {
        /// How many were kept.
        kept: usize,
        /// How many were not.
        left: usize,
    },
    /// Hollows inside the body were kept.
    Cavities {
        /// How many.
        count: usize,
    },
    /// A size that few instruments have.
    Size {
        /// Longest side of the bounding box, in m.
        longest_m: f64,
    },
    /// The surface goes through itself; what is inside any of it is solid.
    Overlaps,
    /// The wall asked for leaves no hollow.
    WallFills {
        /// The wall, in m.
        wall_m: f64,
    },
    /// The body is a thin sheet and was taken as one.
    Sheet {
        /// The least thickness of all but a small share of it, in m.
        thin_m: f64,
        /// The greatest thickness of all but a small share of it, in m.
        thick_m: f64,
    },
    /// The wall is thinner than asked where it would fold.
    Thinner {
        /// At how many points of the surface.
        points: usize,
    },
    /// Elements smaller than the budget allows, so that thin parts are more than a pattern of holes.
    Finer {
        /// Thickness of the thin parts, in m.
        thin_m: f64,
        /// Nodes the mesh has.
        nodes: usize,
        /// Nodes asked for.
        asked: usize,
    },
    /// The mesh lacks parts thinner than its elements.
    Lost {
        /// Volume of the mesh over that of the body.
        share: f64,
    },
    /// Points that could not be brought to an edge or the surface without spoiling elements.
    Rounded {
        /// How many.
        points: usize,
    },
}

impl Display for Note {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        match self {
            Self::NotUtf8 => write!(f, "names are not in UTF-8; odd characters were replaced"),
            Self::NoMaterials { name } => write!(
                f,
                "the material file \"{name}\" is missing; only the shape is read, so nothing is lost"
            ),
            Self::NotFaces { lines } => {
                write!(
                    f,
                    "{lines} lines, points or curves left out: only faces make a solid"
                )
            }
            Self::Cut { polygons } => write!(f, "cut {polygons} polygons into triangles"),
            Self::Welded { points } => {
                write!(f, "joined {points} points with others at their place")
            }
            Self::NoArea { faces } => write!(f, "dropped {faces} faces without area"),
            Self::Doubled { faces } => write!(f, "dropped {faces} faces that lie on another"),
            Self::InnerWalls { faces } => {
                write!(f, "dropped {faces} faces back to back inside the body")
            }
            Self::Turned { faces } => {
                write!(
                    f,
                    "turned {faces} faces round to agree with their neighbours"
                )
            }
            Self::InsideOut { pieces } => write!(f, "turned {pieces} pieces that were inside out"),
            Self::HoleClosed { edges, share, near } => write!(
                f,
                "closed a hole of {edges} edges, {:.2} % of the surface, near ({:.4}, {:.4}, {:.4})",
                100.0 * share,
                near[0],
                near[1],
                near[2]
            ),
            Self::ManyFaced { edges } => {
                write!(
                    f,
                    "more than two faces meet at {edges} edges; taken as they are"
                )
            }
            Self::PiecesLeft { kept, left } => {
                write!(
                    f,
                    "kept {kept} pieces and left out {left}: a body is one piece"
                )
            }
            Self::Cavities { count } => write!(f, "{count} closed hollows kept inside the body"),
            Self::Size { longest_m } => write!(
                f,
                "the body is {longest_m:.4} m long: is the file in other units? Set the size"
            ),
            Self::Overlaps => {
                write!(
                    f,
                    "the surface goes through itself; all that it encloses is solid"
                )
            }
            Self::WallFills { wall_m } => {
                write!(
                    f,
                    "a wall of {:.2} mm leaves no hollow: the body is solid",
                    1e3 * wall_m
                )
            }
            Self::Sheet { thin_m, thick_m } => write!(
                f,
                "taken as a sheet {:.2} to {:.2} mm thick: wedges go from wall to wall",
                1e3 * thin_m,
                1e3 * thick_m
            ),
            Self::Thinner { points } => write!(
                f,
                "the wall is thinner than asked at {points} points, in edges too sharp for it"
            ),
            Self::Finer {
                thin_m,
                nodes,
                asked,
            } => write!(
                f,
                "{nodes} nodes instead of {asked}: parts are only {:.2} mm thick",
                1e3 * thin_m
            ),
            Self::Lost { share } => write!(
                f,
                "the mesh has {:.1} % of the body's volume: allow more nodes, or thicken it",
                100.0 * share
            ),
            Self::Rounded { points } => {
                write!(
                    f,
                    "{points} points of the mesh stay off the surface's edges"
                )
            }
        }
    }
}
