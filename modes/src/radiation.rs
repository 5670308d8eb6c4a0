//! How strongly a mode's motion drives the air.

mod baffle;
mod cylinder;
mod huygens;
mod pipe;
mod surface;
mod turn;

pub use baffle::{baffled_decay_per_s, beamed_decay_per_s};
pub use cylinder::cylinder_decay_per_s;
pub use huygens::{Listener, Transfers};
pub use pipe::Pipe;
pub use surface::Surface;

/// Density of air at 20 °C in kg/m³ (O'Brien, Cook & Essl 2001, §3.2).
pub const AIR_KG_M3: f64 = 1.21;

/// Speed of sound in air at 20 °C in m/s (the same).
pub const SOUND_M_S: f64 = 343.0;

use std::f64::consts::TAU;

/// ∫|φ·n| dS in m² kg^(−1/2) over the triangles (numbered counter-clockwise from outside) of a
/// surface: "summing the amount of normal displacement … over the surface" (O'Brien 2002 §3.4).
///
/// `mode` holds three displacements to a node.
#[must_use]
pub fn rectified_area(nodes: &[[f64; 3]], triangles: &[[u32; 3]], mode: &[f64]) -> f64 {
    triangles
        .iter()
        .map(|triangle| {
            let [p, q, r] = triangle.map(|node| nodes[node as usize]);
            let (u, v) = (
                [0, 1, 2].map(|a| q[a] - p[a]),
                [0, 1, 2].map(|a| r[a] - p[a]),
            );
            let normal = [
                0.5 * (u[1] * v[2] - u[2] * v[1]),
                0.5 * (u[2] * v[0] - u[0] * v[2]),
                0.5 * (u[0] * v[1] - u[1] * v[0]),
            ];
            let mean = |a: usize| {
                triangle
                    .iter()
                    .map(|&node| mode[3 * node as usize + a])
                    .sum::<f64>()
                    / 3.0
            };
            (0..3).map(|a| normal[a] * mean(a)).sum::<f64>().abs()
        })
        .sum()
}

/// A mode's coupling to the air: its rectified area times 2π times its frequency in Hz, in
/// m² kg^(−1/2) / s.
#[must_use]
pub fn coupling(rectified_area: f64, hz: f64) -> f64 {
    TAU * hz * rectified_area
}
