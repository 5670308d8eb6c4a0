//! Notes in, sound out.

use idiophone_tests::{peak, playing, plugin, release, strike};
use xtask::host::{Event, NoteExpressionType, Plugin, ProcessStatus, Take, TimedEvent};
use xtask::settings;

/// Sets parameters of an inactive instance by name.
fn set(plugin: &mut Plugin, texts: &[&str]) {
    for text in texts {
        let setting = settings::setting(plugin, text).unwrap();
        plugin.set(&[setting]).unwrap();
    }
}

fn bits(take: &Take) -> Vec<u32> {
    let both = take.left.iter().chain(&take.right);
    both.map(|sample| sample.to_bits()).collect()
}

#[test]
fn a_strike_sounds_from_its_frame_on() {
    let mut plugin = playing(48_000.0).unwrap();
    let take = plugin
        .play(&[strike(74, 0.8).at(1000)], 48_000, 512)
        .unwrap();
    for channel in [&take.left, &take.right] {
        assert_eq!(peak(&channel[..1000]), 0.0);
        assert!(peak(&channel[1000..2000]) > 1e-3);
        assert!(peak(&channel[40_000..]) > 1e-4, "it rings on");
    }
    assert_ne!(take.status, ProcessStatus::Sleep);
}

#[test]
fn harder_strikes_are_louder() {
    let mut last = 0.0;
    for velocity in [0.1, 0.4, 0.7, 1.0] {
        let mut plugin = playing(48_000.0).unwrap();
        let take = plugin
            .play(&[strike(74, velocity).at(0)], 9600, 512)
            .unwrap();
        let now = peak(&take.left);
        assert!(now > last, "velocity {velocity}: {now} after {last}");
        last = now;
    }
}

#[test]
fn a_note_that_has_died_away_ends_and_leaves_silence() {
    let mut plugin = plugin().unwrap();
    set(&mut plugin, &["Alpha 2=50 1/s"]);
    plugin.activate(48_000.0, 512).unwrap();
    let events = [strike(74, 0.8).at(10), release(74).at(4800)];
    let take = plugin.play(&events, 96_000, 512).unwrap();
    let ids: Vec<_> = take.ended.iter().map(|(_, id)| *id).collect();
    assert_eq!(ids, [Some(74)]);
    let after = plugin.play(&[], 4800, 512).unwrap();
    assert_eq!(peak(&after.left), 0.0);
    assert!(matches!(
        after.status,
        ProcessStatus::Sleep | ProcessStatus::ContinueIfNotQuiet
    ));
}

/// A short piece that moves every parameter and every controller while it rings.
fn piece(plugin: &mut Plugin) -> Vec<TimedEvent> {
    let mut events = vec![
        strike(50, 1.0).at(0),
        strike(74, 0.3).at(3),
        strike(81, 0.6).at(64),
        strike(74, 0.9).at(5000),
        Event::controller(1, 90).at(6000),
        Event::Midi([0xE0, 0, 80]).at(6001),
        release(50).at(7000),
        strike(93, 0.5).at(7000),
    ];
    events.extend(hands(plugin));
    for (number, param) in plugin
        .params()
        .iter()
        .filter(|param| !param.hidden)
        .enumerate()
    {
        for step in 0..4u64 {
            let value = param.default + 0.1 * step as f64 * (param.max - param.default);
            let value = if param.stepped { value.round() } else { value };
            let id = param.id;
            events.push(Event::Param { id, value }.at(300 + 1009 * step + 97 * number as u64));
        }
    }
    events.sort_by_key(|event| event.frame);
    events
}

/// Pedals, pressure, MPE, note expressions and modulation, some of them at the sample of a strike.
fn hands(plugin: &mut Plugin) -> Vec<TimedEvent> {
    let params = plugin.params();
    let position = settings::find(&params, "Strike position").unwrap().id;
    let damping = settings::find(&params, "Alpha 2").unwrap().id;
    let said = |kind, note_id, value| Event::Expression {
        kind,
        note_id,
        value,
    };
    let modulated = |id, note_id, amount| Event::Modulation {
        id,
        note_id,
        amount,
    };
    let midi = |bytes| Event::Midi(bytes);
    vec![
        said(NoteExpressionType::Tuning, 74, 0.4).at(3),
        modulated(position, 74, 0.3).at(3),
        said(NoteExpressionType::Brightness, 81, 0.9).at(64),
        modulated(damping, 74, 0.4).at(700),
        said(NoteExpressionType::Volume, 50, 0.7).at(777),
        said(NoteExpressionType::Pan, 50, 0.1).at(1500),
        midi([0xD0, 60, 0]).at(2000),
        midi([0xA0, 81, 90]).at(2222),
        midi([0xB0, 101, 0]).at(2500),
        midi([0xB0, 100, 6]).at(2500),
        midi([0xB0, 6, 8]).at(2500),
        Event::NoteOn {
            channel: 3,
            key: 62,
            note_id: 62,
            velocity: 0.7,
        }
        .at(2600),
        midi([0xE3, 12, 70]).at(2600),
        midi([0xE3, 99, 60]).at(3003),
        midi([0xB0, 64, 70]).at(3500),
        midi([0xB0, 66, 127]).at(3600),
        release(81).at(4000),
        midi([0xB0, 11, 90]).at(4444),
        midi([0xB0, 64, 0]).at(9000),
        midi([0xB0, 121, 0]).at(9100),
    ]
}

