//! What the air takes from a bar's modes: the bar as a cylinder that stirs the air as its sections
//! do.

use super::quarter::{Class, Quarter};
use crate::Family;
use crate::radiation::cylinder_decay_per_s;
use crate::shape::Bar;
use std::f64::consts::PI;

/// Points across half the width.
const ACROSS: usize = 8;

/// Points along half the length.
const ALONG: usize = 100;

/// Rise half-way up the bar at points across the half section at `x_m` ≥ 0.
pub(super) fn rise_across(quarter: &Quarter, bar: &Bar, vector: &[f64], x_m: f64) -> [f64; ACROSS] {
    std::array::from_fn(|j| {
        let y_m = 0.5 * bar.width_m * (j as f64 + 0.5) / ACROSS as f64;
        quarter.at(vector, x_m, y_m, 0.5)[2]
    })
}

/// Amplitude decay rate in 1/s by the bar's own radiation.
///
/// In potential flow a strip of half width b that moves across its plane stirs the far air as a
/// cylinder of radius b/√2 does, and one that turns at the rate Ω as a cylinder of radius b whose
/// wall moves Ωb/8 · sin 2θ (Lamb 1932, §71–72, of the ellipse); the air that a section of area A
/// displaces adds A/2π to the square of the first radius.
pub(super) fn radiation_per_s(
    quarter: &Quarter,
    bar: &Bar,
    (class, family): (Class, Family),
    hz: f64,
    vector: &[f64],
) -> f64 {
    let thickness_m = bar.volume_m3() / (bar.length_m * bar.width_m);
    let dipole_m =
        |across_m: f64| (across_m * across_m / 8.0 + bar.width_m * thickness_m / (2.0 * PI)).sqrt();
    let (order, radius_m, axis) = match family {
        Family::Torsion => (2, 0.5 * bar.width_m, 2),
        Family::Lateral => (1, dipole_m(thickness_m), 1),
        _ => (1, dipole_m(bar.width_m), 2),
    };
    let step_m = 0.5 * bar.length_m / ALONG as f64;
    let half: Vec<f64> = (0..ALONG)
        .map(|i| {
            let x_m = (i as f64 + 0.5) * step_m;
            match family {
                Family::Torsion => quarter.at(vector, x_m, 0.5 * bar.width_m, 0.5)[2] / 8.0,
                Family::Lateral => quarter.at(vector, x_m, 0.0, 0.5)[1],
                _ => rise_across(quarter, bar, vector, x_m).iter().sum::<f64>() / ACROSS as f64,
            }
        })
        .collect();
    let image = class.mirrored(0)[axis];
    let mirrored = half.iter().rev().map(|u| image * u);
    let motion: Vec<f64> = mirrored.chain(half.iter().copied()).collect();
    cylinder_decay_per_s(hz, order, radius_m, step_m, &motion)
}
