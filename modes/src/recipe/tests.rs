//! Right recipes are taken as they are meant, wrong ones refused with a cure.

use super::{KeyRange, MeshRecipe, Recipe, RecipeError, RecipeFileError, ShapeRecipe};
use crate::ImperfectionSize;
use crate::{Material, TABLE_1};

const CHIMES: &str = Recipe::FACTORY[0].1;

fn parse(text: &str) -> Result<Recipe, RecipeError> {
    Recipe::parse(text, "my.toml")
}

/// The chimes with one line changed.
fn chimes_with(from: &str, to: &str) -> String {
    let changed = CHIMES.replacen(from, to, 1);
    assert_ne!(changed, CHIMES, "{from} is not there");
    changed
}

#[track_caller]
fn message(from: &str, to: &str) -> String {
    let message = parse(&chimes_with(from, to)).unwrap_err().to_string();
    assert!(!message.contains('\n'), "{message}");
    message
}

#[test]
fn the_factory_chimes_are_those_of_the_paper() {
    let recipe = parse(CHIMES).unwrap();
    let chime = TABLE_1[0];
    assert_eq!(recipe.name, Recipe::FACTORY[0].0);
    assert_eq!(recipe.keys, KeyRange { low: 36, high: 96 });
    assert_eq!(recipe.keys.iter().len(), 61);
    assert_eq!((recipe.tuning.a4_hz, recipe.tuning.partial), (440.0, 1));
    assert_eq!(
        recipe.shape,
        ShapeRecipe::Tube {
            outer_radius_m: 0.0125,
            wall_m: 0.001,
            plug_m: 0.0,
            hung_at: 0.2242,
            felt_at: 0.03,
        }
    );
    assert_eq!(recipe.material, chime.material);
    assert_eq!(recipe.damping.rayleigh, chime.rayleigh);
    assert_eq!(recipe.text, CHIMES);
}

#[test]
fn materials_can_be_told_in_three_ways() {
    let name = "name = \"O'Brien 2002 aluminium\"";
    let told = |to| parse(&chimes_with(name, to)).unwrap().material;
    let aluminium = Material::named("aluminium").unwrap();
    assert_eq!(told("name = \"aluminium\""), aluminium);
    assert_eq!(
        told("young_pa = 68.9e9\npoisson = 0.33\ndensity_kg_m3 = 2700"),
        aluminium
    );
    assert_eq!(
        told("lambda_pa = 4.98e10\nmu_pa = 2.57e10\ndensity_kg_m3 = 2700"),
        TABLE_1[0].material
    );
}

#[test]
fn a_named_material_lends_its_damping() {
    let without = chimes_with("[damping]", "")
        .replace("alpha1_s = 1e-7", "")
        .replace("alpha2_per_s = 0.0", "")
        .replace("loss_factor = 0.0", "")
        .replace("support_kg_s = 0.02", "");
    let steel = without.replace("O'Brien 2002 aluminium", "steel");
    let damping = parse(&steel).unwrap().damping;
    assert_eq!(
        (damping.rayleigh.alpha1_s, damping.rayleigh.alpha2_per_s),
        (3e-8, 5.0)
    );
    let nameless = without.replace(
        "name = \"O'Brien 2002 aluminium\"",
        "young_pa = 1e9\npoisson = 0.3\ndensity_kg_m3 = 900",
    );
    let message = parse(&nameless).unwrap_err().to_string();
    assert!(message.starts_with("my.toml: damping is left out, but must be given"));
}

#[test]
fn one_key_is_a_range() {
    let one = chimes_with("low = 36", "low = 96");
    let keys: Vec<u8> = parse(&one).unwrap().keys.iter().collect();
    assert_eq!(keys, [96]);
    let all = KeyRange { low: 0, high: 127 };
    assert_eq!((all.iter().len(), all.iter().last()), (128, Some(127)));
}

#[test]
fn whole_numbers_serve_as_numbers() {
    let recipe = parse(&chimes_with("a4_hz = 440.0", "a4_hz = 432")).unwrap();
    assert_eq!(recipe.tuning.a4_hz, 432.0);
    let mesh = parse(&chimes_with("around = 48", "around = 8"))
        .unwrap()
        .mesh;
    assert_eq!(
        mesh,
        MeshRecipe {
            fewest_modes: None,
            around: 8,
            max_element_m: 0.006,
            highest_hz: 20_000.0,
        }
    );
}

