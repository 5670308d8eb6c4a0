//! What stops the sound: all sound off, all notes off, choke.

use idiophone_tests::{peak, playing, strike};
use xtask::host::Event;

/// By then the sound is gone.
const QUICKLY: usize = 4800;
/// −90 dB.
const GONE: f32 = 3.2e-5;

/// Level before and a tenth of a second after `event` at 0.2 s, while four chimes ring.
fn before_and_after(event: Event) -> (f32, f32) {
    let mut plugin = playing(48_000.0).unwrap();
    let mut events: Vec<_> = [50, 62, 74, 86].map(|key| strike(key, 1.0).at(0)).into();
    events.push(event.at(9600));
    let take = plugin.play(&events, 24_000, 512).unwrap();
    (
        peak(&take.left[8600..9600]),
        peak(&take.left[9600 + QUICKLY..]),
    )
}

#[test]
fn all_sound_off_and_all_notes_off_silence_everything() {
    for number in [120, 123] {
        let (before, after) = before_and_after(Event::controller(number, 0));
        assert!(after < GONE * before, "CC{number}: {before} to {after}");
    }
}

#[test]
fn a_choke_silences_its_key_alone() {
    let ringing = |events: &[xtask::host::TimedEvent]| {
        let mut plugin = playing(48_000.0).unwrap();
        let take = plugin.play(events, 24_000, 512).unwrap();
        peak(&take.left[9600 + QUICKLY..])
    };
    let choke = Event::Choke {
        channel: 0,
        key: 74,
    };
    let struck = strike(74, 1.0).at(0);
    let kept = ringing(&[struck]);
    assert!(ringing(&[struck, choke.at(9600)]) < GONE * kept);
    let other = strike(62, 1.0).at(0);
    assert!(ringing(&[struck, other, choke.at(9600)]) > 0.1 * ringing(&[other]));
}

#[test]
fn another_key_s_choke_changes_nothing() {
    let (before, after) = before_and_after(Event::Choke {
        channel: 0,
        key: 100,
    });
    assert!(after > 0.1 * before, "{before} to {after}");
}
