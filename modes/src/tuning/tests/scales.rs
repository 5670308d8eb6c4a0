//! Scales whose pitches are known in closed form, on the keys that no map moves.

use super::super::{KeyboardMap, Scale, Tuning};
use super::{assert_hz, scale};
use crate::equal_temperament_hz;

fn plain(notes: &[&str]) -> Tuning {
    Tuning::new(&scale(notes), &KeyboardMap::default())
}

#[test]
fn twelve_equal_steps_are_equal_temperament() {
    let notes: Vec<String> = (1..12)
        .map(|step| format!(" {step}00.00000"))
        .chain(["2/1".to_owned()])
        .collect();
    let notes: Vec<&str> = notes.iter().map(String::as_str).collect();
    let of_file = plain(&notes);
    let of_nothing = Tuning::load(None, None).unwrap();
    assert_eq!(of_nothing, Tuning::default());
    for key in 0..=127 {
        assert_hz(&of_file, key, equal_temperament_hz(key, 440.0));
        assert!(of_file.offset_semitones(key).unwrap().abs() < 1e-11);
        assert_eq!(Tuning::default().offset_semitones(key), Some(0.0));
    }
    assert_eq!(of_file.hz(128), None);
    assert_eq!(of_file.offset_semitones(255), None);
}

/// Fifths of 3/2 from E♭ to G♯.
#[test]
fn pythagorean() {
    let tuning = plain(&[
        "2187/2048",
        "9/8",
        "32/27",
        "81/64",
        "4/3",
        "729/512",
        "3/2",
        "6561/4096",
        "27/16",
        "16/9",
        "243/128",
        "2/1",
    ]);
    assert_hz(&tuning, 69, 440.0);
    assert_hz(&tuning, 60, 440.0 * 16.0 / 27.0);
    for key in 0..120 {
        let fifth = tuning.hz(key + 7).unwrap() / tuning.hz(key).unwrap();
        // The wolf, a Pythagorean comma narrow, lies on G♯.
        let wolf = 3.0_f64.powi(-11) * 2.0_f64.powi(18);
        let fifths = if key % 12 == 8 { wolf } else { 1.5 };
        assert!((fifth / fifths - 1.0).abs() < 1e-14, "{key}: {fifth}");
    }
}

/// Aaron 1523: four fifths make a third of 5/4 and two octaves. Cents to five digits, as such files
/// have them.
#[test]
fn quarter_comma_meantone() {
    let fifth_cents = 1200.0 * 5.0_f64.log2() / 4.0;
    // Fifths up from C to each of C♯, D, E♭, …, C.
    let fifths = [7, 2, -3, 4, -1, 6, 1, 8, 3, -2, 5, 0];
    let notes = fifths.map(|fifths| match fifths {
        4 => "5/4".to_owned(),
        0 => "2/1".to_owned(),
        _ => format!(
            "{:.5}",
            (f64::from(fifths) * fifth_cents).rem_euclid(1200.0)
        ),
    });
    assert_eq!(notes[0], "76.04900");
    assert_eq!(notes[6], "696.57843");
    let tuning = plain(&notes.each_ref().map(String::as_str));
    let interval = |low: u8, high: u8| tuning.hz(high).unwrap() / tuning.hz(low).unwrap();
    let cents = |low, high| 1200.0 * interval(low, high).log2();
    assert!((interval(60, 64) - 1.25).abs() < 1e-14);
    for low in [62, 63, 65, 67, 69, 70] {
        assert!((cents(low, low + 4) - 386.313_714).abs() < 1.1e-5, "{low}");
    }
    assert!((cents(68, 75) - 737.637).abs() < 5e-4);
    // C4, three fifths below A4, against the 900 cents of equal temperament.
    assert!((tuning.offset_semitones(60).unwrap() - 0.102_647_1).abs() < 1e-7);
}

#[test]
fn nineteen_steps_to_the_octave() {
    let notes: Vec<String> = (1..=19)
        .map(|step| format!("{:.10}", 1200.0 * f64::from(step) / 19.0))
        .collect();
    let notes: Vec<&str> = notes.iter().map(String::as_str).collect();
    let tuning = plain(&notes);
    for key in 0..=127 {
        let hz = 440.0 * ((f64::from(key) - 69.0) / 19.0).exp2();
        assert_hz(&tuning, key, hz);
        let semitones = (f64::from(key) - 69.0) * (12.0 / 19.0 - 1.0);
        assert!((tuning.offset_semitones(key).unwrap() - semitones).abs() < 1e-9);
    }
}

