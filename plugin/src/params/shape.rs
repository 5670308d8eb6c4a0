//! How the bodies are drawn, beside the recipe's drawing.

use super::Spec;
use super::build::{float, share};
use crate::maker::Drawing;
use modes::{Knob, Recipe};
use nice_plug::prelude::{FloatParam, Params};
use std::ops::RangeInclusive;

/// Thickness and width over the recipe's.
const TIMES: RangeInclusive<f64> = 0.5..=2.0;
/// Shares either way.
const EITHER_WAY: RangeInclusive<f64> = -1.0..=1.0;
/// What is added to Poisson's ratio.
const POISSON_OFFSET: RangeInclusive<f64> = -0.15..=0.15;
/// Length over the recipe's.
const LENGTHS: RangeInclusive<f64> = 0.7..=1.4;
/// Put 100 % in the middle.
const SKEW: f32 = 0.63;
const LENGTH_SKEW: f32 = 0.82;

/// Length over the recipe's.
pub const LENGTH: Spec = Spec {
    id: "slen",
    name: "Length",
    tooltip: "Length over that of the drawing, of bowls the height, of plates and drums all sides. Bodies keep \
              their pitches: what bends is as much thicker as that asks for, strings and drums are tighter.",
    skew: LENGTH_SKEW,
    ..Spec::percent(&LENGTHS, 1.0)
};

/// Thickness over the recipe's.
pub const WALL: Spec = Spec {
    id: "swall",
    name: "Wall",
    tooltip: "Thickness of walls, bars, plates, wires and drumheads over that of the drawing. Bodies keep their \
              pitches: they are cut to them anew while you turn, and what rings goes on in the new shape.",
    skew: SKEW,
    ..Spec::percent(&TIMES, 1.0)
};

/// Width over the recipe's.
pub const BREADTH: Spec = Spec {
    id: "swide",
    name: "Breadth",
    tooltip: "Diameter of tubes, width of bars, of bowls their width beside their height, and of square drums \
              one side beside the other, over those of the drawing. Bodies keep their pitches.",
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

pub(super) const SPECS: [Spec; 5] = [LENGTH, WALL, BREADTH, PROFILE, POISSON];

/// What of a recipe's drawing each of them changes.
const KNOBS: [Knob; SPECS.len()] = [
    Knob::Length,
    Knob::Wall,
    Knob::Width,
    Knob::Profile,
    Knob::Poisson,
];

/// The drawing.
#[derive(Params)]
pub struct Shape {
    /// See [`LENGTH`].
    #[id = "slen"]
    pub length: FloatParam,
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
            length: float(&LENGTH),
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
            length: share(&self.length) as f32,
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
    let knobs = SPECS.iter().zip(KNOBS);
    let idle = knobs.filter_map(|(spec, knob)| Some((spec.id, recipe.shape.idle(knob)?)));
    idle.collect()
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
        let strings = Recipe::FACTORY
            .iter()
            .position(|(name, _)| *name == "strings");
        let strings = recipe(strings.unwrap());
        assert_eq!(ids(Some(&strings)), ["swide", "sprof", "spois"]);
        assert_eq!(ids(None), ["slen", "swall", "swide", "sprof", "spois"]);
    }

    #[test]
    fn a_new_instance_has_the_recipe_s_own_drawing() {
        assert_eq!(Shape::default().drawing(), Drawing::OWN);
    }
}
