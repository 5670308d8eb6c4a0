//! The bodies of a recipe one at a time, in any order, on any thread.

use super::BuildError;
use super::body::Maker;
use super::sound::{ears_m, sounding};
use crate::{Bank, Body, CODE, Provenance, Recipe, SolvedBody};

/// Makes the bodies of one recipe.
pub struct Builder<'a>(Maker<'a>);

/// A finished body and how well it is solved.
#[derive(Clone, Debug)]
pub struct Finished {
    /// The body.
    pub body: Body,
    orthonormality: f64,
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

    /// The body of `key`.
    ///
    /// # Errors
    ///
    /// If it cannot be tuned or solved.
    pub fn body(&self, key: u8) -> Result<Finished, BuildError> {
        Ok(self.finished(key, self.0.solve(key)?))
    }

    /// The body of `key`; if a bar cannot have the partials asked for, one with the nearest to them that
    /// were found within reach.
    ///
    /// # Errors
    ///
    /// If there is none either.
    pub fn body_within(&self, key: u8) -> Result<Finished, BuildError> {
        Ok(self.finished(key, self.0.solve_within(key)?))
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
        Bank {
            name: recipe.name.clone(),
            title: recipe.title.clone(),
            material: recipe.material,
            damping: recipe.damping,
            ears_m: ears_m(&recipe.listener),
            provenance: Provenance {
                recipe: recipe.text.clone(),
                code: CODE.to_owned(),
                mesh: self.0.mesh(),
                solver: "shift-invert block Lanczos for each symmetry, inertia counts".into(),
                tolerance_cents: recipe.tuning.tolerance_cents,
                max_residual: residuals.fold(0.0, f64::max),
                max_orthonormality_error: orthonormality.fold(0.0, f64::max),
            },
            bodies: finished.into_iter().map(|f| f.body).collect(),
            spread: None,
        }
    }
}
