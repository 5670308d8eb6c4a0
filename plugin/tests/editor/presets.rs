//! Presets are searched and chosen, sounds compared, steps undone.

use crate::bench::Bench;
use crate::host::Said;
use egui::{Key, Modifiers, Role};
use egui_kittest::Harness;
use egui_kittest::kittest::Queryable as _;
use idiophone::editor::Touch;
use idiophone::presets::{Preset, factory};

pub(crate) fn click(harness: &mut Harness<'_>, label: &str) {
    harness.get_by_role_and_label(Role::Button, label).click();
    harness.run_steps(3);
}

pub(crate) fn type_text(harness: &mut Harness<'_>, text: &str) {
    harness.event(egui::Event::Text(text.to_owned()));
    harness.run_steps(2);
}

fn named(name: &str) -> &'static Preset {
    let found = factory().iter().find(|preset| preset.card.name == name);
    found.expect("there is such a preset")
}

/// Holds all parameters beside what a preset wants.
fn assert_loaded(bench: &Bench, name: &str) {
    for (spec, plain) in named(name).sound.wanted() {
        assert_eq!(bench.text(spec.id), spec.format(plain), "{}", spec.name);
    }
}

/// Every value that the host knows, as text.
fn sound(bench: &Bench) -> Vec<String> {
    idiophone::params::specs()
        .map(|spec| bench.text(spec.id))
        .collect()
}

#[test]
fn a_search_and_a_click_load_a_preset_by_whole_gestures() {
    let bench = Bench::new("chimes");
    bench.set("alpha2", 0.5);
    let mut harness = bench.harness();
    click(&mut harness, "Presets");
    type_text(&mut harness, "ballads yarn");
    assert!(harness.query_by_label("Temple block").is_none());
    bench.host.said();
    click(&mut harness, "Yarn and motor");
    assert_loaded(&bench, "Yarn and motor");
    let said = bench.host.said();
    assert!(said.len() > 9, "{said:?}");
    for gesture in said.chunks(3) {
        let [Said::Begin(begun), Said::Set(set, _), Said::End(ended)] = gesture else {
            panic!("{gesture:?}");
        };
        assert!(begun == set && set == ended);
    }
    let chosen = bench.saved.chosen();
    assert_eq!(chosen.key, "factory/Yarn and motor");
    assert!(!chosen.changed);
}

#[test]
fn arrows_go_through_what_is_found_and_the_pointer_does_not_reach_beneath() {
    let bench = Bench::new("chimes");
    let mut harness = bench.harness();
    click(&mut harness, "Presets");
    click(&mut harness, "Shelf Oak bowls");
    let mut seen = Vec::new();
    for _ in 0..3 {
        harness.key_press(Key::ArrowDown);
        harness.run_steps(2);
        seen.push(bench.saved.chosen().key);
        assert_eq!(bench.text("instr"), "Oak bowls");
    }
    harness.key_press(Key::ArrowUp);
    harness.run_steps(2);
    assert_eq!(bench.saved.chosen().key, seen[1]);
    assert!(seen[0] != seen[1] && seen[1] != seen[2]);
    bench.touches();
    let middle = egui::pos2(300.0, 100.0);
    harness.hover_at(middle);
    harness.step();
    harness.get_by_label("Shelf Oak bowls").click();
    harness.run_steps(2);
    assert_eq!(bench.touches(), [], "no body is struck through the browser");
    harness.key_press(Key::Escape);
    harness.run_steps(2);
    assert!(harness.query_by_label("Search presets").is_none());
}

#[test]
fn presets_are_heard_as_they_are_chosen_if_that_is_wanted() {
    let bench = Bench::new("chimes");
    let mut harness = bench.harness();
    click(&mut harness, "Presets");
    click(&mut harness, "Brass clapper");
    harness.run_steps(30);
    assert_eq!(bench.touches(), []);
    click(&mut harness, "Hear each preset");
    click(&mut harness, "Garden chimes");
    harness.run_steps(30);
    let touches = bench.touches();
    assert!(
        matches!(touches[..], [Touch::Strike { key: 60, .. }]),
        "{touches:?}"
    );
    harness.run_steps(90);
    assert_eq!(bench.touches(), [Touch::Release { key: 60 }]);
}

