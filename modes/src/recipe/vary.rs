//! A recipe with its bodies' drawing changed, as by knobs.

use super::dimensions::dimensions;
use super::{Knob, Recipe, RecipeError};
use crate::Material;
use toml::{Table, Value};

/// How the bodies of an instrument differ from the recipe's drawing; what of it means nothing to a shape,
/// [`ShapeRecipe::idle`](super::ShapeRecipe::idle) says.
///
/// Each body keeps its pitch: tubes are cut, bars hollowed, bowls scaled, and strings and films tightened
/// to it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Variation {
    /// Length over that of the recipe: of bowls the height, of drums and plates all sides. What bends is
    /// thicker as the square, tubes of a larger diameter too; what is taut is tighter as the square.
    pub length: f64,
    /// Thickness of the wall, of a bar the bar's, of a string the wire's, of drums the film's, over that of
    /// the recipe. Plates and bars grow longer as the root; strings and films are under the same stress.
    pub wall: f64,
    /// Diameter, of a bar its width, of a rectangle its second side, over that of the recipe; a bowl's
    /// beside its height.
    pub width: f64,
    /// Of a bar how far its undercut stretches the partials, −1…1 (`bar::stretched`); of a bowl how much
    /// thicker the rim gets and the base thinner, in octaves. 0 is the recipe's.
    pub profile: f64,
    /// Poisson's ratio; the material's own without. Young's modulus stays.
    pub poisson: Option<f64>,
}

impl Default for Variation {
    /// The recipe's own drawing.
    fn default() -> Self {
        Self {
            length: 1.0,
            wall: 1.0,
            width: 1.0,
            profile: 0.0,
            poisson: None,
        }
    }
}

impl Variation {
    /// The same with what `knob` changes as the recipe has it.
    fn without(self, knob: Knob) -> Self {
        let own = Self::default();
        match knob {
            Knob::Length => Self {
                length: own.length,
                ..self
            },
            Knob::Wall => Self {
                wall: own.wall,
                ..self
            },
            Knob::Width => Self {
                width: own.width,
                ..self
            },
            Knob::Profile => Self {
                profile: own.profile,
                ..self
            },
            Knob::Poisson => Self {
                poisson: own.poisson,
                ..self
            },
        }
    }
}

impl Recipe {
    /// The recipe with `variation` in its text, without its comments; the recipe itself if nothing
    /// varies.
    ///
    /// # Errors
    ///
    /// If a dimension leaves its range.
    pub fn varied(&self, variation: &Variation) -> Result<Self, RecipeError> {
        let idle = Knob::ALL
            .into_iter()
            .filter(|knob| self.shape.idle(*knob).is_some());
        let variation = idle.fold(*variation, Variation::without);
        if variation == Variation::default() {
            return Ok(self.clone());
        }
        // The text was read before.
        let mut table: Table = self.text.parse().unwrap_or_default();
        if let Some(body) = section(&mut table, "body") {
            for (field, value) in dimensions(&self.shape, &variation) {
                body.insert(field.to_owned(), Value::Float(value));
            }
        }
        if let Some(poisson) = variation.poisson {
            let Material { density_kg_m3, .. } = self.material;
            let numbers = [
                ("young_pa", self.material.young_pa()),
                ("poisson", poisson),
                ("density_kg_m3", density_kg_m3),
            ];
            let numbers = numbers.map(|(field, value)| (field.to_owned(), Value::Float(value)));
            table.insert(
                "material".to_owned(),
                Value::Table(numbers.into_iter().collect()),
            );
            self.spell_damping(&mut table);
        }
        Self::parse(&table.to_string(), &self.name)
    }

    /// Writes out the damping that came with the name of a material.
    fn spell_damping(&self, table: &mut Table) {
        if table.contains_key("damping") {
            return;
        }
        let rayleigh = self.damping.rayleigh;
        let fields = [
            ("alpha1_s", rayleigh.alpha1_s),
            ("alpha2_per_s", rayleigh.alpha2_per_s),
        ];
        let fields = fields.map(|(field, value)| (field.to_owned(), Value::Float(value)));
        table.insert(
            "damping".to_owned(),
            Value::Table(fields.into_iter().collect()),
        );
    }
}

