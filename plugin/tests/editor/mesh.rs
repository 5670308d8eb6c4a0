//! The sheet on which a mesh becomes an instrument.

use crate::bench::Bench;
use crate::looks::{USUAL, draw};
use crate::picture::check;
use egui_kittest::Harness;
use egui_kittest::kittest::Queryable as _;
use idiophone::shelf::Library;
use modes::solid::{gallery, write_obj};
use std::fs;
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};
use tempfile::TempDir;

/// A folder of banks with a star's mesh in it, given to an editor.
fn give(bench: &Bench) -> (TempDir, PathBuf) {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("star.obj");
    fs::write(&file, write_obj(&gallery::star(5, 100.0, 20.0))).unwrap();
    let library = Library::new(Some(folder.path().to_path_buf()));
    assert!(library.refresh());
    bench.ui.borrow_mut().instruments().set_library(library);
    (folder, file)
}

fn open(bench: &Bench, path: &Path) {
    bench.ui.borrow_mut().instruments().open(path.to_path_buf());
}

/// An editor with a file on the sheet.
fn sheet<'a>(bench: &'a Bench, file: &Path) -> Harness<'a> {
    let mut harness = bench.harness();
    open(bench, file);
    let name = file.file_name().unwrap().to_str().unwrap();
    wait(&mut harness, &format!("{name}: "));
    harness
}

fn click(harness: &mut Harness<'_>, label: &str) {
    harness.get_by_label(label).click();
    harness.run_steps(3);
}

/// Steps on until there is a label with that in it.
fn wait(harness: &mut Harness<'_>, label: &str) {
    let start = Instant::now();
    while harness.query_by_label_contains(label).is_none() {
        assert!(start.elapsed() < Duration::from_secs(120), "no {label}");
        std::thread::sleep(Duration::from_millis(5));
        harness.step();
    }
    harness.run_steps(3);
}

#[test]
fn a_mesh_of_the_folder_is_built_listed_and_plays() {
    let bench = Bench::new("chimes");
    let (folder, _) = give(&bench);
    let mut harness = bench.harness();
    click(&mut harness, "Instrument");
    click(&mut harness, "star (mesh)");
    wait(&mut harness, "star.obj: ");
    click(&mut harness, "Preview");
    click(&mut harness, "Build");
    wait(&mut harness, "It plays");
    assert_eq!(bench.text("instr"), "Your own");
    assert!(!bench.host.said().is_empty(), "the host knows of it");
    let own = bench.controls.shelf().own().unwrap();
    assert_eq!(own.title(), "star");
    // In file units of 1 mm, it is as long as it was drawn.
    let recipe = &own.bank().provenance.recipe;
    assert!(
        recipe.contains("size_m = 0.19") || recipe.contains("size_m = 0.2"),
        "{recipe}"
    );
    assert!(folder.path().join("star.bank").is_file());
    click(&mut harness, "Close");
    assert!(harness.query_by_label("Build").is_none());
    bench.ui.borrow_mut().instruments().library().refresh();
    let entries = bench.ui.borrow_mut().instruments().library().entries();
    assert_eq!(entries.len(), 1, "and is in the list from now on");
}

#[test]
fn a_build_that_is_cancelled_leaves_what_plays() {
    let bench = Bench::new("chimes");
    let (folder, file) = give(&bench);
    let mut harness = sheet(&bench, &file);
    click(&mut harness, "Build");
    click(&mut harness, "Cancel");
    wait(&mut harness, "Given up");
    assert!(bench.controls.shelf().own().is_none());
    assert!(!folder.path().join("star.bank").exists());
}

#[test]
fn a_preview_plays_on_when_full_quality_is_given_up_until_one_goes_on() {
    let bench = Bench::new("chimes");
    let (folder, file) = give(&bench);
    let mut harness = sheet(&bench, &file);
    click(&mut harness, "Build");
    wait(&mut harness, "The preview sounds");
    click(&mut harness, "Cancel");
    wait(&mut harness, "The preview plays");
    assert_eq!(bench.text("instr"), "Your own");
    assert_eq!(bench.controls.shelf().own().unwrap().title(), "star");
    assert!(!folder.path().join("star.bank").exists());
    click(&mut harness, "Close");
    assert!(harness.query_by_label("Build").is_none());
    click(&mut harness, "Go on to full quality");
    wait(&mut harness, "The preview sounds");
    assert!(harness.query_by_label("Go on to full quality").is_none());
    click(&mut harness, "Cancel");
    wait(&mut harness, "The preview plays");
}

#[test]
fn a_mesh_that_is_refused_is_shown_with_its_reason() {
    let bench = Bench::new("chimes");
    let (folder, _) = give(&bench);
    let mut harness = bench.harness();
    let sheet = folder.path().join("sheet.obj");
    fs::write(&sheet, "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n").unwrap();
    open(&bench, &sheet);
    wait(&mut harness, "sheet.obj: 2 triangles");
    click(&mut harness, "Build");
    wait(&mut harness, "a solid has at least four");
    open(&bench, &folder.path().join("nothing.obj"));
    wait(&mut harness, "cannot read the mesh");
}

