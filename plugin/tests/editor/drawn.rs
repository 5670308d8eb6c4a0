//! A body that a mesh gives is seen, and struck wherever it is clicked.

use crate::bench::Bench;
use crate::host::Said;
use crate::looks::{USUAL, draw};
use crate::picture::check;
use egui::{Event, Modifiers, PointerButton, Pos2, vec2};
use egui_kittest::Harness;
use egui_kittest::kittest::Queryable as _;
use idiophone::editor::Touch;
use idiophone::engine::{Engine, Vectors};
use idiophone::shelf::{OWN, Own};
use modes::factory::Silent;
use modes::freeform::make;
use modes::solid::{gallery, write_obj};
use modes::{Bank, MeshOrder, PieceOrder};
use std::sync::OnceLock;

/// A star of bronze that three octaves share, coarsely solved.
pub(crate) fn star() -> Bank {
    static STAR: OnceLock<Bank> = OnceLock::new();
    STAR.get_or_init(|| {
        let folder = tempfile::tempdir().unwrap();
        let file = folder.path().join("star.obj");
        std::fs::write(&file, write_obj(&gallery::star(5, 0.1, 0.02))).unwrap();
        let order = MeshOrder {
            title: None,
            pieces: vec![PieceOrder {
                file: file.to_str().unwrap().to_owned(),
                material: "bell bronze".to_owned(),
                size_m: Some(0.2),
                keys: [48, 84],
                by: "size".to_owned(),
                tuned: "lowest".to_owned(),
                ..PieceOrder::default()
            }],
            nodes: 1500,
            most_modes: 24,
        };
        make(&order.recipe("star").unwrap(), &Silent).unwrap().bank
    })
    .clone()
}

/// A bench on which the star plays.
pub(crate) fn bench() -> Bench {
    let bench = Bench::new("chimes");
    bench.controls.shelf().put(Own::new(star()).unwrap());
    bench.set("instr", 1.0);
    bench
}

fn click(harness: &mut Harness<'_>, pos: Pos2) {
    for pressed in [true, false] {
        harness.event(Event::PointerMoved(pos));
        harness.event(Event::PointerButton {
            pos,
            button: PointerButton::Primary,
            pressed,
            modifiers: Modifiers::NONE,
        });
        harness.step();
    }
    harness.step();
}

/// Key, position and place across of the only blow that has come.
fn struck(bench: &Bench) -> (u8, [f32; 2]) {
    let touches = bench.touches();
    match touches[..] {
        [
            Touch::Strike {
                key,
                position,
                across,
                ..
            },
            Touch::Release { .. },
        ] => (key, [position, across]),
        _ => panic!("{touches:?}"),
    }
}

#[test]
fn a_click_on_the_body_strikes_along_and_across_and_both_are_automation() {
    let bench = bench();
    let mut harness = bench.harness();
    harness.run_steps(2);
    let rect = harness.get_by_label("Body C4").rect();
    let middle = rect.center() + vec2(0.0, 28.0);
    let mut places = Vec::new();
    for aside in [-0.12, 0.0, 0.12] {
        click(&mut harness, middle + vec2(aside * rect.width(), 0.0));
        let (key, place) = struck(&bench);
        assert_eq!(key, 60);
        let said = bench.host.said();
        for (name, value) in [("Strike position", place[0]), ("Strike across", place[1])] {
            let set = said.iter().any(
                |said| matches!(said, Said::Set(id, x) if id == name && (x - value).abs() < 1e-3),
            );
            assert!(set, "{name} {value}: {said:?}");
        }
        let begins = said.iter().filter(|said| matches!(said, Said::Begin(_)));
        let ends = said.iter().filter(|said| matches!(said, Said::End(_)));
        assert_eq!((begins.count(), ends.count()), (2, 2));
        places.push(place);
    }
    assert!(places[0] != places[1] && places[1] != places[2]);
    harness.run_steps(60);
    harness.get_by_label("Undo").click();
    harness.run_steps(2);
    for id in ["pos", "acrs"] {
        let (now, usual) = bench.value(id);
        assert_eq!(now, usual, "{id}: clicks one after the other are one step");
    }
}

#[test]
fn a_body_of_the_row_is_struck_where_it_is_clicked() {
    let bench = bench();
    let mut harness = bench.harness();
    harness.run_steps(2);
    let rect = harness.get_by_label("C3").rect();
    click(&mut harness, rect.center());
    let (key, place) = struck(&bench);
    assert_eq!(key, 48);
    let aside = rect.center() + vec2(0.25 * rect.width(), 0.0);
    click(&mut harness, aside);
    assert_ne!(struck(&bench).1, place);
    let corner = rect.left_top() + vec2(1.0, 1.0);
    click(&mut harness, corner);
    assert_eq!(bench.touches(), [], "a star does not fill its corners");
}

#[test]
fn it_is_seen_at_rest_in_motion_and_in_one_mode() {
    let bench = bench();
    check("star-at-rest", &draw(&bench, USUAL, 1.0, None));
    let instrument = bench.controls.shelf().number(OWN);
    let mut engine = Engine::with_vectors(
        &bench.controls.shelf().bank(instrument),
        48e3,
        Vectors::Plain,
    );
    engine.set(&bench.controls.settings());
    assert!(engine.strike(60, 0.9));
    let (mut left, mut right) = (vec![0.0; 4800], vec![0.0; 4800]);
    engine.process(&mut left, &mut right);
    bench
        .link
        .show(|frame| frame.fill(instrument, &engine, [0.1, 0.1]));
    check("star-rings", &draw(&bench, USUAL, 1.0, None));
    let label = star().bodies[0].modes[2].label;
    bench
        .controls
        .trims()
        .change(|trims| trims.set_solo(Some(label)));
    check("star-mode", &draw(&bench, USUAL, 1.0, None));
}
