//! Recipes of meshes.

use super::{FreeFineness, FreeRecipe, MeshScale, Recipe, TunedMode, Up};
use crate::SpreadRule;
use std::path::Path;

const BELL: &str = r#"
name = "bell"
[keys]
low = 48
high = 84
[tuning]
by = "density"
mode = 5
[body]
shape = "mesh"
file = "bell.obj"
size_m = 0.2
wall_m = 0.004
[material]
name = "bell bronze"
"#;

fn parse(text: &str) -> Result<FreeRecipe, String> {
    FreeRecipe::parse(text, "bell.toml", Path::new("shapes")).map_err(|error| error.to_string())
}

#[test]
fn a_recipe_is_read_with_what_it_leaves_out() {
    let recipe = parse(BELL).unwrap();
    assert_eq!(recipe.title, "bell");
    let [piece] = &recipe.pieces[..] else {
        panic!("{recipe:?}");
    };
    assert_eq!(piece.shape.file, Path::new("shapes/bell.obj"));
    assert_eq!(piece.shape.wall_m, Some(0.004));
    assert_eq!(piece.shape.scale, MeshScale::Longest(0.2));
    assert_eq!((piece.shape.up, recipe.a4_hz), (Up::Z, 440.0));
    assert!(piece.shape.objects.is_empty());
    assert_eq!(piece.tuning.rule, SpreadRule::Density);
    assert_eq!(piece.tuning.mode, TunedMode::Number(5));
    assert_eq!(piece.fineness, FreeFineness::default());
    assert!(piece.damping.rayleigh.alpha1_s > 0.0);
    assert!(FreeRecipe::is_meant(BELL));
    assert!(
        !Recipe::FACTORY
            .iter()
            .any(|(_, text)| FreeRecipe::is_meant(text))
    );
}

#[test]
fn what_is_out_of_range_is_named_with_what_is_allowed() {
    for (from, to, told) in [
        (
            "\"density\"",
            "\"weight\"",
            "tuning.by is \"weight\", but must be \"size\", ",
        ),
        (
            "mode = 5",
            "mode = 0",
            "tuning.mode is 0, but must be \"lowest\", \"loudest\" or a ",
        ),
        (
            "mode = 5",
            "mode = \"best\"",
            "tuning.mode is \"best\", but must be ",
        ),
        (
            "\"mesh\"",
            "\"tube\"",
            "body.shape is \"tube\", but must be \"mesh\"",
        ),
        (
            "file = \"bell.obj\"",
            "",
            "body.file is left out, but must be given",
        ),
        (
            "size_m = 0.2",
            "size_m = 200.0",
            "body.size_m is 200, but must be 0.001 to 10",
        ),
        (
            "size_m = 0.2",
            "size_m = 0.2\nunit_m = 0.001",
            "body.unit_m is 0.001, but must be left out where body.size_m tells the size",
        ),
        (
            "size_m = 0.2",
            "unit_m = 0.0",
            "body.unit_m is 0, but must be 0.000001 to 1000",
        ),
        (
            "size_m = 0.2",
            "up = \"north\"",
            "body.up is \"north\", but must be \"x\", \"y\" or \"z\"",
        ),
        (
            "size_m = 0.2",
            "object = \"a\"\nobjects = [\"b\"]",
            "body.objects is given, but must be left out where body.object names one",
        ),
        (
            "size_m = 0.2",
            "objects = []",
            "body.objects is empty, but must be left out for all objects, or a list",
        ),
        (
            "shape = \"mesh\"",
            "",
            "body.shape is left out, but must be given",
        ),
        (
            "[keys]\nlow = 48\nhigh = 84",
            "",
            "keys is left out, but must be given",
        ),
        (
            "wall_m = 0.004",
            "wall_m = 0.0",
            "body.wall_m is 0, but must be 0.0002 to 1",
        ),
        (
            "high = 84",
            "high = 12",
            "keys.high is 12, but must be no less than keys.low = 48",
        ),
        (
            "\"bell bronze\"",
            "\"bronze\"",
            "material.name is \"bronze\", but must be a known one",
        ),
        (
            "[material]",
            "[mesh]\nnodes = 7\n[material]",
            "mesh.nodes is 7, but must be a whole ",
        ),
        (
            "[keys]",
            "colour = 3\n[keys]",
            "bell.toml:3:1: unknown field",
        ),
    ] {
        let text = BELL.replace(from, to);
        assert_ne!(text, BELL);
        let error = parse(&text).unwrap_err();
        assert!(error.contains(told), "{error}");
        assert!(
            error.starts_with("bell.toml") && !error.contains('\n'),
            "{error}"
        );
    }
}
