//! Files that are dragged over the window and dropped.

use crate::bench::Bench;
use crate::looks::USUAL;
use crate::own::Folder;
use crate::picture::check;
use egui::{DroppedFile, HoveredFile, Modifiers, RawInput, Rect, ViewportId};
use egui_kittest::Harness;
use egui_kittest::kittest::Queryable as _;
use idiophone::editor::Raster;
use idiophone::notices::Subject;
use modes::solid::{gallery, write_obj};
use nice_plug::prelude::ParamSetter;
use std::fs;
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::time::{Duration, Instant};
use tempfile::TempDir;

const FIFTHS: &str = "fifths.scl\n2\n3/2\n2/1\n";
/// Only the seven white keys play.
const WHITE: &str = "12\n0\n127\n60\n69\n440.0\n12\n0\nx\n2\nx\n4\n5\nx\n7\nx\n9\nx\n11\n";

#[derive(Debug)]
struct File(PathBuf);

impl DroppedFile for File {
    fn path(&self) -> &Path {
        &self.0
    }

    fn bytes(&self) -> Result<Vec<u8>, String> {
        fs::read(&self.0).map_err(|error| error.to_string())
    }
}

fn hover(harness: &mut Harness<'_>, files: &[PathBuf]) {
    let hovered = files.iter().map(|path| HoveredFile {
        path: Some(path.clone()),
        ..HoveredFile::default()
    });
    harness.input_mut().hovered_files = hovered.collect();
    harness.run_steps(2);
}

fn drop_files(harness: &mut Harness<'_>, files: &[PathBuf]) {
    let dropped = files.iter().cloned().map(|path| Arc::new(File(path)) as _);
    let input = harness.input_mut();
    input.hovered_files.clear();
    input.dropped_files = dropped.collect();
    harness.step();
    harness.input_mut().dropped_files.clear();
    harness.run_steps(3);
}

/// A folder that is not the user's, with a file in it.
fn elsewhere(name: &str, content: &str) -> (TempDir, PathBuf) {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join(name);
    fs::write(&file, content).unwrap();
    (folder, file)
}

fn star() -> String {
    write_obj(&gallery::star(5, 100.0, 20.0))
}

/// Steps on until there is a label with that in it.
fn wait(harness: &mut Harness<'_>, label: &str) {
    let start = Instant::now();
    while harness.query_by_label_contains(label).is_none() {
        assert!(start.elapsed() < Duration::from_secs(60), "no {label}");
        std::thread::sleep(Duration::from_millis(5));
        harness.step();
    }
}

/// What is said of the files that were dropped last.
fn said(bench: &Bench) -> Option<String> {
    let notices = bench.controls.notices().all();
    let dropped = notices
        .into_iter()
        .find(|notice| notice.subject == Subject::Dropped);
    dropped.map(|notice| notice.text)
}

#[test]
fn a_mesh_that_hovers_is_promised_and_comes_onto_the_sheet_when_it_is_dropped() {
    let bench = Bench::new("chimes");
    let (_folder, file) = elsewhere("star.obj", &star());
    let mut harness = bench.harness();
    let promise = "Drop to make an instrument of star.obj";
    hover(&mut harness, std::slice::from_ref(&file));
    assert!(harness.query_by_label(promise).is_some());
    hover(&mut harness, &[]);
    assert!(harness.query_by_label(promise).is_none(), "it has left");
    assert!(harness.query_by_label("Build").is_none());
    hover(&mut harness, std::slice::from_ref(&file));
    drop_files(&mut harness, &[file]);
    assert!(harness.query_by_label(promise).is_none());
    wait(&mut harness, "star.obj: ");
    assert!(harness.query_by_label("Build").is_some());
    assert_eq!(said(&bench), None);
}

