//! The user's own presets: saved, renamed, deleted, taken in, marked, and broken.

use crate::bench::Bench;
use crate::presets::{click, type_text};
use egui::{Key, Modifiers, Role};
use egui_kittest::Harness;
use egui_kittest::kittest::Queryable as _;
use std::fs;
use std::path::{Path, PathBuf};
use tempfile::TempDir;

/// A bench with a user's folder.
fn at_home() -> (Bench, TempDir) {
    let home = tempfile::tempdir().unwrap();
    let bench = Bench::new("chimes");
    let folder = Some(home.path().to_owned());
    bench.ui.borrow_mut().keep_presets_in(folder);
    (bench, home)
}

fn presets(home: &Path) -> PathBuf {
    home.join("Presets")
}

/// Puts a text in the place of what is in a field.
fn fill(harness: &mut Harness<'_>, field: &str, text: &str) {
    harness.get_by_label(field).focus();
    harness.run_steps(2);
    harness.key_press_modifiers(Modifiers::COMMAND, Key::A);
    harness.run_steps(2);
    type_text(harness, text);
}

fn save(harness: &mut Harness<'_>, name: &str, tags: &str) {
    click(harness, "Save preset");
    fill(harness, "Name", name);
    fill(harness, "Tags, with commas between", tags);
    let replaces = harness.query_by_label("Replace").is_some();
    click(harness, if replaces { "Replace" } else { "Save" });
}

#[test]
fn a_sound_is_saved_and_found_again() {
    let (bench, home) = at_home();
    bench.set("alpha2", 0.5);
    let value = bench.text("alpha2");
    let mut harness = bench.harness();
    save(&mut harness, "My knock", "dull, short");
    let text = fs::read_to_string(presets(home.path()).join("My knock.toml")).unwrap();
    assert!(text.contains(&format!("alpha2 = \"{value}\"")), "{text}");
    assert!(text.contains("tags = [\"dull\", \"short\"]"), "{text}");
    assert_eq!(bench.saved.chosen().key, "user/My knock.toml");
    harness.run_steps(2);
    assert!(!bench.saved.chosen().changed);
    bench.set("alpha2", 0.1);
    harness.run_steps(2);
    assert!(bench.saved.chosen().changed);
    click(&mut harness, "My knock");
    assert_eq!(bench.text("alpha2"), value);
    save(&mut harness, "My knock", "longer");
    assert_eq!(fs::read_dir(presets(home.path())).unwrap().count(), 1);
}

#[test]
fn one_s_own_may_be_called_as_a_factory_s() {
    let (bench, _home) = at_home();
    bench.set("alpha2", 0.5);
    let value = bench.text("alpha2");
    let mut harness = bench.harness();
    save(&mut harness, "Brass clapper", "a");
    click(&mut harness, "Shelf My presets");
    click(&mut harness, "Brass clapper");
    assert_eq!(bench.text("alpha2"), value);
    click(&mut harness, "Shelf All presets");
    let both = harness.query_all_by_role_and_label(Role::Button, "Brass clapper");
    let second = both.max_by(|a, b| a.rect().top().total_cmp(&b.rect().top()));
    second.unwrap().click();
    harness.run_steps(3);
    assert_eq!(bench.saved.chosen().key, "factory/Brass clapper");
    assert_eq!(bench.value("alpha2").0, bench.value("alpha2").1);
}

#[test]
fn a_preset_is_renamed_deleted_and_marked() {
    let (bench, home) = at_home();
    let mut harness = bench.harness();
    save(&mut harness, "One", "a");
    click(&mut harness, "Mark One");
    let marked = || fs::read_to_string(home.path().join("favourites.txt")).unwrap();
    assert_eq!(marked(), "user/One.toml\n");
    click(&mut harness, "Rename…");
    fill(&mut harness, "Name", "Two");
    click(&mut harness, "Rename");
    assert!(presets(home.path()).join("Two.toml").is_file());
    assert_eq!(bench.saved.chosen().key, "user/Two.toml");
    assert_eq!(marked(), "user/Two.toml\n");
    click(&mut harness, "Delete…");
    assert!(
        presets(home.path()).join("Two.toml").is_file(),
        "not before it is confirmed"
    );
    click(&mut harness, "Delete");
    assert!(!presets(home.path()).join("Two.toml").exists());
    assert!(presets(home.path()).join("Deleted/Two.toml").is_file());
    let line = harness.query_by_role_and_label(Role::Button, "Two");
    assert!(line.is_none());
}

#[test]
fn files_come_in_and_go_out() {
    let (bench, home) = at_home();
    let from = home.path().join("afar.toml");
    fs::write(&from, "name = \"Afar\"\n[sound]\nalpha2 = \"3 1/s\"\n").unwrap();
    let mut harness = bench.harness();
    click(&mut harness, "Preset menu");
    click(&mut harness, "Import…");
    fill(&mut harness, "File to import", from.to_str().unwrap());
    click(&mut harness, "Import");
    click(&mut harness, "Afar");
    assert_eq!(bench.text("alpha2"), "3.00 1/s");
    let to = home.path().join("out/of here.toml");
    click(&mut harness, "Export…");
    fill(&mut harness, "File to write", to.to_str().unwrap());
    click(&mut harness, "Export");
    assert_eq!(fs::read(&to).unwrap(), fs::read(&from).unwrap());
    click(&mut harness, "Import…");
    fill(&mut harness, "File to import", "/nowhere/at all.toml");
    click(&mut harness, "Import");
    assert!(
        harness.query_by_label("File to import").is_some(),
        "it stays open"
    );
}

#[test]
fn a_broken_file_is_listed_with_its_reason() {
    let (bench, home) = at_home();
    fs::create_dir_all(presets(home.path())).unwrap();
    fs::write(
        presets(home.path()).join("Odd.toml"),
        "name = \"Odd\"\nsound = 3\n",
    )
    .unwrap();
    let mut harness = bench.harness();
    click(&mut harness, "Presets");
    let before = bench.saved.chosen();
    bench.host.said();
    click(&mut harness, "Odd.toml");
    assert_eq!(bench.saved.chosen(), before);
    assert_eq!(bench.host.said(), []);
    assert!(
        harness
            .query_by_label_contains("Odd.toml, line 2: ")
            .is_some()
    );
    assert!(harness.query_by_label_contains("write [sound]").is_some());
    assert!(presets(home.path()).join("Odd.toml").is_file());
}

#[test]
fn a_preset_that_is_gone_is_named_and_its_sound_stays() {
    let (bench, home) = at_home();
    let mut harness = bench.harness();
    save(&mut harness, "One", "a");
    fs::remove_file(presets(home.path()).join("One.toml")).unwrap();
    harness.key_press(Key::Escape);
    harness.run_steps(2);
    click(&mut harness, "Presets");
    assert!(harness.query_by_label_contains("not here now").is_some());
    assert!(
        harness.query_by_label("Delete…").is_none(),
        "there is no file"
    );
    assert_eq!(bench.saved.chosen().key, "user/One.toml");
}
