//! A recipe with its bodies' drawing changed, as by knobs.

use super::{Recipe, RecipeError, ShapeRecipe};
use crate::Material;
use toml::{Table, Value};

/// How the bodies of an instrument differ from the recipe's drawing.
///
/// Each body keeps its pitch: tubes are cut, bars hollowed and bowls scaled to it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Variation {
    /// Thickness of the wall, of a bar the bar's, over that of the recipe.
    pub wall: f64,
    /// Diameter, of a bar its width, over that of the recipe; a bowl's beside its height.
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
            wall: 1.0,
            width: 1.0,
            profile: 0.0,
            poisson: None,
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
        if *variation == Variation::default() {
            return Ok(self.clone());
        }
        // The text was read before.
        let mut table: Table = self.text.parse().unwrap_or_default();
        if let Some(body) = section(&mut table, "body") {
            for (field, value) in self.dimensions(variation) {
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

    /// The fields of the body that `variation` changes.
    fn dimensions(&self, variation: &Variation) -> Vec<(&'static str, f64)> {
        let &Variation {
            wall,
            width,
            profile,
            ..
        } = variation;
        match self.shape {
            ShapeRecipe::Tube {
                outer_radius_m,
                wall_m,
                ..
            } => vec![
                ("outer_radius_m", width * outer_radius_m),
                ("wall_m", wall * wall_m),
            ],
            ShapeRecipe::Bar {
                thickness,
                width: own,
                undercut,
                ..
            } => vec![
                ("thickness", wall * thickness),
                ("width", width * own),
                ("undercut", (undercut + profile).clamp(-1.0, 1.0)),
            ],
            ShapeRecipe::Bowl(bowl) => {
                let thicker = profile.exp2();
                vec![
                    ("rim_radius_m", width * bowl.rim_radius_m),
                    ("base_radius_m", width * bowl.base_radius_m),
                    ("rim_wall_m", wall * thicker * bowl.rim_wall_m),
                    ("base_wall_m", wall / thicker * bowl.base_wall_m),
                ]
            }
        }
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
