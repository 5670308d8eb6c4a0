//! Hollow bodies.

use super::*;
use crate::Material;
use crate::fem::{TetMass, assemble};
use std::f64::consts::PI;

#[test]
fn walls_of_cells_have_their_volumes() {
    let ball = 4.0 / 3.0 * PI * (1e-3 - 0.08f64.powi(3));
    for (name, soup, volume_m3, error) in [
        ("ball", gallery::sphere(0.1, 4), ball, 3e-3),
        (
            "cube",
            gallery::cuboid([0.1; 3]),
            1e-3 - 0.06f64.powi(3),
            1e-9,
        ),
    ] {
        println!("{name}");
        let meshed = meshed(&soup, &hollow(0.02, 20_000));
        let share = meshed.quality.volume_m3 / volume_m3;
        assert!((share - 1.0).abs() < error, "{name}: {share}");
        assert!(meshed.quality.min_dihedral_deg > 15.0);
    }
}

#[test]
fn thin_walls_have_their_volumes() {
    let ball = 4.0 / 3.0 * PI * (1e-3 - 0.096f64.powi(3));
    let can = PI * (0.0025 * 0.12 - 0.047f64.powi(2) * 0.114);
    let torus = 2.0 * PI * PI * 0.1 * (0.0016 - 0.037f64.powi(2));
    for (name, soup, wall_m, volume_m3, error) in [
        ("ball", gallery::sphere(0.1, 5), 0.004, ball, 2e-3),
        (
            "cube",
            gallery::cuboid([0.1; 3]),
            0.003,
            1e-3 - 0.094f64.powi(3),
            1e-3,
        ),
        ("can", gallery::cylinder(0.05, 0.12, 128), 0.003, can, 3e-3),
        ("torus", gallery::torus(0.1, 0.04, 128), 0.003, torus, 3e-3),
    ] {
        println!("{name}");
        let meshed = meshed(&soup, &hollow(wall_m, 12_000));
        let share = meshed.quality.volume_m3 / volume_m3;
        println!("  volume {:.1e}", share - 1.0);
        assert!((share - 1.0).abs() < error, "{name}: {share}");
        assert!(meshed.quality.nodes < 18_000);
        // Wedges are wider than high, and flat where they are; few are spoilt by it.
        assert!(meshed.quality.min_dihedral_deg > 4.0);
        assert!(meshed.quality.straight_share < 0.01);
        if name == "cube" {
            let outside = closed::signed_volume(&meshed.mesh.nodes, &meshed.mesh.surface());
            assert!((outside / volume_m3 - 1.0).abs() < 1e-9, "{outside}");
        }
    }
}

/// Wedges may be so much wider than high and no more.
#[test]
fn a_wall_that_needs_more_nodes_says_so() {
    let meshed = meshed(&gallery::sphere(0.1, 4), &hollow(0.004, 2_000));
    let (thin_m, nodes, asked) = (0.004, meshed.quality.nodes, 2_000);
    let finer = Note::Finer {
        thin_m,
        nodes,
        asked,
    };
    assert_eq!(meshed.notes, [finer]);
}

#[test]
fn a_wall_that_fills_the_body_is_said_to() {
    let meshed = meshed(&gallery::cuboid([0.1; 3]), &hollow(0.06, 2_000));
    let wall_m = 0.06;
    assert_eq!(meshed.notes, [Note::WallFills { wall_m }]);
    assert!((meshed.quality.volume_m3 / 1e-3 - 1.0).abs() < 1e-9);
}

/// A star's tips are sharper than its wall is thick: the wall is thinner there, and said to be.
#[test]
fn a_wall_does_not_fold_in_sharp_edges() {
    let star = gallery::star(12, 0.1, 0.06);
    let wall_m = 0.002;
    let meshed = meshed(&star, &hollow(wall_m, 12_000));
    let thinner = |note: &Note| matches!(note, Note::Thinner { .. });
    assert!(meshed.notes.iter().any(thinner), "{:?}", meshed.notes);
    let share = meshed.quality.volume_m3 / (wall_m * meshed.surface.area_m2());
    assert!((0.85..1.0).contains(&share), "{share}");
    // Flat they are, but every one can be integrated over.
    let steel = Material::from_young(2e11, 0.3, 7800.0).unwrap();
    assert!(assemble(&meshed.mesh, &steel, TetMass::Consistent).is_ok());
}
