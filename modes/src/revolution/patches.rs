//! The patches of a body of revolution that touch the air, and how a mode moves them.

use super::Wall;
use crate::radiation::Surface;
use std::f64::consts::{FRAC_2_PI, TAU};

/// Patches of the surface around the axis: three to each wave of the most that bowls have.
const PATCHES_AROUND: usize = 64;

/// Outward unit normal (r, z) of a side: the body is on its left.
pub(super) fn side_normal(wall: &Wall, side: &[u32; 3]) -> [f64; 2] {
    let [start, _, end] = side.map(|node| wall.meridian.nodes_m[node as usize]);
    let (dr, dz) = (end[0] - start[0], end[1] - start[1]);
    let length = dr.hypot(dz);
    [dz / length, -dr / length]
}

/// Normal motion on the patches: side by side, around the axis.
pub(super) fn around(sides: &[f64], order: f64, turn: f64) -> Vec<f32> {
    let waves: Vec<f64> = (0..PATCHES_AROUND)
        .map(|i| (order * (patch_angle(i) - turn)).cos())
        .collect();
    sides
        .iter()
        .flat_map(|side| waves.iter().map(move |wave| (side * wave) as f32))
        .collect()
}

/// ∫|φ·n| dS of motions cos mθ times these on the sides; the mean of |cos mθ| is 2/π.
pub(super) fn rectified_area(wall: &Wall, sides: &[f64], order: usize) -> f64 {
    let share = if order == 0 { 1.0 } else { FRAC_2_PI };
    let rings = wall.heard.iter().zip(sides);
    rings
        .map(|(side, motion)| share * TAU * ring_m2(wall, side) * motion.abs())
        .sum()
}

/// Area of the ring that a side sweeps, to each radian, in m².
fn ring_m2(wall: &Wall, side: &[u32; 3]) -> f64 {
    let [p, q, r] = side.map(|node| wall.meridian.nodes_m[node as usize]);
    (r[0] - p[0]).hypot(r[1] - p[1]) * q[0]
}

fn patch_angle(i: usize) -> f64 {
    TAU * (i as f64 + 0.5) / PATCHES_AROUND as f64
}

/// A point or direction (r, z) at the angle θ, in the frame of the row: the strike line, θ = 0,
/// faces the player, towards −y; z is up.
fn turned([r, z]: [f64; 2], angle: f64) -> [f64; 3] {
    let (sin, cos) = angle.sin_cos();
    [r * sin, -r * cos, z]
}

pub(super) fn surface(wall: &Wall) -> Surface {
    let (mut low, mut high) = (f64::INFINITY, f64::NEG_INFINITY);
    for node in &wall.meridian.nodes_m {
        (low, high) = (low.min(node[1]), high.max(node[1]));
    }
    let middle = 0.5 * (low + high);
    let mut surface = Surface {
        mouth_m: wall.mouth_m.map(|[r, z]| [r, z - middle]),
        ..Surface::default()
    };
    for side in &wall.heard {
        let q = wall.meridian.nodes_m[side[1] as usize];
        let normal = side_normal(wall, side);
        let area = ring_m2(wall, side) * TAU / PATCHES_AROUND as f64;
        for i in 0..PATCHES_AROUND {
            surface
                .points_m
                .push(turned([q[0], q[1] - middle], patch_angle(i)));
            surface.normals.push(turned(normal, patch_angle(i)));
            surface.areas_m2.push(area);
        }
    }
    surface
}
