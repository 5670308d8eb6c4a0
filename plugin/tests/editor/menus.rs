//! A right click on a control.

use crate::bench::Bench;
use egui_kittest::Harness;
use egui_kittest::kittest::Queryable as _;

/// The editor with the page of damping open, and the menu of a control.
fn menu_of(bench: &Bench, name: &str) -> Harness<'static> {
    let mut harness = bench.harness();
    harness.get_by_label("Damping").click();
    harness.run_steps(2);
    harness.get_by_label(name).click_secondary();
    harness.run_steps(3);
    harness
}

fn pick(harness: &mut Harness<'_>, label: &str) {
    harness.get_by_label(label).click();
    harness.run_steps(3);
}

#[test]
fn it_resets() {
    let bench = Bench::new("chimes");
    bench.set("own", 0.1);
    let mut harness = menu_of(&bench, "Own damping");
    pick(&mut harness, "Reset to 1.00 x");
    assert_eq!(bench.text("own"), "1.00 x");
    assert_eq!(bench.host.said().len(), 3, "one gesture");
}

#[test]
fn it_opens_the_field_to_type_in() {
    let bench = Bench::new("chimes");
    let mut harness = menu_of(&bench, "Alpha 1");
    assert!(harness.query_by_label("Alpha 1 value").is_none());
    pick(&mut harness, "Type a value…");
    assert!(harness.query_by_label("Alpha 1 value").is_some());
}

#[test]
fn it_carries_a_value_to_another_control() {
    let bench = Bench::new("chimes");
    bench.set("radia", 0.7);
    let mut harness = menu_of(&bench, "Radiation damping");
    pick(&mut harness, "Copy value");
    let text = bench.text("radia");
    assert_ne!(bench.text("suppt"), text);
    harness.get_by_label("Supports").click_secondary();
    harness.run_steps(3);
    pick(&mut harness, &format!("Paste {text}"));
    assert_eq!(bench.text("suppt"), text);
}

#[test]
fn a_switch_has_one_too() {
    let bench = Bench::new("chimes");
    bench.set("noff", 1.0);
    let mut harness = menu_of(&bench, "Note-off");
    pick(&mut harness, "Reset to rings on");
    assert_eq!(bench.text("noff"), "rings on");
}
