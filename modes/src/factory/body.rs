//! One key's body: tuned and solved, by shape.

use super::BuildError;
use super::bars::Bars;
use super::bowls::{Bowls, imperfection};
use crate::bar::{
    BarFineness, BarStock, BarTuneError, BarTuning, TunedBar, bar_modes, retune_bar, tune_bar,
    vibraphone_ratios, vibraphone_stock,
};
use crate::revolution::{Bell, LAYERS, SolvedWall};
use crate::shape::{Bar, Tube};
use crate::solve::Band;
use crate::tube::{TubeTuning, TuneError, predicted_length_m, tune_tube};
use crate::{Recipe, ShapeRecipe, SolveError, SolvedBody, equal_temperament_hz};

/// What makes the bodies of one recipe.
pub(super) struct Maker<'a> {
    recipe: &'a Recipe,
    shape: Shape<'a>,
    /// Of bars, across half the width and through the thickness.
    cells: [usize; 2],
}

/// What all keys share.
enum Shape<'a> {
    /// A tube, cut for each key.
    Tube(Bell),
    /// A bar, hollowed for each key.
    Bar(Bars),
    /// Bowls, solved once and scaled to each key.
    Bowls(Box<Bowls<'a>>),
}

/// Cells across half a bar's width and through its thickness: with two, bending 3 of a bar is right
/// to a cent where one leaves four.
const BAR_CELLS: [usize; 2] = [3, 2];

/// The same of a draft.
const DRAFT_CELLS: [usize; 2] = [2, 1];

/// Pitch of key 69, in Hz, for which a vibraphone's stock is measured.
const STOCK_A4_HZ: f64 = 440.0;

/// Halvings by which ratios within reach are looked for.
const RATIO_STEPS: usize = 6;

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
                ratios,
                times: [thickness, width],
                undercut,
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
        Ok(Self {
            recipe,
            shape,
            cells,
        })
    }

    /// Mesh and element in words.
    pub(super) fn mesh(&self) -> String {
        let longest_m = self.recipe.mesh.max_element_m;
        match self.shape {
            Shape::Bar(..) => format!(
                "20-node hexahedra of a quarter, 2×2×2 points, {} across half the width, {} through, \
                 at most {longest_m} m along",
                self.cells[0], self.cells[1]
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
            Shape::Bar(bars) => self.bar_modes(&self.tuned_bar(bars, key)?, key, 1),
            Shape::Bowls(bowls) => bowls
                .body(key)
                .map_err(|error| self.out_of_tune(key, error)),
        }
    }

    /// As [`Self::solve`]; but of a bar whose partials are out of reach, one with the nearest within.
    pub(super) fn solve_within(&self, key: u8) -> Result<SolvedBody, BuildError> {
        let error = match self.solve(key) {
            Err(error) => self.with_ratios(error),
            solved => return solved,
        };
        let (
            BuildError::Tune {
                error: TuneError::Ratios { within, .. },
                ..
            },
            Shape::Bar(bars),
        ) = (&error, &self.shape)
        else {
            return Err(error);
        };
        let bar = self
            .bar_of(key, *within, bars.times)
            .map_err(|error| self.out_of_tune(key, TuneError::Bar(error)))?;
        self.bar_modes(&bar, key, 1)
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
        let (stock, tuning) = self.stock_of(key, bars.ratios(key), bars.times);
        let (material, fineness) = (&self.recipe.material, self.bar_fineness(1));
        let tuned = match last {
            Some(last) => retune_bar(last, &stock, material, fineness, &tuning),
            None => tune_bar(&stock, material, fineness, &tuning),
        };
        let tuned = tuned.map_err(|error| self.out_of_tune(key, TuneError::Bar(error)))?;
        Ok((self.bar_modes(&tuned.bar, key, 1)?, Some(tuned)))
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
                let bar = self.tuned_bar(bars, key)?;
                Ok([self.bar_modes(&bar, key, 1)?, self.bar_modes(&bar, key, 2)?])
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

    fn tuned_bar(&self, bars: &Bars, key: u8) -> Result<Bar, BuildError> {
        self.bar_of(key, bars.ratios(key), bars.times)
            .map_err(|error| self.out_of_tune(key, TuneError::Bar(error)))
    }

    /// The bar of `key` with these ratios, of stock so many times as thick and as wide.
    fn bar_of(
        &self,
        key: u8,
        ratios: [f64; 2],
        [thicker, wider]: [f64; 2],
    ) -> Result<Bar, BarTuneError> {
        let (stock, tuning) = self.stock_of(key, ratios, [thicker, wider]);
        let material = &self.recipe.material;
        Ok(tune_bar(&stock, material, self.bar_fineness(1), &tuning)?.bar)
    }

    /// What that bar is cut from, and what it is tuned to.
    fn stock_of(
        &self,
        key: u8,
        ratios: [f64; 2],
        [thicker, wider]: [f64; 2],
    ) -> (BarStock, BarTuning) {
        let tuning = BarTuning {
            pitch_hz: self.pitch_hz(key),
            ratios,
            tolerance_cents: self.recipe.tuning.tolerance_cents,
        };
        // At another pitch the same drawing at another size: all stock has its key's partials.
        let mut stock = vibraphone_stock(key).scaled(STOCK_A4_HZ / self.recipe.tuning.a4_hz);
        stock.thickness_m *= thicker;
        stock.width_m *= wider;
        // A thicker bar of the same drawing is as much longer as the root: bending goes with t/l².
        stock.length_m *= thicker.sqrt();
        (stock, tuning)
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
        let Some(within) = self.ratios_towards(bars, *key) else {
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

    /// Of the ratios from a vibraphone's own to those `asked` for, the farthest that the bar of `key` was
    /// found to have.
    fn ratios_towards(&self, bars: &Bars, key: u8) -> Option<[f64; 2]> {
        let asked = bars.ratios(key);
        let own = vibraphone_ratios(key);
        let at = |share: f64| {
            [0, 1].map(|i| {
                let ratio = own[i] + share * (asked[i] - own[i]);
                (100.0 * ratio).round() / 100.0
            })
        };
        let can_be_had = |share: f64| self.bar_of(key, at(share), bars.times).is_ok();
        if !can_be_had(0.0) {
            return None;
        }
        let (mut near, mut far) = (0.0, 1.0);
        for _ in 0..RATIO_STEPS {
            let share = 0.5 * (near + far);
            if can_be_had(share) {
                near = share;
            } else {
                far = share;
            }
        }
        Some(at(near))
    }

    fn tube_modes(&self, bell: &Bell, key: u8, finer: usize) -> Result<SolvedWall, BuildError> {
        let recipe = self.recipe;
        let wall = bell.wall(recipe.mesh.max_element_m / finer as f64, finer * LAYERS);
        SolvedWall::new(wall, &recipe.material, band(recipe))
            .map_err(|error| self.unsolved(key, error))
    }

    fn bar_fineness(&self, finer: usize) -> BarFineness {
        BarFineness {
            max_element_m: self.recipe.mesh.max_element_m / finer as f64,
            across: finer * self.cells[0],
            through: finer * self.cells[1],
        }
    }

    fn bar_modes(&self, bar: &Bar, key: u8, finer: usize) -> Result<SolvedBody, BuildError> {
        let fineness = self.bar_fineness(finer);
        bar_modes(bar, &self.recipe.material, fineness, band(self.recipe))
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
