//! What hands do is heard as asked: pitches to a cent, decay to 2 %.

use idiophone_tests::chime::{CONTACT_S, Off, bent, off, together};
use idiophone_tests::{Partial, plugin_with, release, strike};
use xtask::host::{Event, NoteExpressionType, TimedEvent};

const RATE_HZ: f64 = 48_000.0;
const KEY: u8 = 74;
/// While it rings, by then.
const LATER: u64 = 9600;
/// Length of sound that is looked at, in frames.
const WINDOW: usize = 14_400;
/// −60 dB: what is weaker than this beside the strongest partial is not measured.
const FAINT: f64 = 1e-3;
/// Parameters and hands have arrived by then, in frames.
const SETTLED: usize = 960;

/// Sound of events, from `from` on.
fn heard(settings: &[&str], events: &[TimedEvent], from: usize) -> Vec<f32> {
    let mut plugin = plugin_with(settings).unwrap();
    plugin.activate(RATE_HZ, 512).unwrap();
    let take = plugin.play(events, from + WINDOW, 512).unwrap();
    take.left[from..].to_vec()
}

/// A sound is the sum of what is expected.
fn assert_heard(what: &str, sound: &[f32], expected: &[Partial]) -> Off {
    let off = off(sound, RATE_HZ, expected, FAINT);
    println!(
        "{what}: {} partials, {:.1e} cents and {:.1e} of the decay off, {:.0} dB unexplained",
        off.count, off.cents, off.decay, off.unexplained_db
    );
    assert!(off.count >= 3, "{what}: {} partials", off.count);
    assert!(off.cents < 1.0, "{what}: {} cents", off.cents);
    assert!(off.decay < 0.02, "{what}: {} of the decay", off.decay);
    assert!(
        off.unexplained_db < -60.0,
        "{what}: {} dB",
        off.unexplained_db
    );
    off
}

fn contact() -> usize {
    xtask::midi::frame(CONTACT_S, RATE_HZ) as usize
}

/// The note is bent by `semitones` when `events` come before it, and when they come while it rings.
fn assert_bent(what: &str, settings: &[&str], events: &[Event], semitones: f64) {
    let at = |frame| events.iter().map(move |event| event.at(frame));
    let expected = bent(KEY, semitones, 0.0);
    let mut before: Vec<_> = at(0).collect();
    before.push(strike(KEY, 0.8).at(0));
    assert_heard(what, &heard(settings, &before, contact()), &expected);
    let mut later = vec![strike(KEY, 0.8).at(0)];
    later.extend(at(LATER));
    let from = LATER as usize + SETTLED;
    let what = format!("{what} while it rings");
    assert_heard(&what, &heard(settings, &later, from), &expected);
}

fn wheel(channel: u8, bits: u16) -> Event {
    let bytes = bits.to_be_bytes();
    let msb = bytes[0] << 1 | bytes[1] >> 7;
    Event::Midi([0xE0 | channel, bytes[1] & 0x7F, msb & 0x7F])
}

fn cc(channel: u8, number: u8, value: u8) -> Event {
    Event::Midi([0xB0 | channel, number, value])
}

fn on(channel: u8, key: u8) -> Event {
    Event::NoteOn {
        channel,
        key,
        note_id: u32::from(key),
        velocity: 0.8,
    }
}

#[test]
fn the_wheel_bends_by_its_range() {
    let up = 2.0 * 8191.0 / 8192.0;
    assert_bent("wheel up", &[], &[wheel(0, 16_383)], up);
    assert_bent("wheel down", &[], &[wheel(0, 0)], -2.0);
    assert_bent("middle", &[], &[wheel(0, 9000), wheel(0, 8192)], 0.0);
    let twelve = ["Bend range=12 st"];
    assert_bent("an octave", &twelve, &[wheel(0, 0)], -12.0);
    let rpn = [
        cc(0, 101, 0),
        cc(0, 100, 0),
        cc(0, 6, 7),
        cc(0, 38, 50),
        wheel(0, 4096),
    ];
    assert_bent("RPN 0", &[], &rpn, -3.75);
}

#[test]
fn note_expressions_and_assignments_bend() {
    let tuning = |value| Event::Expression {
        kind: NoteExpressionType::Tuning,
        note_id: u32::from(KEY),
        value,
    };
    let from = LATER as usize + SETTLED;
    for value in [0.37, -3.0] {
        let events = [strike(KEY, 0.8).at(0), tuning(value).at(0)];
        let what = format!("tuning by {value}");
        let expected = bent(KEY, value, 0.0);
        assert_heard(&what, &heard(&[], &events, contact()), &expected);
        let events = [strike(KEY, 0.8).at(0), tuning(value).at(LATER)];
        assert_heard(&what, &heard(&[], &events, from), &expected);
    }
    let breath = [
        "Assign 8 source=breath",
        "Assign 8 target=bend",
        "Assign 8 depth=-25 %",
    ];
    let by = -3.0 * 100.0 / 127.0;
    assert_bent("breath", &breath, &[cc(0, 2, 100)], by);
}

