//! How well shaped tetrahedra are.

use super::vector::{cross, dot, norm, six_volumes, sub};

/// The shapes of a mesh's elements.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Quality {
    /// Smallest angle between two faces of an element with its edges straight, in degrees.
    pub min_dihedral_deg: f64,
    /// Greatest angle between two faces of an element with its edges straight, in degrees.
    pub max_dihedral_deg: f64,
    /// Smallest volume over the cube of the root mean square edge, 1 for a regular tetrahedron.
    pub min_volume_length: f64,
    /// Elements.
    pub elements: usize,
    /// Nodes, mid-edge nodes included.
    pub nodes: usize,
    /// Volume of the curved elements, in m³.
    pub volume_m3: f64,
    /// Edges that had to stay straight: of a filled body over those of its boundary; of a wall
    /// the triangles, over all.
    pub straight_share: f64,
}

/// Volume over the cube of the root mean square edge, 1 for a regular tetrahedron, negative inside
/// out (Parthasarathy, Graichen & Hathaway 1994).
pub(super) fn volume_length(corners: [[f64; 3]; 4]) -> f64 {
    let mut squares = 0.0;
    for i in 0..4 {
        for j in 0..i {
            let edge = sub(corners[i], corners[j]);
            squares += dot(edge, edge);
        }
    }
    let mean = squares / 6.0;
    std::f64::consts::SQRT_2 * six_volumes(corners) / (mean * mean.sqrt())
}

/// Smallest and greatest angle between two faces, in degrees.
pub(super) fn dihedrals_deg(corners: [[f64; 3]; 4]) -> (f64, f64) {
    let (mut least, mut most) = (180.0f64, 0.0f64);
    for (i, j, k, l) in [
        (0, 1, 2, 3),
        (0, 2, 3, 1),
        (0, 3, 1, 2),
        (1, 2, 0, 3),
        (1, 3, 2, 0),
        (2, 3, 0, 1),
    ] {
        let edge = sub(corners[j], corners[i]);
        let first = cross(edge, sub(corners[k], corners[i]));
        let second = cross(edge, sub(corners[l], corners[i]));
        let angle = norm(cross(first, second))
            .atan2(dot(first, second))
            .to_degrees();
        least = least.min(angle);
        most = most.max(angle);
    }
    (least, most)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_regular_tetrahedron_is_best() {
        let regular = [
            [1.0, 1.0, 1.0],
            [-1.0, 1.0, -1.0],
            [1.0, -1.0, -1.0],
            [-1.0, -1.0, 1.0],
        ];
        assert!((volume_length(regular).abs() - 1.0).abs() < 1e-12);
        let (least, most) = dihedrals_deg(regular);
        let expected = (1.0f64 / 3.0).acos().to_degrees();
        assert!((least - expected).abs() < 1e-9 && (most - expected).abs() < 1e-9);
    }
}
