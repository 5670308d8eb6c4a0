//! Every instrument on its own mesh and on one twice as fine.

use super::{CheckError, Row, cents, factory, greater};
use crate::factory::halved;
use crate::{Recipe, ShapeRecipe};

/// Below this, in Hz, no partial may move.
const HIGHEST_HZ: f64 = 10_000.0;

pub(super) fn rows() -> Result<Vec<Row>, CheckError> {
    let mut rows = Vec::new();
    for (name, _) in Recipe::FACTORY {
        let recipe = factory(name)?;
        if matches!(recipe.shape, ShapeRecipe::Closed(_)) {
            continue;
        }
        let (low, high) = (recipe.keys.low, recipe.keys.high);
        let keys = match recipe.shape {
            // All are scaled from the lowest.
            ShapeRecipe::Bowl(_) => vec![low],
            _ => vec![low, low.midpoint(high), high],
        };
        for key in keys {
            rows.push(row(&recipe, key)?);
        }
    }
    Ok(rows)
}

fn row(recipe: &Recipe, key: u8) -> Result<Row, CheckError> {
    let [shipped, finer] = halved(recipe, key)?;
    let modes = shipped.modes.iter().filter(|mode| mode.hz < HIGHEST_HZ);
    let count = modes.clone().count();
    let moves = modes.map(|mode| {
        let twin = finer.modes.iter().find(|other| other.label == mode.label);
        twin.map_or(f64::NAN, |twin| cents(mode.hz, twin.hz))
    });
    let name = &recipe.name;
    Ok(Row::absolute(
        format!("{name}, key {key}, mesh halved: greatest move of {count} modes below 10 kHz"),
        (0.0, moves.fold(0.0, greater), "cents"),
        3.0,
        "convergence",
    ))
}
