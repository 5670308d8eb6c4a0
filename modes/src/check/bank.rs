//! The chimes bank, built from nothing.

use super::{CheckError, Row};
use crate::factory::{Silent, build};
use crate::{Family, Recipe, equal_temperament_hz};
use std::time::Instant;

pub(super) fn rows() -> Result<Vec<Row>, CheckError> {
    let (name, text) = Recipe::FACTORY[0];
    let recipe = Recipe::parse(text, name)?;
    let start = Instant::now();
    let bank = build(&recipe, &Silent)?;
    let seconds = start.elapsed().as_secs_f64();
    let cents_off = |body: &crate::Body| {
        let fundamental = body.modes.iter().find(|mode| {
            mode.label.family == Family::Bending && mode.label.index == recipe.tuning.partial
        });
        let pitch_hz = equal_temperament_hz(body.key, recipe.tuning.a4_hz);
        fundamental.map_or(f64::NAN, |mode| 1200.0 * (mode.hz / pitch_hz).log2().abs())
    };
    let worst_cents =
        bank.bodies.iter().map(cents_off).fold(
            0.0,
            |worst: f64, cents| if cents <= worst { worst } else { cents },
        );
    Ok(vec![
        Row {
            name: "chimes: keys with a body".to_owned(),
            reference: 61.0,
            value: bank.bodies.len() as f64,
            unit: "",
            error: (61.0 - bank.bodies.len() as f64).max(0.0),
            bound: 0.0,
            ok: bank.bodies.len() >= 61,
            source: "the recipe",
        },
        Row::absolute(
            "chimes: key farthest from equal temperament",
            (0.0, worst_cents, "cents"),
            recipe.tuning.tolerance_cents,
            "A4 = 440 Hz",
        ),
        Row::absolute(
            "chimes: greatest relative residual",
            (0.0, bank.provenance.max_residual, ""),
            1e-6,
            "‖Kφ − λMφ‖ / ‖Kφ‖",
        ),
        Row::absolute(
            "chimes: departure from mass-orthonormality",
            (0.0, bank.provenance.max_orthonormality_error, ""),
            1e-12,
            "|ΦᵀMΦ − I|",
        ),
        Row::absolute(
            "chimes: time to tune and solve every key",
            (0.0, seconds, "s"),
            60.0,
            "two cores",
        ),
    ])
}
