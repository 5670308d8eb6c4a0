//! What a recipe says of a body of closed form.

use super::error::Fault;
use super::raw::RawBody;
use crate::shape::{BarEnds, ClosedShape};

/// A field of the body and what is given for it.
type Field = (&'static str, Option<f64>);

/// Greatest length of a body, in m.
const LONGEST_M: f64 = 10.0;

/// Greatest tension, in N or N/m.
const TIGHTEST: f64 = 1e6;

/// All fields that only bodies of closed form have.
pub(super) fn closed_fields(body: &RawBody) -> [Field; 9] {
    [
        ("body.length_m", body.length_m),
        ("body.second_side_m", body.second_side_m),
        ("body.width_m", body.width_m),
        ("body.thickness_m", body.thickness_m),
        ("body.radius_m", body.radius_m),
        ("body.square_m", body.square_m),
        ("body.tension_n", body.tension_n),
        ("body.tension_n_m", body.tension_n_m),
        ("body.board_s_kg", body.board_s_kg),
    ]
}

/// The names of the shapes.
pub(super) const CLOSED: [&str; 8] = [
    "string",
    "clamped bar",
    "free bar",
    "cantilever",
    "rectangular membrane",
    "circular membrane",
    "circular plate",
    "L membrane",
];

/// The shape if it is one of [`CLOSED`].
pub(super) fn check_closed(body: &RawBody) -> Result<Option<ClosedShape>, Fault> {
    let own: &[&str] = match body.shape.as_str() {
        "string" => &["length_m", "radius_m", "tension_n", "board_s_kg"],
        "free bar" => &["length_m", "thickness_m", "width_m"],
        "clamped bar" | "cantilever" => &["length_m", "thickness_m", "width_m", "board_s_kg"],
        "rectangular membrane" => &["length_m", "second_side_m", "thickness_m", "tension_n_m"],
        "circular membrane" => &["radius_m", "thickness_m", "tension_n_m"],
        "circular plate" => &["radius_m", "thickness_m"],
        "L membrane" => &["square_m", "thickness_m", "tension_n_m"],
        _ => return Ok(None),
    };
    let is_own = |field: &str| {
        own.iter()
            .any(|name| field.strip_prefix("body.") == Some(name))
    };
    for (field, x) in closed_fields(body) {
        if let (false, Some(x)) = (is_own(field), x) {
            let allowed = format!("left out: a {} has {}", body.shape, own.join(", "));
            return Err(Fault::field(field, x, allowed));
        }
    }
    shape(body).map(Some)
}

fn shape(body: &RawBody) -> Result<ClosedShape, Fault> {
    let bar = |ends| -> Result<ClosedShape, Fault> {
        let length_m = length("body.length_m", body.length_m)?;
        Ok(ClosedShape::Bar {
            length_m,
            thickness_m: thin("body.thickness_m", body.thickness_m, length_m)?,
            width_m: below("body.width_m", body.width_m, length_m)?,
            ends,
            board_s_kg: body
                .board_s_kg
                .map(|x| below("body.board_s_kg", Some(x), 1.0))
                .transpose()?,
        })
    };
    Ok(match body.shape.as_str() {
        "string" => {
            let length_m = length("body.length_m", body.length_m)?;
            ClosedShape::String {
                length_m,
                radius_m: thin("body.radius_m", body.radius_m, length_m)?,
                tension_n: below("body.tension_n", body.tension_n, TIGHTEST)?,
                board_s_kg: below("body.board_s_kg", body.board_s_kg, 1.0)?,
            }
        }
        "clamped bar" => bar(BarEnds::Clamped)?,
        "free bar" => bar(BarEnds::Free)?,
        "cantilever" => bar(BarEnds::Cantilever)?,
        "rectangular membrane" => {
            let sides_m = [
                length("body.length_m", body.length_m)?,
                length("body.second_side_m", body.second_side_m)?,
            ];
            ClosedShape::RectangularMembrane {
                sides_m,
                thickness_m: thin(
                    "body.thickness_m",
                    body.thickness_m,
                    sides_m[0].min(sides_m[1]),
                )?,
                tension_n_m: below("body.tension_n_m", body.tension_n_m, TIGHTEST)?,
            }
        }
        "circular membrane" => {
            let radius_m = length("body.radius_m", body.radius_m)?;
            ClosedShape::CircularMembrane {
                radius_m,
                thickness_m: thin("body.thickness_m", body.thickness_m, radius_m)?,
                tension_n_m: below("body.tension_n_m", body.tension_n_m, TIGHTEST)?,
            }
        }
        "circular plate" => {
            let radius_m = length("body.radius_m", body.radius_m)?;
            ClosedShape::CircularPlate {
                radius_m,
                thickness_m: thin("body.thickness_m", body.thickness_m, radius_m)?,
            }
        }
        _ => {
            let square_m = length("body.square_m", body.square_m)?;
            ClosedShape::LMembrane {
                square_m,
                thickness_m: thin("body.thickness_m", body.thickness_m, square_m)?,
                tension_n_m: below("body.tension_n_m", body.tension_n_m, TIGHTEST)?,
            }
        }
    })
}

fn length(field: &'static str, x: Option<f64>) -> Result<f64, Fault> {
    below(field, x, LONGEST_M)
}

/// What is thin beside `length_m`, as thin bodies are: a fifth at most.
fn thin(field: &'static str, x: Option<f64>, length_m: f64) -> Result<f64, Fault> {
    below(field, x, 0.2 * length_m)
}

fn below(field: &'static str, x: Option<f64>, most: f64) -> Result<f64, Fault> {
    match x {
        Some(x) if x > 0.0 && x <= most => Ok(x),
        Some(x) => Err(Fault::field(
            field,
            x,
            format!("above 0 and at most {most}"),
        )),
        None => Err(Fault::field(field, "left out", "given")),
    }
}

#[cfg(test)]
mod tests {
    use crate::shape::ClosedShape;
    use crate::{Recipe, ShapeRecipe};

    fn text(body: &str) -> String {
        format!(
            "name = \"my\"\nkeys = {{ low = 60, high = 72 }}\n\
             tuning = {{ a4_hz = 440.0, partial = 1, tolerance_cents = 1.0 }}\n\
             material = {{ name = \"aluminium\" }}\nmesh = {{ max_element_m = 0.02 }}\n\
             [body]\n{body}\n"
        )
    }

    fn refused(body: &str) -> String {
        Recipe::parse(&text(body), "my.toml")
            .unwrap_err()
            .to_string()
    }

    #[test]
    fn every_shape_is_read() {
        let bodies = [
            "shape = \"string\"\nlength_m = 0.6\nradius_m = 5e-4\ntension_n = 700.0\nboard_s_kg = 1e-3",
            "shape = \"clamped bar\"\nlength_m = 0.3\nthickness_m = 0.004\nwidth_m = 0.03",
            "shape = \"free bar\"\nlength_m = 0.3\nthickness_m = 0.004\nwidth_m = 0.03",
            "shape = \"cantilever\"\nlength_m = 0.3\nthickness_m = 0.004\nwidth_m = 0.03",
            "shape = \"rectangular membrane\"\nlength_m = 0.3\nsecond_side_m = 0.2\n\
             thickness_m = 2e-4\ntension_n_m = 3000.0",
            "shape = \"circular membrane\"\nradius_m = 0.2\nthickness_m = 2e-4\ntension_n_m = 3000.0",
            "shape = \"circular plate\"\nradius_m = 0.2\nthickness_m = 1e-3",
            "shape = \"L membrane\"\nsquare_m = 0.2\nthickness_m = 2e-4\ntension_n_m = 3000.0",
        ];
        for body in bodies {
            let recipe = Recipe::parse(&text(body), "my.toml").unwrap();
            assert!(matches!(recipe.shape, ShapeRecipe::Closed(_)), "{body}");
        }
        let plate = Recipe::parse(&text(bodies[6]), "my.toml").unwrap();
        let expected = ClosedShape::CircularPlate {
            radius_m: 0.2,
            thickness_m: 1e-3,
        };
        assert_eq!(plate.shape, ShapeRecipe::Closed(expected));
    }

    #[test]
    fn fields_of_others_are_refused() {
        let plate = "shape = \"circular plate\"\nradius_m = 0.2\nthickness_m = 1e-3\n";
        assert_eq!(
            refused(&format!("{plate}tension_n_m = 3000.0")),
            "my.toml: body.tension_n_m is 3000, but must be left out: a circular plate has radius_m, \
             thickness_m"
        );
        assert_eq!(
            refused(&format!("{plate}wall_m = 0.01")),
            "my.toml: body.wall_m is 0.01, but must be left out: a circular plate has none"
        );
        assert_eq!(
            refused("shape = \"bar\"\nsquare_m = 0.2"),
            "my.toml: body.square_m is 0.2, but must be left out: a bar has none"
        );
    }

    #[test]
    fn what_is_not_thin_is_refused() {
        assert_eq!(
            refused("shape = \"circular plate\"\nradius_m = 0.2\nthickness_m = 0.1"),
            "my.toml: body.thickness_m is 0.1, but must be above 0 and at most 0.04000000000000001"
        );
    }
}
