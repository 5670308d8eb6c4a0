//! Solids with something wrong, and things that are no solid.

use super::files::*;
use super::{Case, Refused, Solid};
use crate::solid::{gallery, write_obj};

/// Solids with something wrong, and things that are no solid.
pub(super) fn texts(cube: String, thirds: Vec<String>) -> Vec<Case> {
    let points = corners([0.0; 3], 0.5);
    let with = |faces: &[String]| points.clone() + &faces.concat();
    let ball = gallery::sphere(0.5, 3);
    let without = |gone: &[usize]| {
        let mut ball = ball.clone();
        let mut at = 0..;
        ball.triangles
            .retain(|_| !gone.contains(&at.next().unwrap()));
        ball.objects[0].triangles = 0..ball.triangles.len();
        write_obj(&ball)
    };
    let sphere = 0.519;
    let mut flipped = thirds.clone();
    flipped[3] = "f 6 8 5\n".replace("6 8 5", "7 8 5");
    let inside_out: Vec<[i64; 4]> = faces(1).into_iter().map(reversed).collect();
    let twice = [&thirds[..], &thirds[4..6]].concat();
    let back: Vec<[i64; 4]> = [faces(1), inside_out.clone()].concat();
    let sliver = [&thirds[..], &["f 1 1 2\n".into(), "f 3 3 3\n".into()]].concat();
    vec![
        ("a cube", cube.clone(), Solid(1.0, "polygons")),
        ("triangles", with(&thirds), Solid(1.0, ANY)),
        (
            "inside out",
            points.clone() + &lines(&inside_out),
            Solid(1.0, "inside out"),
        ),
        ("one face turned", with(&flipped), Solid(1.0, "agree")),
        ("faces twice", with(&twice), Solid(1.0, "lie on another")),
        (
            "two-sided",
            points.clone() + &lines(&back),
            Solid(1.0, "lie on another"),
        ),
        ("zero area", with(&sliver), Solid(1.0, "without area")),
        ("points apart", apart(&ball), Solid(sphere, "joined")),
        (
            "a small hole",
            without(&[7]),
            Solid(sphere, "closed a hole of 3 edges"),
        ),
        (
            "three holes",
            without(&[7, 100, 200]),
            Solid(sphere, "closed a hole"),
        ),
        (
            "a face gone",
            points.clone() + &lines(&faces(1)[1..]),
            Solid(1.0, "hole of 4 edges"),
        ),
        (
            "a triangle gone",
            with(&thirds[1..]),
            Solid(1.0, "hole of 3 edges"),
        ),
        (
            "half open",
            points.clone() + &lines(&faces(1)[2..5]),
            Refused("open"),
        ),
        (
            "one triangle",
            "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n".into(),
            Refused("at least four"),
        ),
        (
            "a sheet",
            "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 2 0 0\nv 2 1 0\nf 1 2 3 4\nf 2 5 6 3\n".into(),
            Refused("open"),
        ),
        (
            "a sheet twice",
            "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\nf 1 2 4\nf 2 3 4\n".into(),
            Refused(ANY),
        ),
        ("a strip with one side", moebius(), Refused("one side")),
        ("in kilometres", scaled(&cube, 1e3), Solid(1.0, ANY)),
        ("in nanometres", scaled(&cube, 1e-9), Solid(1.0, ANY)),
        (
            "far away",
            corners([1e6, -1e6, 0.0], 0.5) + &lines(&faces(1)),
            Solid(1.0, ANY),
        ),
        (
            "beyond all numbers",
            scaled(&cube, 1e200),
            Refused("no point in space"),
        ),
        ("two bodies", two([3.0, 0.0, 0.0]), Solid(1.0, "left out 1")),
        (
            "two bodies that overlap",
            two([0.5, 0.25, 0.0]),
            Solid(1.625, "goes through itself"),
        ),
        (
            "two bodies face to face",
            two([1.0, 0.0, 0.0]),
            Solid(2.0, "more than two faces"),
        ),
        (
            "two bodies at an edge",
            two([1.0, 1.0, 0.0]),
            Solid(1.0, "left out 1"),
        ),
        (
            "two bodies at a corner",
            two([1.0, 1.0, 1.0]),
            Solid(1.0, "left out 1"),
        ),
        (
            "the same body twice",
            two([0.0; 3]),
            Solid(1.0, "lie on another"),
        ),
        ("a hollow", nested(reversed), Solid(7.0, "1 closed hollows")),
        ("a body in a body", nested(|face| face), Solid(8.0, ANY)),
        ("a figure of eight", eight(), Solid(0.25, "left out 1")),
        (
            "a speck beside",
            cube.clone() + &scaled(&corners([9.0, 0.0, 0.0], 0.5), 1e-3) + &lines(&faces(9)),
            Solid(1.0, ANY),
        ),
        (
            "negative indices",
            points.clone() + &lines(&faces(-8)),
            Solid(1.0, ANY),
        ),
        (
            "no materials",
            "mtllib none.mtl\nusemtl red\n".to_owned() + &cube,
            Solid(1.0, "none.mtl"),
        ),
        (
            "a name in Greek",
            "o \u{39a}\u{3c9}\u{3b4}\u{3c9}\u{3bd}\n".to_owned() + &cube,
            Solid(1.0, ANY),
        ),
        (
            "groups and smoothing",
            "g a b\ns 1\n".to_owned() + &cube,
            Solid(1.0, ANY),
        ),
        (
            "line ends of old",
            cube.replace('\n', "\r\n"),
            Solid(1.0, ANY),
        ),
        (
            "lines go on",
            cube.replace("f 1 3", "f 1 \\\n3"),
            Solid(1.0, ANY),
        ),
        (
            "lines and points too",
            cube.clone() + "l 1 2\np 3\nf 1 2\n",
            Solid(1.0, "left out"),
        ),
        (
            "points unused",
            cube + "v 1e9 0 0\nv 0 -1e9 0\n",
            Solid(1.0, ANY),
        ),
        ("a disc of 300 corners", disc(300), Solid(0.785, "polygons")),
    ]
}
