//! What the commands say to bad input: one line, what is wrong, what is allowed, nothing written.

#![expect(clippy::unwrap_used, reason = "tests fail by panicking")]

use std::path::Path;
use std::process::Command;

/// What `cargo xtask` writes to standard error, having failed.
fn complaint(arguments: &[&str]) -> String {
    let output = Command::new(env!("CARGO_BIN_EXE_xtask"))
        .args(arguments)
        .output()
        .unwrap();
    let text = String::from_utf8(output.stderr).unwrap();
    assert!(!output.status.success(), "{arguments:?}: {text}");
    assert_eq!(text.trim_end().lines().count(), 1, "{text}");
    text
}

fn assert_says(arguments: &[&str], parts: &[&str]) {
    let text = complaint(arguments);
    for part in parts {
        assert!(text.contains(part), "{arguments:?}: {text}");
    }
}

fn song() -> String {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).parent().unwrap();
    root.join("songs/chimes.mid").to_str().unwrap().to_owned()
}

#[test]
fn render_refuses_numbers_out_of_range() {
    let dir = tempfile::tempdir().unwrap();
    let out = dir.path().join("out.wav");
    let (song, path) = (song(), out.to_str().unwrap());
    let cases = [
        (["--rate", "0"], "8000…384000 Hz"),
        (["--rate", "1000000"], "8000…384000 Hz"),
        (["--block", "0"], "1…65536 frames"),
        (["--tail", "-1"], "0…600 s"),
        (["--tail", "NaN"], "0…600 s"),
    ];
    for (option, allowed) in cases {
        assert_says(
            &["render", &song, path, option[0], option[1]],
            &[option[0], option[1], allowed],
        );
    }
    assert_says(
        &["render", &song, path, "--rate", "fast"],
        &["--rate", "fast"],
    );
    assert_eq!(std::fs::read_dir(dir.path()).unwrap().count(), 0);
}

#[test]
fn render_refuses_what_is_no_song() {
    let dir = tempfile::tempdir().unwrap();
    let fake = dir.path().join("fake.mid");
    std::fs::write(&fake, "RIFF").unwrap();
    let fake = fake.to_str().unwrap();
    let out = dir.path().join("out.wav");
    let out = out.to_str().unwrap();
    assert_says(&["render", fake, out], &["fake.mid", "not a MIDI file"]);
    assert_says(
        &["render", "missing.mid", out],
        &["missing.mid", "cannot read"],
    );
    assert_eq!(std::fs::read_dir(dir.path()).unwrap().count(), 1);
}

#[test]
fn render_refuses_a_place_it_cannot_write() {
    let dir = tempfile::tempdir().unwrap();
    let out = dir.path().join("missing/out.wav");
    let out = out.to_str().unwrap();
    assert_says(
        &["render", &song(), out],
        &["missing/out.wav", "cannot write"],
    );
    let folder = dir.path().to_str().unwrap();
    assert_says(&["render", &song(), folder], &["is a directory"]);
}

#[test]
fn render_refuses_what_is_no_plug_in() {
    let dir = tempfile::tempdir().unwrap();
    let out = dir.path().join("out.wav");
    let out = out.to_str().unwrap();
    let song = song();
    assert_says(
        &["render", &song, out, "--plugin", &song],
        &["chimes.mid", "not a CLAP plug-in"],
    );
    assert_eq!(std::fs::read_dir(dir.path()).unwrap().count(), 0);
}

#[test]
fn banks_and_recipes_are_named_when_they_are_wrong() {
    assert_says(&["bank", "gong"], &["gong", "allowed", "chimes"]);
    assert_says(&["precompute", "gong"], &["gong", "allowed", "chimes"]);
    assert_says(
        &["export", "gong", "--key", "74", "."],
        &["gong", "allowed"],
    );
    assert_says(&["bank", "chimes", "--key", "900"], &["--key", "900"]);
    let dir = tempfile::tempdir().unwrap();
    let recipe = dir.path().join("thin.toml");
    let text = include_str!("../../recipes/chimes.toml");
    let line = "wall_m = 0.001";
    assert!(text.contains(line));
    std::fs::write(&recipe, text.replace(line, "wall_m = -0.001")).unwrap();
    assert_says(
        &["precompute", recipe.to_str().unwrap()],
        &["thin.toml", "wall_m", "-0.001"],
    );
}

