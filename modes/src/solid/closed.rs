//! A surface that encloses a solid.

use super::Note;
use super::vector::{bounds, dot, doubled_area, norm, scale, sub};
use crate::Up;

/// Triangles that close and face outwards, in metres, the middle of their bounding box at the origin.
#[derive(Clone, Debug, PartialEq)]
pub struct ClosedSurface {
    /// Corners, in m.
    pub points_m: Vec<[f64; 3]>,
    /// Corner numbers, counter-clockwise from outside the solid.
    pub triangles: Vec<[u32; 3]>,
    /// What was repaired.
    pub notes: Vec<Note>,
}

impl ClosedSurface {
    /// The same turned so that the file's `up` points along z.
    #[must_use]
    pub fn turned(mut self, up: Up) -> Self {
        for point in &mut self.points_m {
            *point = up.turned(*point);
        }
        self
    }

    /// Corners of a triangle, in m.
    #[must_use]
    pub fn corners_m(&self, triangle: usize) -> [[f64; 3]; 3] {
        self.triangles[triangle].map(|i| self.points_m[i as usize])
    }

    /// The volume it encloses, in m³; where it overlaps itself, counted as often.
    #[must_use]
    pub fn volume_m3(&self) -> f64 {
        signed_volume(&self.points_m, &self.triangles)
    }

    /// Its area, in m².
    #[must_use]
    pub fn area_m2(&self) -> f64 {
        (0..self.triangles.len())
            .map(|t| 0.5 * norm(doubled_area(self.corners_m(t))))
            .sum()
    }

    /// The least and greatest coordinates, in m.
    #[must_use]
    pub fn bounds_m(&self) -> ([f64; 3], [f64; 3]) {
        let used = self.triangles.iter().flatten();
        bounds(used.map(|&i| self.points_m[i as usize]))
    }

    /// The same shape with its longest side `size_m` long.
    #[must_use]
    pub fn resized(&self, size_m: f64) -> Self {
        let (low, high) = self.bounds_m();
        let longest = (0..3).map(|a| high[a] - low[a]).fold(0.0, f64::max);
        let mut resized = self.clone();
        for point in &mut resized.points_m {
            *point = scale(*point, size_m / longest);
        }
        resized
    }
}

/// The volume that outward triangles enclose.
pub(super) fn signed_volume(points: &[[f64; 3]], triangles: &[[u32; 3]]) -> f64 {
    // From a point nearby, so that far from the origin no digits are lost.
    let from = triangles
        .first()
        .map_or([0.0; 3], |t| points[t[0] as usize]);
    let cone = |t: &[u32; 3]| {
        let corners = t.map(|i| sub(points[i as usize], from));
        dot(doubled_area(corners), corners[0])
    };
    triangles.iter().map(cone).sum::<f64>() / 6.0
}
