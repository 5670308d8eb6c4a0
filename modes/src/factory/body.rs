//! One key's body: tuned and solved, by shape.

use super::BuildError;
use super::bars::Bars;
use super::bowls::{Bowls, imperfection};
use crate::bar::{TunedBar, bar_modes};
use crate::revolution::{Bell, LAYERS, SolvedWall};
use crate::shape::Tube;
use crate::solve::Band;
use crate::tube::{TubeTuning, TuneError, predicted_length_m, tune_tube};
use crate::{Recipe, ShapeRecipe, SolveError, SolvedBody, equal_temperament_hz};

/// What makes the bodies of one recipe.
pub(super) struct Maker<'a> {
    recipe: &'a Recipe,
    shape: Shape<'a>,
}

/// What all keys share.
enum Shape<'a> {
    /// A tube, cut for each key.
    Tube(Bell),
    /// A bar, hollowed for each key.
    Bar(Bars<'a>),
    /// Bowls, solved once and scaled to each key.
    Bowls(Box<Bowls<'a>>),
}

/// Cells across half a bar's width and through its thickness: with two, bending 3 of a bar is right
/// to a cent where one leaves four.
const BAR_CELLS: [usize; 2] = [3, 2];

/// The same of a draft.
const DRAFT_CELLS: [usize; 2] = [2, 1];

impl<'a> Maker<'a> {
    /// What cannot be tuned is said here, before the minutes that the rest may take.
    pub(super) fn new(recipe: &'a Recipe) -> Result<Self, BuildError> {
        let maker = Self::unchecked(recipe, BAR_CELLS)?;
        if let Shape::Tube(bell) = &maker.shape {
            for key in recipe.keys.iter() {
                predicted_length_m(&bell.tube, &recipe.material, &maker.tuning(key))
                    .map_err(|error| out_of_tune(recipe, key, error))?;
            }
        }
        Ok(maker)
    }

    /// For drafts: each key says for itself whether it can be tuned.
    pub(super) fn draft(recipe: &'a Recipe) -> Result<Self, BuildError> {
        Self::unchecked(recipe, DRAFT_CELLS)
    }

    fn unchecked(recipe: &'a Recipe, cells: [usize; 2]) -> Result<Self, BuildError> {
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
            ShapeRecipe::Bar {
                ratios,
                thickness,
                width,
                undercut,
            } => Shape::Bar(Bars {
                recipe,
                asked: ratios,
                times: [thickness, width],
                undercut,
                cells,
            }),
            ShapeRecipe::Bowl(bowl) => {
                let bowls = Bowls::new(recipe, &bowl)
                    .map_err(|error| out_of_tune(recipe, recipe.keys.low, error))?;
                Shape::Bowls(Box::new(bowls))
            }
            ShapeRecipe::Closed(_) => {
                return Err(BuildError::Closed {
                    recipe: recipe.name.clone(),
                });
            }
        };
        Ok(Self { recipe, shape })
    }

    /// Mesh and element in words.
    pub(super) fn mesh(&self) -> String {
        let longest_m = self.recipe.mesh.max_element_m;
        match &self.shape {
            Shape::Bar(bars) => format!(
                "20-node hexahedra of a quarter, 2×2×2 points, {} across half the width, {} through, \
                 at most {longest_m} m along",
                bars.cells[0], bars.cells[1]
            ),
            _ => format!(
                "8-node quadrilaterals of the meridian, 3×3 points, {LAYERS} through the wall, at most \
                 {longest_m} m long"
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

    /// The body of `key` with every mode that the recipe asks for.
    pub(super) fn solve(&self, key: u8) -> Result<SolvedBody, BuildError> {
        match &self.shape {
            Shape::Tube(bell) => {
                let solved = self.tube_modes(&self.tuned_tube(bell, key)?, key, 1)?;
                let given = self.recipe.imperfection.as_ref();
                let imperfection = given.map(|given| imperfection(&solved, given, 1.0));
                let imperfection = imperfection
                    .transpose()
                    .map_err(|error| self.out_of_tune(key, error))?;
                Ok(solved.body(imperfection))
            }
            Shape::Bar(bars) => self.bar_modes(bars, &self.tuned_bar(bars, key, None)?, key, 1),
            Shape::Bowls(bowls) => bowls
                .body(key)
                .map_err(|error| self.out_of_tune(key, error)),
        }
    }

    /// As [`Self::solve`]; but of a bar that cannot be had, the nearest to it towards a vibraphone's own.
    /// Also what share of that way it is.
    pub(super) fn solve_within(&self, key: u8) -> Result<(SolvedBody, f64), BuildError> {
        let Shape::Bar(bars) = &self.shape else {
            return Ok((self.solve(key)?, 1.0));
        };
        let (share, tuned) = match self.tuned_bar(bars, key, None) {
            Ok(tuned) => (1.0, tuned),
            Err(error) => bars.nearest(key).ok_or(error)?,
        };
        Ok((self.bar_modes(bars, &tuned, key, 1)?, share))
    }

    /// As [`Self::solve`]; a bar beginning with what was its key's `last`. Also what the next begins with.
    pub(super) fn resolve(
        &self,
        key: u8,
        last: Option<&TunedBar>,
    ) -> Result<(SolvedBody, Option<TunedBar>), BuildError> {
        let Shape::Bar(bars) = &self.shape else {
            return Ok((self.solve(key)?, None));
        };
        let tuned = self.tuned_bar(bars, key, last)?;
        Ok((self.bar_modes(bars, &tuned, key, 1)?, Some(tuned)))
    }

    /// As [`halved`].
    fn halved(&self, key: u8) -> Result<[SolvedBody; 2], BuildError> {
        match &self.shape {
            Shape::Tube(bell) => {
                let bell = self.tuned_tube(bell, key)?;
                let at = |finer| Ok(self.tube_modes(&bell, key, finer)?.body(None));
                Ok([at(1)?, at(2)?])
            }
            Shape::Bar(bars) => {
                let tuned = self.tuned_bar(bars, key, None)?;
                let at = |finer| self.bar_modes(bars, &tuned, key, finer);
                Ok([at(1)?, at(2)?])
            }
            Shape::Bowls(bowls) => {
                let at = |finer| Ok(bowls.finer(finer)?.body(None));
                let both = at(1).and_then(|shipped| Ok([shipped, at(2)?]));
                both.map_err(|error| self.out_of_tune(key, error))
            }
        }
    }

    fn tuned_tube(&self, shape: &Bell, key: u8) -> Result<Bell, BuildError> {
        let Recipe { material, mesh, .. } = self.recipe;
        tune_tube(shape, material, mesh.max_element_m, &self.tuning(key))
            .map_err(|error| self.out_of_tune(key, error))
    }

    fn tuned_bar(
        &self,
        bars: &Bars<'_>,
        key: u8,
        last: Option<&TunedBar>,
    ) -> Result<TunedBar, BuildError> {
        bars.tuned(key, last)
            .map_err(|error| self.out_of_tune(key, TuneError::Bar(error)))
    }

    /// `error` with ratios that can be had, if it was those asked for that could not.
    pub(super) fn with_ratios(&self, error: BuildError) -> BuildError {
        let (
            BuildError::Tune {
                key,
                error: TuneError::Bar(_),
                ..
            },
            Shape::Bar(bars),
        ) = (&error, &self.shape)
        else {
            return error;
        };
        let Some(within) = bars.ratios_within(*key) else {
            return error;
        };
        let (pitch_hz, asked) = (self.pitch_hz(*key), bars.ratios(*key));
        self.out_of_tune(
            *key,
            TuneError::Ratios {
                pitch_hz,
                asked,
                within,
            },
        )
    }

    fn tube_modes(&self, bell: &Bell, key: u8, finer: usize) -> Result<SolvedWall, BuildError> {
        let recipe = self.recipe;
        let wall = bell.wall(recipe.mesh.max_element_m / finer as f64, finer * LAYERS);
        SolvedWall::new(wall, &recipe.material, band(recipe))
            .map_err(|error| self.unsolved(key, error))
    }

    fn bar_modes(
        &self,
        bars: &Bars<'_>,
        tuned: &TunedBar,
        key: u8,
        finer: usize,
    ) -> Result<SolvedBody, BuildError> {
        let (material, fineness) = (&self.recipe.material, bars.fineness(finer));
        bar_modes(&tuned.bar, material, fineness, band(self.recipe))
            .map_err(|error| self.unsolved(key, error))
    }

    fn out_of_tune(&self, key: u8, error: TuneError) -> BuildError {
        out_of_tune(self.recipe, key, error)
    }

    fn unsolved(&self, key: u8, error: SolveError) -> BuildError {
        BuildError::Solve {
            recipe: self.recipe.name.clone(),
            key,
            error,
        }
    }
}

/// The body of `key` on its own mesh and on one with elements half as long, wide and thick; without
/// an imperfection, and of the lowest key's size if all are scaled from one.
pub(crate) fn halved(recipe: &Recipe, key: u8) -> Result<[SolvedBody; 2], BuildError> {
    Maker::new(recipe)?.halved(key)
}

/// What went wrong with `key`: of a solver that failed in the midst of tuning, that.
fn out_of_tune(recipe: &Recipe, key: u8, error: TuneError) -> BuildError {
    let recipe = recipe.name.clone();
    let field = match error {
        TuneError::Solve(error) => return BuildError::Solve { recipe, key, error },
        TuneError::Profile(_) => "body",
        TuneError::Beat { .. } => "imperfection.beat_hz",
        TuneError::Ratios { .. } => "body.second_ratio, body.third_ratio",
        _ => "keys",
    };
    BuildError::Tune {
        recipe,
        field,
        key,
        error,
    }
}

/// The frequencies that the recipe asks for.
pub(super) fn band(recipe: &Recipe) -> Band {
    Band {
        high_hz: recipe.mesh.highest_hz,
        ..Band::AUDIBLE
    }
}