#[test]
fn the_bar_goes_on_and_back() {
    let bench = Bench::new("chimes");
    let mut harness = bench.harness();
    click(&mut harness, "Next preset");
    assert_loaded(&bench, &factory()[0].card.name);
    click(&mut harness, "Next preset");
    assert_loaded(&bench, &factory()[1].card.name);
    click(&mut harness, "Previous preset");
    assert_loaded(&bench, &factory()[0].card.name);
}

#[test]
fn steps_are_undone_and_done_again() {
    let bench = Bench::new("chimes");
    let mut harness = bench.harness();
    let start = sound(&bench);
    click(&mut harness, "Next preset");
    let loaded = sound(&bench);
    click(&mut harness, "Next instrument");
    let turned = sound(&bench);
    harness.run_steps(2);
    assert!(bench.saved.chosen().changed);
    let undo = |harness: &mut Harness<'_>| {
        harness.key_press_modifiers(Modifiers::COMMAND, Key::Z);
        harness.run_steps(2);
    };
    undo(&mut harness);
    assert_eq!(sound(&bench), loaded);
    assert!(!bench.saved.chosen().changed);
    undo(&mut harness);
    assert_eq!(sound(&bench), start);
    assert_eq!(bench.saved.chosen().key, "");
    undo(&mut harness);
    assert_eq!(sound(&bench), start);
    click(&mut harness, "Redo");
    assert_eq!(sound(&bench), loaded);
    harness.key_press_modifiers(Modifiers::COMMAND | Modifiers::SHIFT, Key::Z);
    harness.run_steps(2);
    assert_eq!(sound(&bench), turned);
}

#[test]
fn sides_keep_their_own_sound() {
    let bench = Bench::new("chimes");
    let mut harness = bench.harness();
    let a = sound(&bench);
    click(&mut harness, "Side B");
    assert_eq!(
        sound(&bench),
        a,
        "a side that was never heard begins as the other"
    );
    click(&mut harness, "Next preset");
    let b = sound(&bench);
    assert_ne!(a, b);
    click(&mut harness, "Side A");
    assert_eq!(sound(&bench), a);
    click(&mut harness, "Side B");
    assert_eq!(sound(&bench), b);
    click(&mut harness, "Undo");
    assert_eq!(sound(&bench), a);
    click(&mut harness, "Side B");
    assert_eq!(sound(&bench), b);
    click(&mut harness, "Copy to the other side");
    click(&mut harness, "Side A");
    assert_eq!(sound(&bench), b);
}

#[test]
fn a_scale_goes_with_its_preset_and_the_song_s_own_stays() {
    let bench = Bench::new("chimes");
    let mut harness = bench.harness();
    let song = "song\n1\n1200.0\n";
    bench.controls.tuning().set_scale(song.to_owned());
    click(&mut harness, "Next preset");
    assert_eq!(bench.controls.tuning().scale(), song);
    click(&mut harness, "Presets");
    click(&mut harness, "Five steps");
    let five = &named("Five steps").sound.scala.scale;
    assert_eq!(bench.controls.tuning().scale(), *five);
    click(&mut harness, "Felt evening");
    assert_eq!(bench.controls.tuning().scale(), "");
    click(&mut harness, "Undo");
    assert_eq!(bench.controls.tuning().scale(), *five);
    click(&mut harness, "Undo");
    assert_eq!(bench.controls.tuning().scale(), song);
}

#[test]
fn init_is_a_new_instance_on_the_same_instrument() {
    let bench = Bench::new("vibraphone");
    bench.set("alpha2", 0.5);
    bench.set("bend", 0.9);
    let bend = bench.text("bend");
    let mut harness = bench.harness();
    click(&mut harness, "Preset menu");
    click(&mut harness, "Init");
    assert_eq!(bench.text("instr"), "Vibraphone");
    assert_eq!(bench.value("alpha2").0, bench.value("alpha2").1);
    assert_eq!(bench.text("bend"), bend, "hands are the player's");
}

#[test]
fn what_was_done_outlives_the_window() {
    let bench = Bench::new("chimes");
    let mut harness = bench.harness();
    let start = sound(&bench);
    click(&mut harness, "Next preset");
    drop(harness);
    bench.reopen();
    let mut harness = bench.harness();
    click(&mut harness, "Undo");
    assert_eq!(sound(&bench), start);
}