fn section<'a>(table: &'a mut Table, name: &str) -> Option<&'a mut Table> {
    table.get_mut(name)?.as_table_mut()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::ShapeRecipe;

    fn factory(name: &str) -> Recipe {
        let (name, text) = Recipe::FACTORY.iter().find(|(n, _)| *n == name).unwrap();
        Recipe::parse(text, name).unwrap()
    }

    #[test]
    fn nothing_varied_is_the_recipe_itself() {
        for (name, _) in Recipe::FACTORY {
            let recipe = factory(name);
            assert_eq!(recipe.varied(&Variation::default()).unwrap(), recipe);
        }
        let chimes = factory("chimes");
        let bent = Variation {
            profile: 0.5,
            ..Variation::default()
        };
        assert_eq!(chimes.varied(&bent).unwrap(), chimes, "a tube has none");
        let bars = factory("vibraphone");
        assert_ne!(bars.varied(&bent).unwrap(), bars);
    }

    #[test]
    fn only_what_is_varied_differs_and_the_text_says_it_all() {
        let chimes = factory("chimes");
        let variation = Variation {
            wall: 1.5,
            width: 0.8,
            poisson: Some(0.25),
            ..Variation::default()
        };
        let varied = chimes.varied(&variation).unwrap();
        let (ShapeRecipe::Tube { wall_m: a, .. }, ShapeRecipe::Tube { wall_m: b, .. }) =
            (chimes.shape, varied.shape)
        else {
            panic!("chimes are tubes");
        };
        assert_eq!(b, 1.5 * a);
        assert!((varied.material.poisson() - 0.25).abs() < 1e-12);
        let young = varied.material.young_pa() / chimes.material.young_pa();
        assert!((young - 1.0).abs() < 1e-12, "{young}");
        assert_eq!(
            (varied.damping, varied.losses),
            (chimes.damping, chimes.losses)
        );
        assert_eq!(varied.mesh, chimes.mesh);
        assert_eq!(Recipe::parse(&varied.text, "chimes").unwrap(), varied);
    }

    #[test]
    fn each_knob_alone_goes_to_its_ends() {
        let own = Variation::default();
        for (name, _) in Recipe::FACTORY {
            for wall in [0.5, 2.0] {
                let varied = factory(name).varied(&Variation { wall, ..own });
                assert!(varied.is_ok(), "{name} {wall}: {varied:?}");
            }
            for length in [0.7, 1.4] {
                let varied = factory(name).varied(&Variation { length, ..own });
                assert!(varied.is_ok(), "{name} {length}: {varied:?}");
            }
            for profile in [-1.0, 1.0] {
                let varied = factory(name).varied(&Variation { profile, ..own });
                assert!(varied.is_ok(), "{name} {profile}: {varied:?}");
            }
            let varied = factory(name).varied(&Variation { width: 2.0, ..own });
            assert!(varied.is_ok(), "{name}: {varied:?}");
        }
    }

    /// What is idle changes nothing, and what is not changes the text.
    #[test]
    fn a_knob_is_idle_or_changes_the_recipe() {
        let turned = Variation {
            length: 1.1,
            wall: 1.1,
            width: 1.1,
            profile: 0.1,
            poisson: Some(0.2),
        };
        for (name, _) in Recipe::FACTORY {
            let recipe = factory(name);
            for knob in Knob::ALL {
                let others = Knob::ALL.into_iter().filter(|other| *other != knob);
                let alone = others.fold(turned, Variation::without);
                let same = recipe.varied(&alone).unwrap() == recipe;
                assert_eq!(same, recipe.shape.idle(knob).is_some(), "{name} {knob:?}");
            }
        }
    }

    #[test]
    fn a_wall_that_runs_into_itself_is_refused_with_a_cure() {
        let narrow = Variation {
            width: 0.5,
            ..Variation::default()
        };
        let error = factory("oak-bowls").varied(&narrow).unwrap_err();
        assert!(error.to_string().contains("would do"), "{error}");
    }
}
