//! Whatever a host may send, in no order that makes sense.

use idiophone_tests::{Noise, peak, playing};
use xtask::host::{Event, Param};

/// Events in all.
const EVENTS: usize = 100_000;
/// Longest block.
const BLOCK: u64 = 512;
/// No sample of the storm is greater.
const BOUND: f32 = 8.0;

pub(super) fn random(noise: &mut Noise, params: &[Param]) -> Event {
    let odd = |noise: &mut Noise, value: f64| match noise.below(50) {
        0 => f64::NAN,
        1 => f64::INFINITY,
        2 => -1e30,
        _ => value,
    };
    let (channel, key) = (noise.below(16) as u8, noise.data_byte());
    let velocity = noise.unit();
    match noise.below(10) {
        0..3 => Event::NoteOn {
            channel,
            key,
            note_id: noise.below(64) as u32,
            velocity: odd(noise, velocity),
        },
        3 => Event::NoteOff {
            channel,
            key,
            note_id: noise.below(64) as u32,
            velocity: odd(noise, velocity),
        },
        4 => Event::Choke { channel, key },
        5 => Event::Midi([
            0x80 | (noise.below(112) as u8),
            noise.data_byte(),
            noise.data_byte(),
        ]),
        6 => Event::Transport {
            playing: noise.below(2) == 0,
            tempo_bpm: 20.0 + 300.0 * noise.unit(),
            seconds: 1000.0 * noise.unit(),
        },
        _ => {
            let param = &params[noise.below(params.len() as u64) as usize];
            let value = param.min + noise.unit() * (param.max - param.min);
            Event::Param {
                id: param.id,
                value: odd(noise, value),
            }
        }
    }
}

#[test]
fn a_storm_of_events_leaves_the_sound_finite() {
    let mut plugin = playing(48_000.0).unwrap();
    let params: Vec<_> = plugin.params();
    let mut noise = Noise::new(2002);
    let loudest = plugin
        .on_audio_thread(|audio| {
            let (mut sent, mut loudest) = (0, 0.0f32);
            while sent < EVENTS {
                let frames = noise.below(BLOCK) + 1;
                let count = noise.below(48) as usize;
                let mut events: Vec<_> = (0..count)
                    .map(|_| random(&mut noise, &params).at(noise.below(frames)))
                    .collect();
                events.sort_by_key(|event| event.frame);
                let take = audio
                    .play(&events, frames as usize, BLOCK as usize)
                    .unwrap();
                loudest = loudest.max(peak(&take.left)).max(peak(&take.right));
                sent += count;
            }
            loudest
        })
        .unwrap();
    println!("loudest sample {loudest}");
    assert!(loudest > 0.0 && loudest < BOUND, "{loudest}");
}
