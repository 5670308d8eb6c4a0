//! Ordinary channels: each speaks for the keys it struck.

use crate::support::{assigned, bend, bits, release, send, strike};
use idiophone::hands::{Hands, Mpe, Settings, Source, Target};

#[test]
fn a_channel_bends_what_it_struck_and_goes_on_when_the_key_is_up() {
    let mut hands = Hands::new();
    strike(&mut hands, 0, 60);
    strike(&mut hands, 5, 64);
    hands.pitch_bend(0, 0.5);
    assert_eq!((bend(&hands, 60), bend(&hands, 64)), (1.0, 0.0));
    release(&mut hands, 0, 60);
    hands.pitch_bend(0, -1.0);
    assert_eq!(bend(&hands, 60), -2.0, "it rings, and the wheel is its own");
    hands.pitch_bend(5, 1.0);
    strike(&mut hands, 5, 60);
    assert_eq!(bend(&hands, 60), 2.0, "another channel has it now");
    assert_eq!(bend(&hands, 61), 0.0, "never struck");
}

#[test]
fn wheels_act_by_the_table() {
    let mut hands = assigned(&[
        (Source::ModWheel, Target::BowSpeed),
        (Source::Expression, Target::Level),
        (Source::Brightness, Target::Hardness),
        (Source::Pressure, Target::HandDamping),
        (Source::SoftPedal, Target::MalletMass),
        (Source::Breath, Target::BowPressure),
        (Source::Foot, Target::ListenerDistance),
    ]);
    strike(&mut hands, 2, 60);
    strike(&mut hands, 3, 61);
    let untouched = hands.key(61);
    send(&mut hands, 2, &[(1, 127), (11, 0), (74, 0), (67, 127)]);
    hands.channel_pressure(2, 0.5);
    hands.controller(2, 2, 0.25);
    let key = hands.key(60);
    assert_eq!(key.bow_speed_octaves, 2.0);
    assert_eq!(key.level, 0.0);
    assert_eq!(key.bow_pressure, 0.25);
    assert!((modes::t60_s(key.hand_per_s) - 0.24).abs() < 1e-9);
    let touch = hands.touch(60);
    assert_eq!(touch.hardness_decades, -2.0);
    assert_eq!(touch.mass_octaves, 2.0);
    assert_eq!(hands.key(61), untouched);
}

#[test]
fn a_hand_cannot_take_damping_away() {
    let mut hands = assigned(&[(Source::Key, Target::HandDamping)]);
    strike(&mut hands, 0, 12);
    strike(&mut hands, 0, 108);
    assert_eq!(hands.key(12).hand_per_s, 0.0);
    assert!((modes::t60_s(hands.key(108).hand_per_s) - 0.06).abs() < 1e-12);
}

#[test]
fn the_whole_follows_the_channel_that_struck_last() {
    let mut hands = assigned(&[
        (Source::ModWheel, Target::MotorSpeed),
        (Source::Foot, Target::MotorDepth),
        (Source::Breath, Target::ListenerDistance),
    ]);
    send(&mut hands, 0, &[(1, 127), (2, 127)]);
    assert_eq!(hands.whole().motor_speed_hz, 12.0, "before any note");
    assert_eq!(hands.whole().distance_octaves, 2.0);
    strike(&mut hands, 4, 60);
    assert_eq!(hands.whole().motor_speed_hz, 0.0);
    send(&mut hands, 4, &[(4, 127)]);
    assert_eq!(hands.whole().motor_depth, 1.0);
    strike(&mut hands, 0, 62);
    assert_eq!(hands.whole().motor_speed_hz, 12.0);
    assert_eq!(hands.whole().motor_depth, 0.0);
}

