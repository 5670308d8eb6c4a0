//! What a recipe's fields ask of each other.

use super::error::Fault;
use super::{Recipe, ShapeRecipe};
use crate::equal_temperament_hz;
use crate::shape::ClosedShape;

/// Refuses pitches that the mesh does not go up to, and tunings that the shape does not have.
pub(super) fn check_together(recipe: &Recipe) -> Result<(), Fault> {
    let tuning = &recipe.tuning;
    if !matches!(recipe.shape, ShapeRecipe::Tube { .. }) {
        if tuning.partial != 1 {
            let allowed = "1: all but tubes are tuned by their lowest mode";
            return Err(Fault::field("tuning.partial", tuning.partial, allowed));
        }
        if tuning.octaves_below != 0 {
            let allowed = "0: all but tubes are heard as their lowest mode";
            let octaves = tuning.octaves_below;
            return Err(Fault::field("tuning.octaves_below", octaves, allowed));
        }
    }
    if matches!(recipe.shape, ShapeRecipe::Closed(_)) {
        let allowed = "left out: bodies of closed form have none";
        if recipe.imperfection.is_some() {
            return Err(Fault::field("imperfection", "given", allowed));
        }
        if recipe.resonator.is_some() {
            return Err(Fault::field("resonator", "given", allowed));
        }
    }
    let products = matches!(
        recipe.shape,
        ShapeRecipe::Closed(
            ClosedShape::RectangularMembrane { .. }
                | ClosedShape::CircularMembrane { .. }
                | ClosedShape::CircularPlate { .. }
        )
    );
    if let Some(fewest) = recipe.mesh.fewest_modes.filter(|_| !products) {
        let allowed =
            "left out: all but rectangular and round films and plates have all their modes";
        return Err(Fault::field("mesh.fewest_modes", fewest, allowed));
    }
    let key = recipe.keys.high;
    let tuned_hz = equal_temperament_hz(key, tuning.a4_hz) * f64::from(1 << tuning.octaves_below);
    let highest_hz = recipe.mesh.highest_hz;
    if tuned_hz > highest_hz {
        let allowed = format!(
            "such that what key {key} is tuned by, {tuned_hz:.0} Hz, is not above mesh.highest_hz = \
             {highest_hz}"
        );
        return Err(Fault::field("keys.high", key, allowed));
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    fn refused(name: &str, changes: &[(&str, &str)]) -> String {
        let (_, text) = Recipe::FACTORY
            .iter()
            .find(|(own, _)| *own == name)
            .unwrap();
        let text = changes.iter().fold((*text).to_owned(), |text, (from, to)| {
            let changed = text.replacen(from, to, 1);
            assert_ne!(changed, text, "{from} is not there");
            changed
        });
        Recipe::parse(&text, "my.toml").unwrap_err().to_string()
    }

    #[test]
    fn what_a_key_is_tuned_by_is_asked_to_be_in_the_mesh() {
        assert_eq!(
            refused(
                "metal-bowls",
                &[("highest_hz = 7000.0", "highest_hz = 1000.0")]
            ),
            "my.toml: keys.high is 84, but must be such that what key 84 is tuned by, 1047 Hz, is not \
             above mesh.highest_hz = 1000"
        );
        let message = refused("tubular-bells", &[("high = 84", "high = 127")]);
        assert!(
            message.contains("what key 127 is tuned by, 25088 Hz"),
            "{message}"
        );
    }

    #[test]
    fn bars_and_bowls_are_asked_for_their_lowest_mode() {
        for name in ["vibraphone", "singing-bowls"] {
            assert_eq!(
                refused(name, &[("partial = 1", "partial = 2")]),
                "my.toml: tuning.partial is 2, but must be 1: all but tubes are tuned by their lowest mode"
            );
            assert_eq!(
                refused(name, &[("partial = 1", "partial = 1\noctaves_below = 1")]),
                "my.toml: tuning.octaves_below is 1, but must be 0: all but tubes are heard as their lowest \
                 mode"
            );
        }
    }
}
