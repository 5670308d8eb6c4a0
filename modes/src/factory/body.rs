//! One key's body: tuned and solved, by shape.

use super::BuildError;
use crate::bar::{
    BarFineness, BarTuning, bar_modes, tune_bar, vibraphone_ratios, vibraphone_stock,
};
use crate::fem::Harmonic;
use crate::revolution::{Bell, Imperfection, Wall, bowl, revolution_modes};
use crate::shape::{Bowl, Tube};
use crate::solve::{Band, lowest};
use crate::tube::{TubeTuning, TuneError, predicted_length_m, tune_tube};
use crate::{Recipe, ShapeRecipe, SolveError, SolvedBody, equal_temperament_hz};

/// What makes the bodies of one recipe.
pub(super) struct Maker<'a> {
    recipe: &'a Recipe,
    shape: Shape,
}

/// What all keys share.
enum Shape {
    /// A tube, cut for each key.
    Tube(Bell),
    /// A bar, hollowed for each key to these ratios or to a vibraphone's.
    Bar(Option<[f64; 2]>),
    /// A body that is solved once, at the size of the lowest key, and scaled to each key.
    Scaled(Box<SolvedBody>),
}

/// Cells across half a bar's width and through its thickness: with two, bending 3 of a bar is right
/// to a cent where one leaves four.
const BAR: BarFineness = BarFineness {
    max_element_m: 0.0,
    across: 3,
    through: 2,
};

/// Waves around the axis of the mode that carries a bowl's pitch.
const BOWL_WAVES: usize = 2;

impl<'a> Maker<'a> {
    /// What cannot be tuned is said here, before the minutes that the rest may take.
    pub(super) fn new(recipe: &'a Recipe) -> Result<Self, BuildError> {
        let shape = match recipe.shape {
            ShapeRecipe::Tube {
                outer_radius_m,
                wall_m,
                plug_m,
                hung_at,
                felt_at,
            } => Shape::Tube(Bell {
                tube: Tube {
                    outer_radius_m,
                    wall_m,
                    length_m: 0.0,
                },
                plug_m,
                hung_at,
                felt_at,
            }),
            ShapeRecipe::Bar { ratios } => Shape::Bar(ratios),
            ShapeRecipe::Bowl(bowl) => Shape::Scaled(Box::new(lowest_bowl(recipe, &bowl)?)),
        };
        let maker = Self { recipe, shape };
        if let Shape::Tube(bell) = &maker.shape {
            for key in recipe.keys.iter() {
                predicted_length_m(&bell.tube, &recipe.material, &maker.tuning(key))
                    .map_err(|error| out_of_tune(recipe, key, error))?;
            }
        }
        Ok(maker)
    }

    /// Mesh and element in words.
    pub(super) fn mesh(&self) -> String {
        let longest_m = self.recipe.mesh.max_element_m;
        match self.shape {
            Shape::Bar(_) => format!(
                "20-node hexahedra of a quarter, 2×2×2 points, {} across half the width, {} through, \
                 at most {longest_m} m along",
                BAR.across, BAR.through
            ),
            _ => format!(
                "8-node quadrilaterals of the meridian, 2×2 points, at most {longest_m} m long"
            ),
        }
    }

