//! How the browser of presets looks.

use crate::bench::Bench;
use crate::looks::{USUAL, draw};
use crate::picture::check;
use egui::Pos2;
use idiophone::editor::{Chosen, LEAST_SIZE};
use std::fs;
use std::path::Path;

/// A bench with presets of the user's own: one good, one broken, one marked.
fn shelves(home: &Path, instrument: &str) -> Bench {
    let bench = Bench::new(instrument);
    let folder = home.join("Presets");
    fs::create_dir_all(&folder).unwrap();
    let text = "name = \"Kitchen at dawn\"\ncategory = \"Natural\"\ntags = [\"soft\", \"morning\"]\nauthor = \"Ada\"\n\
                about = \"Spoons before anyone is up.\"\n\n[sound]\ninstr = \"Metal bowls\"\nwarp = \"3 x\"\n";
    fs::write(folder.join("Kitchen at dawn.toml"), text).unwrap();
    fs::write(folder.join("Torn.toml"), "name = \"Torn\n[sound]\n").unwrap();
    let marked = "factory/Slow fans\nuser/Kitchen at dawn.toml\n";
    fs::write(home.join("favourites.txt"), marked).unwrap();
    bench.ui.borrow_mut().keep_presets_in(Some(home.to_owned()));
    bench
}

fn choose(bench: &Bench, key: &str) {
    bench.saved.choose(Chosen {
        key: key.to_owned(),
        ..Default::default()
    });
}

/// The middle of the button to save, in the header of a usual window.
const SAVE: Pos2 = Pos2::new(600.0, 22.0);
/// The middle of the preset's name in the header of a usual window.
const NAME: Pos2 = Pos2::new(400.0, 22.0);

#[test]
fn a_browser_in_a_dim_room() {
    let home = tempfile::tempdir().unwrap();
    let bench = shelves(home.path(), "vibraphone");
    choose(&bench, "factory/Slow fans");
    let drawn = draw(&bench, USUAL, 1.0, Some((NAME, true)));
    check("browser", &drawn);
}

#[test]
fn a_browser_in_a_bright_room_on_a_fine_screen() {
    let home = tempfile::tempdir().unwrap();
    let bench = shelves(home.path(), "metal-bowls");
    bench.saved.set_dark(false);
    choose(&bench, "user/Kitchen at dawn.toml");
    let drawn = draw(&bench, USUAL, 2.0, Some((NAME, true)));
    check("browser-light-2x", &drawn);
}

#[test]
fn a_browser_in_the_least_window() {
    let home = tempfile::tempdir().unwrap();
    let bench = shelves(home.path(), "chimes");
    let name = Pos2::new(240.0, 22.0);
    check(
        "browser-least",
        &draw(&bench, LEAST_SIZE, 1.0, Some((name, true))),
    );
}

#[test]
fn a_preset_about_to_be_saved() {
    let home = tempfile::tempdir().unwrap();
    let bench = shelves(home.path(), "vibraphone");
    choose(&bench, "factory/Slow fans");
    check(
        "browser-saving",
        &draw(&bench, USUAL, 1.0, Some((SAVE, true))),
    );
}
