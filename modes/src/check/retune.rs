//! What a turn of a shape knob costs: bodies retuned from the last one, bowls solved anew.

use super::{CheckError, Row, bowl_wall, factory, greater};
use crate::bar::{
    BarFineness, BarTuning, TunedBar, retune_bar, tune_bar, vibraphone_ratios, vibraphone_stock,
};
use crate::revolution::{Bell, SolvedWall};
use crate::shape::Tube;
use crate::solve::Band;
use crate::tube::{TubeTuning, retune_tube, tune_tube};
use crate::{Recipe, ShapeRecipe, equal_temperament_hz};
use std::time::Instant;

/// Longest time in s to retune a bar or a tube, and to solve a bowl.
const TUNE_S: f64 = 0.05;
const BOWL_S: f64 = 0.2;

/// How far the pitch is turned, as a ratio: 9 cents.
const TURN: f64 = 1.005;

/// Each is done so often, and the least time counts: what else runs on the machine is not meant.
const REPEATS: usize = 3;

const SOURCE: &str = "as fast as a knob is turned";

pub(super) fn rows() -> Result<Vec<Row>, CheckError> {
    let mut rows = vec![bars()?, bells()?];
    for name in ["singing-bowls", "crystal-bowls", "metal-bowls", "oak-bowls"] {
        rows.push(bowl(&factory(name)?)?);
    }
    Ok(rows)
}

/// The least time in s that `work` takes.
pub(super) fn least_s<T>(work: impl Fn() -> Result<T, CheckError>) -> Result<f64, CheckError> {
    let mut least_s = f64::INFINITY;
    for _ in 0..REPEATS {
        let start = Instant::now();
        work()?;
        least_s = least_s.min(start.elapsed().as_secs_f64());
    }
    Ok(least_s)
}

fn bars() -> Result<Row, CheckError> {
    let recipe = factory("vibraphone")?;
    let fineness = BarFineness {
        max_element_m: recipe.mesh.max_element_m,
        across: 3,
        through: 2,
    };
    let mut slowest_s = 0.0;
    for key in 53..=89 {
        let stock = vibraphone_stock(key);
        let tuning = |times: f64| BarTuning {
            pitch_hz: times * equal_temperament_hz(key, recipe.tuning.a4_hz),
            ratios: vibraphone_ratios(key),
            tolerance_cents: recipe.tuning.tolerance_cents,
        };
        let last = tune_bar(&stock, &recipe.material, fineness, &tuning(1.0))?;
        let retune = || -> Result<TunedBar, CheckError> {
            let turned = tuning(TURN);
            Ok(retune_bar(
                &last,
                &stock,
                &recipe.material,
                fineness,
                &turned,
            )?)
        };
        slowest_s = greater(slowest_s, least_s(retune)?);
    }
    Ok(Row::absolute(
        "vibraphone bars of keys 53–89, one retuned by 9 cents: slowest key",
        (0.0, slowest_s, "s"),
        TUNE_S,
        SOURCE,
    ))
}

fn bells() -> Result<Row, CheckError> {
    let recipe = factory("tubular-bells")?;
    let ShapeRecipe::Tube {
        outer_radius_m,
        wall_m,
        plug_m,
        ..
    } = recipe.shape
    else {
        unreachable!("tubular bells are tubes")
    };
    let shape = Bell {
        plug_m,
        ..Bell::open(Tube {
            outer_radius_m,
            wall_m,
            length_m: 0.0,
        })
    };
    let longest_m = recipe.mesh.max_element_m;
    let mut slowest_s = 0.0;
    for key in recipe.keys.iter() {
        let octaves = f64::from(1 << recipe.tuning.octaves_below);
        let tuning = |times: f64| TubeTuning {
            pitch_hz: octaves * times * equal_temperament_hz(key, recipe.tuning.a4_hz),
            partial: usize::from(recipe.tuning.partial),
            tolerance_cents: recipe.tuning.tolerance_cents,
        };
        let last = tune_tube(&shape, &recipe.material, longest_m, &tuning(1.0))?;
        let retune = || {
            Ok(retune_tube(
                &last,
                &recipe.material,
                longest_m,
                &tuning(TURN),
            )?)
        };
        slowest_s = greater(slowest_s, least_s(retune)?);
    }
    let (low, high) = (recipe.keys.low, recipe.keys.high);
    Ok(Row::absolute(
        format!("tubular bells of keys {low}–{high}, one retuned by 9 cents: slowest key"),
        (0.0, slowest_s, "s"),
        TUNE_S,
        SOURCE,
    ))
}

/// A bowl as `recipe` draws it, with all its modes.
fn bowl(recipe: &Recipe) -> Result<Row, CheckError> {
    let band = Band {
        high_hz: recipe.mesh.highest_hz,
        ..Band::AUDIBLE
    };
    let solve = || {
        let solved = SolvedWall::new(bowl_wall(recipe, 1.0)?, &recipe.material, band)?;
        Ok(solved.body(None))
    };
    Ok(Row::absolute(
        format!("one bowl as recipes/{}.toml draws it", recipe.name),
        (0.0, least_s(solve)?, "s"),
        BOWL_S,
        SOURCE,
    ))
}
