//! The dimensions that a variation gives a body, as fields of its recipe.
//!
//! Where a pitch is not searched for, they are such that it stays of itself.

use super::{ShapeRecipe, Variation};
use crate::shape::ClosedShape;

/// A field of the body and its value.
type Field = (&'static str, f64);

/// The fields of the body that `variation` changes.
pub(super) fn dimensions(shape: &ShapeRecipe, variation: &Variation) -> Vec<Field> {
    let &Variation {
        length,
        wall,
        width,
        profile,
        ..
    } = variation;
    // Bending goes with thickness over length squared.
    let thicker = length * length;
    match *shape {
        ShapeRecipe::Tube {
            outer_radius_m,
            wall_m,
            ..
        } => vec![
            ("outer_radius_m", thicker * width * outer_radius_m),
            ("wall_m", thicker * wall * wall_m),
        ],
        ShapeRecipe::Bar {
            thickness,
            width: own,
            undercut,
            ..
        } => vec![
            ("thickness", thicker * wall * thickness),
            ("width", width * own),
            ("undercut", (undercut + profile).clamp(-1.0, 1.0)),
        ],
        ShapeRecipe::Bowl(bowl) => {
            let to_the_rim = profile.exp2();
            vec![
                ("height_m", length * bowl.height_m),
                ("rim_radius_m", width * bowl.rim_radius_m),
                ("base_radius_m", width * bowl.base_radius_m),
                ("rim_wall_m", wall * to_the_rim * bowl.rim_wall_m),
                ("base_wall_m", wall / to_the_rim * bowl.base_wall_m),
            ]
        }
        ShapeRecipe::Closed(shape) => closed(&shape, variation),
    }
}

/// Of bodies of closed form: what is bent is as much longer as it is thicker, what is taut is taut by the
/// same stress however thick it is, and the more so the longer.
fn closed(shape: &ClosedShape, variation: &Variation) -> Vec<Field> {
    let &Variation {
        length,
        wall,
        width,
        ..
    } = variation;
    let (bent_length, bent_wall) = (length * wall.sqrt(), length * length * wall);
    let (film, film_tension) = (wall, wall * length * length);
    match *shape {
        ClosedShape::String {
            length_m,
            radius_m,
            tension_n,
            ..
        } => vec![
            ("length_m", length * length_m),
            ("radius_m", wall * radius_m),
            ("tension_n", (wall * length).powi(2) * tension_n),
        ],
        ClosedShape::Bar {
            length_m,
            thickness_m,
            width_m,
            ..
        } => vec![
            ("length_m", bent_length * length_m),
            ("thickness_m", bent_wall * thickness_m),
            ("width_m", width * width_m),
        ],
        ClosedShape::RectangularMembrane {
            sides_m: [first_m, second_m],
            thickness_m,
            tension_n_m,
        } => vec![
            ("length_m", length * first_m),
            ("second_side_m", length * width * second_m),
            ("thickness_m", film * thickness_m),
            ("tension_n_m", film_tension * tension_n_m),
        ],
        ClosedShape::CircularMembrane {
            radius_m,
            thickness_m,
            tension_n_m,
        } => vec![
            ("radius_m", length * radius_m),
            ("thickness_m", film * thickness_m),
            ("tension_n_m", film_tension * tension_n_m),
        ],
        ClosedShape::CircularPlate {
            radius_m,
            thickness_m,
        } => vec![
            ("radius_m", bent_length * radius_m),
            ("thickness_m", bent_wall * thickness_m),
        ],
        ClosedShape::LMembrane {
            square_m,
            thickness_m,
            tension_n_m,
        } => vec![
            ("square_m", length * square_m),
            ("thickness_m", film * thickness_m),
            ("tension_n_m", film_tension * tension_n_m),
        ],
    }
}