#[test]
fn several_meshes_that_are_dropped_become_a_kit() {
    let bench = Bench::new("chimes");
    let folder = Folder::new("kit");
    folder.give(&bench);
    let (elsewhere, star) = elsewhere("star.obj", &star());
    let at = |name: &str, content: &str| {
        let file = elsewhere.path().join(name);
        fs::write(&file, content).unwrap();
        file
    };
    let ball = at("ball.obj", &write_obj(&gallery::sphere(120.0, 3)));
    let files = [star, at("broken.obj", "f 1 2 3\n"), ball];
    let mut harness = bench.harness();
    hover(&mut harness, &files);
    let promise = "Drop to make a kit of star.obj and 2 more";
    assert!(harness.query_by_label(promise).is_some());
    drop_files(&mut harness, &files);
    wait(&mut harness, "C2  star");
    wait(&mut harness, "C#2  ball");
    assert!(harness.query_by_label_contains("broken.obj").is_some());
    harness.run_steps(3);
    for button in ["Preview", "Build"] {
        harness.get_by_label(button).click();
        harness.run_steps(3);
    }
    wait(&mut harness, "It plays");
    let own = bench.controls.shelf().own().unwrap();
    let keys: Vec<u8> = own.bank().bodies.iter().map(|body| body.key).collect();
    assert_eq!(keys, [36, 37]);
    // A further drop is a new sheet.
    drop_files(&mut harness, &files[2..]);
    wait(&mut harness, "ball.obj: ");
    assert!(harness.query_by_label_contains("C2  star").is_none());
    assert!(harness.query_by_label_contains("broken.obj").is_none());
}

#[test]
fn of_several_banks_the_first_plays_and_all_lie_in_the_folder() {
    let bench = Bench::new("oak-bowls");
    let folder = Folder::new("dropped");
    let library = folder.give(&bench);
    let elsewhere = tempfile::tempdir().unwrap();
    let files = ["gong", "cup"].map(|name| {
        let file = elsewhere.path().join(format!("{name}.bank"));
        let mut bank = idiophone::factory::bank(0).clone();
        bank.bodies.truncate(3);
        (bank.name, bank.title) = (name.to_owned(), format!("My {name}"));
        bank.save(&file).unwrap();
        file
    });
    let mut harness = bench.harness();
    drop_files(&mut harness, &files);
    let shelf = bench.controls.shelf();
    assert!(library.serve(shelf).unwrap().is_ok());
    assert!(library.take_in().unwrap().is_empty());
    harness.run_steps(3);
    assert_eq!(bench.text("instr"), "Your own");
    assert_eq!(shelf.own().unwrap().title(), "My gong");
    library.refresh();
    for name in ["gong", "cup"] {
        assert!(library.named(name).is_some(), "{name}");
    }
}

#[test]
fn a_scale_and_a_keyboard_map_tune_in_one_step_that_can_be_undone() {
    let bench = Bench::new("chimes");
    let (folder, scale) = elsewhere("fifths.scl", FIFTHS);
    let map = folder.path().join("white.kbm");
    fs::write(&map, WHITE).unwrap();
    let texts = bench.controls.tuning();
    let mut harness = bench.harness();
    let before = texts.tuning();
    drop_files(&mut harness, &[scale, map]);
    assert_eq!([texts.scale(), texts.keyboard()], [FIFTHS, WHITE]);
    assert_eq!(texts.fault(), None);
    assert!(texts.tuning() != before);
    assert!(!bench.host.said().is_empty(), "the host knows of it");
    harness.key_press_modifiers(Modifiers::COMMAND, egui::Key::Z);
    harness.run_steps(2);
    assert_eq!([texts.scale(), texts.keyboard()], ["", ""]);
    assert!(texts.tuning() == before);
    harness.key_press_modifiers(Modifiers::COMMAND, egui::Key::Y);
    harness.run_steps(2);
    assert_eq!([texts.scale(), texts.keyboard()], [FIFTHS, WHITE]);
}

#[test]
fn a_scale_in_old_letters_is_kept_in_new_ones() {
    let bench = Bench::new("chimes");
    let (_folder, scale) = elsewhere("old.scl", "");
    fs::write(&scale, b"Quinte \xfcber alles\n2\n3/2\n2/1\n").unwrap();
    let mut harness = bench.harness();
    drop_files(&mut harness, &[scale]);
    let text = bench.controls.tuning().scale();
    assert_eq!(text, "Quinte \u{fc}ber alles\n2\n3/2\n2/1\n");
}

