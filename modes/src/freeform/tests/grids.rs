//! Strike grids lie on the surface, whatever its shape.

use super::super::axes::Frame;
use super::super::grid::Grid;
use super::super::outside::Outside;
use super::super::{Limits, free_body};
use super::material;
use crate::mesh::{
    Block, Mesh, ball_tet10, blocks_tet10, brick_tet10, cylinder_tet10, hollow_ball_tet10,
};
use std::f64::consts::TAU;

/// A tube, open at both ends.
fn sleeve() -> Mesh {
    let wall = |[turn, out, up]: [f64; 3]| {
        let (sin, cos) = (TAU * turn).sin_cos();
        let radius = 0.04 + 0.004 * out;
        [radius * cos, radius * sin, 0.1 * up]
    };
    blocks_tet10(&[Block {
        counts: [12, 1, 4],
        place_m: &wall,
    }])
}

fn grid(mesh: &Mesh) -> (Grid, Outside) {
    let outside = Outside::of(mesh);
    let frame = Frame::of(&mesh.nodes, &outside.triangles);
    (
        Grid::new((&mesh.nodes, &outside.triangles), &frame, (25, 12)),
        outside,
    )
}

#[test]
fn points_lie_on_the_surface_and_normals_face_outwards() {
    let torus = |[turn, x, y]: [f64; 3]| {
        let (sin, cos) = (TAU * turn).sin_cos();
        let radius = 0.1 + 0.02 * (x - 0.5);
        [radius * cos, radius * sin, 0.02 * y]
    };
    let torus = blocks_tet10(&[Block {
        counts: [16, 1, 1],
        place_m: &torus,
    }]);
    for mesh in [
        ball_tet10(0.05, 3, 1),
        hollow_ball_tet10([0.04, 0.05], 3, 1),
        brick_tet10([0.2, 0.05, 0.004], [8, 2, 1]),
        cylinder_tet10([0.01, 0.3], [1, 1, 8]),
        sleeve(),
        torus,
    ] {
        let (grid, outside) = grid(&mesh);
        assert_eq!(grid.line.len(), 300);
        for (foot, (point, normal)) in grid
            .feet
            .iter()
            .zip(grid.line.points_m.iter().zip(&grid.line.normals))
        {
            let mut nodes = foot.nodes;
            nodes.sort_unstable();
            let own = outside.triangles.iter().any(|t| {
                let mut t = *t;
                t.sort_unstable();
                t == nodes
            });
            assert!(own && foot.shares.iter().all(|s| (-1e-9..=1.0 + 1e-9).contains(s)));
            let at = foot.at(|node| mesh.nodes[node as usize]);
            assert!((0..3).all(|a| (at[a] - point[a]).abs() < 1e-12));
            let length: f64 = normal.iter().map(|x| x * x).sum();
            assert!((length - 1.0).abs() < 1e-9);
        }
    }
}

#[test]
fn balls_and_bricks_are_struck_from_outside_all_around() {
    let (ball, _) = grid(&ball_tet10(0.05, 3, 1));
    for (point, normal) in ball.line.points_m.iter().zip(&ball.line.normals) {
        let out: f64 = (0..3).map(|a| point[a] * normal[a]).sum();
        assert!(out > 0.0495 && out < 0.0501, "{out}");
    }
    // Broad sides of a plate are reached over their whole width.
    let (plate, _) = grid(&brick_tet10([0.2, 0.05, 0.004], [8, 2, 1]));
    let on_top = |p: &&[f64; 3]| p[2] > 0.00199;
    let reach = plate.line.points_m.iter().filter(on_top);
    let reach = reach.fold(0.0, |most: f64, p| most.max(p[1].abs()));
    assert!(reach > 0.012, "{reach}");
    let hollow = grid(&hollow_ball_tet10([0.04, 0.05], 3, 1)).0;
    let near = |p: &[f64; 3]| p.iter().map(|x| x * x).sum::<f64>().sqrt() > 0.049;
    assert!(hollow.line.points_m.iter().all(near));
}

/// What is struck moves as the mesh does: a rod's first mode is that of a beam along the grid.
#[test]
fn shapes_on_the_grid_are_those_of_the_mesh() {
    let mesh = brick_tet10([0.2, 0.01, 0.006], [12, 1, 1]);
    let limits = Limits {
        highest_hz: 3000.0,
        most: 10,
        tuned: None,
    };
    let body = free_body(&mesh, &material(), limits, &()).unwrap();
    let (first, line) = (&body.solved.modes[0], &body.solved.line);
    let columns = line.grid().columns;
    let end = first.shape[0][2].abs();
    let middle = first.shape[columns / 2][2].abs();
    // Free beam: 0.6079 of the end's motion in the middle (Blevins 1979, table 8-1).
    assert!(
        (f64::from(middle / end) - 0.6079).abs() < 0.01,
        "{}",
        middle / end
    );
    // 2/√m at the end.
    let expected = 2.0 / body.solved.mass_kg.sqrt();
    assert!((f64::from(end) / expected - 1.0).abs() < 0.01);
    assert!((body.solved.mass_kg / (2700.0 * 0.2 * 0.01 * 0.006) - 1.0).abs() < 1e-9);
    assert!((body.solved.length_m - 0.2).abs() < 1e-12);
}

#[test]
fn many_modes_are_cut_to_the_number_asked_for() {
    let mesh = brick_tet10([0.2, 0.01, 0.006], [12, 1, 1]);
    let of = |most| {
        let limits = Limits {
            highest_hz: 200e3,
            most,
            tuned: None,
        };
        free_body(&mesh, &material(), limits, &())
            .unwrap()
            .solved
            .modes
            .len()
    };
    let found = of(20);
    assert!((12..=20).contains(&found), "{found}");
}
