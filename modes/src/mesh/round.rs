//! Balls, hollow balls and cylinders of ten-node tetrahedra, their nodes on the true surfaces.

use super::Mesh;
use super::blocks::{Block, blocks_tet10};
use std::f64::consts::FRAC_PI_4;

/// Half the side of the cube in the middle of a ball (or the square in a disc), in radii.
const CORE: f64 = 0.4;

/// The six sides of a cube: axis and sign.
const SIDES: [(usize, f64); 6] = [
    (0, 1.0),
    (0, -1.0),
    (1, 1.0),
    (1, -1.0),
    (2, 1.0),
    (2, -1.0),
];

/// A ball: a cube of `cells` cells to a side, and as many to each of six blocks around it, `layers`
/// deep.
#[must_use]
pub fn ball_tet10(radius_m: f64, cells: usize, layers: usize) -> Mesh {
    let core = |p: [f64; 3]| p.map(|x| CORE * radius_m * (2.0 * x - 1.0));
    let shells = SIDES.map(|side| {
        move |[a, b, out]: [f64; 3]| {
            let (on_cube, on_ball) = (on_cube(side, a, b), on_ball(side, a, b));
            [0, 1, 2].map(|i| radius_m * (CORE * on_cube[i] * (1.0 - out) + on_ball[i] * out))
        }
    });
    let mut blocks = vec![Block {
        counts: [cells; 3],
        place_m: &core,
    }];
    blocks.extend(shells.iter().map(|place_m| Block {
        counts: [cells, cells, layers],
        place_m,
    }));
    blocks_tet10(&blocks)
}

/// What is between two balls: `cells` cells to the side of each of six blocks, `layers` deep.
#[must_use]
pub fn hollow_ball_tet10(radii_m: [f64; 2], cells: usize, layers: usize) -> Mesh {
    let shells = SIDES.map(|side| {
        move |[a, b, out]: [f64; 3]| {
            let radius_m = radii_m[0] + (radii_m[1] - radii_m[0]) * out;
            on_ball(side, a, b).map(|x| radius_m * x)
        }
    });
    let blocks: Vec<Block<'_>> = shells
        .iter()
        .map(|place_m| Block {
            counts: [cells, cells, layers],
            place_m,
        })
        .collect();
    blocks_tet10(&blocks)
}

/// A solid cylinder about the z axis, its middle at the origin: a square of `cells` cells to a side,
/// and as many to each of four blocks around it, `layers` deep, `along` cells long.
#[must_use]
pub fn cylinder_tet10([radius_m, length_m]: [f64; 2], [cells, layers, along]: [usize; 3]) -> Mesh {
    let core = |[x, y, z]: [f64; 3]| {
        let [x, y] = [x, y].map(|x| CORE * radius_m * (2.0 * x - 1.0));
        [x, y, length_m * (z - 0.5)]
    };
    let sectors = [0.0, 1.0, 2.0, 3.0].map(|quarter| {
        move |[a, out, z]: [f64; 3]| {
            let (sin, cos) = (FRAC_PI_4 * (2.0 * a - 1.0)).sin_cos();
            let x = CORE * (1.0 - out) + cos * out;
            let y = CORE * (2.0 * a - 1.0) * (1.0 - out) + sin * out;
            let (sin, cos) = (2.0 * FRAC_PI_4 * quarter).sin_cos();
            let [x, y] = [x * cos - y * sin, x * sin + y * cos].map(|x| radius_m * x);
            [x, y, length_m * (z - 0.5)]
        }
    });
    let mut blocks = vec![Block {
        counts: [cells, cells, along],
        place_m: &core,
    }];
    blocks.extend(sectors.iter().map(|place_m| Block {
        counts: [cells, layers, along],
        place_m,
    }));
    blocks_tet10(&blocks)
}

/// A point on a side of the cube from −1 to 1, at `a` and `b` in 0…1.
fn on_cube((axis, sign): (usize, f64), a: f64, b: f64) -> [f64; 3] {
    let mut point = [0.0; 3];
    point[axis] = sign;
    point[(axis + 1) % 3] = 2.0 * a - 1.0;
    point[(axis + 2) % 3] = 2.0 * b - 1.0;
    point
}

/// A point on the unit sphere, at equal angles for equal steps of `a` and `b`.
fn on_ball(side: (usize, f64), a: f64, b: f64) -> [f64; 3] {
    let even = |x: f64| 0.5 + 0.5 * (FRAC_PI_4 * (2.0 * x - 1.0)).tan();
    let point = on_cube(side, even(a), even(b));
    let length = point.iter().map(|x| x * x).sum::<f64>().sqrt();
    point.map(|x| x / length)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Material;
    use crate::fem::{TetMass, assemble};
    use crate::mesh::brick_tet10;
    use std::f64::consts::PI;

    fn mass_kg(mesh: &Mesh) -> f64 {
        let material = Material::from_young(1e9, 0.3, 1000.0).unwrap();
        let pencil = assemble(mesh, &material, TetMass::Consistent).unwrap();
        let shift: Vec<f64> = (0..pencil.unknowns())
            .map(|u| f64::from(u8::from(u % 3 == 0)))
            .collect();
        let mut moved = vec![0.0; shift.len()];
        pencil.multiply(&pencil.mass, &shift, &mut moved);
        shift.iter().zip(&moved).map(|(x, y)| x * y).sum()
    }

    fn area_m2(mesh: &Mesh) -> f64 {
        let triangles = mesh.surface();
        let corners = triangles.iter().map(|t| t.map(|i| mesh.nodes[i as usize]));
        corners
            .map(|[p, q, r]| {
                let [u, v] = [q, r].map(|q| [0, 1, 2].map(|a| q[a] - p[a]));
                let cross = [
                    u[1] * v[2] - u[2] * v[1],
                    u[2] * v[0] - u[0] * v[2],
                    u[0] * v[1] - u[1] * v[0],
                ];
                0.5 * cross.iter().map(|x| x * x).sum::<f64>().sqrt()
            })
            .sum()
    }

    #[test]
    fn round_bodies_weigh_what_they_should_and_close() {
        let near = |found: f64, expected: f64, bound: f64| {
            assert!((found / expected - 1.0).abs() < bound, "{found} {expected}");
        };
        let ball = ball_tet10(0.1, 3, 2);
        near(mass_kg(&ball), 1000.0 * 4.0 / 3.0 * PI * 1e-3, 1e-3);
        near(area_m2(&ball), 4.0 * PI * 1e-2, 0.02);
        let hollow = hollow_ball_tet10([0.05, 0.1], 3, 2);
        near(
            mass_kg(&hollow),
            1000.0 * 4.0 / 3.0 * PI * (1e-3 - 1.25e-4),
            1e-3,
        );
        near(area_m2(&hollow), 4.0 * PI * 1.25e-2, 0.02);
        let cylinder = cylinder_tet10([0.1, 0.3], [2, 1, 2]);
        near(mass_kg(&cylinder), 1000.0 * PI * 1e-2 * 0.3, 1e-3);
        near(area_m2(&cylinder), 2.0 * PI * (1e-2 + 0.03), 0.02);
        let brick = brick_tet10([0.1, 0.2, 0.3], [1, 2, 2]);
        near(mass_kg(&brick), 6.0, 1e-12);
        near(area_m2(&brick), 0.22, 1e-12);
    }
}
