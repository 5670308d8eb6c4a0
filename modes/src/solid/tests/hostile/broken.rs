//! Files that are no mesh.

use super::files::*;
use super::{Case, Refused, Solid};

/// Files that are no mesh.
pub(super) fn broken() -> Vec<Case> {
    let cube = cube();
    let huge: String = (0..2001)
        .map(|_| "f 1".to_owned() + &" 1 2".repeat(501) + "\n")
        .collect();
    vec![
        ("nothing", String::new(), Refused("no faces")),
        ("only points", corners([0.0; 3], 0.5), Refused("no faces")),
        (
            "not a number",
            cube.replacen("v -0.5", "v nan", 1),
            Refused(":1: \"nan\""),
        ),
        (
            "infinite",
            cube.replacen("v 0.5", "v inf", 1),
            Refused(":2: \"inf\""),
        ),
        (
            "a number too large",
            cube.replacen("v 0.5", "v 1e999", 1),
            Refused(":2: \"1e999\""),
        ),
        (
            "a word",
            cube.replacen("v 0.5", "v half", 1),
            Refused(":2: \"half\""),
        ),
        (
            "a point of two",
            cube.clone() + "v 1 2\n",
            Refused(":15: a point has three"),
        ),
        (
            "point 0",
            cube.clone() + "f 0 1 2\n",
            Refused(":15: a face uses point 0"),
        ),
        (
            "point 9",
            cube.clone() + "f 1 2 9\n",
            Refused(":15: a face uses point 9"),
        ),
        (
            "too far back",
            cube.clone() + "f -9 1 2\n",
            Refused(":15: a face uses point -9"),
        ),
        (
            "an index beyond",
            cube.clone() + "f 1 2 9223372036854775807\n",
            Refused(":15: a face uses"),
        ),
        (
            "a normal beyond",
            cube.replace("f 1 ", "f 1/9223372036854775807/9223372036854775807 "),
            Solid(1.0, ANY),
        ),
        (
            "more than an index",
            cube.clone() + "f 1 2 99999999999999999999\n",
            Refused("no corner"),
        ),
        (
            "corners in one line",
            "v 0 0 0\nv 1 0 0\nv 2 0 0\nf 1 2 3\n".into(),
            Refused("at least four"),
        ),
        (
            "corners in one point",
            "v 1 1 1\nf 1 1 1\nf 1 1 1 1\n".into(),
            Refused("at least four"),
        ),
        (
            "millions of triangles",
            "v 0 0 0\nv 1 0 0\n".to_owned() + &huge,
            Refused("2000000 are read"),
        ),
    ]
}
