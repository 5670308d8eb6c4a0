//! The map of timbre on the body: switched on, followed, and pictured on bodies of every kind.

use crate::bench::Bench;
use crate::drawn;
use crate::looks::{USUAL, draw};
use crate::picture::check;
use egui::{Key, Pos2, vec2};
use egui_kittest::kittest::Queryable as _;

/// A bench on which the map lies on the body, which notes strike at a place along and across.
fn mapped(instrument: &str, place: [f32; 2]) -> Bench {
    laid(Bench::new(instrument), place)
}

fn laid(bench: Bench, [along, across]: [f32; 2]) -> Bench {
    bench.saved.set_map(true);
    bench.set("pos", along);
    bench.set("acrs", across);
    bench
}

#[test]
fn it_is_laid_on_and_taken_off_by_pointer_and_keys() {
    let bench = Bench::new("vibraphone");
    let mut harness = bench.harness();
    harness.run_steps(2);
    assert!(!bench.saved.map());
    harness.get_by_label("Map").click();
    harness.run_steps(2);
    assert!(bench.saved.map());
    harness.get_by_label("Map").focus();
    harness.step();
    harness.key_press(Key::Space);
    harness.run_steps(2);
    assert!(!bench.saved.map());
    assert_eq!(bench.touches(), [], "that is no blow");
    assert_eq!(bench.host.said(), [], "and no parameter");
}

#[test]
fn it_looks_from_where_notes_strike() {
    let bench = mapped("square-drums", [0.2, 0.3]);
    let [one, other] = [0.2, 0.7].map(|along| {
        bench.set("pos", along);
        draw(&bench, USUAL, 1.0, None).rgba
    });
    // Its panel, which begins some way down on the left.
    let body = |pixels: &[[u8; 4]]| -> Vec<[u8; 4]> {
        let rows = pixels.chunks(1000).skip(270).take(130);
        rows.flat_map(|row| row[20..480].to_vec()).collect()
    };
    let [one, other] = [one, other].map(|pixels| body(&pixels));
    let changed = one.iter().zip(&other).filter(|(a, b)| a != b).count();
    assert!(changed > 5000, "{changed}");
}

#[test]
fn on_a_drum_with_what_the_pointer_is_on() {
    let bench = mapped("square-drums", [0.2, 0.3]);
    let at = Pos2::ZERO + vec2(270.0, 340.0);
    let drawn = draw(&bench, USUAL, 2.0, Some((at, false)));
    check("square-drums-map-2x", &drawn);
}

#[test]
fn on_a_string_and_a_bar_in_bands() {
    let bench = mapped("strings", [0.1, 0.0]);
    check("strings-map", &draw(&bench, USUAL, 1.0, None));
    let bench = mapped("vibraphone", [0.15, 0.0]);
    check("vibraphone-map", &draw(&bench, USUAL, 1.0, None));
}

#[test]
fn on_a_bowl_in_a_bright_room() {
    let bench = mapped("singing-bowls", [0.03, 0.0]);
    bench.saved.set_dark(false);
    check("singing-bowls-map-light", &draw(&bench, USUAL, 1.0, None));
}

#[test]
fn on_a_mesh_and_in_the_least_window() {
    let bench = laid(drawn::bench(), [0.3, 0.2]);
    check("star-map", &draw(&bench, USUAL, 1.0, None));
    let least = idiophone::editor::LEAST_SIZE;
    check("star-map-least", &draw(&bench, least, 1.0, None));
}