/// A controller that announces itself, a bent finger, another that is not, and the whole hand.
#[test]
fn fingers_of_an_mpe_controller_bend_their_own_notes() {
    let announce = [cc(0, 101, 0), cc(0, 100, 6), cc(0, 6, 15)];
    let other = 81;
    let by = 48.0 * 100.0 / 8192.0;
    let mut events: Vec<_> = announce.iter().map(|event| event.at(0)).collect();
    events.extend([
        wheel(2, 8192 + 100).at(0),
        on(2, KEY).at(0),
        on(3, other).at(0),
    ]);
    let both =
        |first: f64, second: f64| together(&[bent(KEY, first, 0.0), bent(other, second, 0.0)]);
    let sound = heard(&[], &events, contact());
    assert_heard("two fingers", &sound, &both(by, 0.0));
    events.push(wheel(0, 0).at(LATER));
    let from = LATER as usize + SETTLED;
    let sound = heard(&[], &events, from);
    assert_heard("and the hand", &sound, &both(by - 2.0, -2.0));
    // Without the announcement, and with MPE off, channels are ordinary ones.
    let plain = heard(&["MPE=off"], &events[..6], contact());
    assert_heard("no MPE", &plain, &both(2.0 * 100.0 / 8192.0, 0.0));
    let always = heard(&["MPE=always"], &events[3..6], contact());
    assert_heard("always MPE", &always, &both(by, 0.0));
}

/// Decay rate of a hand on a released chime, which has no felt, in 1/s: 60 dB in 0.25 s.
const HAND_PER_S: f64 = 27.631_021_115_928_547;

/// Decay of the note after `events` is that of the bank and `added_per_s`.
fn assert_decay(what: &str, settings: &[&str], events: &[TimedEvent], added_per_s: f64) {
    let from = LATER as usize + SETTLED;
    let sound = heard(settings, events, from);
    assert_heard(what, &sound, &bent(KEY, 0.0, added_per_s));
}

#[test]
fn pedals_and_dampers_take_what_they_should() {
    let damps = ["Note-off=damps"];
    let off = |velocity| Event::NoteOff {
        channel: 0,
        key: KEY,
        note_id: u32::from(KEY),
        velocity,
    };
    let struck = strike(KEY, 0.8).at(0);
    assert_decay("rings on", &[], &[struck, off(0.0).at(LATER)], 0.0);
    assert_decay("held", &damps, &[struck], 0.0);
    let released = [struck, off(0.0).at(LATER)];
    assert_decay("released", &damps, &released, HAND_PER_S);
    let fast = [struck, off(1.0).at(LATER)];
    assert_decay("released fast", &damps, &fast, 2.0 * HAND_PER_S);
    for (value, felt) in [(31, 1.0), (64, 1.5 - 2.0 * 64.0 / 127.0), (96, 0.0)] {
        let events = [cc(0, 64, value).at(0), struck, off(0.0).at(LATER)];
        let what = format!("pedal at {value}");
        assert_decay(&what, &damps, &events, felt * HAND_PER_S);
    }
    let lifted = [
        struck,
        cc(0, 64, 127).at(100),
        off(0.0).at(200),
        cc(0, 64, 0).at(LATER),
    ];
    assert_decay("pedal up", &damps, &lifted, HAND_PER_S);
}

#[test]
fn sostenuto_holds_what_was_down() {
    let damps = ["Note-off=damps"];
    let other = 81;
    let events = [
        strike(KEY, 0.8).at(0),
        cc(0, 66, 127).at(100),
        strike(other, 0.8).at(200),
        release(KEY).at(LATER),
        release(other).at(LATER),
    ];
    let from = LATER as usize + SETTLED;
    let sound = heard(&damps, &events, from);
    let hand_per_s = HAND_PER_S * release_firmness().exp2();
    let expected = together(&[bent(KEY, 0.0, 0.0), bent(other, 0.0, hand_per_s)]);
    assert_heard("sostenuto", &sound, &expected);
}

/// Octaves by which a key let go with velocity ½ is damped more firmly than the middle byte says.
fn release_firmness() -> f64 {
    let middle = 64.0 / 127.0;
    (0.5 - middle) / middle
}

#[test]
fn hands_on_bodies_damp_them() {
    let pressure = [
        "Assign 8 source=pressure",
        "Assign 8 target=hand damping",
        "Assign 8 depth=100 %",
    ];
    // 60 dB in 60 ms at full, quadratic.
    let hand_per_s = |firm: f64| 1000f64.ln() / 0.06 * firm * firm;
    let struck = strike(KEY, 0.8).at(0);
    let share = 32.0 / 127.0;
    for (what, event) in [
        ("channel pressure", Event::Midi([0xD0, 32, 0])),
        ("key pressure", Event::Midi([0xA0, KEY, 32])),
        (
            "pressure of a note",
            Event::Expression {
                kind: NoteExpressionType::Pressure,
                note_id: u32::from(KEY),
                value: share,
            },
        ),
    ] {
        let events = [struck, event.at(LATER)];
        assert_decay(what, &pressure, &events, hand_per_s(share));
    }
}

#[test]
fn levels_are_as_asked() {
    let struck = strike(KEY, 0.8).at(0);
    let expected = bent(KEY, 0.0, 0.0);
    let level = |event: Event| {
        let sound = heard(&[], &[struck, event.at(0)], contact());
        off(&sound, RATE_HZ, &expected, FAINT).strongest()
    };
    let plain = level(cc(0, 11, 127));
    let volume = |value| Event::Expression {
        kind: NoteExpressionType::Volume,
        note_id: u32::from(KEY),
        value,
    };
    for (event, wanted) in [
        (cc(0, 11, 64), (64f64 / 127.0).powi(2)),
        (volume(0.5), 0.5),
        (volume(2.0), 2.0),
    ] {
        let db = 20.0 * (level(event) / plain / wanted).log10();
        assert!(db.abs() < 0.01, "{event:?}: {db} dB off");
    }
}
