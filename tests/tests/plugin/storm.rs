//! Whatever a host may send, in no order that makes sense.

use idiophone::engine::OUTPUT_BOUND;
use idiophone_tests::{Noise, peak, playing};
use xtask::host::{Event, NoteExpressionType, Param};

/// Events in all.
const EVENTS: usize = 30_000;
/// Frames a second.
const RATE: usize = 48_000;
/// What five instruments make together at most, with the limiter off.
pub(super) const BOUND: f32 = 5.0 * OUTPUT_BOUND;
/// Longest block.
const BLOCK: u64 = 512;
const EXPRESSIONS: [NoteExpressionType; 7] = [
    NoteExpressionType::Volume,
    NoteExpressionType::Pan,
    NoteExpressionType::Tuning,
    NoteExpressionType::Vibrato,
    NoteExpressionType::Expression,
    NoteExpressionType::Brightness,
    NoteExpressionType::Pressure,
];

/// Anything that a host may say of an instrument with these parameters.
pub(super) fn random(noise: &mut Noise, params: &[Param]) -> Event {
    let odd = |noise: &mut Noise, value: f64| match noise.below(50) {
        0 => f64::NAN,
        1 => f64::INFINITY,
        2 => -1e30,
        _ => value,
    };
    let (channel, key) = (noise.below(16) as u8, noise.data_byte());
    let velocity = noise.unit();
    match noise.below(12) {
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
        7 => Event::Expression {
            kind: EXPRESSIONS[noise.below(7) as usize],
            note_id: noise.below(64) as u32,
            value: odd(noise, 128.0 * velocity * velocity * velocity - 4.0),
        },
        8 => {
            let some: Vec<_> = params.iter().filter(|param| param.modulatable).collect();
            Event::Modulation {
                id: some[noise.below(some.len() as u64) as usize].id,
                note_id: noise.below(64) as u32,
                amount: odd(noise, 2.0 * velocity - 1.0),
            }
        }
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
    let mut plugin = playing(RATE as f64).unwrap();
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
            // What is once no number would stay it.
            let hush = Event::controller(120, 0).at(0);
            audio.play(&[hush], RATE, BLOCK as usize).unwrap();
            let after = audio.play(&[], 4800, BLOCK as usize).unwrap();
            assert_eq!(peak(&after.left), 0.0, "after the storm");
            loudest
        })
        .unwrap();
    println!("loudest sample {loudest}");
    assert!(loudest > 0.0 && loudest < BOUND, "{loudest}");
}