#[test]
fn instruments_are_listed_to_who_asks_for_another() {
    let all = ["chimes", "vibraphone", "tubular-bells", "oak-bowls"];
    assert_says(&["demo", "gong"], &["`gong`", "allowed"]);
    assert_says(&["demo", "chimes", "gong"], &all);
    let dir = tempfile::tempdir().unwrap();
    let out = dir.path().join("out.png");
    let out = out.to_str().unwrap();
    assert_says(&["figure", "gong", out], &all);
    assert_says(
        &["figure", "chimes", out, "--key", "7"],
        &["--key 7", "36…96"],
    );
    assert_eq!(std::fs::read_dir(dir.path()).unwrap().count(), 0);
}

#[test]
fn spectrogram_refuses_what_is_no_sound() {
    let dir = tempfile::tempdir().unwrap();
    let out = dir.path().join("out.png");
    let out = out.to_str().unwrap();
    assert_says(&["spectrogram", &song(), out], &["chimes.mid"]);
    assert_says(&["spectrogram", "missing.wav", out], &["missing.wav"]);
    assert_eq!(std::fs::read_dir(dir.path()).unwrap().count(), 0);
}

#[test]
fn tuning_names_the_file_and_the_line() {
    let dir = tempfile::tempdir().unwrap();
    let write = |name: &str, content: &str| {
        let path = dir.path().join(name);
        std::fs::write(&path, content).unwrap();
        path.to_str().unwrap().to_owned()
    };
    let scl = write("good.scl", "! good.scl\nOctaves\n1\n2/1\n");
    let bad = write("bad.scl", "! bad.scl\nA slip\n2\n3/2\n5/0\n");
    let kbm = write("bad.kbm", "12\n0\n128\n");
    assert_says(&["tuning", &bad], &["bad.scl: line 5: \"5/0\"", "not be 0"]);
    assert_says(
        &["tuning", &scl, "--keyboard", &kbm],
        &["bad.kbm: line 3: \"128\"", "from 0 to 127"],
    );
    assert_says(&["tuning", "missing.scl"], &["missing.scl: cannot read"]);
    let out = dir.path().join("out.wav");
    let (song, path) = (song(), out.to_str().unwrap());
    assert_says(
        &["render", &song, path, "--scale", &bad],
        &["bad.scl: line 5", "not be 0"],
    );
    assert_says(
        &["render", &song, path, "--scale", &scl, "--keyboard", &kbm],
        &["bad.kbm: line 3", "from 0 to 127"],
    );
    assert!(!out.exists());
}

#[test]
fn precompute_refuses_meshes_that_are_none() {
    let dir = tempfile::tempdir().unwrap();
    let missing = dir.path().join("none.obj");
    let flat = dir.path().join("flat.obj");
    std::fs::write(&flat, "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n").unwrap();
    let out = dir.path().join("out.bank");
    let (missing, flat, path) = (
        missing.to_str().unwrap(),
        flat.to_str().unwrap(),
        out.to_str().unwrap(),
    );
    let mesh = ["precompute", "-o", path, "--mesh"];
    let with = |rest: &[&'static str]| [&mesh[..], &[flat], rest].concat();
    assert_says(
        &[&mesh[..], &[missing]].concat(),
        &["none.obj: cannot read"],
    );
    assert_says(&with(&[]), &["flat.obj: "]);
    assert_says(
        &with(&["--size", "-1"]),
        &["body.size_m is -1", "0.001 to 10"],
    );
    assert_says(&with(&["--by", "colour"]), &["\"colour\"", "\"stiffness\""]);
    assert_says(&with(&["--keys", "90", "20"]), &["keys.high is 20"]);
    assert!(!out.exists());
}
