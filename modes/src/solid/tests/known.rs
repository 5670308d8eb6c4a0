//! Bodies whose volumes, areas and frequencies are known.

use super::*;
use crate::Material;
use crate::fem::{TetMass, assemble};
use crate::solve::{Band, modes_in_band};
use std::f64::consts::{PI, TAU};

/// Volume and area of the surface as the file has it, facets and all: what a mesh can come to.
struct Known {
    name: &'static str,
    soup: Soup,
    volume_m3: f64,
    area_m2: f64,
    /// Of both, for what facets lack.
    error: f64,
}

fn known() -> Vec<Known> {
    let (r, t) = (0.1, 0.04);
    vec![
        Known {
            name: "ball",
            soup: gallery::sphere(r, 5),
            volume_m3: 4.0 / 3.0 * PI * r.powi(3),
            area_m2: 4.0 * PI * r * r,
            error: 1e-3,
        },
        Known {
            name: "cube",
            soup: gallery::cuboid([r; 3]),
            volume_m3: r.powi(3),
            area_m2: 6.0 * r * r,
            error: 1e-11,
        },
        Known {
            name: "plate",
            soup: gallery::cuboid([0.1, 0.23, 0.017]),
            volume_m3: 0.1 * 0.23 * 0.017,
            area_m2: 2.0 * (0.1 * 0.23 + 0.1 * 0.017 + 0.23 * 0.017),
            error: 1e-11,
        },
        Known {
            name: "torus",
            soup: gallery::torus(r, t, 200),
            volume_m3: 2.0 * PI * PI * r * t * t,
            area_m2: 4.0 * PI * PI * r * t,
            error: 2e-3,
        },
        Known {
            name: "can",
            soup: gallery::cylinder(0.05, 0.12, 128),
            volume_m3: PI * 0.0025 * 0.12,
            area_m2: TAU * 0.05 * (0.12 + 0.05),
            error: 1e-3,
        },
    ]
}

#[test]
fn volumes_areas_and_angles_are_as_they_should_be() {
    for body in known() {
        println!("{}", body.name);
        let meshed = meshed(&body.soup, &nodes(8_000));
        let quality = meshed.quality;
        let volume = quality.volume_m3 / body.volume_m3 - 1.0;
        let area = area_m2(&meshed) / body.area_m2 - 1.0;
        println!("  volume {volume:.1e}, area {area:.1e}");
        assert!(volume.abs() < body.error, "{}: {volume:e}", body.name);
        assert!(area.abs() < body.error, "{}: {area:e}", body.name);
        assert!(quality.min_dihedral_deg > 20.0 && quality.max_dihedral_deg < 145.0);
        // The layers of a plate's cells are whole, so its nodes come in steps.
        let least = if body.name == "plate" { 4_000 } else { 6_800 };
        assert!((least..8_300).contains(&quality.nodes), "{}", quality.nodes);
        assert!(
            meshed.notes.is_empty() || body.name == "plate",
            "{:?}",
            meshed.notes
        );
    }
}

/// A cube turned so that no side lies along the lattice keeps its edges and corners.
#[test]
fn edges_and_corners_are_kept_wherever_they_lie() {
    let (mut points, triangles) = gallery::cuboid([0.1; 3]).into_parts();
    let (sin, cos) = 0.5f64.sin_cos();
    for p in &mut points {
        let [x, y, z] = *p;
        let [x, y] = [cos * x - sin * y, sin * x + cos * y];
        *p = [x, cos * y - sin * z, sin * y + cos * z];
    }
    let meshed = meshed(&Soup::single(points, triangles), &nodes(8_000));
    assert!((meshed.quality.volume_m3 / 1e-3 - 1.0).abs() < 1e-3);
    let at_corner = |corner: &[f64; 3]| {
        let nodes = meshed.mesh.nodes.iter();
        nodes
            .map(|&node| vector::distance(node, *corner))
            .fold(1.0, f64::min)
            < 1e-12
    };
    assert!(meshed.surface.points_m.iter().all(at_corner));
}

/// A root of `f` between `low` and `high`, where it changes sign.
fn root(f: impl Fn(f64) -> f64, mut low: f64, mut high: f64) -> f64 {
    let sign = f(low) > 0.0;
    for _ in 0..60 {
        let middle = 0.5 * (low + high);
        if (f(middle) > 0.0) == sign {
            low = middle;
        } else {
            high = middle;
        }
    }
    low
}

/// The halves of a free ball turn against each other, lowest of all and five times over, where
/// x j₃(x) = j₂(x) for x = ωR/c with the speed c of shear waves (Lamb 1882, §4); in sines and cosines:
/// (12 − 5x²) sin x = x (12 − x²) cos x.
#[test]
fn the_ball_rings_as_lamb_says() {
    let material = Material::from_young(2e11, 0.3, 7800.0).unwrap();
    let shear_m_s = (material.mu_pa / material.density_kg_m3).sqrt();
    let x = root(
        |x| (12.0 - 5.0 * x * x) * x.sin() - x * (12.0 - x * x) * x.cos(),
        2.0,
        3.0,
    );
    let lowest_hz = x * shear_m_s / (TAU * 0.1);
    let meshed = meshed(&gallery::sphere(0.1, 5), &nodes(3_000));
    let pencil = assemble(&meshed.mesh, &material, TetMass::Consistent).unwrap();
    let band = Band {
        low_hz: 20.0,
        high_hz: 15_000.0,
    };
    let found = modes_in_band(&pencil, band).unwrap().modes;
    assert_eq!(found.len(), 10);
    for mode in &found[..5] {
        let error = mode.hz / lowest_hz - 1.0;
        assert!(
            error.abs() < 1e-3,
            "{} Hz for {lowest_hz}: {error:e}",
            mode.hz
        );
    }
}