#[test]
fn rpn_0_sets_the_bend_range_of_a_channel() {
    let mut hands = Hands::new();
    strike(&mut hands, 0, 60);
    strike(&mut hands, 1, 61);
    hands.pitch_bend(0, 1.0);
    hands.pitch_bend(1, 1.0);
    send(&mut hands, 0, &[(101, 0), (100, 0), (6, 12), (38, 50)]);
    assert_eq!((bend(&hands, 60), bend(&hands, 61)), (12.5, 2.0));
    send(&mut hands, 0, &[(101, 127), (100, 127), (6, 5)]);
    assert_eq!(bend(&hands, 60), 12.5, "data for the null parameter");
    send(&mut hands, 0, &[(101, 0), (100, 0), (6, 7)]);
    assert_eq!(bend(&hands, 60), 7.0, "a new first byte clears the second");
    send(&mut hands, 0, &[(6, 127)]);
    assert_eq!(bend(&hands, 60), 96.0);
    hands.set(&Settings {
        bend_range_semitones: 3.0,
        ..Settings::default()
    });
    assert_eq!((bend(&hands, 60), bend(&hands, 61)), (3.0, 3.0));
}

/// MMA RP-015.
#[test]
fn reset_all_controllers_is_for_its_channel() {
    let mut hands = assigned(&[
        (Source::ModWheel, Target::BowSpeed),
        (Source::Brightness, Target::Hardness),
        (Source::Pressure, Target::BowPressure),
    ]);
    for channel in [0, 1] {
        strike(&mut hands, channel, 60 + channel);
        send(&mut hands, channel, &[(1, 127), (74, 127), (64, 127)]);
        hands.pitch_bend(channel, 1.0);
        hands.channel_pressure(channel, 1.0);
    }
    let other = hands.key(61);
    send(&mut hands, 0, &[(101, 0), (100, 0), (121, 0), (6, 12)]);
    let key = hands.key(60);
    assert_eq!((key.bend_semitones, key.bow_pressure), (0.0, 0.0));
    assert_eq!(key.bow_speed_octaves, 0.0);
    assert_eq!(hands.touch(60).hardness_decades, 2.0, "CC 74 stays");
    release(&mut hands, 0, 60);
    assert_eq!(hands.dampers(60), 0.0);
    hands.pitch_bend(0, 1.0);
    assert_eq!(bend(&hands, 60), 2.0, "the parameter number was forgotten");
    assert_eq!(hands.key(61), other);
}

#[test]
fn only_what_moved_is_looked_at() {
    let mut hands = Hands::new();
    assert_eq!(hands.changed(), u128::MAX);
    assert_eq!(hands.changed(), 0);
    strike(&mut hands, 0, 60);
    strike(&mut hands, 0, 64);
    strike(&mut hands, 9, 70);
    assert_eq!(hands.changed(), bits(&[60, 64, 70]));
    hands.pitch_bend(0, 0.1);
    assert_eq!(hands.changed(), bits(&[60, 64]));
    send(&mut hands, 9, &[(1, 3)]);
    assert_eq!(hands.changed(), bits(&[70]));
    strike(&mut hands, 9, 64);
    assert_eq!(hands.changed(), bits(&[64]));
    hands.pitch_bend(0, 0.2);
    assert_eq!(hands.changed(), bits(&[60]), "64 is another channel's now");
    send(&mut hands, 9, &[(7, 3), (10, 3)]);
    hands.set(&Settings::default());
    assert_eq!(hands.changed(), 0, "not ours, and nothing new");
    hands.set(&Settings {
        mpe: Mpe::Off,
        ..Settings::default()
    });
    assert_eq!(hands.changed(), u128::MAX);
}

#[test]
fn a_reset_takes_the_hands_off_but_keeps_what_was_announced() {
    let mut hands = Hands::new();
    send(&mut hands, 0, &[(101, 0), (100, 0), (6, 12), (64, 127)]);
    strike(&mut hands, 0, 60);
    hands.pitch_bend(0, 1.0);
    hands.reset();
    assert_eq!((hands.held(), hands.dampers(60)), (0, 0.0));
    strike(&mut hands, 0, 60);
    assert_eq!(bend(&hands, 60), 0.0);
    hands.pitch_bend(0, 1.0);
    assert_eq!(bend(&hands, 60), 12.0);
}