/// Line to change, change, the error.
const FIELDS: &[(&str, &str, &str)] = &[
    (
        "name = \"chimes\"",
        "name = \"\"",
        "name is \"\", but must be 1 to 64 small letters, digits, - and _, because it names a file",
    ),
    (
        "name = \"chimes\"",
        "name = \"../x\"",
        "name is \"../x\", but must be 1 to 64 small letters, digits, - and _, because it names a file",
    ),
    (
        "low = 36",
        "low = -1",
        "keys.low is -1, but must be a whole number from 0 to 127",
    ),
    (
        "high = 96",
        "high = 128",
        "keys.high is 128, but must be a whole number from 0 to 127",
    ),
    (
        "high = 96",
        "high = 65572",
        "keys.high is 65572, but must be a whole number from 0 to 127",
    ),
    (
        "low = 36",
        "low = 97",
        "keys.high is 96, but must be no less than keys.low = 97",
    ),
    (
        "a4_hz = 440.0",
        "a4_hz = 299.9",
        "tuning.a4_hz is 299.9, but must be 300 to 600",
    ),
    (
        "a4_hz = 440.0",
        "a4_hz = nan",
        "tuning.a4_hz is NaN, but must be 300 to 600",
    ),
    (
        "partial = 1",
        "partial = 0",
        "tuning.partial is 0, but must be a whole number from 1 to 16",
    ),
    (
        "tolerance_cents = 1.0",
        "tolerance_cents = 0.0",
        "tuning.tolerance_cents is 0, but must be 0.001 to 50",
    ),
    (
        "shape = \"tube\"",
        "shape = \"bell\"",
        "body.shape is \"bell\", but must be \"tube\", \"bar\", \"bowl\", or of closed form: \
         \"string\", \"clamped bar\", \"free bar\", \"cantilever\", \"rectangular membrane\", \
         \"circular membrane\", \"circular plate\", \"L membrane\"",
    ),
    (
        "outer_radius_m = 0.0125",
        "outer_radius_m = inf",
        "body.outer_radius_m is inf, but must be above 0 and at most 1",
    ),
    (
        "wall_m = 0.001",
        "wall_m = -0.001",
        "body.wall_m is -0.001, but must be at least 0.000125 and below body.outer_radius_m = 0.0125",
    ),
    (
        "wall_m = 0.001",
        "wall_m = 0.0125",
        "body.wall_m is 0.0125, but must be at least 0.000125 and below body.outer_radius_m = 0.0125",
    ),
    (
        "wall_m = 0.001",
        "wall_m = nan",
        "body.wall_m is NaN, but must be at least 0.000125 and below body.outer_radius_m = 0.0125",
    ),
    (
        "alpha1_s = 1e-7",
        "alpha1_s = -1e-7",
        "damping.alpha1_s is -0.0000001, but must be 0 to 0.001",
    ),
    (
        "alpha2_per_s = 0.0",
        "alpha2_per_s = inf",
        "damping.alpha2_per_s is inf, but must be 0 to 10000",
    ),
    (
        "around = 48",
        "around = 6",
        "mesh.around is 6, but must be an even number from 8 to 512",
    ),
    (
        "around = 48",
        "around = 47",
        "mesh.around is 47, but must be an even number from 8 to 512",
    ),
    (
        "around = 48",
        "around = 514",
        "mesh.around is 514, but must be an even number from 8 to 512",
    ),
    (
        "max_element_m = 0.006",
        "max_element_m = 0.0",
        "mesh.max_element_m is 0, but must be 0.0005 to 0.1",
    ),
];

#[test]
fn values_out_of_range_are_told_with_field_value_and_range() {
    for (from, to, expected) in FIELDS {
        assert_eq!(message(from, to), format!("my.toml: {expected}"));
    }
}

#[test]
fn impossible_materials_are_told_with_field_value_and_range() {
    for (numbers, expected) in [
        (
            "young_pa = 0\npoisson = 0.3",
            "young_pa is 0, but must be finite and above 0",
        ),
        (
            "young_pa = 1e9\npoisson = 0.5",
            "poisson is 0.5, but must be -0.5 to 0.49",
        ),
        (
            "young_pa = 1e9\npoisson = 0.4999",
            "poisson is 0.4999, but must be -0.5 to 0.49",
        ),
        (
            "lambda_pa = 1e9\nmu_pa = nan",
            "mu_pa is NaN, but must be finite and above 0",
        ),
        (
            "lambda_pa = inf\nmu_pa = 1e9",
            "lambda_pa is inf, but must be -0.5 to 49 times material.mu_pa",
        ),
    ] {
        let to = format!("{numbers}\ndensity_kg_m3 = 2700");
        let message = message("name = \"O'Brien 2002 aluminium\"", &to);
        assert_eq!(message, format!("my.toml: material.{expected}"));
    }
    let two_ways = message("name = \"O'Brien", "mu_pa = 1e9\nname = \"O'Brien");
    assert!(two_ways.starts_with("my.toml: material is not told in one way, but must be name"));
}

