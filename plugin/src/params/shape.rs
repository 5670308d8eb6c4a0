//! How the bodies are drawn, beside the recipe's drawing.

use super::Spec;
use super::build::{float, share};
use crate::maker::Drawing;
use modes::Recipe;
use nice_plug::prelude::{FloatParam, Params};
use std::ops::RangeInclusive;

/// Thickness and width over the recipe's.
const TIMES: RangeInclusive<f64> = 0.5..=2.0;
/// Shares either way.
const EITHER_WAY: RangeInclusive<f64> = -1.0..=1.0;
/// What is added to Poisson's ratio.
const POISSON_OFFSET: RangeInclusive<f64> = -0.15..=0.15;
/// Puts 100 % in the middle.
const SKEW: f32 = 0.63;

/// Thickness over the recipe's.
pub const WALL: Spec = Spec {
    id: "swall",
    name: "Wall",
    tooltip: "Thickness of the wall, of a bar the bar's, over that of the drawing. Bodies keep their \
              pitches: they are cut to them anew while you turn, and what rings goes on in the new shape.",
    skew: SKEW,
    ..Spec::percent(&TIMES, 1.0)
};

/// Width over the recipe's.
pub const BREADTH: Spec = Spec {
    id: "swide",
    name: "Breadth",
    tooltip: "Diameter of tubes, width of bars, and of bowls their width beside their height, over those of \
              the drawing. Bodies keep their pitches.",
    skew: SKEW,
    ..Spec::percent(&TIMES, 1.0)
};

/// Undercut, or where the wall is thick.
pub const PROFILE: Spec = Spec {
    id: "sprof",
    name: "Profile",
    tooltip: "How deep bars are hollowed: deeper stretches the upper partials, shallower draws them together. \
              Of bowls how much thicker the rim is and thinner the base. Tubes have none.",
    ..Spec::percent(&EITHER_WAY, 0.0)
};

/// What is added to Poisson's ratio.
pub const POISSON: Spec = Spec {
    id: "spois",
    name: "Poisson",
    tooltip: "Added to the material's Poisson's ratio, in hundredths: how much it narrows as it is stretched. Moves twisting \
              modes and those of shells against those that bend.",
    ..Spec::percent(&POISSON_OFFSET, 0.0)
};

pub(super) const SPECS: [Spec; 4] = [WALL, BREADTH, PROFILE, POISSON];

/// The drawing.
#[derive(Params)]
pub struct Shape {
    /// See [`WALL`].
    #[id = "swall"]
    pub wall: FloatParam,
    /// See [`BREADTH`].
    #[id = "swide"]
    pub breadth: FloatParam,
    /// See [`PROFILE`].
    #[id = "sprof"]
    pub profile: FloatParam,
    /// See [`POISSON`].
    #[id = "spois"]
    pub poisson: FloatParam,
}

impl Default for Shape {
    fn default() -> Self {
        Self {
            wall: float(&WALL),
            breadth: float(&BREADTH),
            profile: float(&PROFILE),
            poisson: float(&POISSON),
        }
    }
}

impl Shape {
    /// What they say.
    #[must_use]
    pub fn drawing(&self) -> Drawing {
        Drawing {
            wall: share(&self.wall) as f32,
            width: share(&self.breadth) as f32,
            profile: share(&self.profile) as f32,
            poisson: share(&self.poisson) as f32,
        }
    }
}

/// The controls that do nothing to the bodies of a recipe, by id, and why.
#[must_use]
pub fn idle(recipe: Option<&Recipe>) -> Vec<(&'static str, &'static str)> {
    let Some(recipe) = recipe else {
        let why =
            "These bodies come from a mesh or a file without a drawing: there is none to change.";
        return SPECS.iter().map(|spec| (spec.id, why)).collect();
    };
    if !recipe.shape.varies() {
        let why = "These bodies are known in closed form, by their size alone.";
        return SPECS.iter().map(|spec| (spec.id, why)).collect();
    }
    if recipe.shape.has_profile() {
        return Vec::new();
    }
    vec![(PROFILE.id, "A tube is straight: it has no profile.")]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_has_no_meaning_is_idle() {
        let recipe = |at: usize| {
            let (name, text) = Recipe::FACTORY[at];
            Recipe::parse(text, name).unwrap()
        };
        let ids = |recipe: Option<&Recipe>| -> Vec<&str> {
            idle(recipe).into_iter().map(|(id, _)| id).collect()
        };
        assert_eq!(ids(Some(&recipe(0))), ["sprof"]);
        assert_eq!(ids(Some(&recipe(1))), [""; 0]);
        assert_eq!(ids(None), ["swall", "swide", "sprof", "spois"]);
    }

    #[test]
    fn a_new_instance_has_the_recipe_s_own_drawing() {
        assert_eq!(Shape::default().drawing(), Drawing::OWN);
    }
}
