//! The keyboard goes through the window as eyes do.

use crate::bench::Bench;
use egui::{Key, Rect, vec2};
use egui_kittest::Harness;
use egui_kittest::kittest::{NodeT as _, Queryable as _};

/// What has the keyboard, and where it is.
fn focused(harness: &Harness<'_>) -> (String, Rect) {
    let node = harness
        .query_by(|node| node.is_focused() && node.label().is_some())
        .unwrap();
    (node.accesskit_node().label().unwrap(), node.rect())
}

#[test]
fn tab_goes_from_the_head_to_the_row_the_body_and_the_parameters_and_round() {
    let bench = Bench::new("chimes");
    let mut harness = bench.harness();
    harness.run_steps(2);
    let window = Rect::from_min_size(egui::Pos2::ZERO, vec2(1000.0, 680.0));
    let mut names: Vec<String> = Vec::new();
    loop {
        harness.key_press(Key::Tab);
        harness.run_steps(2);
        let (name, rect) = focused(&harness);
        assert!(window.contains_rect(rect), "{name} is seen");
        if names.first() == Some(&name) {
            break;
        }
        assert!(
            !names.contains(&name) && names.len() < 60,
            "{name} after {names:?}"
        );
        names.push(name);
    }
    let at = |name: &str| names.iter().position(|other| other == name).unwrap();
    assert_eq!(at("Instrument"), 0);
    assert!(at("Preset menu") < at("Velocity"));
    assert!(at("Velocity") < at("Partials") && at("Velocity") < at("Body C4"));
    assert!(at("Partial levels") < at("Strike") && at("Body C4") < at("Strike"));
    assert!(at("Hands") < at("Strike position"));
    assert_eq!(at("Dead stroke"), names.len() - 1);
}
