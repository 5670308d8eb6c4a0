//! A body of any shape: its surface and how it moves are given.

use super::edges::edges;
use super::struck::Lines;
use super::{Kind, Motions, Solid, Vector, add, cross, dot, heard_modes, unit};
use modes::{StrikeLine, Surface};
use std::collections::HashMap;

/// Cosine of the angle from which two triangles meet at an edge that is seen as one.
const CREASE: f32 = 0.77;

/// A surface as a mesh gives it.
#[derive(Clone, Debug)]
pub struct Drawing {
    /// Points, in m.
    pub points_m: Vec<Vector>,
    /// Triangles of points, counter-clockwise from outside.
    pub triangles: Vec<[u32; 3]>,
    /// Displacement φ of each point in kg^(−1/2), for each of the lowest modes in the order of
    /// [`Partial::all`](crate::engine::Partial::all); others are not seen to move it.
    pub motions: Vec<Vec<Vector>>,
    /// Where it is struck.
    pub line: StrikeLine,
}

impl Drawing {
    /// What a bank says of how a body looks and moves, in the size of that body.
    #[must_use]
    pub fn of(body: &modes::Body, surface: &Surface) -> Self {
        let scale = body.surface_scale() as f32;
        // Of bodies that differ in size alone, φ goes with size^(−3/2); where it is something else that
        // differs, all motions do by the same factor, which the picture's exaggeration takes up.
        let factor = scale.powf(-1.5);
        let numbers: HashMap<_, usize> = (0..)
            .zip(&body.modes)
            .map(|(number, mode)| (mode.label, number))
            .collect();
        let motion = |mode: &modes::Mode| -> Vec<Vector> {
            let known = numbers.get(&mode.label);
            known
                .and_then(|number| surface.motions.get(*number))
                .map_or_else(Vec::new, |motion| {
                    let points = 0..motion.points.len();
                    points.map(|i| motion.at(i).map(|x| factor * x)).collect()
                })
        };
        Self {
            points_m: surface
                .points_m
                .iter()
                .map(|point| point.map(|x| scale * x))
                .collect(),
            triangles: surface.triangles.clone(),
            motions: heard_modes(body).into_iter().map(motion).collect(),
            line: body.line.clone(),
        }
    }
}

/// Motion as it is given: each point as one of the drawing.
#[derive(Clone, Debug)]
pub(super) struct Given {
    motions: Vec<Vec<Vector>>,
    from: Vec<u32>,
}

impl Given {
    pub(super) fn motion(&self, mode: usize) -> Vec<Vector> {
        let Some(motion) = self.motions.get(mode) else {
            return vec![[0.0; 3]; self.from.len()];
        };
        let at = |i: &u32| motion.get(*i as usize).copied().unwrap_or_default();
        self.from.iter().map(at).collect()
    }
}

impl Solid {
    /// From a drawing: smooth but for its creases, and struck as the nearest place of its grid. Triangles of
    /// points that are not there are left out.
    #[must_use]
    pub fn drawn(kind: Kind, drawing: Drawing) -> Self {
        let Drawing {
            points_m,
            mut triangles,
            motions,
            line,
        } = drawing;
        triangles.retain(|triangle| triangle.iter().all(|i| (*i as usize) < points_m.len()));
        let split = Split::of(&points_m, &triangles);
        let points: Vec<Vector> = split.from.iter().map(|i| points_m[*i as usize]).collect();
        Self {
            kind,
            edges: edges(&split.triangles, &points),
            places: Vec::new(),
            points_m: points,
            normals: split.normals,
            triangles: split.triangles,
            thicker: 1.0,
            lines: Lines::of(&line),
            motions: Motions::Given(Given {
                motions,
                from: split.from,
            }),
        }
    }
}

/// Points that count once for each smooth part of the surface that they are on.
struct Split {
    normals: Vec<Vector>,
    triangles: Vec<[u32; 3]>,
    /// The point of the drawing that each is.
    from: Vec<u32>,
}

