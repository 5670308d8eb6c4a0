//! Every key of a recipe, tuned and solved.

use super::Progress;
use crate::shape::Tube;
use crate::solve::Band;
use crate::tube::{Fineness, TubeTuning, TuneError, predicted_length_m, tube_modes, tune_tube};
use crate::{Bank, Body, CODE, Provenance, Recipe, ShapeRecipe, SolveError, equal_temperament_hz};
use rayon::prelude::*;
use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};

/// Why a recipe gave no bank.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum BuildError {
    /// A key's body cannot be tuned.
    #[error("{recipe}: keys: key {key}: {error}")]
    Tune {
        /// Name of the recipe.
        recipe: String,
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
    /// The caller asked to stop.
    #[error("{recipe}: cancelled")]
    Cancelled {
        /// Name of the recipe.
        recipe: String,
    },
}

/// A finished body and how well it is solved.
struct Finished {
    body: Body,
    residual: f64,
    orthonormality: f64,
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
    let keys: Vec<u8> = recipe.keys.iter().collect();
    // What cannot be tuned is said before the minutes that the rest may take.
    for &key in &keys {
        predicted_length_m(&shape(recipe), &recipe.material, &tuning(recipe, key))
            .map_err(|error| out_of_tune(recipe, key, error))?;
    }
    let (done, cancelled) = (AtomicUsize::new(0), AtomicBool::new(false));
    // The longest tubes take longest; begun first, they leave no thread waiting at the end.
    let finished: Vec<Result<Finished, BuildError>> = keys
        .par_iter()
        .with_max_len(1)
        .map(|&key| {
            let stopped = || BuildError::Cancelled {
                recipe: recipe.name.clone(),
            };
            if cancelled.load(Ordering::Relaxed) {
                return Err(stopped());
            }
            let finished = body(recipe, key)?;
            let count = done.fetch_add(1, Ordering::Relaxed) + 1;
            if progress.advance(count, keys.len()).is_break() {
                cancelled.store(true, Ordering::Relaxed);
                return Err(stopped());
            }
            Ok(finished)
        })
        .collect();
    let finished = finished.into_iter().collect::<Result<Vec<_>, _>>()?;
    let greatest = |of: fn(&Finished) -> f64| finished.iter().map(of).fold(0.0, f64::max);
    Ok(Bank {
        name: recipe.name.clone(),
        material: recipe.material,
        damping: recipe.damping,
        ears_m: [[-0.1, -1.0, 0.5], [0.1, -1.0, 0.5]],
        provenance: Provenance {
            recipe: recipe.text.clone(),
            code: CODE.to_owned(),
            mesh: format!(
                "20-node hexahedra, 2×2×2 points, one layer, {} around, at most {} m along",
                recipe.mesh.around, recipe.mesh.max_element_m
            ),
            solver: "shift-invert block Lanczos per number of waves around, inertia counts".into(),
            tolerance_cents: recipe.tuning.tolerance_cents,
            max_residual: greatest(|f| f.residual),
            max_orthonormality_error: greatest(|f| f.orthonormality),
        },
        bodies: finished.into_iter().map(|f| f.body).collect(),
    })
}

fn out_of_tune(recipe: &Recipe, key: u8, error: TuneError) -> BuildError {
    BuildError::Tune {
        recipe: recipe.name.clone(),
        key,
        error,
    }
}

/// The tube that every key's is cut from.
fn shape(recipe: &Recipe) -> Tube {
    let ShapeRecipe::Tube {
        outer_radius_m,
        wall_m,
    } = recipe.shape;
    Tube {
        outer_radius_m,
        wall_m,
        length_m: 0.0,
    }
}

fn tuning(recipe: &Recipe, key: u8) -> TubeTuning {
    TubeTuning {
        pitch_hz: equal_temperament_hz(key, recipe.tuning.a4_hz),
        partial: usize::from(recipe.tuning.partial),
        tolerance_cents: recipe.tuning.tolerance_cents,
    }
}

fn body(recipe: &Recipe, key: u8) -> Result<Finished, BuildError> {
    let fineness = Fineness {
        around: usize::from(recipe.mesh.around),
        max_element_m: recipe.mesh.max_element_m,
    };
    let tuning = tuning(recipe, key);
    let tube = tune_tube(&shape(recipe), &recipe.material, fineness, &tuning)
        .map_err(|error| out_of_tune(recipe, key, error))?;
    let solved = tube_modes(&tube, &recipe.material, fineness, Band::AUDIBLE).map_err(|error| {
        BuildError::Solve {
            recipe: recipe.name.clone(),
            key,
            error,
        }
    })?;
    Ok(Finished {
        residual: solved
            .modes
            .iter()
            .map(|mode| mode.residual)
            .fold(0.0, f64::max),
        orthonormality: solved.orthonormality,
        body: Body {
            key,
            pitch_hz: tuning.pitch_hz,
            length_m: tube.length_m,
            mass_kg: tube.volume_m3() * recipe.material.density_kg_m3,
            line: solved.line,
            modes: solved.modes,
        },
    })
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
        let recipe = recipe(|text| text.replace("outer_radius_m = 0.0125", "outer_radius_m = 0.5"));
        let error = build(&recipe, &Silent).err().unwrap().to_string();
        assert!(
            error.starts_with("chimes: keys: key 84: ") && error.contains("they reach"),
            "{error}"
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
