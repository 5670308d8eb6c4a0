//! Parameters are turned, typed and reset, in gestures that begin and end.

use crate::bench::Bench;
use crate::host::Said;
use egui::{
    Event, Key, Modifiers, MouseWheelSource, MouseWheelUnit, PointerButton, TouchPhase, vec2,
};
use egui_kittest::Harness;
use egui_kittest::kittest::Queryable as _;

/// The editor with the page of damping open.
fn damping(bench: &Bench) -> Harness<'static> {
    let mut harness = bench.harness();
    harness.get_by_label("Damping").click();
    harness.run_steps(2);
    harness
}

fn drag(harness: &mut Harness<'_>, name: &str, up: f32, modifiers: Modifiers) {
    let from = harness.get_by_label(name).rect().center();
    let press = |pos, pressed| Event::PointerButton {
        pos,
        button: PointerButton::Primary,
        pressed,
        modifiers,
    };
    let to = from - vec2(0.0, up);
    harness.event(Event::ModifiersChanged(modifiers));
    harness.event(Event::PointerMoved(from));
    harness.event(press(from, true));
    harness.step();
    for step in 1..=4 {
        harness.event(Event::PointerMoved(
            from + (to - from) * (step as f32 / 4.0),
        ));
        harness.step();
    }
    harness.event(press(to, false));
    harness.step();
    harness.event(Event::ModifiersChanged(Modifiers::NONE));
}

/// One whole gesture on the parameter; the places that it went to.
fn gesture(said: &[Said], name: &str) -> Vec<f32> {
    let [Said::Begin(first), middle @ .., Said::End(last)] = said else {
        panic!("no gesture: {said:?}");
    };
    assert_eq!([first, last], [name; 2]);
    let place = |said: &Said| match said {
        Said::Set(other, value) if other == name => *value,
        _ => panic!("{said:?}"),
    };
    middle.iter().map(place).collect()
}

#[test]
fn a_drag_is_one_gesture_and_shift_makes_it_fine() {
    let bench = Bench::new("chimes");
    bench.set("alpha2", 0.2);
    let mut harness = damping(&bench);
    drag(&mut harness, "Alpha 2", 45.0, Modifiers::NONE);
    let coarse = gesture(&bench.host.said(), "Alpha 2");
    assert!(coarse.windows(2).all(|pair| pair[0] < pair[1]));
    let moved = bench.value("alpha2").0 - 0.2;
    assert!((moved - 0.25).abs() < 0.03, "{moved}");
    bench.set("alpha2", 0.2);
    drag(&mut harness, "Alpha 2", 45.0, Modifiers::SHIFT);
    gesture(&bench.host.said(), "Alpha 2");
    let fine = bench.value("alpha2").0 - 0.2;
    assert!((fine / moved - 0.1).abs() < 0.02, "{fine} of {moved}");
}

#[test]
fn a_double_click_resets() {
    let bench = Bench::new("chimes");
    bench.set("own", 0.1);
    let mut harness = damping(&bench);
    for _ in 0..2 {
        harness.get_by_label("Own damping").click();
        harness.step();
    }
    harness.run_steps(2);
    let (value, default) = bench.value("own");
    assert_eq!(value, default);
    assert_eq!(gesture(&bench.host.said(), "Own damping"), [default]);
}

fn type_in(harness: &mut Harness<'_>, name: &str, text: &str) {
    harness.get_by_label(&format!("Type {name}")).click();
    harness.run_steps(3);
    harness.event(Event::Text(text.to_owned()));
    harness.step();
    harness.key_press(Key::Enter);
    harness.run_steps(2);
}

#[test]
fn a_value_is_typed_with_its_unit() {
    let bench = Bench::new("chimes");
    let mut harness = damping(&bench);
    type_in(&mut harness, "Alpha 1", "0.003 ms");
    assert_eq!(bench.text("alpha1"), "3.00e-6 s");
    assert_eq!(gesture(&bench.host.said(), "Alpha 1").len(), 1);
}

#[test]
fn what_cannot_be_stays_open_and_escape_leaves_it_as_it_was() {
    let bench = Bench::new("chimes");
    let mut harness = damping(&bench);
    let before = bench.text("alpha1");
    type_in(&mut harness, "Alpha 1", "3 apples");
    assert_eq!(bench.text("alpha1"), before);
    assert!(harness.query_by_label("Alpha 1 value").is_some());
    harness.key_press(Key::Escape);
    harness.run_steps(2);
    assert!(harness.query_by_label("Alpha 1 value").is_none());
    assert_eq!(bench.host.said(), []);
}

#[test]
fn letters_that_are_typed_play_nothing() {
    let bench = Bench::new("chimes");
    let mut harness = damping(&bench);
    harness.get_by_label("Type Alpha 1").click();
    harness.run_steps(3);
    bench.touches();
    harness.key_press(Key::Z);
    harness.step();
    assert_eq!(bench.touches(), []);
}

#[test]
fn wheel_and_arrows_turn() {
    let bench = Bench::new("chimes");
    bench.set("alpha2", 0.5);
    let mut harness = damping(&bench);
    let at = harness.get_by_label("Alpha 2").rect().center();
    harness.hover_at(at);
    harness.step();
    harness.event(Event::MouseWheel {
        unit: MouseWheelUnit::Line,
        delta: vec2(0.0, 1.0),
        phase: TouchPhase::Move,
        source: MouseWheelSource::Wheel,
        modifiers: Modifiers::NONE,
    });
    harness.step();
    let by_wheel = bench.value("alpha2").0;
    assert!((by_wheel - 0.52).abs() < 1e-4, "{by_wheel}");
    harness.get_by_label("Alpha 2").focus();
    harness.run_steps(2);
    harness.key_press(Key::ArrowDown);
    harness.run_steps(2);
    let by_key = bench.value("alpha2").0;
    assert!((by_key - 0.5).abs() < 1e-4, "{by_key}");
    assert!(harness.get_by_label("Alpha 2").is_focused());
}

#[test]
fn a_switch_and_the_instrument_are_chosen() {
    let bench = Bench::new("chimes");
    let mut harness = damping(&bench);
    let before = bench.value("noff").0;
    harness.get_by_label("Note-off").click();
    harness.run_steps(2);
    assert_eq!(bench.value("noff").0, 1.0 - before);
    harness.get_by_label("Next instrument").click();
    harness.run_steps(2);
    assert_eq!(bench.text("instr"), idiophone::factory::title(1.0));
    harness.get_by_label("Instrument").click();
    harness.run_steps(3);
    harness.get_by_label("Vibraphone").click();
    harness.run_steps(3);
    assert_eq!(bench.text("instr"), "Vibraphone");
}

#[test]
fn handles_of_damping_drag_their_parameters() {
    let bench = Bench::new("vibraphone");
    let mut harness = bench.harness();
    harness.get_by_label("Decay").click();
    harness.run_steps(2);
    for (id, name) in [
        ("alpha1", "Alpha 1"),
        ("alpha2", "Alpha 2"),
        ("tanphi", "Loss factor"),
    ] {
        bench.host.said();
        let handle = format!("{name} handle");
        drag(&mut harness, &handle, 30.0, Modifiers::NONE);
        let places = gesture(&bench.host.said(), name);
        assert!(
            places.windows(2).all(|pair| pair[0] < pair[1]),
            "{places:?}"
        );
        assert!(bench.value(id).0 > bench.value(id).1, "{id}");
        drag(&mut harness, &handle, -400.0, Modifiers::NONE);
        assert_eq!(bench.value(id).0, 0.0, "{id} down to nothing");
    }
}
