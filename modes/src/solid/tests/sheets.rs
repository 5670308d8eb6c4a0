//! Closed surfaces around thin sheets.

use super::*;
use crate::TABLE_1;
use crate::fem::{Harmonic, Meridian, TetMass, assemble};
use crate::solve::{Band, lowest_of, modes_in_band};
use std::collections::HashSet;

/// The least and greatest thickness of the sheet that a body was taken as, in m.
fn thickness_m(meshed: &Meshed) -> Option<[f64; 2]> {
    meshed.notes.iter().find_map(|note| match *note {
        Note::Sheet { thin_m, thick_m } => Some([thin_m, thick_m]),
        _ => None,
    })
}

/// A round lip is cut off, and what tapers to it may be; everything else is all there.
#[test]
fn sheets_have_the_volumes_of_their_surfaces() {
    for (name, soup, nodes_asked, thick_m, error) in [
        (
            "cup",
            gallery::cup(0.04, 0.09, 0.002),
            12_000,
            [0.00199, 0.00201],
            2e-3,
        ),
        (
            "wok",
            gallery::wok(0.18, 0.09, 0.002),
            12_000,
            [0.00199, 0.00201],
            2e-3,
        ),
        ("bell", gallery::bell(0.15), 8_000, [0.009, 0.022], 6e-3),
        (
            "plate",
            gallery::cuboid([0.3, 0.2, 0.002]),
            8_000,
            [0.00199, 0.00201],
            1e-9,
        ),
        (
            "star",
            gallery::star(5, 0.1, 0.002),
            8_000,
            [0.00199, 0.00201],
            1e-9,
        ),
        (
            "round lip",
            round_lip(0.04, 0.09, 0.002),
            12_000,
            [0.00199, 0.00201],
            5e-3,
        ),
        ("shell", shell(0.1, 0.002), 12_000, [0.00199, 0.00201], 1e-3),
    ] {
        println!("{name}");
        let meshed = meshed(&soup, &nodes(nodes_asked));
        let [thin_m, most_m] = thickness_m(&meshed).unwrap();
        assert!(thin_m >= thick_m[0] && most_m <= thick_m[1], "{name}");
        let share = meshed.quality.volume_m3 / meshed.surface.volume_m3();
        assert!((share - 1.0).abs() < error, "{name}: {share}");
        assert!(meshed.quality.straight_share < 0.03, "{name}");
        assert!(closes(&meshed.mesh.surface()), "{name}");
    }
}

/// Whether each edge is gone along once one way and once the other.
fn closes(triangles: &[[u32; 3]]) -> bool {
    let sides = triangles
        .iter()
        .flat_map(|&[a, b, c]| [[a, b], [b, c], [c, a]]);
    let once: HashSet<[u32; 2]> = sides.clone().collect();
    once.len() == 3 * triangles.len() && sides.into_iter().all(|[a, b]| once.contains(&[b, a]))
}

/// A cup whose lip is half a circle.
fn round_lip(radius_m: f64, height_m: f64, wall_m: f64) -> Soup {
    let at = |z: f64| radius_m * (0.9 + 0.1 * z / height_m);
    let side = |inset: f64, from: f64| -> Vec<[f64; 2]> {
        let steps = (0..=8).map(|k| from + (height_m - from) * f64::from(k) / 8.0);
        steps.map(|z| [at(z) - inset, z]).collect()
    };
    let mut outline = vec![[0.0, 0.0]];
    outline.extend(side(0.0, 0.0));
    outline.extend((1..8).map(|k| {
        let (sin, cos) = (std::f64::consts::PI * f64::from(k) / 8.0).sin_cos();
        let half_m = 0.5 * wall_m;
        [radius_m - half_m + half_m * cos, height_m + half_m * sin]
    }));
    outline.extend(side(wall_m, wall_m).into_iter().rev());
    outline.push([0.0, wall_m]);
    gallery::revolve(&outline, 90)
}

/// A ball with a hollow in it.
fn shell(radius_m: f64, wall_m: f64) -> Soup {
    let (mut points, mut triangles) = gallery::sphere(radius_m, 4).into_parts();
    let (inner, turned) = gallery::sphere(radius_m - wall_m, 4).into_parts();
    let first = points.len() as u32;
    points.extend(inner);
    triangles.extend(
        turned
            .into_iter()
            .map(|[a, b, c]| [a, c, b].map(|i| i + first)),
    );
    Soup::single(points, triangles)
}

