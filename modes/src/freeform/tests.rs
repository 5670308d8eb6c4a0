//! Bodies of any shape against closed forms and other methods.

mod banks;
mod brick;
mod cylinder;
mod grids;
mod kits;
mod lamb;
mod made;
mod tube;

use super::{Limits, free_body};
use crate::Material;
use crate::mesh::Mesh;

/// Aluminium.
fn material() -> Material {
    Material::from_young(70e9, 0.33, 2700.0).unwrap()
}

/// Frequencies in Hz of the elastic modes of `mesh` below `highest_hz`.
fn modes_hz(mesh: &Mesh, highest_hz: f64) -> Vec<f64> {
    let limits = Limits {
        highest_hz,
        most: 1000,
        tuned: None,
    };
    let body = free_body(mesh, &material(), limits, &()).unwrap();
    body.solved.modes.iter().map(|mode| mode.hz).collect()
}

/// Greatest relative difference of the first `count` frequencies.
fn worst(found: &[f64], expected: &[f64], count: usize) -> f64 {
    assert!(found.len() >= count && expected.len() >= count, "{found:?}");
    let pairs = found.iter().zip(expected).take(count);
    pairs.fold(0.0, |worst, (found, expected)| {
        (found / expected - 1.0).abs().max(worst)
    })
}
