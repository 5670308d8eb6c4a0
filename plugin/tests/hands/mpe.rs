//! MIDI Polyphonic Expression 1.0 (MMA/AMEI RP-053), section by section. Channels count from 0 here.

use crate::support::{assigned, bend, configure, release, send, strike};
use idiophone::hands::{Hands, Mpe, Settings, Source, Target};

fn with(mpe: Mpe) -> Hands {
    let mut hands = Hands::new();
    hands.set(&Settings {
        mpe,
        ..Settings::default()
    });
    hands
}

/// §2.1: a configuration message on channel 1 opens the lower zone; §2.4: its ranges are 2 and 48
/// semitones; §2.3.2: both bends add.
#[test]
fn members_bend_alone_and_the_manager_bends_all() {
    let mut hands = Hands::new();
    hands.pitch_bend(1, 1.0);
    strike(&mut hands, 1, 60);
    assert_eq!(bend(&hands, 60), 2.0, "not before it is announced");
    configure(&mut hands, 0, 15);
    strike(&mut hands, 1, 60);
    strike(&mut hands, 2, 64);
    assert_eq!(bend(&hands, 60), 0.0);
    hands.pitch_bend(1, 0.25);
    hands.pitch_bend(0, -0.5);
    assert_eq!((bend(&hands, 60), bend(&hands, 64)), (11.0, -1.0));
}

/// §2.4: the range of one member is that of all; the manager has its own.
#[test]
fn bend_ranges_are_the_zone_s() {
    let mut hands = Hands::new();
    configure(&mut hands, 0, 15);
    send(&mut hands, 3, &[(101, 0), (100, 0), (6, 24)]);
    send(&mut hands, 0, &[(101, 0), (100, 0), (6, 12)]);
    strike(&mut hands, 1, 60);
    hands.pitch_bend(1, 1.0);
    assert_eq!(bend(&hands, 60), 24.0);
    hands.pitch_bend(0, 1.0);
    assert_eq!(bend(&hands, 60), 36.0);
    configure(&mut hands, 0, 15);
    assert_eq!(bend(&hands, 60), 50.0, "announced again: 48 and 2");
}

/// §2.1.1: the whole of the channels in two zones; then the upper takes some from the lower.
#[test]
fn two_zones_have_two_managers() {
    let mut hands = Hands::new();
    configure(&mut hands, 0, 7);
    configure(&mut hands, 15, 7);
    strike(&mut hands, 7, 60);
    strike(&mut hands, 8, 72);
    hands.pitch_bend(0, 1.0);
    assert_eq!((bend(&hands, 60), bend(&hands, 72)), (2.0, 0.0));
    hands.pitch_bend(15, -1.0);
    assert_eq!((bend(&hands, 60), bend(&hands, 72)), (2.0, -2.0));
    configure(&mut hands, 15, 10);
    strike(&mut hands, 7, 61);
    assert_eq!(bend(&hands, 61), -2.0, "channel 8 is the upper zone's");
    strike(&mut hands, 4, 62);
    assert_eq!(bend(&hands, 62), 2.0, "channel 5 is not");
}

/// §2.1.4: channels that enter or leave let go of their notes and go to rest; others play on.
#[test]
fn channels_that_change_sides_go_to_rest() {
    let mut hands = Hands::new();
    configure(&mut hands, 0, 7);
    for (channel, key) in [(3, 60), (7, 61), (12, 62)] {
        strike(&mut hands, channel, key);
        hands.pitch_bend(channel, 0.5);
    }
    configure(&mut hands, 15, 9);
    assert_eq!(hands.held(), 1 << 60);
    assert_eq!(bend(&hands, 60), 24.0);
    assert_eq!((bend(&hands, 61), bend(&hands, 62)), (0.0, 0.0));
    hands.pitch_bend(12, 1.0);
    assert_eq!(bend(&hands, 62), 0.0, "its finger is gone");
}

/// §2.1: no members, no zone.
#[test]
fn no_members_end_it() {
    let mut hands = Hands::new();
    configure(&mut hands, 0, 15);
    configure(&mut hands, 0, 0);
    strike(&mut hands, 1, 60);
    hands.pitch_bend(1, 1.0);
    hands.pitch_bend(0, 1.0);
    assert_eq!(bend(&hands, 60), 2.0, "an ordinary channel again");
}

/// §2.1.1: other channels and other numbers are invalid.
#[test]
fn invalid_messages_are_ignored() {
    let mut hands = Hands::new();
    configure(&mut hands, 4, 7);
    configure(&mut hands, 0, 16);
    strike(&mut hands, 5, 60);
    hands.pitch_bend(5, 1.0);
    assert_eq!(bend(&hands, 60), 2.0);
}

