//! The outline of a flat body, drawn from the unit square.

use crate::bank::{Surface as Picture, SurfaceMotion};
use std::f64::consts::TAU;

/// What of the plane a body covers, in m, in the frame of its closed form.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Outline {
    /// Along x from the origin, with a width about it.
    Strip { length_m: f64, width_m: f64 },
    /// A rectangle with a corner at the origin.
    Rectangle { sides_m: [f64; 2] },
    /// A disc about the origin.
    Disc { radius_m: f64 },
    /// Three squares: from the end of the upper arm by the origin to that of the right arm.
    Ell { square_m: f64 },
}

/// Patches, triangles of a picture: cells along and across.
pub(super) type Cells = [usize; 2];

impl Outline {
    /// The point at `u` along and `v` across, both 0…1, and the area in m² to a unit of each.
    pub(super) fn place(self, [u, v]: [f64; 2]) -> ([f64; 2], f64) {
        match self {
            Self::Strip { length_m, width_m } => {
                ([length_m * u, width_m * (v - 0.5)], length_m * width_m)
            }
            Self::Rectangle { sides_m: [x, y] } => ([x * u, y * v], x * y),
            Self::Disc { radius_m } => {
                let (sin, cos) = (TAU * v).sin_cos();
                let r_m = radius_m * u;
                ([r_m * cos, r_m * sin], TAU * radius_m * r_m)
            }
            Self::Ell { square_m } => {
                // From the inner edge, v = 0, straight across to the outer one; w is 1 at the arms' ends
                // and 0 on the diagonal.
                let w = (2.0 * u - 1.0).abs();
                let (along, across) = ((1.0 - v) * (1.0 + w) + v * 2.0 * w, 1.0 - v);
                let point = if u < 0.5 {
                    [across, along]
                } else {
                    [along, across]
                };
                // To a unit of u, 2 of w, along grows by 2 (1 + v).
                let area_m2 = square_m * square_m * 2.0 * (1.0 + v);
                (point.map(|x| square_m * x), area_m2)
            }
        }
    }

    /// The middle of what surrounds it, in m.
    pub(super) fn middle_m(self) -> [f64; 2] {
        match self {
            Self::Strip { length_m, .. } => [0.5 * length_m, 0.0],
            Self::Rectangle { sides_m } => sides_m.map(|x| 0.5 * x),
            Self::Disc { .. } => [0.0; 2],
            Self::Ell { square_m } => [square_m; 2],
        }
    }

    /// Greatest length, in m.
    pub(super) fn length_m(self) -> f64 {
        match self {
            Self::Strip { length_m, .. } => length_m,
            Self::Rectangle { sides_m: [x, y] } => x.max(y),
            Self::Disc { radius_m } => 2.0 * radius_m,
            Self::Ell { square_m } => 2.0 * square_m,
        }
    }

    /// Lengths along and around or across, in m.
    pub(super) fn spans_m(self) -> [f64; 2] {
        match self {
            Self::Strip { length_m, width_m } => [length_m, width_m],
            Self::Rectangle { sides_m } => sides_m,
            Self::Disc { radius_m } => [radius_m, TAU * radius_m],
            Self::Ell { square_m } => [4.0 * square_m, square_m],
        }
    }

    /// As many cells as keep each within `longest_m`.
    pub(super) fn cells(self, longest_m: f64) -> Cells {
        #[expect(clippy::cast_sign_loss, reason = "lengths are positive")]
        self.spans_m()
            .map(|span_m| (span_m / longest_m).ceil() as usize)
    }

    /// Middles and areas of the cells, row by row.
    pub(super) fn patches(self, [along, across]: Cells) -> Vec<([f64; 2], f64)> {
        let share = |i: usize, count: usize| (i as f64 + 0.5) / count as f64;
        (0..across)
            .flat_map(|j| (0..along).map(move |i| [share(i, along), share(j, across)]))
            .map(|at| {
                let (point_m, area_m2) = self.place(at);
                (point_m, area_m2 / (along * across) as f64)
            })
            .collect()
    }

