//! Recipes of several meshes.

use super::{FreeRecipe, KeyRange, MeshOrder, MeshScale, PieceOrder, Recipe, TunedMode, Up};
use crate::{Material, SpreadRule};
use std::path::Path;

/// Three pieces, the highest first, that share a file, a unit, a material and a way of tuning.
const KIT: &str = r#"
name = "kit"
[tuning]
a4_hz = 442.0
by = "stiffness"
[body]
file = "kit.obj"
unit_m = 0.001
up = "y"
[material]
name = "bell bronze"
[damping]
alpha1_s = 3e-8
alpha2_per_s = 1.0
support_kg_s = 0.02
[mesh]
nodes = 3000
[[piece]]
keys = { low = 60, high = 72 }
tuning = { by = "nothing", mode = 2 }
body = { file = "cup.obj", size_m = 0.1, wall_m = 0.003, up = "z" }
material = { name = "glass" }
[[piece]]
keys = { low = 36, high = 36 }
body = { object = "kick" }
[[piece]]
keys = { low = 37, high = 48 }
body = { objects = ["shell", "rim"] }
damping = { alpha1_s = 1e-7, alpha2_per_s = 2.0 }
mesh = { most_modes = 50 }
"#;

fn parse(text: &str) -> Result<FreeRecipe, String> {
    FreeRecipe::parse(text, "kit.toml", Path::new("shapes")).map_err(|error| error.to_string())
}

#[test]
fn what_a_piece_leaves_out_is_as_outside_the_pieces() {
    assert!(FreeRecipe::is_meant(KIT));
    let recipe = parse(KIT).unwrap();
    assert_eq!(recipe.a4_hz, 442.0);
    let [kick, drum, cup] = &recipe.pieces[..] else {
        panic!("{recipe:?}");
    };
    assert_eq!(kick.keys, KeyRange { low: 36, high: 36 });
    assert_eq!(drum.keys, KeyRange { low: 37, high: 48 });
    assert_eq!(cup.keys, KeyRange { low: 60, high: 72 });
    for piece in [kick, drum] {
        assert_eq!(piece.shape.file, Path::new("shapes/kit.obj"));
        assert_eq!(piece.shape.scale, MeshScale::Unit(0.001));
        assert_eq!(piece.shape.up, Up::Y);
        assert_eq!(piece.tuning.rule, SpreadRule::Stiffness);
        assert_eq!(piece.tuning.mode, TunedMode::Lowest);
        assert_eq!(piece.material, Material::named("bell bronze").unwrap());
    }
    assert_eq!(kick.shape.objects, ["kick"]);
    assert_eq!(drum.shape.objects, ["shell", "rim"]);
    assert_eq!(kick.damping.rayleigh.alpha2_per_s, 1.0);
    assert_eq!(kick.losses.support_kg_s, 0.02);
    assert_eq!(drum.damping.rayleigh.alpha2_per_s, 2.0);
    assert_eq!([kick, drum, cup].map(|p| p.fineness.nodes), [3000; 3]);
    let most = [kick, drum, cup].map(|p| p.fineness.most_modes);
    assert_eq!(most, [200, 50, 200]);
    assert_eq!(cup.shape.file, Path::new("shapes/cup.obj"));
    assert!(cup.shape.objects.is_empty());
    assert_eq!(cup.shape.scale, MeshScale::Longest(0.1));
    assert_eq!((cup.shape.up, cup.shape.wall_m), (Up::Z, Some(0.003)));
    assert_eq!(cup.tuning.rule, SpreadRule::Fixed);
    assert_eq!(cup.tuning.mode, TunedMode::Number(2));
    // Of another material is of that one's damping.
    let glass = crate::NamedMaterial::find("glass").unwrap();
    assert_eq!(cup.damping.rayleigh, glass.damping);
    assert_eq!(cup.losses.support_kg_s, 0.0);
}

