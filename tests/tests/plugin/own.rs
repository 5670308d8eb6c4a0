//! Instruments of the user's own travel in songs.

use idiophone::factory;
use idiophone::shelf::{OWN, Own};
use idiophone_tests::{plugin, strike};
use modes::Bank;
use serde_json::{Value, json};
use std::path::Path;
use std::process::Command;
use std::time::{Duration, Instant};
use xtask::host::Plugin;

/// Where the test in a process of its own finds the song and leaves the sound.
const SONG: &str = "IDIOPHONE_TEST_SONG";
const SOUND: &str = "IDIOPHONE_TEST_SOUND";

/// Chimes of brass, which no factory bank has.
fn bell() -> Bank {
    let mut bank = factory::bank(0).clone();
    "bell".clone_into(&mut bank.name);
    "A bell of mine".clone_into(&mut bank.title);
    bank.damping.loss_factor = 2e-3;
    bank.bodies.retain(|body| (60..=72).contains(&body.key));
    bank
}

/// A song with a bank of its own, or with something else in its place.
fn song(plugin: &mut Plugin, bank: &str) -> Value {
    let mut song = plugin.state().unwrap();
    song["params"]["instr"] = json!({"i32": OWN});
    song["fields"]["instrument"] = json!({"name": "own", "title": "Your own"})
        .to_string()
        .into();
    song["fields"]["bank"] = bank.into();
    song
}

fn sound(plugin: &mut Plugin) -> Vec<u8> {
    plugin.activate(48_000.0, 512).unwrap();
    let notes = [strike(62, 0.8).at(0), strike(71, 0.5).at(5000)];
    let take = plugin.play(&notes, 24_000, 512).unwrap();
    plugin.deactivate();
    let samples = take.left.iter().chain(&take.right);
    samples.flat_map(|sample| sample.to_le_bytes()).collect()
}

#[test]
fn a_song_with_its_own_bank_renders_the_same_bits_in_a_fresh_host_without_a_folder() {
    let folder = tempfile::tempdir().unwrap();
    let own = Own::new(bell()).unwrap();
    let mut first = plugin().unwrap();
    let loaded = song(&mut first, own.text());
    first.load_state(&loaded).unwrap();
    let here = sound(&mut first);
    let chimes = sound(&mut plugin().unwrap());
    assert!(here != chimes && here.iter().any(|byte| *byte != 0));
    let saved = first.save().unwrap();
    let [song_file, sound_file] = ["song", "sound"].map(|name| folder.path().join(name));
    std::fs::write(&song_file, &saved).unwrap();
    let nowhere = folder.path().join("nowhere");
    let test = "own::the_song_of_another_process_is_rendered";
    let run = Command::new(std::env::current_exe().unwrap())
        .args(["--exact", test, "--ignored"])
        .env(SONG, &song_file)
        .env(SOUND, &sound_file)
        .env("HOME", &nowhere)
        .env("XDG_DATA_HOME", &nowhere)
        .env("APPDATA", &nowhere)
        .output()
        .unwrap();
    assert!(run.status.success(), "{run:?}");
    let there = std::fs::read(&sound_file).unwrap();
    assert!(there == here, "the same bits");
    assert!(!nowhere.exists());
}

#[test]
#[ignore = "the test above runs it, in a process of its own"]
fn the_song_of_another_process_is_rendered() {
    let file = |name: &str| std::env::var_os(name).unwrap();
    let saved = std::fs::read(Path::new(&file(SONG))).unwrap();
    let mut fresh = plugin().unwrap();
    fresh.load(&saved).unwrap();
    assert_eq!(fresh.save().unwrap(), saved);
    std::fs::write(Path::new(&file(SOUND)), sound(&mut fresh)).unwrap();
}