#[test]
fn an_unknown_material_gets_the_nearest_and_the_list() {
    let message = message("O'Brien 2002 aluminium", "bras");
    assert!(message.starts_with("my.toml: material.name is \"bras\", but must be a known one"));
    assert!(message.contains("did you mean \"brass\"?") && message.contains("\"rosewood\""));
}

#[test]
fn faults_of_the_text_have_line_and_column() {
    let line_of = |needle: &str| CHIMES.lines().position(|l| l.starts_with(needle)).unwrap() + 1;
    for (from, to, column, expected) in [
        ("wall_m = 0.001", "wall_m = ", 10, ""),
        (
            "wall_m = 0.001",
            "wall_mm = 1.0",
            1,
            "unknown field `wall_mm`, expected one of",
        ),
        (
            "wall_m = 0.001",
            "wall_m = \"thin\"",
            10,
            "invalid type: string \"thin\", expected f64",
        ),
    ] {
        let message = message(from, to);
        let place = format!("my.toml:{}:{column}: {expected}", line_of("wall_m"));
        assert!(message.starts_with(&place), "{message} is not {place}");
    }
    let missing = message("wall_m = 0.001", "");
    assert_eq!(
        missing,
        "my.toml: body.wall_m is left out, but must be given"
    );
    let missing = message("tolerance_cents = 1.0", "");
    let place = format!(
        "my.toml:{}:1: missing field `tolerance_cents`",
        line_of("[tuning]")
    );
    assert!(missing.starts_with(&place), "{missing}");
    assert!(
        parse("")
            .unwrap_err()
            .to_string()
            .starts_with("my.toml:1:1: missing field")
    );
}

#[test]
fn bowls_that_are_none_are_told_with_field_value_and_range() {
    let bowls = Recipe::FACTORY[3].1;
    for (from, to, expected) in [
        (
            "squareness = 2.0",
            "squareness = 1.0",
            "body.squareness is 1, but must be 2 to 10",
        ),
        (
            "base_radius_m = 0.045",
            "base_radius_m = 0.1",
            "body.base_radius_m is 0.1, but must be above 0 and below 0.09",
        ),
        (
            "rim_wall_m = 0.004",
            "rim_wall_m = 0.0",
            "body.rim_wall_m is 0, but must be above 0.00045 and below 0.03",
        ),
        (
            "base_radius_m = 0.045",
            "base_radius_m = 0.088",
            "body.base_wall_m is 0.0015, but must be less: the wall runs into itself",
        ),
    ] {
        let text = bowls.replace(from, to);
        assert_ne!(text, bowls);
        let message = Recipe::parse(&text, "my.toml").unwrap_err().to_string();
        let expected = format!("my.toml: {expected}");
        assert!(message.starts_with(&expected), "{message}");
    }
}

#[test]
fn an_imperfection_has_one_size() {
    let bowls = Recipe::FACTORY[3].1;
    let with = |size: &str| {
        let text = bowls.replace("beat_hz = 0.6", size);
        Recipe::parse(&text, "my.toml").map(|recipe| recipe.imperfection)
    };
    let share = with("mass_share = 0.001").unwrap().unwrap();
    assert_eq!(share.size, ImperfectionSize::MassShare(0.001));
    let beat = with("beat_hz = 0.6").unwrap().unwrap();
    assert_eq!(beat.size, ImperfectionSize::BeatHz(0.6));
    for (size, error) in [
        (
            "",
            "my.toml: imperfection is given without a size, but must be given either as mass_share or \
             as beat_hz",
        ),
        (
            "beat_hz = 1.0\nmass_share = 0.1",
            "my.toml: imperfection is given both as mass_share and as beat_hz, but must be given either \
             as mass_share or as beat_hz",
        ),
        (
            "beat_hz = -1.0",
            "my.toml: imperfection.beat_hz is -1, but must be 0 to 20",
        ),
    ] {
        assert_eq!(with(size).unwrap_err().to_string(), error);
    }
}

#[test]
fn a_missing_file_is_named() {
    let error = Recipe::load("no/such/recipe.toml").unwrap_err();
    assert!(matches!(error, RecipeFileError::Read { .. }));
    assert!(
        error
            .to_string()
            .starts_with("no/such/recipe.toml: cannot read the recipe: ")
    );
}

#[cfg(unix)]
#[test]
fn an_endless_file_is_refused() {
    let message = Recipe::load("/dev/zero").unwrap_err().to_string();
    assert!(
        message.ends_with("longer than 1 MiB; choose a recipe, a short TOML file"),
        "{message}"
    );
}
