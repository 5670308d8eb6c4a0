//! How the window looks.

use crate::bench::Bench;
use crate::own::Folder;
use crate::picture::check;
use crate::raster::{Pixels, Raster};
use egui::{Context, Event, Modifiers, PointerButton, Pos2, RawInput, Rect, ViewportId, vec2};
use idiophone::engine::Trim;
use idiophone::notices::{Cure, Notice, Subject};
use nice_plug::prelude::ParamSetter;

/// Draws a window of `size` points after the pointer has come to a place and, if so said, clicked there.
pub(crate) fn draw(
    bench: &Bench,
    size: [f32; 2],
    scale: f32,
    pointer: Option<(Pos2, bool)>,
) -> Pixels {
    let context = Context::default();
    bench.ui.borrow_mut().undress();
    // Lists are there at once.
    context.all_styles_mut(|style| style.animation_time = 0.0);
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

pub(crate) const USUAL: [f32; 2] = [1000.0, 680.0];

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
    let at = Pos2::ZERO + vec2(192.0, 540.0);
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
    let tab = Pos2::ZERO + vec2(581.0, 219.0);
    let drawn = draw(&bench, USUAL, 1.0, Some((tab, true)));
    check("vibraphone-damping", &drawn);
}

/// The window after a click on a tab.
fn leaf(bench: &Bench, size: [f32; 2], scale: f32, tab: Pos2) -> Pixels {
    draw(bench, size, scale, Some((tab, true)))
}

#[test]
fn why_it_ends_and_what_the_mallet_does() {
    let bench = Bench::new("vibraphone");
    bench.set("alpha1", 0.4);
    bench.set("tanphi", 0.5);
    bench.set("alpha2", 0.3);
    bench.ring("vibraphone", &[(60, 0.9)], 0.1);
    let decay = Pos2::ZERO + vec2(101.0, 463.0);
    check("vibraphone-decay", &leaf(&bench, USUAL, 1.0, decay));
    check("vibraphone-decay-2x", &leaf(&bench, USUAL, 2.0, decay));
    let blow = Pos2::ZERO + vec2(155.0, 463.0);
    check("vibraphone-blow", &leaf(&bench, USUAL, 1.0, blow));
    check("vibraphone-blow-2x", &leaf(&bench, USUAL, 2.0, blow));
}

#[test]
fn what_has_been_heard() {
    let bench = Bench::new("singing-bowls");
    for key in [55, 57, 60, 62, 64, 67] {
        bench.ring("singing-bowls", &[(key, 0.9)], 0.6);
        draw(&bench, USUAL, 1.0, None);
    }
    let tab = Pos2::ZERO + vec2(215.0, 463.0);
    check("singing-bowls-spectrum", &leaf(&bench, USUAL, 1.0, tab));
    check("singing-bowls-spectrum-2x", &leaf(&bench, USUAL, 2.0, tab));
}

#[test]
fn one_mode_alone_with_its_nodal_lines() {
    let bench = Bench::new("singing-bowls");
    let label = |name: &str| {
        let bank = idiophone::factory::bank(3);
        let modes = bank.bodies[12].modes.iter();
        modes
            .map(|mode| mode.label)
            .find(|label| label.to_string() == name)
    };
    bench
        .controls
        .trims()
        .change(|trims| trims.set_solo(label("shell (3,0) a")));
    bench.ring("singing-bowls", &[(60, 0.9)], 0.2);
    check("singing-bowls-mode", &draw(&bench, USUAL, 1.0, None));
    check("singing-bowls-mode-2x", &draw(&bench, USUAL, 2.0, None));
}

#[test]
fn trimmed_partials() {
    let bench = Bench::new("vibraphone");
    let modes = &idiophone::factory::bank(1).bodies[24].modes;
    bench.controls.trims().change(|trims| {
        for (mode, (level_db, ringing)) in modes.iter().zip([(-9.0, 2.0), (6.0, 0.5)]) {
            assert!(trims.set(&mode.label, Trim { level_db, ringing }));
        }
    });
    bench.ring("vibraphone", &[(60, 0.9)], 0.1);
    check("vibraphone-trimmed", &draw(&bench, USUAL, 1.0, None));
    check("vibraphone-trimmed-2x", &draw(&bench, USUAL, 2.0, None));
}

#[test]
fn a_wide_window() {
    let bench = Bench::new("singing-bowls");
    bench.ring("singing-bowls", &[(60, 0.9)], 0.2);
    check(
        "singing-bowls-wide",
        &draw(&bench, [1920.0, 1080.0], 1.0, None),
    );
}

#[test]
fn the_list_of_instruments_and_what_a_song_lacks() {
    let (bench, folder) = (Bench::new("chimes"), Folder::new("looks"));
    let _library = folder.give(&bench);
    bench.controls.notices().post(Notice {
        subject: Subject::Bank,
        text: "The song's own instrument cannot be read: \"A bell of mine\" is kept as of layout 2, and the \
               newest that this version reads is 1; update Idiophone. The song keeps it as it is."
            .to_owned(),
        cure: Some(Cure::Load("A bell of mine".to_owned())),
    });
    let list = Pos2::ZERO + vec2(240.0, 22.0);
    let drawn = draw(&bench, USUAL, 1.0, Some((list, true)));
    check("chimes-list", &drawn);
}
