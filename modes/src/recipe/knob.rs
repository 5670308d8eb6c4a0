//! What of a drawing can be changed, and which shapes it means nothing to.

use super::ShapeRecipe;
use crate::shape::ClosedShape;

/// A dimension or property by which a drawing is changed: a field of [`super::Variation`].
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Knob {
    /// [`super::Variation::length`].
    Length,
    /// [`super::Variation::wall`].
    Wall,
    /// [`super::Variation::width`].
    Width,
    /// [`super::Variation::profile`].
    Profile,
    /// [`super::Variation::poisson`].
    Poisson,
}

/// Of closed forms Poisson's ratio is at most a factor of all frequencies.
const NO_POISSON: &str = "It scales all partials of these bodies alike, which tuning takes back.";

impl Knob {
    /// All of them.
    pub const ALL: [Self; 5] = [
        Self::Length,
        Self::Wall,
        Self::Width,
        Self::Profile,
        Self::Poisson,
    ];
}

impl ShapeRecipe {
    /// Why `knob` changes nothing of this shape that tuning does not take back; none if it changes
    /// something.
    #[must_use]
    pub fn idle(&self, knob: Knob) -> Option<&'static str> {
        match (self, knob) {
            (Self::Tube { .. }, Knob::Profile) => Some("A tube is straight: it has no profile."),
            (Self::Closed(shape), _) => idle(shape, knob),
            _ => None,
        }
    }
}

fn idle(shape: &ClosedShape, knob: Knob) -> Option<&'static str> {
    match (shape, knob) {
        (_, Knob::Length | Knob::Wall)
        | (ClosedShape::Bar { .. } | ClosedShape::RectangularMembrane { .. }, Knob::Width) => None,
        (ClosedShape::String { .. }, Knob::Width) => {
            Some("A wire is as wide as it is thick: Wall makes it thicker.")
        }
        (ClosedShape::LMembrane { .. }, Knob::Width) => {
            Some("Three equal squares have no breadth.")
        }
        (ClosedShape::CircularMembrane { .. } | ClosedShape::CircularPlate { .. }, Knob::Width) => {
            Some("What is round has no breadth beside its diameter.")
        }
        (_, Knob::Profile) => Some("These bodies are even all over: they have no profile."),
        (ClosedShape::CircularPlate { .. }, Knob::Poisson) => Some(NO_POISSON),
        (ClosedShape::Bar { .. }, Knob::Poisson) => {
            Some("Thin bars bend without it: it is not in their closed form.")
        }
        (_, Knob::Poisson) => {
            Some("Tension alone, or with a wire's stiffness, knows no such ratio.")
        }
    }
}
