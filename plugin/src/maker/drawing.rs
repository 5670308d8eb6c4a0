//! What of a recipe's drawing is changed, and the recipe that comes of it.

use crate::params::shape::{BREADTH, LENGTH, POISSON, PROFILE, WALL};
use modes::{Bank, Recipe, RecipeError, Variation};

/// How the bodies differ from the recipe's drawing; see [`Variation`].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Drawing {
    /// Length over the recipe's.
    pub length: f32,
    /// Thickness over the recipe's.
    pub wall: f32,
    /// Width over the recipe's.
    pub width: f32,
    /// −1…1, 0 for the recipe's.
    pub profile: f32,
    /// Added to Poisson's ratio.
    pub poisson: f32,
}

/// Range that Poisson's ratio is kept in: what recipes allow of solids that narrow when stretched.
const RATIOS: [f64; 2] = [0.0, 0.49];

impl Drawing {
    /// The recipe's own.
    pub const OWN: Self = Self {
        length: 1.0,
        wall: 1.0,
        width: 1.0,
        profile: 0.0,
        poisson: 0.0,
    };

    /// The names of the knobs that are turned.
    pub(super) fn turned(&self) -> Vec<&'static str> {
        let own = Self::OWN;
        let knobs = [
            (LENGTH, self.length != own.length),
            (WALL, self.wall != own.wall),
            (BREADTH, self.width != own.width),
            (PROFILE, self.profile != own.profile),
            (POISSON, self.poisson != own.poisson),
        ];
        let turned = knobs.into_iter().filter(|(_, turned)| *turned);
        turned.map(|(knob, _)| knob.name).collect()
    }

    /// The recipe with this drawing.
    ///
    /// # Errors
    ///
    /// If a dimension leaves its range.
    pub fn apply(&self, recipe: &Recipe) -> Result<Recipe, RecipeError> {
        let moved = || recipe.material.poisson() + f64::from(self.poisson);
        let changed = self.poisson != 0.0;
        recipe.varied(&Variation {
            length: f64::from(self.length),
            wall: f64::from(self.wall),
            width: f64::from(self.width),
            profile: f64::from(self.profile),
            poisson: changed.then(|| moved().clamp(RATIOS[0], RATIOS[1])),
        })
    }
}

/// The recipe that a bank was built from; none for what is not drawn by dimensions.
#[must_use]
pub fn recipe_of(bank: &Bank) -> Option<Recipe> {
    Recipe::parse(&bank.provenance.recipe, &bank.name).ok()
}

/// The text of the recipe that `bank` is to be built from in this drawing; none if it is as it is, or cannot
/// be.
pub(crate) fn wanted_text(drawing: &Drawing, bank: &Bank) -> Option<String> {
    if *drawing == Drawing::OWN {
        return None;
    }
    let varied = drawing.apply(&recipe_of(bank)?).ok()?;
    (varied.text != bank.provenance.recipe).then_some(varied.text)
}
