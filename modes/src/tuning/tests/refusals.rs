//! Every fault is found, with its line, its text and what would be right.

use super::super::{KeyboardMap, ScalaError, Scale, Tuning};
use super::map_text;
use std::path::Path;

fn assert_refused<T>(read: Result<T, ScalaError>, message: &str) {
    let error = read.err().map(|error| error.to_string());
    assert_eq!(error.as_deref(), Some(message));
}

#[test]
fn a_scale_says_what_is_wrong_with_it() {
    let refused =
        |text: &str, message: &str| assert_refused(Scale::parse(text.as_bytes()), message);
    refused(
        "! a.scl\n!\nA scale\n 3\n!\n 9/8\n 5/0 a slip\n 2/1\n",
        "line 7: \"5/0 a slip\": a ratio's lower number must not be 0",
    );
    let count = "the number of notes must be a whole number from 1 on, such as 12; if there is no \
                 description, put an empty line before it";
    refused(
        "A scale\r\n100.0\r\n2/1",
        &format!("line 2: \"100.0\": {count}"),
    );
    refused("A scale\n-1\n2/1", &format!("line 2: \"-1\": {count}"));
    refused("A scale\n0\n", &format!("line 2: \"0\": {count}"));
    refused(
        "A scale\n99999999999\n",
        &format!("line 2: \"99999999999\": {count}"),
    );
    refused(
        "A scale\r3\r9/8\r5/4\r",
        "line 4: the file ends here, but pitch 3 of 3 must follow",
    );
    refused(
        "A scale\n4294967295\n2/1",
        "line 3: the file ends here, but pitch 2 of 4294967295 must follow",
    );
    refused(
        "A scale\n!",
        "line 2: the file ends here, but the number of notes must follow",
    );
    refused(
        "",
        "line 1: the file ends here, but a description or an empty line must follow",
    );
}

#[test]
fn what_is_quoted_fits_a_line() {
    let text = format!("A scale\n1\n\u{1b}[31m{}\n", "é".repeat(5000));
    let error = Scale::parse(text.as_bytes()).unwrap_err();
    let ScalaError::Line { line, found, .. } = &error else {
        panic!("{error}");
    };
    assert_eq!((*line, found.chars().count()), (3, 41));
    assert!(!error.to_string().contains(char::is_control));
}

#[test]
fn a_keyboard_map_says_what_is_wrong_with_it() {
    const GOOD: [&str; 7] = ["12", "0", "127", "60", "69", "440.0", "12"];
    let refused = |place: usize, value: &str, message: &str| {
        let mut head = GOOD;
        head[place] = value;
        let text = map_text(head, "0 1 2 3 4 5 6 7 8 9 10 11");
        let message = format!("line {}: \"{value}\": {message}", place + 3);
        assert_refused(KeyboardMap::parse(text.as_bytes()), &message);
    };
    let size = "the size of the map must be a whole number from 0 to 1000000";
    refused(0, "-1", size);
    refused(0, "twelve", size);
    refused(0, "12.0", size);
    refused(
        1,
        "-1",
        "the first key must be a whole number from 0 to 127",
    );
    refused(
        2,
        "128",
        "the last key must be a whole number from 0 to 127",
    );
    refused(
        3,
        "C4",
        "the middle key must be a whole number from 0 to 127",
    );
    refused(
        4,
        "440.0",
        "the reference key must be a whole number from 0 to 127",
    );
    let hz = "the reference frequency must be in Hz and above 0, such as 440.0";
    for value in ["0", "-440", "440,0", "NaN", "inf", "1e999", "A4"] {
        refused(5, value, hz);
    }
    let octave = "the degree of the formal octave must be a whole number from -1000000 to 1000000";
    refused(6, "2/1", octave);
    let text = map_text(GOOD, "0 1 2 three");
    assert_refused(
        KeyboardMap::parse(text.as_bytes()),
        "line 14: \"three\": an entry must be a degree such as 5, or x for a silent key",
    );
    let text = map_text(["0", "60", "59", "60", "69", "440", "0"], "");
    assert_refused(
        KeyboardMap::parse(text.as_bytes()),
        "line 5: \"59\": the last key must not lie below the first, which is 60",
    );
    let order = [
        "size of the map",
        "first key",
        "last key",
        "middle key",
        "reference key",
        "reference frequency",
        "degree of the formal octave",
    ];
    for (lines, missing) in order.into_iter().enumerate() {
        assert_refused(
            KeyboardMap::parse(GOOD[..lines].join("\n").as_bytes()),
            &format!(
                "line {}: the file ends here, but the {missing} must follow",
                lines.max(1)
            ),
        );
    }
}

/// The description of the format calls it an error, too.
#[test]
fn the_reference_key_must_have_a_degree() {
    let message = "line 7: \"69\": the reference key must have a degree, but its entry is x or \
                   missing; map it, or choose another key";
    let head = ["12", "0", "127", "60", "69", "440.0", "12"];
    for entries in ["0 1 2 3 4 5 6 7 8 x 10 11", "0 1 2 3 4 5 6 7 8", ""] {
        let text = map_text(head, entries);
        assert_refused(KeyboardMap::parse(text.as_bytes()), message);
    }
}

#[test]
fn the_file_is_named() {
    let folder = std::env::temp_dir().join(format!("idiophone-tuning-{}", std::process::id()));
    std::fs::create_dir_all(&folder).unwrap();
    let write = |name: &str, content: &[u8]| {
        let path = folder.join(name);
        std::fs::write(&path, content).unwrap();
        path
    };
    let scl = write("good.scl", b"Octaves\n1\n2/1\n");
    let kbm = write("good.kbm", b"0\n0\n127\n60\n60\n100.0\n0\n");
    let bad = write("bad", b"Octaves\n1\n2/0\n");
    let long = write("long", &vec![b'\n'; (1 << 20) + 1]);
    let says = |scl: Option<&Path>, kbm: Option<&Path>, words: [&str; 2]| {
        let text = Tuning::load(scl, kbm).unwrap_err().to_string();
        assert!(words.iter().all(|word| text.contains(word)), "{text}");
    };
    let tuning = Tuning::load(Some(&scl), Some(&kbm)).unwrap();
    assert_eq!(tuning.hz(61), Some(200.0));
    assert_eq!(Tuning::load(Some(&scl), None).unwrap().hz(70), Some(880.0));
    says(Some(&bad), Some(&kbm), ["bad: line 3", "must not be 0"]);
    says(Some(&scl), Some(&bad), ["bad: line 1", "size of the map"]);
    says(Some(&long), None, ["long: cannot read", "1 MiB"]);
    let gone = folder.join("gone.scl");
    says(Some(&gone), None, ["gone.scl: cannot read", "os error"]);
    says(Some(&folder), None, ["idiophone-tuning", "cannot read"]);
    std::fs::remove_dir_all(&folder).unwrap();
}