impl Split {
    fn of(points_m: &[Vector], triangles: &[[u32; 3]]) -> Self {
        let corner = |i: u32| points_m[i as usize];
        let wide: Vec<Vector> = triangles
            .iter()
            .map(|[a, b, c]| {
                let [ab, ac] = [*b, *c].map(|to| add(corner(to), -1.0, corner(*a)));
                cross(ab, ac)
            })
            .collect();
        let mut around: Vec<Vec<usize>> = vec![Vec::new(); points_m.len()];
        for (number, triangle) in triangles.iter().enumerate() {
            for i in triangle {
                around[*i as usize].push(number);
            }
        }
        let mut split = Self {
            normals: Vec::new(),
            triangles: Vec::with_capacity(triangles.len()),
            from: Vec::new(),
        };
        let mut known: HashMap<(u32, [i16; 3]), u32> = HashMap::new();
        for (number, triangle) in triangles.iter().enumerate() {
            let flat = unit(wide[number]);
            split.triangles.push(triangle.map(|i| {
                let smooth = around[i as usize]
                    .iter()
                    .filter(|other| dot(unit(wide[**other]), flat) > CREASE)
                    .fold([0.0; 3], |sum, other| add(sum, 1.0, wide[*other]));
                let normal = unit(smooth);
                let name = (i, normal.map(|x| (1e3 * x).round() as i16));
                *known.entry(name).or_insert_with(|| {
                    split.normals.push(normal);
                    split.from.push(i);
                    split.from.len() as u32 - 1
                })
            }));
        }
        split
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A cube with corners at 0 and 1, which one mode moves up in proportion to x.
    fn cube() -> Solid {
        let points_m: Vec<Vector> = (0..8u8)
            .map(|i| [i & 1, i >> 1 & 1, i >> 2].map(f32::from))
            .collect();
        let faces = [
            [0, 2, 3, 1],
            [4, 5, 7, 6],
            [0, 1, 5, 4],
            [2, 6, 7, 3],
            [0, 4, 6, 2],
            [1, 3, 7, 5],
        ];
        let rows = [0.0, 0.5, 1.0];
        Solid::drawn(
            Kind::Other,
            Drawing {
                triangles: faces
                    .iter()
                    .flat_map(|[a, b, c, d]| [[*a, *b, *c], [*a, *c, *d], [99, 0, 1]])
                    .collect(),
                motions: vec![points_m.iter().map(|p| [0.0, 0.0, p[0]]).collect()],
                line: StrikeLine {
                    points_m: rows
                        .iter()
                        .flat_map(|y| (0..=10u8).map(|i| [f64::from(i) / 10.0, *y, 1.0]))
                        .collect(),
                    normals: vec![[0.0, 0.0, 1.0]; 33],
                    rows: 3,
                    closed: false,
                },
                points_m,
            },
        )
    }

    #[test]
    fn a_cube_has_six_flat_sides_and_is_closed() {
        let cube = cube();
        assert_eq!((cube.points_m.len(), cube.triangles.len()), (24, 12));
        assert_eq!(cube.edges.len(), 18);
        for (point, normal) in cube.points_m.iter().zip(&cube.normals) {
            let out = add(*point, -1.0, [0.5; 3]);
            assert!((dot(*normal, out) - 0.5).abs() < 1e-6, "{normal:?}");
        }
    }

    #[test]
    fn points_move_as_they_are_given() {
        let cube = cube();
        for (point, moved) in cube.points_m.iter().zip(cube.motion(0)) {
            assert_eq!(moved, [0.0, 0.0, point[0]]);
        }
        assert!(cube.motion(1).iter().all(|u| *u == [0.0; 3]));
    }

    #[test]
    fn it_is_struck_along_and_across_where_its_grid_is_nearest() {
        let cube = cube();
        for (x, y) in [(0.0, 0.0), (0.33, 0.8), (0.97, 0.4), (1.0, 1.0)] {
            let struck = cube.struck_as([x, y, 1.0], 0, [1.0, 0.0, 0.0]);
            assert!((struck.along - x).abs() < 1e-5, "{struck:?}");
            assert!((struck.across.unwrap() - y).abs() < 1e-5, "{struck:?}");
            let (at, normal) = cube.at([struck.along, struck.across.unwrap()]);
            let away = add(at, -1.0, [x, y, 1.0]);
            assert!(dot(away, away) < 1e-10 && normal == [0.0, 0.0, 1.0]);
        }
    }
}