/// A ball beside the star, and a file of three boxes.
fn give_more(folder: &TempDir) -> [PathBuf; 2] {
    [
        ("ball.obj", gallery::sphere(40.0, 3)),
        ("boxes.obj", gallery::stack(3, 50.0)),
    ]
    .map(|(name, soup)| {
        let file = folder.path().join(name);
        fs::write(&file, write_obj(&soup)).unwrap();
        file
    })
}

/// Puts a further mesh onto the sheet, the one of that stem in the folder.
fn add(harness: &mut Harness<'_>, bench: &Bench, path: &Path) {
    bench.ui.borrow_mut().instruments().add(path.to_path_buf());
    let name = path.file_name().unwrap().to_str().unwrap();
    wait(harness, &format!("{name}: "));
}

/// Keys of the bodies that play, and what each is made of.
fn played(bench: &Bench) -> Vec<(u8, f64)> {
    let own = bench.controls.shelf().own().unwrap();
    let bank = own.bank();
    let density = |body| bank.matter_of(body).material.density_kg_m3;
    let bodies = bank.bodies.iter();
    bodies.map(|body| (body.key, density(body))).collect()
}

#[test]
fn two_meshes_of_two_materials_share_the_keys() {
    let bench = Bench::new("chimes");
    let (folder, file) = give(&bench);
    let [ball, _] = give_more(&folder);
    let mut harness = sheet(&bench, &file);
    add(&mut harness, &bench, &ball);
    click(&mut harness, "Material");
    click(&mut harness, "glass");
    click(&mut harness, "Preview");
    click(&mut harness, "Build");
    wait(&mut harness, "It plays");
    let own = bench.controls.shelf().own().unwrap();
    assert_eq!(own.title(), "star kit");
    assert!(folder.path().join("star-kit.bank").is_file());
    let named = |name| modes::Material::named(name).unwrap().density_kg_m3;
    let expected = (36..=96).map(|key| {
        let material = if key <= 65 { "bell bronze" } else { "glass" };
        (key, named(material))
    });
    assert_eq!(played(&bench), expected.collect::<Vec<_>>());
    // The one that is taken away leaves its keys to the other.
    click(&mut harness, "C2–F4  star");
    let remove = harness.get_all_by_label("Remove").next().unwrap();
    remove.click();
    harness.run_steps(3);
    click(&mut harness, "Build");
    wait(&mut harness, "It plays");
    assert_eq!(played(&bench).len(), 61);
    assert!(
        played(&bench)
            .iter()
            .all(|(_, density)| *density == named("glass"))
    );
}

#[test]
fn objects_of_one_file_become_drums() {
    let bench = Bench::new("chimes");
    let (folder, _) = give(&bench);
    let [_, boxes] = give_more(&folder);
    let mut harness = sheet(&bench, &boxes);
    click(&mut harness, "3 objects, 3 bodies");
    click(&mut harness, "Preview");
    click(&mut harness, "Build");
    wait(&mut harness, "It plays");
    let own = bench.controls.shelf().own().unwrap();
    let bodies = &own.bank().bodies;
    let keys: Vec<u8> = bodies.iter().map(|body| body.key).collect();
    assert_eq!(keys, [36, 37, 38]);
    // Each 0.1 of the first's edge larger than the one before, and as much lower.
    let hz = |i: usize| bodies[i].modes[0].hz;
    assert!(
        (hz(0) / hz(1) / 1.1 - 1.0).abs() < 0.01,
        "{} {}",
        hz(0),
        hz(1)
    );
    assert!(
        (hz(0) / hz(2) / 1.2 - 1.0).abs() < 0.01,
        "{} {}",
        hz(0),
        hz(2)
    );
}

#[test]
fn bodies_that_would_share_a_key_are_refused_with_the_cure() {
    let bench = Bench::new("chimes");
    let (folder, file) = give(&bench);
    let [ball, _] = give_more(&folder);
    let mut harness = sheet(&bench, &file);
    add(&mut harness, &bench, &ball);
    harness.get_by_label("Lowest key").set_value_accesskit(50.0);
    harness.run_steps(3);
    click(&mut harness, "Build");
    wait(&mut harness, "no two pieces share a key");
}

#[test]
fn the_sheet_of_a_kit_looks_so() {
    let bench = Bench::new("chimes");
    let (folder, file) = give(&bench);
    let [ball, boxes] = give_more(&folder);
    let mut harness = sheet(&bench, &file);
    add(&mut harness, &bench, &ball);
    add(&mut harness, &bench, &boxes);
    drop(harness);
    check("mesh-kit", &draw(&bench, USUAL, 1.0, None));
}

#[test]
fn the_sheet_looks_so() {
    let bench = Bench::new("chimes");
    let (_folder, file) = give(&bench);
    let harness = sheet(&bench, &file);
    drop(harness);
    check("mesh-sheet", &draw(&bench, USUAL, 1.0, None));
}