#[test]
fn what_is_wrong_with_a_piece_is_named_with_its_number() {
    for (from, to, told) in [
        (
            "{ low = 37, high = 48 }",
            "{ low = 36, high = 48 }",
            "piece 3: keys.low is 36, but must be above 36, the highest key of piece 2: no two pieces ",
        ),
        (
            "{ low = 37, high = 48 }",
            "{ low = 37, high = 61 }",
            "piece 1: keys.low is 60, but must be above 61, the highest key of piece 3: no two ",
        ),
        (
            "high = 72",
            "high = 12",
            "piece 1: keys.high is 12, but must be no less than keys.low = 60",
        ),
        (
            "wall_m = 0.003",
            "wall_m = 9.0",
            "piece 1: body.wall_m is 9, but must be 0.0002 to 1",
        ),
        (
            "\"glass\"",
            "\"glas\"",
            "piece 1: material.name is \"glas\", but must be a known one",
        ),
        (
            "file = \"kit.obj\"",
            "",
            "piece 2: body.file is left out, but must be given",
        ),
        (
            "[material]\nname = \"bell bronze\"",
            "",
            "piece 2: material is left out, but must be given",
        ),
        (
            "name = \"kit\"",
            "name = \"kit\"\nkeys = { low = 1, high = 2 }",
            "kit.toml: keys is given, but must be left out beside pieces: each has its own",
        ),
        ("keys = { low = 36, high = 36 }", "", "missing field `keys`"),
        (
            "mode = 2",
            "modus = 2",
            "kit.toml:20:28: unknown field `modus`",
        ),
    ] {
        let text = KIT.replacen(from, to, 1);
        assert_ne!(text, KIT);
        let error = parse(&text).unwrap_err();
        assert!(error.contains(told), "{error}");
        assert!(
            error.starts_with("kit.toml") && !error.contains('\n'),
            "{error}"
        );
    }
}

#[test]
fn an_order_of_several_is_a_recipe_of_pieces() {
    let piece = |keys: [u8; 2]| PieceOrder {
        file: "shapes/My \"Kit\".obj".into(),
        objects: vec!["kick \"A\"".into(), "rim".into()],
        material: "bronze".into(),
        unit_m: Some(0.01),
        up: Up::X,
        keys,
        by: "density".into(),
        tuned: "3".into(),
        ..PieceOrder::default()
    };
    let order = MeshOrder {
        title: Some("Café".into()),
        pieces: vec![piece([40, 50]), piece([20, 39])],
        nodes: 700,
        most_modes: 20,
    };
    let recipe = order.recipe("the kit").unwrap();
    assert_eq!(
        (recipe.name.as_str(), recipe.title.as_str()),
        ("caf-", "Café")
    );
    let keys: Vec<u8> = recipe.pieces.iter().map(|piece| piece.keys.low).collect();
    assert_eq!(keys, [20, 40]);
    for piece in &recipe.pieces {
        assert_eq!(piece.shape.file, Path::new("shapes/My \"Kit\".obj"));
        assert_eq!(piece.shape.objects, ["kick \"A\"", "rim"]);
        assert_eq!(piece.shape.scale, MeshScale::Unit(0.01));
        assert_eq!(piece.shape.up, Up::X);
        assert_eq!(piece.tuning.rule, SpreadRule::Density);
        assert_eq!(piece.tuning.mode, TunedMode::Number(3));
        assert_eq!(piece.fineness.nodes, 700);
    }
    let clash = MeshOrder {
        pieces: vec![piece([40, 50]), piece([50, 60])],
        ..order
    };
    let error = clash.recipe("the kit").unwrap_err().to_string();
    assert!(
        error.starts_with("the kit: piece 2: keys.low is 50"),
        "{error}"
    );
}

#[test]
fn factory_recipes_are_no_kits() {
    let meant = |(_, text): &(&str, &str)| FreeRecipe::is_meant(text);
    assert!(!Recipe::FACTORY.iter().any(meant));
}
