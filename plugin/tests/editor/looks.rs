//! How the window looks.

use crate::bench::Bench;
use crate::picture::check;
use crate::raster::{Pixels, Raster};
use egui::{Context, Event, Modifiers, PointerButton, Pos2, RawInput, Rect, ViewportId, vec2};
use nice_plug::prelude::ParamSetter;

/// Draws a window of `size` points after the pointer has come to a place and, if so said, clicked there.
fn draw(bench: &Bench, size: [f32; 2], scale: f32, pointer: Option<(Pos2, bool)>) -> Pixels {
    let context = Context::default();
    let mut raster = Raster::default();
    let mut drawn = None;
    // Sizes settle, and what moves comes to rest.
    for step in 0..5u8 {
        let mut input = RawInput {
            screen_rect: Some(Rect::from_min_size(Pos2::ZERO, size.into())),
            time: Some(f64::from(step) / 60.0),
            events: events(step, pointer),
            ..RawInput::default()
        };
        if let Some(info) = input.viewports.get_mut(&ViewportId::ROOT) {
            info.native_pixels_per_point = Some(scale);
        }
        let mut out = context.run_ui(input, |ui| {
            let setter = ParamSetter::new(&*bench.host);
            bench.ui.borrow_mut().show(ui, &setter);
        });
        raster.load(&out.textures_delta);
        out.textures_delta.clear();
        let primitives = context.tessellate(out.shapes, out.pixels_per_point);
        let pixels = size.map(|side| (side * scale) as usize);
        drawn = Some((primitives, pixels));
    }
    let (primitives, pixels) = drawn.unwrap();
    raster.draw(&primitives, pixels, scale)
}

/// What the pointer does at a step: comes, presses, and lets go.
fn events(step: u8, pointer: Option<(Pos2, bool)>) -> Vec<Event> {
    match (step, pointer) {
        (0, Some((pos, _))) => vec![Event::PointerMoved(pos)],
        (1 | 2, Some((pos, true))) => vec![Event::PointerButton {
            pos,
            button: PointerButton::Primary,
            pressed: step == 1,
            modifiers: Modifiers::NONE,
        }],
        _ => Vec::new(),
    }
}

const USUAL: [f32; 2] = [1000.0, 680.0];

#[test]
fn chimes_at_rest() {
    check(
        "chimes-at-rest",
        &draw(&Bench::new("chimes"), USUAL, 1.0, None),
    );
}

#[test]
fn a_vibraphone_that_rings() {
    let bench = Bench::new("vibraphone");
    bench.ring(
        "vibraphone",
        &[(48, 0.9), (55, 0.8), (64, 0.8), (71, 0.8), (74, 0.9)],
        0.15,
    );
    check("vibraphone-rings", &draw(&bench, USUAL, 1.0, None));
}

#[test]
fn the_same_on_a_fine_screen() {
    let bench = Bench::new("vibraphone");
    bench.ring(
        "vibraphone",
        &[(48, 0.9), (55, 0.8), (64, 0.8), (71, 0.8), (74, 0.9)],
        0.15,
    );
    check("vibraphone-rings-2x", &draw(&bench, USUAL, 2.0, None));
}

#[test]
fn bowls_in_a_bright_room() {
    let bench = Bench::new("singing-bowls");
    bench.saved.set_dark(false);
    bench.ring("singing-bowls", &[(52, 0.9), (60, 0.9)], 0.2);
    check("singing-bowls-light", &draw(&bench, USUAL, 1.0, None));
}

#[test]
fn the_least_window() {
    let bench = Bench::new("tubular-bells");
    bench.ring("tubular-bells", &[(60, 1.0)], 0.05);
    let least = idiophone::editor::LEAST_SIZE;
    check("tubular-bells-least", &draw(&bench, least, 1.0, None));
}

#[test]
fn a_partial_that_is_pointed_at() {
    let bench = Bench::new("chimes");
    bench.ring("chimes", &[(72, 1.0)], 0.1);
    let at = Pos2::ZERO + vec2(205.0, 450.0);
    check(
        "chimes-partial-2x",
        &draw(&bench, USUAL, 2.0, Some((at, false))),
    );
}

#[test]
fn causes_of_damping_have_their_colours() {
    let bench = Bench::new("vibraphone");
    bench.set("alpha1", 0.4);
    bench.set("tanphi", 0.5);
    bench.ring("vibraphone", &[(60, 1.0)], 0.1);
    let tab = Pos2::ZERO + vec2(577.0, 305.0);
    let drawn = draw(&bench, USUAL, 1.0, Some((tab, true)));
    check("vibraphone-damping", &drawn);
}

/// A bench with presets of the user's own: one good, one broken, one marked.
fn shelves(home: &std::path::Path, instrument: &str) -> Bench {
    let bench = Bench::new(instrument);
    let folder = home.join("Presets");
    std::fs::create_dir_all(&folder).unwrap();
    let text = "name = \"Kitchen at dawn\"\ncategory = \"Natural\"\ntags = [\"soft\", \"morning\"]\nauthor = \"Ada\"\n\
                about = \"Spoons before anyone is up.\"\n\n[sound]\ninstr = \"Metal bowls\"\nwarp = \"3 x\"\n";
    std::fs::write(folder.join("Kitchen at dawn.toml"), text).unwrap();
    std::fs::write(folder.join("Torn.toml"), "name = \"Torn\n[sound]\n").unwrap();
    let marked = "factory/Slow fans\nuser/Kitchen at dawn.toml\n";
    std::fs::write(home.join("favourites.txt"), marked).unwrap();
    bench.ui.borrow_mut().keep_presets_in(Some(home.to_owned()));
    bench
}

fn choose(bench: &Bench, key: &str) {
    bench.saved.choose(idiophone::editor::Chosen {
        key: key.to_owned(),
        ..Default::default()
    });
}

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
    let least = idiophone::editor::LEAST_SIZE;
    let name = Pos2::new(240.0, 22.0);
    check(
        "browser-least",
        &draw(&bench, least, 1.0, Some((name, true))),
    );
}

#[test]
fn a_preset_about_to_be_saved() {
    let home = tempfile::tempdir().unwrap();
    let bench = shelves(home.path(), "vibraphone");
    choose(&bench, "factory/Slow fans");
    let save = Pos2::new(SAVE_X, 22.0);
    check(
        "browser-saving",
        &draw(&bench, USUAL, 1.0, Some((save, true))),
    );
}

/// The middle of the button to save, there.
const SAVE_X: f32 = 600.0;
