//! Meshes as people have them: each is repaired with a note or refused with a reason.

use super::*;
use crate::factory::Silent;
use std::fmt::Write;
use std::time::Duration;

/// What becomes of a mesh.
enum Fate {
    /// A solid of so many edge lengths cubed, and a note with these words.
    Solid(f64, &'static str),
    /// An error with these words.
    Refused(&'static str),
}
use Fate::{Refused, Solid};

/// Words that every list of notes has.
const ANY: &str = "";

/// The eight corners of a cube about the origin, moved by `[x, y, z]`.
fn corners([x, y, z]: [f64; 3], half: f64) -> String {
    (0..8).fold(String::new(), |mut text, c| {
        let side = |bit: i32| if c >> bit & 1 == 1 { half } else { -half };
        let _ = writeln!(text, "v {} {} {}", x + side(0), y + side(1), z + side(2));
        text
    })
}

/// Faces of a cube whose corners are counted from `first`, outward.
fn faces(first: i64) -> Vec<[i64; 4]> {
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

fn lines(faces: &[[i64; 4]]) -> String {
    faces.iter().fold(String::new(), |mut text, [a, b, c, d]| {
        let _ = writeln!(text, "f {a} {b} {c} {d}");
        text
    })
}

/// Triangles, so that single ones can be spoilt.
fn thirds(faces: &[[i64; 4]]) -> Vec<String> {
    let cut = faces.iter().flat_map(|[a, b, c, d]| [[a, b, c], [a, c, d]]);
    cut.map(|[a, b, c]| format!("f {a} {b} {c}\n")).collect()
}

fn cube() -> String {
    corners([0.0; 3], 0.5) + &lines(&faces(1))
}

/// Two cubes of edge 1, the second moved.
fn two(by: [f64; 3]) -> String {
    corners([0.0; 3], 0.5) + &corners(by, 0.5) + &lines(&faces(1)) + &lines(&faces(9))
}

/// A cube of edge 1 in one of edge 2, faced by `turn`.
fn nested(turn: impl Fn([i64; 4]) -> [i64; 4]) -> String {
    let inner: Vec<[i64; 4]> = faces(9).into_iter().map(turn).collect();
    corners([0.0; 3], 1.0) + &corners([0.0; 3], 0.5) + &lines(&faces(1)) + &lines(&inner)
}

fn reversed([a, b, c, d]: [i64; 4]) -> [i64; 4] {
    [d, c, b, a]
}

fn scaled(text: &str, by: f64) -> String {
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
fn apart(soup: &Soup) -> String {
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
fn moebius() -> String {
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

fn cases() -> Vec<(&'static str, Vec<u8>, Fate)> {
    let mut cases = texts(cube(), thirds(&faces(1)));
    cases.extend(broken());
    let text = |(name, text, fate): (&'static str, String, Fate)| (name, text.into_bytes(), fate);
    let mut cases: Vec<_> = cases.into_iter().map(text).collect();
    let mut latin = b"o Gl\xf6ckchen\n".to_vec();
    latin.extend(cube().into_bytes());
    cases.push(("a name in Latin 1", latin, Solid(1.0, "UTF-8")));
    cases.push((
        "bytes",
        (0..=255).cycle().take(9999).collect(),
        Refused("no faces"),
    ));
    let mut ended = cube().into_bytes();
    ended.extend([0; 64]);
    cases.push(("zeros at the end", ended, Solid(1.0, ANY)));
    cases
}

/// Solids with something wrong, and things that are no solid.
fn texts(cube: String, thirds: Vec<String>) -> Vec<(&'static str, String, Fate)> {
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

/// Files that are no mesh.
fn broken() -> Vec<(&'static str, String, Fate)> {
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

/// A disc of `n` corners and a height of 1, from two polygons and a band.
fn disc(n: usize) -> String {
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
fn eight() -> String {
    let ends = "v -0.5 -0.5 0\nv 0.5 -0.5 0\nv 0.5 0.5 0\nv -0.5 0.5 0\n\
                v -0.5 0.5 1\nv 0.5 0.5 1\nv 0.5 -0.5 1\nv -0.5 -0.5 1\n";
    ends.to_owned() + "f 4 3 2 1\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n"
}

/// Volume in edge lengths of the file cubed, and the notes.
fn fate(content: &[u8]) -> Result<(f64, String), String> {
    let here = std::env::temp_dir();
    let file = parse_obj(content, "a.obj", Some(&here)).map_err(|error| error.to_string())?;
    let how = Repair {
        size_m: Some(0.1),
        ..Repair::default()
    };
    let surface = repair(&file.soup, &how).map_err(|error| error.to_string())?;
    let meshed =
        mesh_solid(&surface, &super::nodes(2_000), &Silent).map_err(|error| error.to_string())?;
    let kept: Vec<[f64; 3]> = file
        .soup
        .triangles
        .iter()
        .flatten()
        .map(|&i| file.soup.points[i as usize])
        .collect();
    let (low, high) = vector::bounds(kept);
    let longest = (0..3).map(|a| high[a] - low[a]).fold(0.0, f64::max);
    let notes: Vec<String> = file
        .notes
        .iter()
        .chain(&meshed.notes)
        .map(Note::to_string)
        .collect();
    let volume = meshed.quality.volume_m3 / 1e-3 * longest.powi(3);
    assert!(
        meshed.quality.min_dihedral_deg > 5.0,
        "{:?}",
        meshed.quality
    );
    Ok((volume, notes.join("; ")))
}

#[test]
fn each_is_repaired_or_refused() {
    let cases = cases();
    assert!(cases.len() >= 50, "{}", cases.len());
    let mut wrong = Vec::new();
    for (name, content, expected) in cases {
        let start = Instant::now();
        let found = fate(&content);
        let right = match (&expected, &found) {
            (Solid(volume, words), Ok((found, notes))) => {
                let unit = match name {
                    "in kilometres" => 1e9,
                    "in nanometres" => 1e-27,
                    _ => 1.0,
                };
                (found / (volume * unit) - 1.0).abs() < 0.03 && notes.contains(words)
            }
            (Refused(words), Err(error)) => error.contains(words),
            _ => false,
        };
        if !right || start.elapsed() > Duration::from_secs(20) {
            wrong.push(format!("{name}: {found:?} in {:?}", start.elapsed()));
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

/// A generator of Marsaglia 2003, for bytes that no one would write.
struct Random(u64);

impl Random {
    fn below(&mut self, most: usize) -> usize {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        (self.0 % most as u64) as usize
    }
}

/// A cube's file with pieces swapped, doubled, cut out or replaced by words that may mean something.
fn spoilt(random: &mut Random) -> Vec<u8> {
    const WORDS: [&str; 14] = [
        "v", "f", "o", "-1", "0", "9", "1e308", "-0.0", "nan", "\n", "\\\n", "1//", "/", "\u{fe}",
    ];
    let cube = cube();
    let mut words: Vec<&str> = cube.split_inclusive([' ', '\n']).collect();
    for _ in 0..1 + random.below(6) {
        let at = random.below(words.len());
        match random.below(4) {
            0 => words[at] = WORDS[random.below(WORDS.len())],
            1 => words.insert(at, WORDS[random.below(WORDS.len())]),
            2 => drop(words.remove(at)),
            _ => words.swap(at, 0),
        }
    }
    let mut bytes = words.concat().into_bytes();
    if random.below(4) == 0 {
        let at = random.below(bytes.len());
        bytes[at] = random.below(256) as u8;
    }
    bytes
}

#[test]
fn no_bytes_make_it_panic() {
    let mut random = Random(0x9e37_79b9_7f4a_7c15);
    let mut read = 0;
    for _ in 0..4_000 {
        let bytes = spoilt(&mut random);
        if let Ok(file) = parse_obj(&bytes, "a.obj", None) {
            read += usize::from(repair(&file.soup, &Repair::default()).is_ok());
        }
    }
    // Some are still solids, or nothing behind the reader was tried.
    assert!(read > 100, "{read}");
}

/// Triangles between points of a coarse grid: everything coincides, crosses and lies double.
#[test]
fn no_triangles_make_it_panic() {
    let mut random = Random(0x2545_f491_4f6c_dd1d);
    let mut solids = 0;
    let how = Meshing {
        most_nodes: 4_000,
        ..super::nodes(300)
    };
    for _ in 0..300 {
        let points = (0..4 + random.below(12)).map(|_| [0; 3].map(|_| random.below(4) as f64));
        let points: Vec<[f64; 3]> = points.collect();
        let count = 4 + random.below(40);
        let triangles = (0..count).map(|_| [0; 3].map(|_| random.below(points.len()) as u32));
        let soup = Soup::single(points.clone(), triangles.collect());
        if let Ok(surface) = repair(&soup, &Repair::default()) {
            solids += usize::from(mesh_solid(&surface, &how, &Silent).is_ok());
        }
    }
    assert!(solids > 20, "{solids}");
}
