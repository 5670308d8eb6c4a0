//! Known bodies through the whole path.

use super::*;
use crate::factory::Silent;
use std::f64::consts::PI;
use std::time::Instant;

mod hostile;

fn meshed(soup: &Soup, how: &Meshing) -> Meshed {
    let surface = repair(soup, &Repair::default()).unwrap();
    let start = Instant::now();
    let meshed = mesh_solid(&surface, how, &Silent).unwrap();
    println!(
        "{:?} {:.2} s",
        meshed.quality,
        start.elapsed().as_secs_f64()
    );
    for note in &meshed.notes {
        println!("  {note}");
    }
    meshed
}

fn nodes(nodes: usize) -> Meshing {
    Meshing {
        resolution: Resolution::Nodes(nodes),
        ..Meshing::default()
    }
}

#[test]
fn known_bodies_have_their_volumes() {
    let ball = gallery::sphere(0.1, 5);
    let cube = gallery::cuboid([0.1; 3]);
    let slab = gallery::cuboid([0.1, 0.23, 0.017]);
    let torus = gallery::torus(0.1, 0.04, 200);
    let can = gallery::cylinder(0.05, 0.12, 128);
    for (name, soup, volume_m3) in [
        ("ball", ball, 4.0 / 3.0 * PI * 1e-3),
        ("cube", cube, 1e-3),
        ("slab", slab, 0.1 * 0.23 * 0.017),
        ("torus", torus, 2.0 * PI * PI * 0.1 * 0.0016),
        ("can", can, PI * 0.0025 * 0.12),
    ] {
        println!("{name}");
        let meshed = meshed(&soup, &nodes(8_000));
        let error = meshed.quality.volume_m3 / volume_m3 - 1.0;
        println!("  volume {error:e}");
    }
}