/// §3.3.3: what a member says after its note's end is for the next note; the manager still counts.
#[test]
fn a_released_note_keeps_its_bend() {
    let mut hands = assigned(&[
        (Source::Pressure, Target::BowPressure),
        (Source::Brightness, Target::Pan),
    ]);
    configure(&mut hands, 0, 15);
    hands.pitch_bend(1, 0.25);
    hands.controller(1, 74, 0.0);
    strike(&mut hands, 1, 60);
    hands.channel_pressure(1, 0.75);
    assert_eq!(hands.key(60).bow_pressure, 0.75);
    release(&mut hands, 1, 60);
    hands.pitch_bend(1, -1.0);
    hands.controller(1, 74, 1.0);
    hands.channel_pressure(1, 1.0);
    strike(&mut hands, 1, 67);
    assert_eq!(bend(&hands, 60), 12.0);
    assert_eq!(hands.key(60).pan, -1.0);
    assert_eq!(hands.key(60).bow_pressure, 0.0, "no finger, no pressure");
    assert_eq!(bend(&hands, 67), -48.0);
    assert_eq!(hands.key(67).bow_pressure, 1.0);
    hands.pitch_bend(0, 1.0);
    assert_eq!((bend(&hands, 60), bend(&hands, 67)), (14.0, -46.0));
    strike(&mut hands, 2, 60);
    assert_eq!(bend(&hands, 60), 2.0, "struck by another finger");
}

/// §2.2: with more notes than channels, those on one channel share it.
#[test]
fn notes_that_share_a_channel_bend_together() {
    let mut hands = Hands::new();
    configure(&mut hands, 0, 1);
    strike(&mut hands, 1, 60);
    strike(&mut hands, 1, 64);
    hands.pitch_bend(1, 0.125);
    assert_eq!((bend(&hands, 60), bend(&hands, 64)), (6.0, 6.0));
    release(&mut hands, 1, 60);
    hands.pitch_bend(1, 0.25);
    assert_eq!((bend(&hands, 60), bend(&hands, 64)), (6.0, 12.0));
}

/// §2.3, table 1: pedals and wheels are the manager's. §3.2: the manager may have notes.
#[test]
fn pedals_and_wheels_are_the_manager_s() {
    let mut hands = assigned(&[(Source::ModWheel, Target::BowSpeed)]);
    configure(&mut hands, 0, 15);
    strike(&mut hands, 1, 60);
    strike(&mut hands, 0, 48);
    send(&mut hands, 1, &[(1, 127), (64, 127), (66, 127)]);
    release(&mut hands, 1, 60);
    assert_eq!(hands.key(60).bow_speed_octaves, 0.0);
    assert_eq!(hands.dampers(60), 0.0);
    send(&mut hands, 0, &[(1, 127), (64, 127)]);
    for key in [60, 48] {
        assert_eq!(hands.key(key).bow_speed_octaves, 2.0);
        assert_eq!(hands.dampers(key), 1.0);
    }
    hands.pitch_bend(0, 1.0);
    assert_eq!(bend(&hands, 48), 2.0);
}

/// §2.5 and §2.6: what manager and member say is combined; pressures by the greater, CC 74 by the sum
/// about the middle.
#[test]
fn manager_and_member_are_combined() {
    let mut hands = assigned(&[
        (Source::Pressure, Target::BowPressure),
        (Source::Brightness, Target::Pan),
    ]);
    configure(&mut hands, 15, 15);
    strike(&mut hands, 0, 60);
    hands.channel_pressure(0, 0.5);
    hands.channel_pressure(15, 0.25);
    assert_eq!(hands.key(60).bow_pressure, 0.5);
    hands.channel_pressure(15, 0.75);
    assert_eq!(hands.key(60).bow_pressure, 0.75);
    send(&mut hands, 0, &[(74, 32)]);
    assert_eq!(hands.key(60).pan, -0.5);
    send(&mut hands, 15, &[(74, 48)]);
    assert_eq!(hands.key(60).pan, -0.75);
    send(&mut hands, 15, &[(74, 0)]);
    assert_eq!(hands.key(60).pan, -1.0);
}

/// Reset all controllers on the manager is for the zone; a member's is none of ours (§2.3).
#[test]
fn the_manager_resets_its_zone() {
    let mut hands = Hands::new();
    configure(&mut hands, 0, 15);
    strike(&mut hands, 1, 60);
    hands.pitch_bend(1, 1.0);
    hands.pitch_bend(0, 1.0);
    send(&mut hands, 1, &[(121, 0)]);
    assert_eq!(bend(&hands, 60), 50.0);
    send(&mut hands, 0, &[(121, 0)]);
    assert_eq!(bend(&hands, 60), 0.0);
}

#[test]
fn the_setting_decides_what_is_believed() {
    let mut off = with(Mpe::Off);
    configure(&mut off, 0, 15);
    strike(&mut off, 1, 60);
    off.pitch_bend(1, 1.0);
    assert_eq!(bend(&off, 60), 2.0);

    let mut always = with(Mpe::Lower);
    strike(&mut always, 15, 60);
    always.pitch_bend(15, 1.0);
    configure(&mut always, 15, 7);
    configure(&mut always, 0, 0);
    assert_eq!(bend(&always, 60), 48.0);
    assert_eq!(always.held(), 1 << 60);

    always.set(&Settings {
        mpe: Mpe::Lower,
        member_bend_range_semitones: 24.0,
        ..Settings::default()
    });
    assert_eq!(bend(&always, 60), 24.0);
    always.set(&Settings::default());
    assert_eq!((bend(&always, 60), always.held()), (0.0, 0));
}

#[test]
fn zones_outlive_a_reset() {
    let mut hands = Hands::new();
    configure(&mut hands, 0, 15);
    hands.reset();
    strike(&mut hands, 1, 60);
    hands.pitch_bend(1, 1.0);
    assert_eq!(bend(&hands, 60), 48.0);
}