    pub(super) fn recipe(&self) -> &'a Recipe {
        self.recipe
    }

    /// Pitch of the note that `key` is heard as, in Hz.
    pub(super) fn pitch_hz(&self, key: u8) -> f64 {
        equal_temperament_hz(key, self.recipe.tuning.a4_hz)
    }

    fn tuning(&self, key: u8) -> TubeTuning {
        let tuning = &self.recipe.tuning;
        TubeTuning {
            pitch_hz: self.pitch_hz(key) * f64::from(1 << tuning.octaves_below),
            partial: usize::from(tuning.partial),
            tolerance_cents: tuning.tolerance_cents,
        }
    }

    pub(super) fn solve(&self, key: u8) -> Result<SolvedBody, BuildError> {
        let recipe = self.recipe;
        match &self.shape {
            Shape::Tube(bell) => {
                let max_element_m = recipe.mesh.max_element_m;
                let tuned = tune_tube(bell, &recipe.material, max_element_m, &self.tuning(key))
                    .map_err(|error| out_of_tune(recipe, key, error))?;
                solved(recipe, &tuned.wall(max_element_m))
                    .map_err(|error| unsolved(recipe, key, error))
            }
            Shape::Bar(ratios) => {
                let tuning = BarTuning {
                    pitch_hz: self.pitch_hz(key),
                    ratios: ratios.unwrap_or_else(|| vibraphone_ratios(key)),
                    tolerance_cents: recipe.tuning.tolerance_cents,
                };
                let fineness = BarFineness {
                    max_element_m: recipe.mesh.max_element_m,
                    ..BAR
                };
                let bar = tune_bar(&vibraphone_stock(key), &recipe.material, fineness, &tuning)
                    .map_err(|error| out_of_tune(recipe, key, TuneError::Bar(error)))?;
                bar_modes(&bar, &recipe.material, fineness, band(recipe))
                    .map_err(|error| unsolved(recipe, key, error))
            }
            Shape::Scaled(lowest) => {
                let factor = self.pitch_hz(recipe.keys.low) / self.pitch_hz(key);
                Ok(lowest.scaled(factor, recipe.mesh.highest_hz))
            }
        }
    }
}

fn out_of_tune(recipe: &Recipe, key: u8, error: TuneError) -> BuildError {
    BuildError::Tune {
        recipe: recipe.name.clone(),
        key,
        error,
    }
}

fn unsolved(recipe: &Recipe, key: u8, error: SolveError) -> BuildError {
    BuildError::Solve {
        recipe: recipe.name.clone(),
        key,
        error,
    }
}

fn band(recipe: &Recipe) -> Band {
    Band {
        high_hz: recipe.mesh.highest_hz,
        ..Band::AUDIBLE
    }
}

/// Every mode of `wall` that the recipe asks for.
fn solved(recipe: &Recipe, wall: &Wall) -> Result<SolvedBody, SolveError> {
    let mass_kg = wall.meridian.volume_m3() * recipe.material.density_kg_m3;
    let imperfection = recipe.imperfection.map(|given| Imperfection {
        mass_kg: given.mass_share * mass_kg,
        angle_deg: given.angle_deg,
    });
    revolution_modes(wall, &recipe.material, band(recipe), imperfection)
}

/// The bowl of the lowest key: every length of the recipe's, times what its pitch asks for.
///
/// A pair that an imperfection splits is tuned by its mean.
fn lowest_bowl(recipe: &Recipe, shape: &Bowl) -> Result<SolvedBody, BuildError> {
    let key = recipe.keys.low;
    let failed = |error| unsolved(recipe, key, error);
    let wall = bowl(shape, recipe.mesh.max_element_m)
        .map_err(|error| out_of_tune(recipe, key, TuneError::Profile(error)))?;
    let harmonic = Harmonic::new(&wall.meridian, &recipe.material, BOWL_WAVES).map_err(failed)?;
    let own_hz = lowest(&harmonic.pencil, 0).map_err(failed)?;
    let pitch_hz = equal_temperament_hz(key, recipe.tuning.a4_hz);
    let factor = own_hz / pitch_hz;
    let wall = bowl(&shape.scaled(factor), factor * recipe.mesh.max_element_m)
        .map_err(|error| out_of_tune(recipe, key, TuneError::Profile(error)))?;
    let body = solved(recipe, &wall).map_err(failed)?;
    let pair: Vec<f64> = body
        .modes
        .iter()
        .filter(|mode| usize::from(mode.label.order) == BOWL_WAVES && mode.label.index == 1)
        .map(|mode| mode.hz)
        .collect();
    let mean_hz = pair.iter().sum::<f64>() / pair.len() as f64;
    Ok(body.scaled(mean_hz / pitch_hz, recipe.mesh.highest_hz))
}