    /// What it looks like from above and from below, when the corners of its cells move like that.
    pub(super) fn picture(self, cells: Cells, motions: Vec<SurfaceMotion>) -> Picture {
        let [x, y] = self.middle_m();
        let (points, above) = self.triangles(cells);
        let below = above.iter().map(|[a, b, c]| [*a, *c, *b]);
        let triangles = above.iter().copied().chain(below).collect();
        Picture {
            length_m: self.length_m(),
            motions,
            points_m: points
                .iter()
                .map(|p| [(p[0] - x) as f32, (p[1] - y) as f32, 0.0])
                .collect(),
            triangles,
        }
    }

    /// Corners of the cells, row by row, and triangles of them, counter-clockwise from above.
    pub(super) fn triangles(self, [along, across]: Cells) -> (Vec<[f64; 2]>, Vec<[u32; 3]>) {
        let share = |i: usize, count: usize| i as f64 / count as f64;
        let points: Vec<[f64; 2]> = (0..=across)
            .flat_map(|j| (0..=along).map(move |i| [share(i, along), share(j, across)]))
            .map(|at| self.place(at).0)
            .collect();
        let corner = |i: usize, j: usize| (j * (along + 1) + i) as u32;
        let triangles = (0..across)
            .flat_map(|j| (0..along).map(move |i| (i, j)))
            .flat_map(|(i, j)| {
                let [a, b] = [corner(i, j), corner(i + 1, j)];
                let [c, d] = [corner(i + 1, j + 1), corner(i, j + 1)];
                [[a, b, c], [a, c, d]]
            })
            .map(|triangle| upwards(&points, triangle))
            .collect();
        (points, triangles)
    }
}

/// The triangle so that it is counter-clockwise from above.
fn upwards(points: &[[f64; 2]], [a, b, c]: [u32; 3]) -> [u32; 3] {
    let [p, q, r] = [a, b, c].map(|corner| points[corner as usize]);
    let twice = (q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0]);
    if twice < 0.0 { [a, c, b] } else { [a, b, c] }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::PI;

    const ALL: [(Outline, f64); 4] = [
        (
            Outline::Strip {
                length_m: 0.5,
                width_m: 0.04,
            },
            0.02,
        ),
        (
            Outline::Rectangle {
                sides_m: [0.5, 0.3],
            },
            0.15,
        ),
        (Outline::Disc { radius_m: 0.2 }, 0.04 * PI),
        (Outline::Ell { square_m: 0.2 }, 0.12),
    ];

    #[test]
    fn patches_make_up_the_area() {
        for (outline, area_m2) in ALL {
            let patches = outline.patches(outline.cells(0.02));
            let sum: f64 = patches.iter().map(|(_, area)| area).sum();
            assert!((sum / area_m2 - 1.0).abs() < 1e-12, "{outline:?} {sum}");
            // First moments: the middle of an L lies 5/6 of a square from its corner.
            let mean = |axis: usize| {
                let moments = patches.iter().map(|(p, area)| area * p[axis]);
                moments.sum::<f64>() / area_m2
            };
            let [x, y] = match outline {
                Outline::Ell { square_m } => [5.0 / 6.0 * square_m; 2],
                _ => outline.middle_m(),
            };
            assert!(
                (mean(0) - x).abs() < 1e-3 && (mean(1) - y).abs() < 1e-3,
                "{outline:?}"
            );
        }
    }

    #[test]
    fn triangles_cover_it_once_and_face_up() {
        for (outline, area_m2) in ALL {
            let (points, triangles) = outline.triangles([60, 60]);
            let areas = triangles.iter().map(|triangle| {
                let [p, q, r] = triangle.map(|corner| points[corner as usize]);
                0.5 * ((q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0]))
            });
            assert!(areas.clone().all(|area| area >= 0.0));
            let sum: f64 = areas.sum();
            assert!((sum / area_m2 - 1.0).abs() < 3e-3, "{outline:?} {sum}");
        }
    }
}
