//! The body in three dimensions is struck by clicks, and turned by drags beside it.

use crate::bench::{Bench, usual_position};
use crate::host::Said;
use egui::{Event, Key, Modifiers, PointerButton, Pos2, Vec2, vec2};
use egui_kittest::Harness;
use egui_kittest::kittest::Queryable as _;
use idiophone::editor::Touch;

fn press(harness: &mut Harness<'_>, pos: Pos2, pressed: bool) {
    harness.event(Event::PointerMoved(pos));
    harness.event(Event::PointerButton {
        pos,
        button: PointerButton::Primary,
        pressed,
        modifiers: Modifiers::NONE,
    });
    harness.step();
}

/// Where a share of the panel's width and height from its middle is; below the middle the body lies.
fn spot(harness: &Harness<'_>, name: &str, share: Vec2) -> Pos2 {
    let rect = harness.get_by_label(name).rect();
    rect.center() + rect.size() * share + vec2(0.0, 28.0)
}

/// The place that a click there strikes, if it does.
fn click(bench: &Bench, harness: &mut Harness<'_>, at: Pos2) -> Option<f32> {
    press(harness, at, true);
    press(harness, at, false);
    harness.step();
    let touches = bench.touches();
    match touches[..] {
        [] => None,
        [
            Touch::Strike {
                key: 60, position, ..
            },
            Touch::Release { key: 60 },
        ] => Some(position),
        _ => panic!("{touches:?}"),
    }
}

#[test]
fn a_click_on_the_body_strikes_there_and_is_automation() {
    let bench = Bench::new("chimes");
    let mut harness = bench.harness();
    harness.run_steps(2);
    let [left, middle, right] = [-0.3, 0.0, 0.3].map(|x| spot(&harness, "Body C4", vec2(x, 0.0)));
    let struck = click(&bench, &mut harness, middle).unwrap();
    assert!((struck - 0.5).abs() < 0.06, "{struck}");
    let said = bench.host.said();
    let [Said::Begin(_), Said::Set(name, value), Said::End(_)] = &said[..] else {
        panic!("{said:?}");
    };
    assert_eq!(name, "Strike position");
    assert!((value - struck).abs() < 1e-4);
    // Perspective and the tube's tilt move places a little; up is left.
    let mut near = |at: Pos2| {
        let found =
            (-40..40).find_map(|dy| click(&bench, &mut harness, at + vec2(0.0, 2.0 * dy as f32)));
        found.unwrap()
    };
    let (above, below) = (near(left), near(right));
    assert!(above < 0.35 && below > 0.65, "{above} {below}");
}

#[test]
fn a_bowl_is_struck_inside_and_outside() {
    let bench = Bench::new("singing-bowls");
    let mut harness = bench.harness();
    harness.run_steps(2);
    let at = |share| spot(&harness, "Body C4", share);
    let (inside, below) = (at(vec2(0.0, -0.05)), at(vec2(0.0, 0.19)));
    let inside = click(&bench, &mut harness, inside).unwrap();
    let below = click(&bench, &mut harness, below).unwrap();
    assert!(
        inside > 0.5 && (0.05..0.6).contains(&below),
        "{inside} {below}"
    );
}

#[test]
fn a_drag_beside_the_body_turns_it_and_strikes_nothing() {
    let bench = Bench::new("vibraphone");
    let mut harness = bench.harness();
    harness.run_steps(2);
    let top = spot(&harness, "Body C4", Vec2::ZERO);
    let before = click(&bench, &mut harness, top).unwrap();
    bench.host.said();
    let beside = spot(&harness, "Body C4", vec2(-0.45, 0.1));
    press(&mut harness, beside, true);
    // Half a turn: the bar is seen from its other end and from above all the same.
    for step in 1..=10 {
        harness.event(Event::PointerMoved(beside + vec2(17.0 * step as f32, 0.0)));
        harness.step();
    }
    press(&mut harness, beside + vec2(170.0, 0.0), false);
    harness.step();
    assert_eq!(bench.touches(), []);
    assert_eq!(bench.host.said(), []);
    let after = click(&bench, &mut harness, top + vec2(90.0, 0.0));
    assert_ne!(after, Some(before), "something else lies there now");
}

#[test]
fn the_focused_body_is_struck_where_notes_strike_it() {
    let bench = Bench::new("chimes");
    let mut harness = bench.harness();
    harness.run_steps(2);
    harness.get_by_label("Body C4").focus();
    harness.step();
    harness.key_press(Key::Enter);
    harness.run_steps(2);
    let touches = bench.touches();
    let Some(Touch::Strike {
        key: 60, position, ..
    }) = touches.first()
    else {
        panic!("{touches:?}");
    };
    assert!((position - usual_position()).abs() < 1e-6);
}
