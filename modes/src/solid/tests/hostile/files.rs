//! Texts of small meshes.

use crate::solid::Soup;
use std::fmt::Write;

/// Words that every list of notes has.
pub(super) const ANY: &str = "";

/// The eight corners of a cube about the origin, moved by `[x, y, z]`.
pub(super) fn corners([x, y, z]: [f64; 3], half: f64) -> String {
    (0..8).fold(String::new(), |mut text, c| {
        let side = |bit: i32| if c >> bit & 1 == 1 { half } else { -half };
        let _ = writeln!(text, "v {} {} {}", x + side(0), y + side(1), z + side(2));
        text
    })
}

/// Faces of a cube whose corners are counted from `first`, outward.
pub(super) fn faces(first: i64) -> Vec<[i64; 4]> {
    [
        [0, 2, 3, 1],
        [4, 5, 7, 6],
        [0, 1, 5, 4],
        [2, 6, 7, 3],
        [0, 4, 6, 2],
        [1, 3, 7, 5],
    ]
    .iter()
    .map(|face| face.map(|i| i + first))
    .collect()
}

pub(super) fn lines(faces: &[[i64; 4]]) -> String {
    faces.iter().fold(String::new(), |mut text, [a, b, c, d]| {
        let _ = writeln!(text, "f {a} {b} {c} {d}");
        text
    })
}

/// Triangles, so that single ones can be spoilt.
pub(super) fn thirds(faces: &[[i64; 4]]) -> Vec<String> {
    let cut = faces.iter().flat_map(|[a, b, c, d]| [[a, b, c], [a, c, d]]);
    cut.map(|[a, b, c]| format!("f {a} {b} {c}\n")).collect()
}

pub(super) fn cube() -> String {
    corners([0.0; 3], 0.5) + &lines(&faces(1))
}

/// Two cubes of edge 1, the second moved.
pub(super) fn two(by: [f64; 3]) -> String {
    corners([0.0; 3], 0.5) + &corners(by, 0.5) + &lines(&faces(1)) + &lines(&faces(9))
}

/// A cube of edge 1 in one of edge 2, faced by `turn`.
pub(super) fn nested(turn: impl Fn([i64; 4]) -> [i64; 4]) -> String {
    let inner: Vec<[i64; 4]> = faces(9).into_iter().map(turn).collect();
    corners([0.0; 3], 1.0) + &corners([0.0; 3], 0.5) + &lines(&faces(1)) + &lines(&inner)
}

pub(super) fn reversed([a, b, c, d]: [i64; 4]) -> [i64; 4] {
    [d, c, b, a]
}

pub(super) fn scaled(text: &str, by: f64) -> String {
    text.lines().fold(String::new(), |mut scaled, line| {
        let numbers: Vec<f64> = line.split(' ').skip(1).flat_map(str::parse).collect();
        let _ = match line.strip_prefix("v ") {
            Some(_) => {
                let [x, y, z] = [0, 1, 2].map(|i| numbers[i] * by);
                writeln!(scaled, "v {x:e} {y:e} {z:e}")
            }
            None => writeln!(scaled, "{line}"),
        };
        scaled
    })
}

/// The triangles of a soup, each with points of its own.
pub(super) fn apart(soup: &Soup) -> String {
    let corners = soup.triangles.iter().flatten();
    let mut text = corners.fold(String::new(), |mut text, &i| {
        let [x, y, z] = soup.points[i as usize];
        let _ = writeln!(text, "v {x} {y} {z}");
        text
    });
    for t in 0..soup.triangles.len() {
        let _ = writeln!(text, "f {} {} {}", 3 * t + 1, 3 * t + 2, 3 * t + 3);
    }
    text
}

/// A Möbius strip of 24 squares.
pub(super) fn moebius() -> String {
    let mut text = String::new();
    for k in 0..24 {
        let turn = std::f64::consts::TAU * f64::from(k) / 24.0;
        for side in [-0.3, 0.3] {
            let r = 1.0 + side * (0.5 * turn).cos();
            let z = side * (0.5 * turn).sin();
            let _ = writeln!(text, "v {} {} {z}", r * turn.cos(), r * turn.sin());
        }
    }
    for k in 0..23 {
        let a = 2 * k + 1;
        let _ = writeln!(text, "f {} {} {} {}", a, a + 1, a + 3, a + 2);
    }
    text + "f 47 48 1 2\n"
}

/// A disc of `n` corners and a height of 1, from two polygons and a band.
pub(super) fn disc(n: usize) -> String {
    let mut text = String::new();
    for z in [0.0, 1.0] {
        for k in 0..n {
            let turn = std::f64::consts::TAU * k as f64 / n as f64;
            let _ = writeln!(text, "v {} {} {z}", 0.5 * turn.cos(), 0.5 * turn.sin());
        }
    }
    let words = |face: Vec<usize>| {
        face.iter()
            .fold("f".to_owned(), |text, i| format!("{text} {i}"))
            + "\n"
    };
    text += &words((1..=n).rev().collect());
    text += &words((n + 1..=2 * n).collect());
    (0..n).fold(text, |text, k| {
        let next = (k + 1) % n;
        text + &words(vec![k + 1, next + 1, n + next + 1, n + k + 1])
    })
}

/// A bar whose ends are turned against each other by half a turn, so that its sides meet in the middle
/// and one half is inside out.
pub(super) fn eight() -> String {
    let ends = "v -0.5 -0.5 0\nv 0.5 -0.5 0\nv 0.5 0.5 0\nv -0.5 0.5 0\n\
                v -0.5 0.5 1\nv 0.5 0.5 1\nv 0.5 -0.5 1\nv -0.5 -0.5 1\n";
    ends.to_owned() + "f 4 3 2 1\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n"
}
