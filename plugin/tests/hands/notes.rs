//! What is said of single notes.

use crate::support::{assigned, bend, bits, configure};
use idiophone::hands::{Address, Expression, Hands, Modulated, Note, Settings, Source, Target};

fn note(channel: u8, key: u8, id: i32) -> Note {
    Note {
        channel,
        key,
        id: Some(id),
    }
}

fn chord() -> Hands {
    let mut hands = Hands::new();
    hands.note_on(note(0, 60, 1), 1.0, 0.0);
    hands.note_on(note(0, 64, 2), 1.0, 0.0);
    hands.note_on(note(1, 67, 3), 1.0, 0.0);
    hands.changed();
    hands
}

#[test]
fn addresses_find_their_notes() {
    let any = Address::ALL;
    for (address, keys) in [
        (any, bits(&[60, 64, 67])),
        (Address::id(2), bits(&[64])),
        (Address::from(note(1, 67, 3)), bits(&[67])),
        (Address::from(note(0, 67, 3)), 0),
        (Address::id(4), 0),
        (Address::key(0, 64), bits(&[64])),
        (
            Address {
                channel: Some(0),
                ..any
            },
            bits(&[60, 64]),
        ),
        (
            Address {
                key: Some(67),
                ..any
            },
            bits(&[67]),
        ),
        (
            Address {
                key: Some(68),
                ..any
            },
            0,
        ),
    ] {
        let mut hands = chord();
        hands.expression(Expression::Tuning, address, 0.5);
        let tuned = (0..128).filter(|key| bend(&hands, *key) == 0.5);
        assert_eq!(tuned.fold(0, |bits, key| bits | 1 << key), keys);
        assert_eq!(hands.changed(), keys, "{address:?}");
        assert_eq!(hands.note_off(address, 0.5), keys);
        assert_eq!(hands.held(), bits(&[60, 64, 67]) & !keys);
    }
}

#[test]
fn a_note_that_lost_its_key_says_nothing() {
    let mut hands = chord();
    hands.expression(Expression::Tuning, Address::id(1), 3.0);
    hands.note_on(note(0, 60, 9), 1.0, 0.0);
    assert_eq!(bend(&hands, 60), 0.0, "a new note starts at rest");
    hands.expression(Expression::Tuning, Address::id(1), 3.0);
    assert_eq!(hands.note_off(Address::id(1), 0.5), 0);
    assert_eq!(bend(&hands, 60), 0.0);
    assert_eq!(hands.note_off(Address::id(9), 0.5), bits(&[60]));
    hands.expression(Expression::Tuning, Address::id(9), 3.0);
    assert_eq!(bend(&hands, 60), 3.0, "up, but it rings");
}

#[test]
fn expressions_have_their_units() {
    let mut hands = chord();
    let one = Address::id(1);
    let said = |hands: &mut Hands, kind, value| {
        hands.expression(kind, one, value);
        hands.key(60)
    };
    for (said_pan, pan) in [(-1.0, -1.0), (0.25, 0.25), (7.0, 1.0), (f64::NAN, 0.0)] {
        assert_eq!(said(&mut hands, Expression::Pan, said_pan).pan, pan);
    }
    for (volume, level) in [(0.0, 0.0), (4.0, 4.0), (9.0, 4.0), (f64::NAN, 1.0)] {
        assert_eq!(said(&mut hands, Expression::Volume, volume).level, level);
    }
    let half = said(&mut hands, Expression::Expression, 0.5);
    assert!((half.level - 0.25).abs() < 1e-15, "as CC 11: -12 dB");
    hands.controller(0, 11, 0.5);
    assert!((hands.key(60).level - 0.0625).abs() < 1e-15);
    assert!((hands.key(64).level - 0.25).abs() < 1e-15);
    hands.pitch_bend(0, 1.0);
    assert_eq!(
        said(&mut hands, Expression::Tuning, -0.25).bend_semitones,
        1.75
    );
    let far = said(&mut hands, Expression::Tuning, 1e9).bend_semitones;
    assert_eq!(far, 120.0);
}

