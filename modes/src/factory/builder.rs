//! The bodies of a recipe one at a time, in any order, on any thread.

use super::BuildError;
use super::body::Maker;
use super::sound::{self, Found, sounding};
use crate::bar::TunedBar;
use crate::{Bank, Body, Recipe, SolvedBody};

/// Makes the bodies of one recipe.
pub struct Builder<'a>(Maker<'a>);

/// A finished body and how well it is solved.
#[derive(Clone, Debug)]
pub struct Finished {
    /// The body.
    pub body: Body,
    orthonormality: f64,
}

/// How much longer a draft's elements are, and how far off a draft may be, in cents.
const DRAFT_LENGTHS: f64 = 4.0;
const DRAFT_CENTS: f64 = 3.0;
/// Highest frequency of a draft's modes, in Hz.
const DRAFT_HZ: f64 = 12_000.0;

/// The same recipe, to be solved in a fraction of the time: pitches are right to a few cents, high partials
/// less so.
#[must_use]
pub fn coarse(recipe: &Recipe) -> Recipe {
    let mut coarse = recipe.clone();
    coarse.mesh.max_element_m *= DRAFT_LENGTHS;
    coarse.tuning.tolerance_cents = coarse.tuning.tolerance_cents.max(DRAFT_CENTS);
    coarse.mesh.highest_hz = coarse.mesh.highest_hz.min(DRAFT_HZ);
    coarse
}

impl<'a> Builder<'a> {
    /// For `recipe`. Bowls are solved here, once for all keys.
    ///
    /// # Errors
    ///
    /// If a key cannot be tuned, as far as that is known beforehand.
    pub fn new(recipe: &'a Recipe) -> Result<Self, BuildError> {
        Maker::new(recipe).map(Self)
    }

    /// For drafts of `recipe`, as [`coarse`] makes it, a fraction of the work. Bowls are solved here.
    ///
    /// # Errors
    ///
    /// If bowls cannot be tuned.
    pub fn draft(recipe: &'a Recipe) -> Result<Self, BuildError> {
        Maker::draft(recipe).map(Self)
    }

    /// A draft of the body of `key`: of a bar beginning with what was its key's `last`. Also what the next
    /// is to begin with.
    ///
    /// # Errors
    ///
    /// If it cannot be tuned or solved.
    pub fn redraw(
        &self,
        key: u8,
        last: Option<&TunedBar>,
    ) -> Result<(Body, Option<TunedBar>), BuildError> {
        let (solved, tuned) = self.0.resolve(key, last)?;
        Ok((self.finished(key, solved).body, tuned))
    }

    /// The body of `key`.
    ///
    /// # Errors
    ///
    /// If it cannot be tuned or solved.
    pub fn body(&self, key: u8) -> Result<Finished, BuildError> {
        Ok(self.finished(key, self.0.solve(key)?))
    }

    /// The body of `key`; if a bar cannot be had, the nearest to it that was found on the way from a
    /// vibraphone's own drawing, and what share of that way it is, 0…1.
    ///
    /// # Errors
    ///
    /// If there is none either.
    pub fn body_within(&self, key: u8) -> Result<(Finished, f64), BuildError> {
        let (solved, share) = self.0.solve_within(key)?;
        Ok((self.finished(key, solved), share))
    }

    /// `error` with what could be had instead.
    pub(super) fn told(&self, error: BuildError) -> BuildError {
        self.0.with_ratios(error)
    }

    fn finished(&self, key: u8, solved: SolvedBody) -> Finished {
        let recipe = self.0.recipe();
        let place = f64::from(key - recipe.keys.low) + 0.5;
        Finished {
            orthonormality: solved.orthonormality,
            body: sounding(
                solved,
                (key, self.0.pitch_hz(key)),
                place / recipe.keys.iter().len() as f64,
                &recipe.listener,
                &recipe.losses,
                recipe.resonator,
            ),
        }
    }

    /// The bank of these bodies, by rising key.
    #[must_use]
    pub fn bank(&self, finished: Vec<Finished>) -> Bank {
        let recipe = self.0.recipe();
        let orthonormality = finished.iter().map(|f| f.orthonormality);
        let residuals = finished
            .iter()
            .flat_map(|f| f.body.modes.iter().map(|mode| mode.residual));
        let found = Found {
            mesh: self.0.mesh(),
            solver: "shift-invert block Lanczos for each symmetry, inertia counts",
            residual: residuals.fold(0.0, f64::max),
            orthonormality: orthonormality.fold(0.0, f64::max),
        };
        let bodies = finished.into_iter().map(|f| f.body).collect();
        sound::bank(recipe, found, bodies, None)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Variation;

    #[test]
    fn drafts_are_near_and_go_on_from_the_last() {
        for (name, text) in &Recipe::FACTORY[..2] {
            let recipe = Recipe::parse(text, name).unwrap();
            let mut last = None;
            for wall in [1.0, 1.2] {
                let variation = Variation {
                    wall,
                    ..Variation::default()
                };
                let varied = recipe.varied(&variation).unwrap();
                let fine = Builder::new(&varied).unwrap().body(60).unwrap().body;
                let draft = coarse(&varied);
                let builder = Builder::draft(&draft).unwrap();
                let (body, tuned) = builder.redraw(60, last.as_ref()).unwrap();
                last = tuned;
                // Modes of low order, which coarse elements still follow.
                for mode in fine.modes.iter().take(4) {
                    let same = body.modes.iter().find(|other| other.label == mode.label);
                    let cents = 1200.0 * (same.unwrap().hz / mode.hz).log2();
                    assert!(cents.abs() < 20.0, "{name} {wall} {}: {cents}", mode.hz);
                }
            }
        }
    }

    /// The highest bars are plates rather than bars when they are twice as wide, and cannot have half a
    /// vibraphone's stretch.
    #[test]
    fn a_bar_out_of_reach_goes_part_of_the_way_and_stays_in_tune() {
        let (name, text) = Recipe::FACTORY[1];
        let recipe = Recipe::parse(text, name).unwrap();
        let own = Variation::default();
        let wide = Variation { width: 2.0, ..own };
        let shallow = Variation {
            profile: -1.0,
            ..own
        };
        let within = |variation: &Variation, key: u8| {
            let varied = recipe.varied(variation).unwrap();
            let builder = Builder::new(&varied).unwrap();
            let (finished, share) = builder.body_within(key).unwrap();
            let body = finished.body;
            let first = body
                .modes
                .iter()
                .find(|m| m.label.to_string() == "bending 1");
            let cents = 1200.0 * (first.unwrap().hz / body.pitch_hz).log2();
            assert!(cents.abs() < 1.0, "{cents}");
            share
        };
        for variation in [wide, shallow] {
            let share = within(&variation, 96);
            assert!(share > 0.1 && share < 1.0, "{variation:?}: {share}");
            assert_eq!(within(&variation, 60), 1.0, "{variation:?}");
        }
    }

    #[test]
    fn bodies_of_closed_form_are_refused() {
        let (name, text) = Recipe::FACTORY
            .iter()
            .find(|(n, _)| *n == "strings")
            .unwrap();
        let recipe = Recipe::parse(text, name).unwrap();
        let error = Builder::new(&recipe).err().unwrap().to_string();
        assert!(error.starts_with("strings: body.shape: "), "{error}");
    }
}
