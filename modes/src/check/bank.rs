//! The factory banks, built from nothing.

use super::{CheckError, Row, cents, factory, greater, retune};
use crate::factory::{Silent, build};
use crate::{Bank, Family, Member, Recipe, ShapeRecipe};
use std::time::Instant;

/// Longest time in s that opening a bank may take, from its file's content.
const OPEN_S: f64 = 0.05;

/// What all banks together may weigh, in MB.
const MAX_MB: f64 = 30.0;

/// Beats in Hz that are heard as such.
const BEATS_HZ: [f64; 2] = [0.3, 3.0];

pub(super) fn rows() -> Result<Vec<Row>, CheckError> {
    let (mut rows, mut seconds, mut bytes) = (Vec::new(), 0.0, 0);
    let mut slowest_s = 0.0;
    for (name, _) in Recipe::FACTORY {
        let recipe = factory(name)?;
        let start = Instant::now();
        let bank = build(&recipe, &Silent)?;
        seconds += start.elapsed().as_secs_f64();
        let file = bank.write();
        bytes += file.len();
        slowest_s = greater(slowest_s, retune::least_s(|| Ok(Bank::read(&file)?))?);
        let bank = bank.spread_out();
        rows.extend(quality(&recipe, &bank));
        if recipe.imperfection.is_some() {
            rows.extend(beats(&bank));
        }
    }
    rows.push(Row::absolute(
        "factory banks together",
        (0.0, bytes as f64 / 1e6, "MB"),
        MAX_MB,
        "what a plug-in may weigh",
    ));
    rows.push(Row::absolute(
        "factory banks together: time to tune and solve every key",
        (0.0, seconds, "s"),
        60.0,
        "two cores",
    ));
    rows.push(Row::absolute(
        "factory banks: time to open the slowest",
        (0.0, slowest_s, "s"),
        OPEN_S,
        "a change of instrument",
    ));
    rows.extend(retune::rows()?);
    Ok(rows)
}

fn quality(recipe: &Recipe, bank: &Bank) -> [Row; 4] {
    let name = &bank.name;
    let keys = recipe.keys.iter().len() as f64;
    let off = bank.bodies.iter().map(|body| pitch_off_cents(recipe, body));
    [
        Row::absolute(
            format!("{name}: keys with a body"),
            (keys, bank.bodies.len() as f64, ""),
            0.0,
            "the recipe",
        ),
        Row::absolute(
            format!("{name}: key farthest from equal temperament"),
            (0.0, off.fold(0.0, greater), "cents"),
            recipe.tuning.tolerance_cents,
            "A4 = 440 Hz",
        ),
        Row::absolute(
            format!("{name}: greatest relative residual"),
            (0.0, bank.provenance.max_residual, ""),
            1e-6,
            "‖Kφ − λMφ‖ / ‖Kφ‖",
        ),
        Row::absolute(
            format!("{name}: departure from mass-orthonormality"),
            (0.0, bank.provenance.max_orthonormality_error, ""),
            1e-12,
            "|ΦᵀMΦ − I|",
        ),
    ]
}

/// How far the mode that carries the pitch, or the mean of its pair, is off.
fn pitch_off_cents(recipe: &Recipe, body: &crate::Body) -> f64 {
    let lowest = body.modes.first().map(|mode| mode.label);
    let carries = |mode: &&crate::Mode| match recipe.shape {
        ShapeRecipe::Closed(_) => Some(mode.label) == lowest,
        ShapeRecipe::Bowl(_) => mode.label.order == 2 && mode.label.index == 1,
        _ => mode.label.family == Family::Bending && mode.label.index == recipe.tuning.partial,
    };
    let modes = body.modes.iter().filter(carries);
    let (sum_hz, count) = modes.fold((0.0, 0.0), |(sum, n), mode| (sum + mode.hz, n + 1.0));
    let octaves = f64::from(1 << recipe.tuning.octaves_below);
    cents(sum_hz / count / octaves, body.pitch_hz)
}

/// The slowest and the fastest beat of the two lowest pairs of all keys.
fn beats(bank: &Bank) -> [Row; 2] {
    let (mut slowest, mut fastest) = (f64::INFINITY, 0.0f64);
    for body in &bank.bodies {
        let firsts = body
            .modes
            .iter()
            .filter(|mode| mode.label.member == Member::A);
        for first in firsts.take(2) {
            let partner = body.modes.iter().find(|mode| {
                mode.label.member == Member::B
                    && (mode.label.family, mode.label.order, mode.label.index)
                        == (first.label.family, first.label.order, first.label.index)
            });
            let beat_hz = partner.map_or(f64::NAN, |partner| (partner.hz - first.hz).abs());
            slowest = if beat_hz >= slowest { slowest } else { beat_hz };
            fastest = greater(fastest, beat_hz);
        }
    }
    let row = |what: &str, [bound, value]: [f64; 2], lacks: f64| {
        Row::within(
            format!(
                "{}: {what} beat of the two lowest pairs of all keys",
                bank.name
            ),
            (bound, value, "Hz"),
            (lacks.max(0.0), 0.0),
            "real bowls beat slowly",
        )
    };
    [
        row("slowest", [BEATS_HZ[0], slowest], BEATS_HZ[0] - slowest),
        row("fastest", [BEATS_HZ[1], fastest], fastest - BEATS_HZ[1]),
    ]
}
