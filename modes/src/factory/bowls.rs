//! Bowls of one drawing: solved once, scaled to each key.

use super::body::band;
use crate::fem::Harmonic;
use crate::revolution::{Imperfection, LAYERS, SolvedWall, bowl};
use crate::shape::Bowl;
use crate::solve::lowest;
use crate::tube::TuneError;
use crate::{ImperfectionRecipe, ImperfectionSize, Recipe, SolvedBody, equal_temperament_hz};

/// Waves around the axis of the mode that carries a bowl's pitch.
pub(super) const BOWL_WAVES: usize = 2;

/// The bowl of the lowest key, from which all others are scaled.
pub(super) struct Bowls<'a> {
    recipe: &'a Recipe,
    shape: Bowl,
    max_element_m: f64,
    solved: SolvedWall,
}

impl<'a> Bowls<'a> {
    /// The bowl of the lowest key: every length of the recipe's, times what its pitch asks for.
    pub(super) fn new(recipe: &'a Recipe, shape: &Bowl) -> Result<Self, TuneError> {
        let factor = own_hz(recipe, shape)? / pitch_hz(recipe, recipe.keys.low);
        let shape = shape.scaled(factor);
        let max_element_m = factor * recipe.mesh.max_element_m;
        let wall = bowl(&shape, max_element_m, LAYERS)?;
        Ok(Self {
            recipe,
            shape,
            max_element_m,
            solved: SolvedWall::new(wall, &recipe.material, band(recipe))?,
        })
    }

    /// The same bowl on a mesh `finer` times as fine.
    pub(super) fn finer(&self, finer: usize) -> Result<SolvedWall, TuneError> {
        let wall = bowl(
            &self.shape,
            self.max_element_m / finer as f64,
            finer * LAYERS,
        )?;
        let recipe = self.recipe;
        Ok(SolvedWall::new(wall, &recipe.material, band(recipe))?)
    }

    /// The bowl of `key`. A pair that an imperfection splits is tuned by its mean.
    pub(super) fn body(&self, key: u8) -> Result<SolvedBody, TuneError> {
        let [low_hz, key_hz] = [self.recipe.keys.low, key].map(|key| pitch_hz(self.recipe, key));
        let given = self.recipe.imperfection.as_ref();
        let imperfection = given.map(|given| imperfection(&self.solved, given, key_hz / low_hz));
        let body = self.solved.body(imperfection.transpose()?);
        let pair = body
            .modes
            .iter()
            .filter(|mode| usize::from(mode.label.order) == BOWL_WAVES && mode.label.index == 1);
        let (sum_hz, count) = pair.fold((0.0, 0.0), |(sum, n), mode| (sum + mode.hz, n + 1.0));
        Ok(body.scaled(sum_hz / count / key_hz, self.recipe.mesh.highest_hz))
    }
}

fn pitch_hz(recipe: &Recipe, key: u8) -> f64 {
    equal_temperament_hz(key, recipe.tuning.a4_hz)
}

/// Pitch in Hz of the bowl as drawn in the recipe.
pub(super) fn own_hz(recipe: &Recipe, shape: &Bowl) -> Result<f64, TuneError> {
    let meridian = bowl(shape, recipe.mesh.max_element_m, LAYERS)?.meridian;
    let harmonic = Harmonic::new(&meridian, &recipe.material, BOWL_WAVES)?;
    Ok(lowest(&harmonic.pencil, 0)?)
}

/// What `given` asks of `solved`, which will be scaled to `rough` times its pitch.
pub(super) fn imperfection(
    solved: &SolvedWall,
    given: &ImperfectionRecipe,
    rough: f64,
) -> Result<Imperfection, TuneError> {
    let mass_kg = match given.size {
        ImperfectionSize::MassShare(share) => share * solved.mass_kg,
        ImperfectionSize::BeatHz(beat_hz) => {
            solved
                .mass_for_beat_kg(beat_hz / rough)
                .map_err(|greatest_hz| TuneError::Beat {
                    beat_hz,
                    greatest_hz: rough * greatest_hz,
                })?
        }
    };
    Ok(Imperfection {
        mass_kg,
        angle_deg: given.angle_deg,
    })
}