#[test]
fn block_size_does_not_change_a_bit() {
    let take = |block: usize| {
        let mut plugin = playing(48_000.0).unwrap();
        let events = piece(&mut plugin);
        bits(&plugin.play(&events, 12_000, block).unwrap())
    };
    let reference = take(512);
    for block in [1, 7, 64, 4096] {
        let same = take(block) == reference;
        assert!(same, "blocks of {block} differ from blocks of 512");
    }
}

#[test]
fn a_tail_is_told_that_holds() {
    let mut plugin = plugin().unwrap();
    set(&mut plugin, &["Alpha 2=50 1/s"]);
    plugin.activate(48_000.0, 512).unwrap();
    let (tail, after) = plugin
        .on_audio_thread(|audio| {
            audio.play(&[strike(74, 0.8).at(0)], 4800, 512).unwrap();
            let tail = audio.tail().expect("an end");
            audio.play(&[], tail as usize, 512).unwrap();
            (tail, peak(&audio.play(&[], 4800, 512).unwrap().left))
        })
        .unwrap();
    // 100 dB by the strongest modes' own decay rate of 25 1/s and more.
    assert!((4800..48_000).contains(&tail), "{tail} frames");
    assert!(after < 1e-5, "{after} after {tail} frames");
}

#[test]
fn two_instances_keep_to_themselves() {
    let alone = {
        let mut plugin = playing(48_000.0).unwrap();
        let events = piece(&mut plugin);
        bits(&plugin.play(&events, 9600, 480).unwrap())
    };
    let mut one = playing(48_000.0).unwrap();
    let mut other = plugin().unwrap();
    set(&mut other, &["Alpha 1=1e-5 s", "Output=-3 dB"]);
    other.activate(96_000.0, 64).unwrap();
    let events = piece(&mut one);
    let mut left = Vec::new();
    let mut right = Vec::new();
    for start in (0..9600u64).step_by(480) {
        let now: Vec<_> = events
            .iter()
            .filter(|event| (start..start + 480).contains(&event.frame))
            .map(|event| event.event.at(event.frame - start))
            .collect();
        let take = one.play(&now, 480, 480).unwrap();
        left.extend(take.left);
        right.extend(take.right);
        let key = 60 + (start / 480) as u8;
        other.play(&[strike(key, 0.9).at(5)], 333, 64).unwrap();
    }
    left.append(&mut right);
    let together: Vec<_> = left.iter().map(|sample| sample.to_bits()).collect();
    assert!(together == alone);
}

#[test]
fn an_instance_plays_at_one_rate_after_another() {
    let mut plugin = plugin().unwrap();
    for (rate_hz, block) in [
        (44_100.0, 64),
        (192_000.0, 2048),
        (48_000.0, 1),
        (96_000.0, 333),
    ] {
        plugin.activate(rate_hz, block).unwrap();
        let silent = plugin.play(&[], 1024, block as usize).unwrap();
        assert_eq!(
            peak(&silent.left),
            0.0,
            "nothing is left over at {rate_hz} Hz"
        );
        let take = plugin
            .play(&[strike(74, 0.8).at(0)], 4096, block as usize)
            .unwrap();
        assert!(peak(&take.left) > 1e-3, "{rate_hz} Hz");
        plugin.deactivate();
    }
}

#[test]
fn empty_blocks_do_no_harm() {
    let mut plugin = playing(48_000.0).unwrap();
    plugin
        .on_audio_thread(|audio| {
            for _ in 0..10 {
                audio.process(&[], &mut [], &mut []).unwrap();
                let take = audio.play(&[strike(74, 0.5).at(1)], 64, 64).unwrap();
                assert!(peak(&take.left) > 0.0);
            }
        })
        .unwrap();
}

#[test]
fn a_long_quiet_block_is_silent() {
    let mut plugin = playing(48_000.0).unwrap();
    let take = plugin.play(&[], 48_000, 4096).unwrap();
    assert!(bits(&take).iter().all(|bits| *bits == 0));
}
