//! Scales and keyboard maps that travel in the song.

use idiophone_tests::chime::{CONTACT_S, bent, off};
use idiophone_tests::{peak, plugin, strike};
use xtask::host::{Plugin, Take, TimedEvent};

const KEY: u8 = 74;
const WINDOW: usize = 14_400;
/// −60 dB: what is weaker than this beside the strongest partial is not measured.
const FAINT: f64 = 1e-3;

/// Nineteen equal steps to the octave.
fn nineteen() -> String {
    let steps: Vec<_> = (1..=19)
        .map(|step| format!("{:.6}", 1200.0 * f64::from(step) / 19.0))
        .collect();
    format!(
        "! 19.scl\n!\nnineteen equal steps\n 19\n!\n{}\n",
        steps.join("\n")
    )
}

/// Every second key from 60 on sounds, a fifth apart.
const FIFTHS: &str = "fifths\n1\n3/2\n";
const EVERY_SECOND: &str = "! two.kbm\n2\n0\n127\n60\n60\n261.625565\n1\n0\nx\n";

fn play(plugin: &mut Plugin, events: &[TimedEvent], frames: usize) -> Take {
    plugin.play(events, frames, 512).unwrap()
}

fn assert_pitch(what: &str, sound: &[f32], semitones: f64) {
    let off = off(sound, 48_000.0, &bent(KEY, semitones, 0.0), FAINT);
    println!(
        "{what}: {:.1e} cents, {:.1e} of the decay off",
        off.cents, off.decay
    );
    assert!(
        off.count >= 2 && off.cents < 1.0,
        "{what}: {} cents",
        off.cents
    );
    assert!(off.decay < 0.02, "{what}: {} of the decay", off.decay);
    assert!(
        off.unexplained_db < -60.0,
        "{what}: {} dB",
        off.unexplained_db
    );
}

/// How far key 74 lies from equal temperament in nineteen steps about key 69.
const BY: f64 = 5.0 * 12.0 / 19.0 - 5.0;

#[test]
fn keys_have_the_pitches_of_the_scale() {
    let from = xtask::midi::frame(CONTACT_S, 48_000.0) as usize;
    let mut plugin = plugin().unwrap();
    plugin.tune(&nineteen(), "").unwrap();
    plugin.activate(48_000.0, 512).unwrap();
    let take = play(&mut plugin, &[strike(KEY, 0.8).at(0)], from + WINDOW);
    assert_pitch("nineteen steps", &take.left[from..], BY);
    // Two octaves up the body of key 98 would lie too far: the nearest sounds, eleven keys lower.
    let key = 69 + 19;
    plugin.deactivate();
    plugin.activate(48_000.0, 512).unwrap();
    let take = play(&mut plugin, &[strike(key, 0.8).at(0)], from + WINDOW);
    let octave = off(&take.left[from..], 48_000.0, &bent(key, -7.0, 0.0), FAINT);
    assert!(
        octave.cents < 1.0 && octave.unexplained_db < -60.0,
        "{octave:?}"
    );
}

#[test]
fn what_rings_follows_a_song_that_is_loaded() {
    let mut plugin = plugin().unwrap();
    plugin.activate(48_000.0, 512).unwrap();
    play(&mut plugin, &[strike(KEY, 0.8).at(0)], 4800);
    plugin.tune(&nineteen(), "").unwrap();
    play(&mut plugin, &[], 960);
    let take = play(&mut plugin, &[], WINDOW);
    assert_pitch("loaded while it rings", &take.left, BY);
    plugin.tune("", "").unwrap();
    play(&mut plugin, &[], 960);
    let take = play(&mut plugin, &[], WINDOW);
    assert_pitch("and none again", &take.left, 0.0);
}

#[test]
fn unmapped_keys_are_silent_and_their_notes_end() {
    let mut plugin = plugin().unwrap();
    plugin.tune(FIFTHS, EVERY_SECOND).unwrap();
    plugin.activate(48_000.0, 512).unwrap();
    let take = play(&mut plugin, &[strike(61, 0.8).at(100)], 4800);
    assert_eq!(peak(&take.left), 0.0);
    assert_eq!(take.ended, [(100, Some(61))]);
    let take = play(&mut plugin, &[strike(62, 0.8).at(100)], 4800);
    assert!(peak(&take.left) > 1e-3 && take.ended.is_empty());
}

#[test]
fn a_text_that_cannot_be_read_changes_nothing_and_is_kept() {
    let bad = "bad\n2\n3/2\n5/0\n";
    let mut plugin = plugin().unwrap();
    plugin.tune(&nineteen(), "").unwrap();
    plugin.activate(48_000.0, 512).unwrap();
    plugin.tune(bad, "").unwrap();
    let from = xtask::midi::frame(CONTACT_S, 48_000.0) as usize;
    let take = play(&mut plugin, &[strike(KEY, 0.8).at(0)], from + WINDOW);
    assert_pitch("the last good one", &take.left[from..], BY);
    let state = plugin.state().unwrap();
    let kept: String = serde_json::from_str(state["fields"]["scale"].as_str().unwrap()).unwrap();
    assert_eq!(kept, bad);
}

#[test]
fn a_tuning_travels_with_the_song() {
    let mut first = plugin().unwrap();
    first.tune(&nineteen(), EVERY_SECOND).unwrap();
    let state = first.save().unwrap();
    let mut second = plugin().unwrap();
    second.load(&state).unwrap();
    assert_eq!(second.save().unwrap(), state);
    // A song from before there were tunings has none.
    let mut old = plugin().unwrap().state().unwrap();
    old["fields"] = serde_json::json!({});
    second.load_state(&old).unwrap();
    assert_eq!(second.save().unwrap(), plugin().unwrap().save().unwrap());
}
