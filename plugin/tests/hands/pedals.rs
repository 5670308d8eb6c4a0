//! Dampers: keys, pedals and how fast keys come up.

use crate::support::{assigned, bits, release, send, strike};
use idiophone::hands::{Address, Hands, Source, Target};

#[test]
fn felt_falls_with_the_key_and_half_a_pedal_holds_half_of_it() {
    let mut hands = Hands::new();
    strike(&mut hands, 0, 60);
    assert_eq!((hands.dampers(60), hands.key(60).felt), (1.0, 0.0));
    assert_eq!(release(&mut hands, 0, 60), 1 << 60);
    assert_eq!((hands.dampers(60), hands.key(60).felt), (0.0, 1.0));
    for (pedal, off) in [(0.2, 0.0), (0.4, 0.3), (0.5, 0.5), (0.6, 0.7), (0.8, 1.0)] {
        hands.controller(0, 64, pedal);
        assert!((hands.dampers(60) - off).abs() < 1e-12, "{pedal}");
        assert!((hands.key(60).felt - (1.0 - off)).abs() < 1e-12, "{pedal}");
    }
    hands.controller(3, 64, 0.0);
    assert_eq!(hands.dampers(60), 1.0, "another channel's pedal");
}

#[test]
fn keys_that_nobody_struck_follow_the_lowest_pedal() {
    let mut hands = Hands::new();
    strike(&mut hands, 0, 60);
    hands.changed();
    hands.controller(0, 64, 0.5);
    hands.controller(1, 64, 1.0);
    assert_eq!((hands.dampers(72), hands.dampers(60)), (1.0, 1.0));
    release(&mut hands, 0, 60);
    assert_eq!((hands.dampers(72), hands.dampers(60)), (1.0, 0.5));
    assert_eq!(hands.changed(), u128::MAX);
}

#[test]
fn sostenuto_holds_what_was_down_and_nothing_else() {
    let mut hands = Hands::new();
    strike(&mut hands, 0, 60);
    strike(&mut hands, 0, 64);
    strike(&mut hands, 1, 67);
    release(&mut hands, 0, 64);
    send(&mut hands, 0, &[(66, 127)]);
    strike(&mut hands, 0, 72);
    for (channel, key) in [(0, 60), (0, 72), (1, 67)] {
        release(&mut hands, channel, key);
    }
    let off = [60, 64, 67, 72].map(|key| hands.dampers(key));
    assert_eq!(off, [1.0, 0.0, 0.0, 0.0]);
    strike(&mut hands, 0, 60);
    release(&mut hands, 0, 60);
    assert_eq!(hands.dampers(60), 1.0, "caught until the pedal is up");
    hands.changed();
    send(&mut hands, 0, &[(66, 0)]);
    assert_eq!(hands.dampers(60), 0.0);
    assert_eq!(hands.changed() & bits(&[60, 67]), 1 << 60);
}

#[test]
fn a_fast_release_drops_the_felt_more_firmly() {
    let mut hands = assigned(&[(Source::ReleaseVelocity, Target::DamperFirmness)]);
    for (velocity, felt) in [
        (1.0, 4.0),
        (64.0 / 127.0, 1.0),
        (32.0 / 127.0, 0.5),
        (1e-9, 0.25),
        (0.0, 1.0),
        (f64::NAN, 1.0),
    ] {
        strike(&mut hands, 0, 60);
        assert_eq!(hands.key(60).felt, 0.0);
        hands.note_off(Address::key(0, 60), velocity);
        let weight = hands.key(60).felt;
        assert!((weight - felt).abs() < 1e-6, "{velocity}: {weight}");
    }
    hands.note_off(Address::key(0, 60), 1.0);
    assert_eq!(hands.key(60).felt, 1.0, "it was up already");
    hands.controller(0, 64, 0.5);
    strike(&mut hands, 0, 60);
    hands.note_off(Address::key(0, 60), 1.0);
    assert_eq!(hands.key(60).felt, 2.0, "half of four times");
}