/// Boards that meet, a cup with a handle and what is thick are not one sheet.
#[test]
fn other_bodies_are_filled_as_before() {
    let mut handled = gallery::cup(0.04, 0.09, 0.004);
    let (points, triangles) = gallery::torus(0.025, 0.005, 48).into_parts();
    let first = handled.points.len() as u32;
    // Upright, through the wall.
    handled
        .points
        .extend(points.into_iter().map(|[x, y, z]| [x + 0.055, z, y + 0.05]));
    handled.triangles.extend(
        triangles
            .into_iter()
            .map(|[a, b, c]| [a, c, b].map(|i| i + first)),
    );
    for (name, soup) in [
        ("shelf", gallery::shelf(3, [0.4, 0.2, 0.5], 0.05)),
        (
            "cup with a handle",
            Soup::single(handled.points, handled.triangles),
        ),
        ("ball", gallery::sphere(0.1, 4)),
        ("thick tube", tube([0.01, 0.02], 0.1)),
    ] {
        println!("{name}");
        let meshed = meshed(&soup, &nodes(6_000));
        assert_eq!(thickness_m(&meshed), None, "{name}");
    }
}

/// A tube of these radii in m with both its walls.
fn tube([inner_m, outer_m]: [f64; 2], length_m: f64) -> Soup {
    let outline = [
        [inner_m, 0.0],
        [outer_m, 0.0],
        [outer_m, length_m],
        [inner_m, length_m],
    ];
    gallery::revolve(&outline, 72)
}

/// The wok of a 2 mm wall against its own meridian, 8-node quadrilaterals, by harmonics.
#[test]
fn a_thin_wok_has_the_modes_of_its_meridian() {
    let (radius_m, depth_m, wall_m): (f64, f64, f64) = (0.18, 0.09, 0.002);
    let ball_m = (radius_m * radius_m + depth_m * depth_m) / (2.0 * depth_m);
    let opening = (radius_m / ball_m).asin();
    let cells = 100;
    let meridian = Meridian::new(
        [cells, 1],
        |_, _| true,
        |i, j| {
            let r_m = ball_m - 0.5 * wall_m * j as f64;
            if i == 0 {
                return [0.0, -r_m];
            }
            let (sin, cos) = (opening * i as f64 / (2 * cells) as f64).sin_cos();
            [r_m * sin, -r_m * cos]
        },
    );
    let material = TABLE_1[0].material;
    let band = Band {
        high_hz: 900.0,
        ..Band::AUDIBLE
    };
    let mut expected: Vec<f64> = (0..9)
        .flat_map(|order| {
            let pencil = Harmonic::new(&meridian, &material, order).unwrap().pencil;
            let modes = modes_in_band(&pencil, band).unwrap().modes.into_iter();
            let twice = if order == 0 { 1 } else { 2 };
            modes
                .flat_map(move |mode| std::iter::repeat_n(mode.hz, twice))
                .collect::<Vec<_>>()
        })
        .collect();
    expected.sort_by(f64::total_cmp);
    let worst = |asked: usize| {
        let meshed = meshed(&gallery::wok(radius_m, depth_m, wall_m), &nodes(asked));
        let pencil = assemble(&meshed.mesh, &material, TetMass::Consistent).unwrap();
        let hz = lowest_of(&pencil, 10).unwrap();
        let errors = hz
            .iter()
            .zip(&expected)
            .map(|(hz, exact)| (hz / exact - 1.0).abs());
        errors.fold(0.0, f64::max)
    };
    assert!(expected.len() >= 10, "{expected:?}");
    let (coarse, fine) = (worst(8_000), worst(20_000));
    println!("wok: {coarse:.1e}, {fine:.1e}");
    assert!(coarse < 0.01 && fine < 0.003, "{coarse} {fine}");
}

/// Each edge of the triangles that large meshes are drawn by belongs to two of them, one way each.
#[test]
fn fewer_triangles_close_a_sheet_too() {
    let meshed = meshed(&gallery::cup(0.04, 0.09, 0.002), &nodes(12_000));
    let faces = meshed.mesh.faces();
    let few: Vec<[u32; 3]> = faces.iter().flat_map(|face| face.few.clone()).collect();
    let all: usize = faces.iter().map(|face| face.triangles.len()).sum();
    assert!(2 * few.len() < all, "{} of {all}", few.len());
    let edges = few.iter().flat_map(|&[a, b, c]| [[a, b], [b, c], [c, a]]);
    let mut waiting = HashSet::new();
    for [from, to] in edges {
        if !waiting.remove(&[to, from]) {
            assert!(waiting.insert([from, to]), "{from} to {to} twice");
        }
    }
    assert!(waiting.is_empty(), "{} edges are open", waiting.len());
}