/// Bohlen 1978: thirteen steps to the twelfth, equal and just.
#[test]
fn bohlen_pierce_repeats_at_the_twelfth() {
    let step_cents = 1200.0 * 3.0_f64.log2() / 13.0;
    let notes: Vec<String> = (1..13)
        .map(|step| format!("{:.12}", step_cents * f64::from(step)))
        .chain(["3/1".to_owned()])
        .collect();
    let notes: Vec<&str> = notes.iter().map(String::as_str).collect();
    let equal = plain(&notes);
    for key in 0..=127 {
        let hz = 440.0 * 3.0_f64.powf((f64::from(key) - 69.0) / 13.0);
        assert_hz(&equal, key, hz);
    }
    let just = plain(&[
        "27/25", "25/21", "9/7", "7/5", "75/49", "5/3", "9/5", "49/25", "15/7", "7/3", "63/25",
        "25/9", "3/1",
    ]);
    let c4_hz = 440.0 * 7.0 / 15.0;
    assert_hz(&just, 60, c4_hz);
    assert_hz(&just, 66, c4_hz * 5.0 / 3.0);
    assert_hz(&just, 73 + 13 + 3, c4_hz * 9.0 * 9.0 / 7.0);
    assert_hz(&just, 60 - 1, c4_hz * 25.0 / 27.0);
}

#[test]
fn scales_may_fall_turn_and_stand_still() {
    let falling = plain(&["-100.0", "1/2"]);
    let c4_hz = falling.hz(60).unwrap();
    assert_hz(&falling, 61, c4_hz * (-1.0_f64 / 12.0).exp2());
    assert_hz(&falling, 62, c4_hz / 2.0);
    assert_hz(&falling, 58, c4_hz * 2.0);
    let turning = plain(&["3/2", "5/4", "2"]);
    assert_hz(&turning, 69, 440.0);
    assert_hz(&turning, 70, 660.0);
    assert_hz(&turning, 71, 550.0);
    let still = plain(&["0.0"]);
    assert_hz(&still, 0, 440.0);
    assert_hz(&still, 127, 440.0);
}

/// 67 periods of 30 octaves above A4 no number is left.
#[test]
fn keys_beyond_all_frequencies_are_silent() {
    let tuning = plain(&["1073741824"]);
    assert_hz(&tuning, 70, 440.0 * 1_073_741_824.0);
    assert_eq!(tuning.hz(127), None);
    assert_eq!(tuning.hz(0), None);
    assert_eq!(tuning.offset_semitones(127), None);
}

#[test]
fn any_editor_may_have_written_the_file() {
    let text = "! gamme.scl\n!\nGamme d'été: 2 ½\n 2\n!\n 3/2 quinte\n!\n 2/1\n! fin\n";
    let plain = Scale::parse(text.as_bytes()).unwrap();
    assert_eq!(plain.description(), "Gamme d'été: 2 ½");
    assert_eq!(plain.notes(), 2);
    let latin_1: Vec<u8> = text.chars().map(|c| u8::try_from(c).unwrap()).collect();
    let wide = |bytes: fn(u16) -> [u8; 2]| {
        let marked = "\u{feff}".encode_utf16().chain(text.encode_utf16());
        marked.flat_map(bytes).collect::<Vec<u8>>()
    };
    let files = [
        latin_1,
        text.replace('\n', "\r\n").into_bytes(),
        text.replace('\n', "\r").into_bytes(),
        format!("\u{feff}{text}").into_bytes(),
        text.trim_end_matches("! fin\n").trim_end().into(),
        text.replace(" 2\n", "\t2\t\n\n").into_bytes(),
        format!("{text}9/8\nand more\n").into_bytes(),
        wide(u16::to_le_bytes),
        wide(u16::to_be_bytes),
    ];
    for file in files {
        assert_eq!(Scale::parse(&file), Ok(plain.clone()));
    }
    let nameless = Scale::parse(b"\n1\n2/1").unwrap();
    assert_eq!(nameless.description(), "");
    assert_eq!(nameless.cents(-3), -3600.0);
}
