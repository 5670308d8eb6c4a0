//! Lists of events that a host should not send.

use idiophone_tests::{Noise, peak, playing, strike};
use xtask::host::{Block, Event, ParamId, ProcessStatus, TimedEvent};

const FRAMES: usize = 512;

/// One block after another of an instance of their own, each of `FRAMES` unless it says otherwise.
fn play(blocks: &[(&[TimedEvent], usize)]) -> (Vec<u32>, Vec<Block>) {
    let mut plugin = playing(48_000.0).unwrap();
    plugin
        .on_audio_thread(|audio| {
            let (mut bits, mut said) = (Vec::new(), Vec::new());
            for &(events, frames) in blocks {
                let (mut left, mut right) = (vec![0.0; frames], vec![0.0; frames]);
                said.push(audio.process(events, &mut left, &mut right).unwrap());
                assert!(left.iter().chain(&right).all(|sample| sample.is_finite()));
                bits.extend(left.iter().chain(&right).map(|sample| sample.to_bits()));
            }
            (bits, said)
        })
        .unwrap()
}

/// The bits of a block of events and of a quiet one after it.
fn bits(events: &[TimedEvent]) -> Vec<u32> {
    play(&[(events, FRAMES), (&[], FRAMES)]).0
}

fn silent(bits: &[u32]) -> bool {
    bits.iter().all(|bits| f32::from_bits(*bits) == 0.0)
}

/// A parameter that is heard and can be automated, and two of its values.
fn output() -> (ParamId, f64, f64) {
    let mut plugin = playing(48_000.0).unwrap();
    let params = plugin.params();
    let output = params
        .iter()
        .find(|param| param.name == "Output gain")
        .unwrap();
    (output.id, output.min, output.default)
}

fn set(id: ParamId, value: f64) -> Event {
    Event::Param { id, value }
}

/// Notes, controllers and a parameter at random frames, in order.
fn piece(noise: &mut Noise, count: usize) -> Vec<TimedEvent> {
    let (id, low, high) = output();
    let mut events: Vec<_> = (0..count)
        .map(|_| {
            let key = 60 + noise.below(24) as u8;
            let value = low + (high - low) * (0.5 + 0.5 * noise.unit());
            let event = match noise.below(4) {
                0 => set(id, value),
                1 => Event::controller(64, noise.data_byte()),
                _ => strike(key, noise.unit()),
            };
            event.at(noise.below(FRAMES as u64))
        })
        .collect();
    events.sort_by_key(|event| event.frame);
    events
}

#[test]
fn events_in_any_order_sound_as_in_theirs() {
    let mut noise = Noise::new(7);
    for count in [2, 40, 4000] {
        let sorted = piece(&mut noise, count);
        let mut shuffled = sorted;
        for last in (1..count).rev() {
            let other = noise.below(last as u64 + 1) as usize;
            shuffled.swap(last, other);
        }
        // Events of one frame keep the order in which they come.
        let mut again = shuffled.clone();
        again.sort_by_key(|event| event.frame);
        let in_order = bits(&again);
        assert!(!silent(&in_order));
        assert!(bits(&shuffled) == in_order, "{count} events");
        let reversed: Vec<_> = again
            .chunk_by(|a, b| a.frame == b.frame)
            .rev()
            .flatten()
            .copied()
            .collect();
        assert!(bits(&reversed) == in_order, "{count} events from the last");
    }
}

#[test]
fn events_beyond_the_block_come_at_its_last_frame() {
    let (id, low, high) = output();
    let last = FRAMES as u64 - 1;
    let events = |frame| {
        [
            strike(74, 0.8).at(3),
            set(id, 0.5 * (low + high)).at(frame),
            strike(81, 0.9).at(frame),
            set(id, high).at(frame),
        ]
    };
    let in_time = bits(&events(last));
    assert_ne!(in_time, bits(&events(last)[..1]), "they are heard");
    for frame in [FRAMES as u64, 2 * FRAMES as u64, u64::from(u32::MAX)] {
        assert!(bits(&events(frame)) == in_time, "frame {frame}");
    }
}

