//! Mode shapes along the line on a body's surface where it is struck.

use serde::{Deserialize, Serialize};

/// The line over the surface that the keyboard strikes, sampled at equal steps.
///
/// Position 0 is the line's first point and 1 its last.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct StrikeLine {
    /// Points on the surface, in m.
    pub points_m: Vec<[f64; 3]>,
    /// Outward unit normals at the points.
    pub normals: Vec<[f64; 3]>,
}

impl StrikeLine {
    /// Number of points.
    #[must_use]
    pub fn len(&self) -> usize {
        self.points_m.len()
    }

    /// Whether the line has no points.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.points_m.is_empty()
    }
}