#[test]
fn vibrato_brightness_and_pressure_join_their_controllers() {
    let mut hands = assigned(&[
        (Source::ModWheel, Target::BowSpeed),
        (Source::Brightness, Target::Hardness),
        (Source::Pressure, Target::BowPressure),
    ]);
    hands.note_on(note(0, 60, 1), 1.0, 0.0);
    let one = Address::id(1);
    hands.controller(0, 1, 0.25);
    hands.expression(Expression::Vibrato, one, 0.5);
    assert_eq!(hands.key(60).bow_speed_octaves, 1.0);
    hands.controller(0, 1, 0.75);
    assert_eq!(hands.key(60).bow_speed_octaves, 1.5);
    hands.expression(Expression::Brightness, one, 0.75);
    assert_eq!(hands.touch(60).hardness_decades, 1.0);
    hands.controller(0, 74, 0.0);
    assert_eq!(hands.touch(60).hardness_decades, -1.0);
    hands.expression(Expression::Pressure, one, 0.5);
    hands.channel_pressure(0, 0.25);
    assert_eq!(hands.key(60).bow_pressure, 0.5);
    hands.channel_pressure(0, 0.0);
    hands.note_off(one, 0.5);
    assert_eq!(hands.key(60).bow_pressure, 0.0);
    hands.expression(Expression::Pressure, one, 0.5);
    assert_eq!(hands.key(60).bow_pressure, 0.0, "no finger is there");
}

#[test]
fn the_host_modulates_one_note() {
    let mut hands = chord();
    for (what, amount) in Modulated::ALL.into_iter().zip([0.1, -0.2, 5.0]) {
        hands.modulation(what, Address::id(2), amount);
    }
    let touch = hands.touch(64);
    assert_eq!(touch.position_modulation, 0.1);
    assert_eq!(touch.hardness_modulation, -0.2);
    assert_eq!(hands.key(64).damping_modulation, 1.0);
    assert_eq!(hands.touch(60).position_modulation, 0.0);
    hands.note_on(note(0, 64, 7), 1.0, 0.0);
    assert_eq!(hands.key(64).damping_modulation, 0.0);
}

#[test]
fn strikes_have_velocity_place_and_chance() {
    let mut hands = assigned(&[
        (Source::Velocity, Target::Hardness),
        (Source::Key, Target::StrikePosition),
        (Source::Random, Target::MalletMass),
    ]);
    for (key, place) in [
        (12, -0.5),
        (36, -0.25),
        (60, 0.0),
        (84, 0.25),
        (108, 0.5),
        (127, 0.5),
    ] {
        hands.note_on(note(0, key, 1), 0.25, -0.5);
        let touch = hands.touch(key);
        assert_eq!(touch.position, place, "{key}");
        assert_eq!(touch.velocity, 0.25);
        assert_eq!(touch.hardness_decades, 0.5);
        assert_eq!(touch.mass_octaves, -1.0);
    }
    let curved = |velocity_curve, velocity| {
        let mut hands = Hands::new();
        hands.set(&Settings {
            velocity_curve,
            ..Settings::default()
        });
        hands.note_on(note(0, 60, 1), velocity, 0.0);
        hands.touch(60).velocity
    };
    assert!((curved(1.0, 0.5) - 8.0 / 9.0).abs() < 1e-15);
    assert!((curved(-1.0, 0.5) - 1.0 / 9.0).abs() < 1e-15);
    assert_eq!(curved(0.3, 1.0), 1.0);
    assert_eq!(curved(0.3, f64::NAN), 0.0);
}

#[test]
fn keys_that_are_none_strike_nothing() {
    let mut hands = Hands::new();
    hands.changed();
    hands.note_on(note(0, 200, 1), 1.0, 0.0);
    assert_eq!((hands.held(), hands.changed()), (0, 0));
}

#[test]
fn clap_expressions_work_inside_mpe_zones() {
    let mut hands = Hands::new();
    configure(&mut hands, 0, 15);
    hands.note_on(note(0, 60, 1), 1.0, 0.0);
    hands.expression(Expression::Tuning, Address::id(1), 0.5);
    hands.pitch_bend(0, 0.5);
    assert_eq!(bend(&hands, 60), 1.5);
}