#[test]
fn a_bank_comes_while_another_rings_and_no_step_is_heard() {
    let own = Own::new(bell()).unwrap();
    let mut plugin = plugin().unwrap();
    let song = song(&mut plugin, own.text());
    plugin.activate(48_000.0, 512).unwrap();
    let before = plugin
        .play(&[strike(65, 0.6).at(0)], 12_000, 512)
        .unwrap()
        .left;
    plugin.load_state(&song).unwrap();
    let after = plugin
        .play(&[strike(62, 0.6).at(6000)], 12_000, 512)
        .unwrap()
        .left;
    let step = |samples: &[f32]| {
        let steps = samples.windows(2).map(|pair| (pair[1] - pair[0]).abs());
        steps.fold(0.0f32, f32::max)
    };
    let seam = (after[0] - before[before.len() - 1]).abs();
    assert!(seam <= step(&before[6000..]), "{seam}");
    let rings = |samples: &[f32]| samples.iter().map(|x| x * x).sum::<f32>();
    assert!(
        rings(&after[..6000]) > 0.1 * rings(&before[6000..]),
        "it rings on"
    );
    assert!(
        rings(&after[6000..]) > rings(&after[..6000]),
        "the new one is struck"
    );
}

#[test]
fn a_song_with_a_bank_that_cannot_be_read_loads_and_keeps_it() {
    let text = Own::new(bell()).unwrap().text().to_owned();
    let newer = text.replace("\"layout\":1", "\"layout\":44");
    for broken in [&text[..text.len() / 3], &newer, "null", "[1, 2"] {
        let mut plugin = plugin().unwrap();
        let song = song(&mut plugin, broken);
        plugin.load_state(&song).unwrap();
        assert!(
            sound(&mut plugin).iter().any(|byte| *byte != 0),
            "chimes play"
        );
        let saved = plugin.state().unwrap();
        assert_eq!(saved["fields"]["bank"], *broken);
        assert_eq!(saved["params"]["instr"], json!({"i32": OWN}));
    }
}

#[test]
fn songs_of_the_future_are_saved_again_with_all_that_was_in_them() {
    let mut plugin = plugin().unwrap();
    let mut song = plugin.state().unwrap();
    song["version"] = "999.0.0".into();
    song["params"]["instr"] = json!({"i32": 77});
    song["params"]["wobble"] = json!({"f32": 0.25});
    song["fields"]["instrument"] = json!({"name": "gong", "title": "Gong"}).to_string().into();
    song["fields"]["mesh"] = "{\"nodes\": [1, 2, 3]}".into();
    plugin.load_state(&song).unwrap();
    let first = plugin.state().unwrap();
    assert_eq!(first["params"]["instr"], json!({"i32": 0}));
    assert_eq!(first["fields"]["instrument"], song["fields"]["instrument"]);
    assert_eq!(first["fields"]["mesh"], song["fields"]["mesh"]);
    assert_eq!(first["fields"]["later"], "{\"wobble\":{\"f32\":0.25}}");
    plugin.load_state(&first).unwrap();
    assert_eq!(plugin.state().unwrap(), first);
}

/// The largest factory bank is larger than what most will bring.
#[test]
fn a_large_bank_is_saved_within_a_tenth_of_a_second() {
    let banks = 0..factory::BANKS.len();
    let largest = banks
        .max_by_key(|index| factory::BANKS[*index].1.len())
        .unwrap();
    let start = Instant::now();
    let own = Own::new(factory::bank(largest).clone()).unwrap();
    let packing = start.elapsed();
    let mut plugin = plugin().unwrap();
    let song = song(&mut plugin, own.text());
    plugin.load_state(&song).unwrap();
    let times = (0..5).map(|_| {
        let start = Instant::now();
        plugin.save().unwrap();
        start.elapsed()
    });
    let best = times.min().unwrap();
    println!(
        "{} bytes packed to {} in {packing:?}, saved in {best:?}",
        factory::BANKS[largest].1.len(),
        own.text().len()
    );
    assert!(best < Duration::from_millis(100), "{best:?}");
}
