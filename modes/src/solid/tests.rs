//! Known bodies through the whole path.

mod hostile;
mod known;
mod sheets;
mod walls;

use super::*;
use crate::factory::{Progress, Silent};
use std::ops::ControlFlow;
use std::time::Instant;

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

fn hollow(wall_m: f64, most: usize) -> Meshing {
    Meshing {
        wall_m: Some(wall_m),
        ..nodes(most)
    }
}

/// The area of the boundary's curved triangles, each in 64 flat ones.
fn area_m2(meshed: &Meshed) -> f64 {
    const STEPS: u32 = 8;
    let place = |face: [u32; 6], i: u32, j: u32| {
        let [s, t] = [i, j].map(|k| f64::from(k) / f64::from(STEPS));
        let r = 1.0 - s - t;
        let corner = |l: f64| l * (2.0 * l - 1.0);
        let weights = [
            corner(r),
            corner(s),
            corner(t),
            4.0 * r * s,
            4.0 * s * t,
            4.0 * t * r,
        ];
        let nodes = face.map(|node| meshed.mesh.nodes[node as usize]);
        let weighted = nodes.into_iter().zip(weights);
        weighted.fold([0.0; 3], |sum, (p, w)| {
            vector::add(sum, vector::scale(p, w))
        })
    };
    let mut area = 0.0;
    for face in meshed.mesh.faces() {
        // The three small triangles at its corners begin with the middle of the side before.
        let [first, second, third] = [0, 1, 2].map(|k| face.triangles[k]);
        let face = [first[1], second[1], third[1], first[2], second[2], third[2]];
        for i in 0..STEPS {
            for j in 0..STEPS - i {
                let [p, q, r] = [[i, j], [i + 1, j], [i, j + 1]].map(|[i, j]| place(face, i, j));
                area += 0.5 * vector::norm(vector::doubled_area([p, q, r]));
                if i + j + 1 < STEPS {
                    let s = place(face, i + 1, j + 1);
                    area += 0.5 * vector::norm(vector::doubled_area([q, s, r]));
                }
            }
        }
    }
    area
}

/// Breaks once it has been asked so often.
struct Impatient(std::sync::atomic::AtomicUsize);

impl Progress for Impatient {
    fn advance(&self, done: usize, total: usize) -> ControlFlow<()> {
        assert!(done <= total);
        match self.0.fetch_sub(1, std::sync::atomic::Ordering::Relaxed) {
            0 => ControlFlow::Break(()),
            _ => ControlFlow::Continue(()),
        }
    }
}

#[test]
fn it_stops_when_told() {
    let surface = repair(&gallery::sphere(0.1, 3), &Repair::default()).unwrap();
    for patience in [0, 1, 3, 6] {
        let impatient = Impatient(patience.into());
        let stopped = mesh_solid(&surface, &nodes(3_000), &impatient);
        assert_eq!(stopped, Err(MeshError::Cancelled));
    }
}

#[test]
fn sizes_walls_and_budgets_that_cannot_be_are_refused() {
    let ball = gallery::sphere(0.1, 3);
    let sized = |size_m| {
        let size_m = Some(size_m);
        repair(
            &ball,
            &Repair {
                size_m,
                ..Repair::default()
            },
        )
    };
    for size_m in [f64::NAN, 0.0, -1.0, 1e9] {
        assert!(matches!(sized(size_m), Err(MeshError::Length { .. })));
    }
    let surface = sized(0.5).unwrap();
    let (low, high) = surface.bounds_m();
    assert!((high[2] - low[2] - 0.5).abs() < 1e-3 && (high[2] + low[2]).abs() < 1e-12);
    let tiny = Resolution::CellM(1e-9);
    for how in [
        hollow(f64::NAN, 1_000),
        hollow(-0.1, 1_000),
        Meshing {
            resolution: tiny,
            ..nodes(1_000)
        },
    ] {
        let refused = mesh_solid(&surface, &how, &Silent);
        assert!(matches!(refused, Err(MeshError::Length { .. })));
    }
    let plate = repair(&gallery::star(5, 0.1, 2e-4), &Repair::default()).unwrap();
    let how = Meshing {
        most_nodes: 5_000,
        ..nodes(5_000)
    };
    let refused = mesh_solid(&plate, &how, &Silent);
    assert!(
        matches!(refused, Err(MeshError::TooThin { .. })),
        "{refused:?}"
    );
}

#[test]
fn our_own_shapes_are_bodies() {
    for (name, soup, most) in [
        ("bell", gallery::bell(0.05), 100_000),
        ("cup", gallery::cup(0.04, 0.09, 0.006), 40_000),
        ("wok", gallery::wok(0.1, 0.05, 0.008), 40_000),
        ("star", gallery::star(5, 0.06, 0.01), 8_000),
        ("key", gallery::key(0.08), 8_000),
        ("shelf", gallery::shelf(3, [0.4, 0.2, 0.5], 0.05), 20_000),
        (
            "a letter",
            gallery::the_end(0.1).object("e").unwrap(),
            8_000,
        ),
        (
            "a box",
            gallery::stack(10, 0.1).object("box 10").unwrap(),
            2_000,
        ),
    ] {
        println!("{name}");
        let meshed = meshed(
            &soup,
            &Meshing {
                most_nodes: most,
                ..nodes(most)
            },
        );
        let surface = meshed.surface.volume_m3();
        let share = meshed.quality.volume_m3 / surface;
        // Where parts go through each other the surface counts them twice.
        let once = if meshed.notes.contains(&Note::Overlaps) {
            0.9
        } else {
            0.99
        };
        assert!((once..1.005).contains(&share), "{name}: {share}");
        assert!(meshed.quality.min_dihedral_deg > 10.0, "{name}");
    }
    assert_eq!(gallery::the_end(0.1).objects.len(), 6);
    assert_eq!(gallery::stack(10, 0.1).objects.len(), 10);
}
