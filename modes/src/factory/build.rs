//! Every key of a recipe, tuned and solved.

use super::builder::{Builder, Finished};
use super::{Progress, closed};
use crate::tube::TuneError;
use crate::{Bank, Recipe, ShapeRecipe, SolveError};
use rayon::prelude::*;
use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};

/// Why a recipe gave no bank.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum BuildError {
    /// A key's body cannot be tuned.
    #[error("{recipe}: {field}: key {key}: {error}")]
    Tune {
        /// Name of the recipe.
        recipe: String,
        /// What of it is to be changed.
        field: &'static str,
        /// The key.
        key: u8,
        /// Why not.
        error: TuneError,
    },
    /// A key's body cannot be solved.
    #[error("{recipe}: mesh: key {key}: {error}")]
    Solve {
        /// Name of the recipe.
        recipe: String,
        /// The key.
        key: u8,
        /// Why not.
        error: SolveError,
    },
    /// The body is known in closed form: there is nothing to mesh, and [`build`] alone makes its bank.
    #[error("{recipe}: body.shape: it has a closed form, and no bodies to solve one at a time")]
    Closed {
        /// Name of the recipe.
        recipe: String,
    },
    /// The body has no mode within the mesh's frequencies.
    #[error("{recipe}: mesh.highest_hz: no mode lies below it")]
    Silent {
        /// Name of the recipe.
        recipe: String,
    },
    /// The caller asked to stop.
    #[error("{recipe}: cancelled")]
    Cancelled {
        /// Name of the recipe.
        recipe: String,
    },
}

/// Builds the bank of `recipe`, keys in parallel on rayon's threads.
///
/// The same recipe gives the same bits whatever the number of threads.
///
/// # Errors
///
/// The first key, counted from the lowest, that cannot be tuned or solved; or that `progress` broke
/// off.
pub fn build(recipe: &Recipe, progress: &dyn Progress) -> Result<Bank, BuildError> {
    if let ShapeRecipe::Closed(shape) = &recipe.shape {
        return closed::bank(recipe, shape);
    }
    let builder = Builder::new(recipe)?;
    let keys = recipe.keys.iter().len();
    let (done, cancelled) = (AtomicUsize::new(0), AtomicBool::new(false));
    // The lowest bodies take longest; begun first, they leave no thread waiting at the end.
    let finished: Vec<Result<Finished, BuildError>> = recipe
        .keys
        .iter()
        .collect::<Vec<_>>()
        .par_iter()
        .with_max_len(1)
        .map(|&key| {
            let stopped = || BuildError::Cancelled {
                recipe: recipe.name.clone(),
            };
            if cancelled.load(Ordering::Relaxed) {
                return Err(stopped());
            }
            let finished = builder.body(key)?;
            let count = done.fetch_add(1, Ordering::Relaxed) + 1;
            if progress.advance(count, keys).is_break() {
                cancelled.store(true, Ordering::Relaxed);
                return Err(stopped());
            }
            Ok(finished)
        })
        .collect();
    let finished = finished.into_iter().collect::<Result<Vec<_>, _>>();
    let finished = finished.map_err(|error| builder.told(error))?;
    Ok(builder.bank(finished))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::factory::Silent;
    use std::ops::ControlFlow;

    fn recipe(edit: impl Fn(&str) -> String) -> Recipe {
        let text = edit(Recipe::FACTORY[0].1)
            .replace("low = 36", "low = 84")
            .replace("around = 48", "around = 16")
            .replace("max_element_m = 0.006", "max_element_m = 0.02");
        Recipe::parse(&text, "test.toml").unwrap()
    }

    #[test]
    fn the_number_of_threads_does_not_change_a_bit() {
        let recipe = recipe(str::to_owned);
        let on = |threads: usize| {
            let pool = rayon::ThreadPoolBuilder::new()
                .num_threads(threads)
                .build()
                .unwrap();
            pool.install(|| build(&recipe, &Silent)).unwrap().write()
        };
        assert_eq!(on(1), on(3));
    }

    #[test]
    fn a_pitch_out_of_reach_names_the_key() {
        let recipe = recipe(|text| {
            text.replace("outer_radius_m = 0.0125", "outer_radius_m = 0.5")
                .replace("wall_m = 0.001", "wall_m = 0.005")
        });
        let error = build(&recipe, &Silent).err().unwrap().to_string();
        assert!(
            error.starts_with("chimes: keys: key 84: ") && error.contains("they reach"),
            "{error}"
        );
    }

    #[test]
    fn bars_can_be_cut_to_any_pitch_of_a4() {
        let text = Recipe::FACTORY[1]
            .1
            .replace("low = 36", "low = 80")
            .replace("high = 96", "high = 80");
        for a4_hz in ["300.0", "466.0", "600.0"] {
            let text = text.replace("a4_hz = 440.0", &format!("a4_hz = {a4_hz}"));
            let recipe = Recipe::parse(&text, "test.toml").unwrap();
            let bank = build(&recipe, &Silent).unwrap();
            assert!(bank.bodies[0].modes.len() > 3, "{a4_hz}");
        }
    }

    /// The vibraphone with one key and the ratios that `[second, third]` say.
    fn one_bar([second, third]: [&str; 2]) -> Recipe {
        let ratios = format!("shape = \"bar\"\nsecond_ratio = {second}\nthird_ratio = {third}");
        let text = Recipe::FACTORY[1].1.replace("shape = \"bar\"", &ratios);
        let text = text
            .replace("low = 36", "low = 80")
            .replace("high = 96", "high = 80");
        Recipe::parse(&text, "test.toml").unwrap()
    }

    #[test]
    fn ratios_out_of_reach_are_told_with_others_that_are_not() {
        let error = build(&one_bar(["2.5", "14.0"]), &Silent)
            .err()
            .unwrap()
            .to_string();
        let told = "vibraphone: body.second_ratio, body.third_ratio: key 80: no bar has partials \
                    1 : 2.5 : 14 at 830.61 Hz; ";
        let others = error
            .strip_prefix(told)
            .unwrap_or_else(|| panic!("{error}"));
        let others = others.strip_suffix(" can be had").unwrap();
        let (second, third) = others.split_once(" and ").unwrap();
        assert!(
            build(&one_bar([second, third]), &Silent).is_ok(),
            "{others}"
        );
    }

    #[test]
    fn a_build_can_be_cancelled() {
        struct Once;
        impl Progress for Once {
            fn advance(&self, _: usize, _: usize) -> ControlFlow<()> {
                ControlFlow::Break(())
            }
        }
        let error = build(&recipe(str::to_owned), &Once).err().unwrap();
        assert!(matches!(error, BuildError::Cancelled { .. }));
    }
}
