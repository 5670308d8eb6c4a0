//! Partials are heard alone, trimmed and put back by hand.

use crate::bench::Bench;
use crate::host::Said;
use egui::{Event, Key, Modifiers, PointerButton, Pos2, Rect};
use egui_kittest::Harness;
use egui_kittest::kittest::Queryable as _;
use idiophone::engine::Trim;

fn button(harness: &mut Harness<'_>, pos: Pos2, button: PointerButton, pressed: bool) {
    harness.event(Event::PointerMoved(pos));
    harness.event(Event::PointerButton {
        pos,
        button,
        pressed,
        modifiers: Modifiers::NONE,
    });
    harness.step();
}

fn click(harness: &mut Harness<'_>, pos: Pos2, which: PointerButton) {
    button(harness, pos, which, true);
    button(harness, pos, which, false);
    harness.step();
}

fn drag(harness: &mut Harness<'_>, from: Pos2, by: egui::Vec2) {
    button(harness, from, PointerButton::Primary, true);
    for step in 1..=10 {
        harness.event(Event::PointerMoved(from + by * (step as f32 / 10.0)));
        harness.step();
    }
    button(harness, from + by, PointerButton::Primary, false);
    harness.step();
}

/// A place in the plot: shares of its width and height.
fn at(rect: Rect, x: f32, y: f32) -> Pos2 {
    rect.min + rect.size() * egui::vec2(x, y)
}

/// The share of the width at which the lowest partial stands.
fn lowest(bench: &Bench, harness: &mut Harness<'_>, rect: Rect) -> f32 {
    for step in 0..60 {
        let x = 0.08 + 0.005 * step as f32;
        click(harness, at(rect, x, 0.3), PointerButton::Primary);
        if bench.controls.trims().get().solo().is_some() {
            click(harness, at(rect, x, 0.3), PointerButton::Primary);
            assert_eq!(bench.controls.trims().get().solo(), None, "once more: all");
            return x;
        }
    }
    panic!("there is no partial");
}

#[test]
fn a_partial_is_taken_by_hand() {
    let bench = Bench::new("chimes");
    let mut harness = bench.harness();
    harness.run_steps(2);
    let rect = harness.get_by_label("Partial levels").rect();
    let x = lowest(&bench, &mut harness, rect);
    let trims = || bench.controls.trims().get();
    click(&mut harness, at(rect, x, 0.3), PointerButton::Primary);
    let label = trims().solo().unwrap();
    assert_eq!(label.to_string(), "bending 1 a");
    drag(&mut harness, at(rect, x, 0.3), egui::vec2(0.0, 20.0));
    let level_db = trims().get(&label).level_db;
    assert!((-40.0..-4.0).contains(&level_db), "{level_db}");
    assert_eq!(trims().get(&label).ringing, 1.0);
    drag(&mut harness, at(rect, x, 0.75), egui::vec2(0.0, 14.0));
    let ringing = trims().get(&label).ringing;
    assert!((1.1..8.0).contains(&ringing), "{ringing}");
    assert_eq!(trims().get(&label).level_db, level_db);
    click(&mut harness, at(rect, x, 0.3), PointerButton::Secondary);
    assert_eq!(trims().get(&label), Trim::NONE);
    assert_eq!(bench.host.said(), [] as [Said; 0], "no parameter moves");
    drop(harness);
    drop(bench.ui);
    assert_eq!(
        bench.controls.trims().get().solo(),
        None,
        "a closed window lets all sound"
    );
}

#[test]
fn a_partial_is_taken_by_keys() {
    let bench = Bench::new("chimes");
    let mut harness = bench.harness();
    harness.run_steps(2);
    harness.get_by_label("Partial levels").focus();
    harness.step();
    let mut press = |key: Key, modifiers: Modifiers| {
        harness.key_press_modifiers(modifiers, key);
        harness.run_steps(2);
    };
    press(Key::ArrowRight, Modifiers::NONE);
    press(Key::ArrowDown, Modifiers::NONE);
    press(Key::ArrowDown, Modifiers::NONE);
    press(Key::ArrowUp, Modifiers::SHIFT);
    let trims: Vec<_> = bench.controls.trims().get().all().collect();
    let [(label, trim)] = trims[..] else {
        panic!("{trims:?}");
    };
    assert_eq!(label.to_string(), "bending 1 a");
    assert_eq!(trim.level_db, -2.0);
    assert!((trim.ringing - 1.1).abs() < 1e-6);
    press(Key::Enter, Modifiers::NONE);
    assert_eq!(bench.controls.trims().get().solo(), Some(label));
    press(Key::Delete, Modifiers::NONE);
    assert_eq!(bench.controls.trims().get().all().count(), 0);
    press(Key::ArrowUp, Modifiers::NONE);
    assert_eq!(bench.controls.trims().get().all().count(), 1);
    harness.get_by_label("Reset all trims").click();
    harness.run_steps(2);
    assert_eq!(bench.controls.trims().get().all().count(), 0);
}