#[test]
fn notes_in_an_empty_block_sound_in_the_next() {
    let notes = [strike(74, 0.8).at(0), strike(81, 0.5).at(9)];
    let at_once = [strike(74, 0.8).at(0), strike(81, 0.5).at(0)];
    let later = [strike(60, 0.7).at(0), strike(67, 0.7).at(100)];
    let (late, said) = play(&[(&notes, 0), (&[], 0), (&later, FRAMES), (&[], FRAMES)]);
    let (wanted, _) = play(&[(&[&at_once[..], &later].concat(), FRAMES), (&[], FRAMES)]);
    assert!(late == wanted);
    assert_eq!(said[0].status, ProcessStatus::Continue, "something waits");
    assert_eq!(said[1].status, ProcessStatus::Continue, "still");
}

#[test]
fn more_notes_than_can_wait_do_no_harm() {
    let notes: Vec<_> = (0..10_000)
        .map(|note| strike(60 + (note % 24) as u8, 0.5).at(note))
        .collect();
    let (late, _) = play(&[(&notes, 0), (&notes, 0), (&[], FRAMES)]);
    assert!(!silent(&late));
}

#[test]
fn parameters_in_an_empty_block_are_set_at_once() {
    let (id, low, high) = output();
    let mut plugin = playing(48_000.0).unwrap();
    let value = 0.5 * (low + high);
    let events = [strike(74, 0.5).at(4), set(id, value).at(5)];
    plugin
        .on_audio_thread(|audio| audio.process(&events, &mut [], &mut []))
        .unwrap()
        .unwrap();
    let now = plugin.value(id).unwrap();
    assert!((now - value).abs() < 1e-6, "{now} for {value}");
}

#[test]
fn a_reset_forgets_the_notes_that_wait() {
    let mut plugin = playing(48_000.0).unwrap();
    let quiet = |plugin: &mut xtask::host::Plugin, reset: bool| {
        plugin
            .on_audio_thread(|audio| {
                let note = [strike(74, 0.8).at(0)];
                audio.process(&note, &mut [], &mut []).unwrap();
                if reset {
                    audio.reset();
                }
                peak(&audio.play(&[], FRAMES, FRAMES).unwrap().left)
            })
            .unwrap()
    };
    assert_eq!(quiet(&mut plugin, true), 0.0);
    assert!(quiet(&mut plugin, false) > 0.0);
}

#[test]
fn a_velocity_that_is_no_number_is_none() {
    let note = |velocity| [strike(74, velocity).at(5)];
    assert_eq!(bits(&note(f64::NAN)), bits(&note(0.0)));
    assert_eq!(bits(&note(f64::INFINITY)), bits(&note(1.0)));
    assert_eq!(bits(&note(-3.0)), bits(&note(0.0)));
    assert_ne!(bits(&note(0.5)), bits(&note(1.0)));
}

#[test]
fn keys_and_channels_that_do_not_exist_are_not_all_of_them() {
    let note = strike(74, 0.8).at(0);
    let alone = bits(&[note]);
    for (channel, key) in [(0, 200), (99, 74)] {
        let choke = Event::Choke { channel, key }.at(64);
        assert!(bits(&[note, choke]) == alone, "channel {channel} key {key}");
    }
    let choke = Event::Choke {
        channel: 0,
        key: 74,
    };
    assert!(bits(&[note, choke.at(64)]) != alone);
}

#[test]
fn ten_thousand_events_fit_into_a_block() {
    const COUNT: u64 = 10_000;
    let (id, low, high) = output();
    let sorted: Vec<_> = (0..COUNT)
        .map(|number| {
            let event = match number % 25 {
                24 => set(id, 0.5 * (low + high)),
                key => strike(60 + key as u8, 0.1),
            };
            event.at(number * FRAMES as u64 / COUNT)
        })
        .collect();
    let reversed: Vec<_> = sorted.iter().rev().copied().collect();
    for events in [&sorted, &reversed] {
        let (_, said) = play(&[(events, FRAMES)]);
        // Each note ends the one before it on its key.
        assert_eq!(said[0].ended.len() as u64, COUNT / 25 * 24 - 24);
    }
}

#[test]
fn an_event_shorter_than_its_type_is_not_played() {
    let misformed = |size| Event::Misformed { key: 74, size }.at(0);
    for size in [0, 1, 8, 15, 16, 39] {
        assert!(silent(&bits(&[misformed(size)])), "{size} bytes");
        let sound = strike(81, 0.5).at(9);
        assert_eq!(bits(&[misformed(size), sound]), bits(&[sound]));
    }
    assert!(!silent(&bits(&[misformed(40)])));
}
