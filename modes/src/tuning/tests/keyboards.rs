//! Keyboard maps whose pitches are known in closed form.

use super::super::{KeyboardMap, Scale, Tuning};
use super::{assert_hz, map, scale};

const TEMPLATE: [&str; 7] = ["12", "0", "127", "60", "69", "440.0", "12"];
const MAJOR: [&str; 7] = ["9/8", "5/4", "4/3", "3/2", "5/3", "15/8", "2/1"];

fn silent(tuning: &Tuning) -> Vec<u8> {
    (0..128).filter(|key| tuning.hz(*key).is_none()).collect()
}

#[test]
fn the_map_that_changes_nothing() {
    let written = map(TEMPLATE, "0 1 2 3 4 5 6 7 8 9 10 11");
    for scale in [Scale::default(), scale(&["3/2"; 12])] {
        let linear = Tuning::new(&scale, &KeyboardMap::default());
        let mapped = Tuning::new(&scale, &written);
        for key in 0..128 {
            assert_hz(&mapped, key, linear.hz(key).unwrap());
        }
    }
}

/// Degrees on the white keys, nothing on the black ones: the map repeats every 12 keys, the scale
/// every 7 degrees.
#[test]
fn white_keys_alone() {
    let head = ["12", "0", "127", "60", "69", "440", "7"];
    let tuning = Tuning::new(&scale(&MAJOR), &map(head, "0 x 1 x 2 3 X 4 x 5 x 6"));
    assert_hz(&tuning, 60, 264.0);
    assert_hz(&tuning, 71, 264.0 * 15.0 / 8.0);
    assert_hz(&tuning, 72, 528.0);
    assert_hz(&tuning, 77, 528.0 * 4.0 / 3.0);
    assert_hz(&tuning, 59, 132.0 * 15.0 / 8.0);
    assert_hz(&tuning, 0, 264.0 / 32.0);
    let black = |key: &u8| [1, 3, 6, 8, 10].contains(&(key % 12));
    assert_eq!(silent(&tuning), (0..128).filter(black).collect::<Vec<_>>());
    assert_eq!(tuning.offset_semitones(61), None);
}

#[test]
fn entries_left_out_at_the_end_are_silent() {
    let head = ["12", "0", "127", "60", "60", "264.0", "7"];
    let tuning = Tuning::new(&scale(&MAJOR), &map(head, "0 x 1"));
    assert_hz(&tuning, 60, 264.0);
    assert_hz(&tuning, 62, 297.0);
    assert_hz(&tuning, 72, 528.0);
    assert!((63..72).all(|key| tuning.hz(key).is_none()));
}

#[test]
fn keys_outside_the_range_are_silent_but_may_give_the_frequency() {
    let head = ["0", "36", "48", "60", "69", "432.0", "0"];
    let tuning = Tuning::new(&Scale::default(), &map(head, ""));
    assert_hz(&tuning, 36, 432.0 * (-33.0_f64 / 12.0).exp2());
    assert_hz(&tuning, 48, 432.0 * (-21.0_f64 / 12.0).exp2());
    let outside = (0..36).chain(49..128);
    assert_eq!(silent(&tuning), outside.collect::<Vec<_>>());
}

/// The size is 0, so neither the entries nor the formal octave count.
#[test]
fn a_linear_map_goes_on_for_ever() {
    let head = ["0", "0", "127", "62", "62", "300.0", "5"];
    let tuning = Tuning::new(&scale(&MAJOR), &map(head, "3 x 3"));
    assert_hz(&tuning, 62, 300.0);
    assert_hz(&tuning, 63, 300.0 * 9.0 / 8.0);
    assert_hz(&tuning, 69, 600.0);
    assert_hz(&tuning, 61, 150.0 * 15.0 / 8.0);
}

/// Two octaves before the map repeats, so the fourteenth degree is its octave; degrees may be
/// negative, beyond the period, out of order and on several keys.
#[test]
fn maps_may_do_as_they_like() {
    let head = ["5", "0", "127", "60", "63", "528.0", "14"];
    let tuning = Tuning::new(&scale(&MAJOR), &map(head, "0 -1 9 7 7"));
    assert_hz(&tuning, 60, 264.0);
    assert_hz(&tuning, 61, 132.0 * 15.0 / 8.0);
    assert_hz(&tuning, 62, 528.0 * 5.0 / 4.0);
    assert_hz(&tuning, 64, 528.0);
    assert_hz(&tuning, 65, 264.0 * 4.0);
    assert_hz(&tuning, 59, 132.0);
}

/// A formal octave of degree 0 is an interval of 1/1.
#[test]
fn maps_need_not_rise() {
    let head = ["2", "0", "127", "60", "60", "200.0", "0"];
    let tuning = Tuning::new(&scale(&MAJOR), &map(head, "0 4"));
    assert_hz(&tuning, 60, 200.0);
    assert_hz(&tuning, 61, 300.0);
    assert_hz(&tuning, 62, 200.0);
    assert_hz(&tuning, 1, 300.0);
}

/// 128 entries from key 0 on.
#[test]
fn every_key_may_have_its_own_degree() {
    let head = ["128", "0", "127", "0", "64", "100.0", "128"];
    let entries: Vec<String> = (0..128).map(|key| (127 - key).to_string()).collect();
    let tuning = Tuning::new(&Scale::default(), &map(head, &entries.join(" ")));
    for key in 0..128 {
        let hz = 100.0 * ((64.0 - f64::from(key)) / 12.0).exp2();
        assert_hz(&tuning, key, hz);
    }
}

#[test]
fn remarks_and_blank_lines_are_passed_over() {
    let text = "! a.kbm\r\n\r\n2 keys\r\n0\r\n127 ! all\r\n60\r\n!\r\n60\r\n 2.5e2 Hz\r\n\
                7 the octave\r\n0 on C\r\n\r\nx none\r\n99 is not read\r\nnor this";
    let written = KeyboardMap::parse(text.as_bytes()).unwrap();
    let plain = map(["2", "0", "127", "60", "60", "250", "7"], "0 x");
    assert_eq!(written, plain);
}
