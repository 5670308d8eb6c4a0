//! Bodies are struck by clicks, drags and the computer's keys.

use crate::bench::{Bench, usual_position};
use crate::host::Said;
use egui::{Event, Key, Modifiers, PointerButton, Pos2};
use egui_kittest::Harness;
use egui_kittest::kittest::Queryable as _;
use idiophone::editor::Touch;

const POSITION: &str = "Strike position";

fn button(harness: &mut Harness<'_>, at: Pos2, pressed: bool) {
    harness.event(Event::PointerMoved(at));
    harness.event(Event::PointerButton {
        pos: at,
        button: PointerButton::Primary,
        pressed,
        modifiers: Modifiers::NONE,
    });
    harness.step();
}

/// A place on a tube, 0…1 from above.
fn place(harness: &Harness<'_>, name: &str, position: f32) -> Pos2 {
    let rect = harness.get_by_label(name).rect();
    egui::pos2(rect.center().x, rect.top() + position * rect.height())
}

fn strikes(touches: &[Touch]) -> Vec<(u8, f32, f32)> {
    let strike = |touch: &Touch| match *touch {
        Touch::Strike {
            key,
            velocity,
            position,
            ..
        } => Some((key, velocity, position)),
        Touch::Release { .. } => None,
    };
    touches.iter().filter_map(strike).collect()
}

#[test]
fn playing_is_one_step_to_undo() {
    let bench = Bench::new("chimes");
    let mut harness = bench.harness();
    for (name, position) in [("C4", 0.25), ("E4", 0.5), ("G4", 0.7)] {
        let at = place(&harness, name, position);
        button(&mut harness, at, true);
        button(&mut harness, at, false);
        harness.run_steps(60);
    }
    assert!(bench.value("pos").0 > 0.6);
    harness.get_by_label("Undo").click();
    harness.run_steps(2);
    assert_eq!(bench.value("pos").0, usual_position());
    harness.get_by_label("Redo").click();
    harness.run_steps(2);
    assert!(bench.value("pos").0 > 0.6);
}

#[test]
fn a_click_strikes_where_it_is_and_is_automation() {
    let bench = Bench::new("chimes");
    let mut harness = bench.harness();
    let at = place(&harness, "C4", 0.25);
    button(&mut harness, at, true);
    let struck = strikes(&bench.touches());
    assert_eq!(struck.len(), 1);
    let (key, velocity, position) = struck[0];
    assert_eq!(key, 60);
    assert!((velocity - 100.0 / 127.0).abs() < 1e-6);
    assert!((position - 0.25).abs() < 0.01, "{position}");
    button(&mut harness, at, false);
    harness.step();
    assert_eq!(bench.touches(), [Touch::Release { key: 60 }]);
    let said = bench.host.said();
    let [Said::Begin(a), Said::Set(b, value), Said::End(c)] = &said[..] else {
        panic!("{said:?}");
    };
    assert_eq!([a, b, c], [POSITION; 3]);
    assert!((value - position).abs() < 1e-4);
}

#[test]
fn a_drag_strikes_every_body_that_it_comes_upon_once() {
    let bench = Bench::new("vibraphone");
    let mut harness = bench.harness();
    let [from, to] = ["C4", "C5"].map(|name| place(&harness, name, 0.5));
    button(&mut harness, from, true);
    for step in 1..=8 {
        harness.event(Event::PointerMoved(from + (to - from) * step as f32 / 8.0));
        harness.step();
    }
    button(&mut harness, to, false);
    harness.step();
    let touches = bench.touches();
    let keys: Vec<u8> = strikes(&touches).iter().map(|(key, _, _)| *key).collect();
    assert_eq!(keys, [60, 62, 64, 65, 67, 69, 71, 72], "the white ones");
    let released = |touch: &&Touch| matches!(touch, Touch::Release { .. });
    assert_eq!(touches.iter().filter(released).count(), 8);
    let said = bench.host.said();
    let begins = said.iter().filter(|said| matches!(said, Said::Begin(_)));
    let ends = said.iter().filter(|said| matches!(said, Said::End(_)));
    assert_eq!((begins.count(), ends.count()), (1, 1));
    assert!(
        matches!(said.first(), Some(Said::Begin(_))) && matches!(said.last(), Some(Said::End(_)))
    );
}

#[test]
fn a_bowl_is_struck_from_its_rim_to_its_middle() {
    let bench = Bench::new("singing-bowls");
    let mut harness = bench.harness();
    let rect = harness.get_by_label("C4").rect();
    for (share, expected) in [(0.0, 1.0), (0.5, 0.5), (0.97, 0.03)] {
        let at = rect.center() + egui::vec2(share * 0.5 * rect.width(), 0.0);
        button(&mut harness, at, true);
        button(&mut harness, at, false);
        let struck = strikes(&bench.touches());
        assert!((struck[0].2 - expected).abs() < 0.02, "{struck:?}");
    }
}

#[test]
fn keys_of_the_computer_play_and_the_octave_moves() {
    let bench = Bench::new("chimes");
    let mut harness = bench.harness();
    let mut play = |keys: &[Key]| {
        for key in keys {
            harness.key_down(*key);
            harness.key_up(*key);
            harness.step();
        }
        harness.step();
        strikes(&bench.touches())
            .into_iter()
            .map(|(key, _, position)| {
                assert!((position - usual_position()).abs() < 1e-6);
                key
            })
            .collect::<Vec<_>>()
    };
    assert_eq!(play(&[Key::Z, Key::S, Key::M, Key::Q]), [60, 61, 71, 72]);
    assert_eq!(play(&[Key::Minus, Key::Z]), [48]);
    assert_eq!(play(&[Key::Plus, Key::Plus, Key::Z]), [72]);
    assert_eq!(play(&[Key::F, Key::K]), [0u8; 0], "these play nothing");
    drop(harness);
    assert_eq!(bench.host.said(), [], "and move no parameter");
}

#[test]
fn the_strip_sets_how_hard() {
    let bench = Bench::new("chimes");
    let mut harness = bench.harness();
    let strip = harness.get_by_label("Velocity").rect();
    let at = egui::pos2(strip.center().x, strip.bottom());
    button(&mut harness, at, true);
    button(&mut harness, at, false);
    harness.key_press(Key::Z);
    harness.step();
    let struck = strikes(&bench.touches());
    assert!((struck[0].1 - 1.0 / 127.0).abs() < 1e-6, "{struck:?}");
}