#[test]
fn a_preset_is_kept_and_loaded() {
    let bench = Bench::new("chimes");
    let home = tempfile::tempdir().unwrap();
    let keep = Some(home.path().to_path_buf());
    bench.ui.borrow_mut().keep_presets_in(keep);
    let first = &idiophone::presets::factory()[0];
    let other = idiophone::presets::factory()
        .iter()
        .find(|preset| preset.sound.wanted().ne(first.sound.wanted()))
        .unwrap();
    let (_folder, file) = elsewhere("other.toml", &other.text());
    let mut harness = bench.harness();
    drop_files(&mut harness, &[file]);
    let kept = fs::read_dir(home.path().join("Presets")).unwrap().count();
    assert_eq!(kept, 1);
    let name = &other.card.name;
    let chosen = bench.saved.chosen();
    assert_eq!(chosen.name(), *name);
    assert!(!chosen.changed);
    assert_eq!(said(&bench), None);
}

#[test]
fn what_is_wrong_with_a_file_is_told_with_its_name_and_a_cure() {
    let bench = Bench::new("chimes");
    let (folder, bad) = elsewhere("bad.scl", "bad\n2\n3/2\n5/0\n");
    let home = tempfile::tempdir().unwrap();
    let keep = Some(home.path().to_path_buf());
    bench.ui.borrow_mut().keep_presets_in(keep);
    let at = |name: &str, content: &str| {
        let file = folder.path().join(name);
        fs::write(&file, content).unwrap();
        file
    };
    let mut harness = bench.harness();
    drop_files(&mut harness, &[bad]);
    let text = said(&bench).unwrap();
    assert!(text.contains("bad.scl: line 4: \"5/0\""), "{text}");
    assert_eq!(bench.controls.tuning().scale(), "", "nothing has changed");
    let photo = at("photo.png", "PNG");
    hover(&mut harness, std::slice::from_ref(&photo));
    assert!(harness.query_by_label_contains("photo.png: ").is_some());
    drop_files(&mut harness, &[photo.clone(), at("notes", "")]);
    let text = said(&bench).unwrap();
    assert!(
        text.starts_with("photo.png: Idiophone reads meshes"),
        "{text}"
    );
    assert!(text.ends_with("and 1 more"), "{text}");
    drop_files(&mut harness, &[folder.path().to_path_buf()]);
    assert!(said(&bench).unwrap().contains("is a folder"));
    drop_files(&mut harness, &[at("odd.toml", "name")]);
    assert!(said(&bench).unwrap().starts_with("odd.toml, line 1: "));
    drop_files(&mut harness, &[at("fifths.scl", FIFTHS)]);
    assert_eq!(said(&bench), None, "that is past");
    assert_eq!(bench.controls.tuning().scale(), FIFTHS);
}

#[test]
fn the_veil_looks_so() {
    let bench = Bench::new("chimes");
    let context = egui::Context::default();
    let mut raster = Raster::default();
    let files = ["bell.obj", "cup.obj", "fifths.scl", "photo.png"];
    let mut drawn = Vec::new();
    for step in 0..3u8 {
        let mut input = RawInput {
            screen_rect: Some(Rect::from_min_size(egui::Pos2::ZERO, USUAL.into())),
            time: Some(f64::from(step) / 60.0),
            hovered_files: files
                .map(|name| HoveredFile {
                    path: Some(Path::new("/elsewhere").join(name)),
                    ..HoveredFile::default()
                })
                .to_vec(),
            ..RawInput::default()
        };
        if let Some(info) = input.viewports.get_mut(&ViewportId::ROOT) {
            info.native_pixels_per_point = Some(1.0);
        }
        let mut out = context.run_ui(input, |ui| {
            let setter = ParamSetter::new(&*bench.host);
            bench.ui.borrow_mut().show(ui, &setter);
        });
        raster.load(&out.textures_delta);
        out.textures_delta.clear();
        drawn = context.tessellate(out.shapes, out.pixels_per_point);
    }
    let pixels = USUAL.map(|side| side as usize);
    check("veil", &raster.draw(&drawn, pixels, 1.0));
}
