//! Events in no order that makes sense, and how loud they can get.

use crate::Noise;
use idiophone::engine::OUTPUT_BOUND;
use xtask::host::{Event, NoteExpressionType, Param};

/// What five instruments make together at most, with the limiter off.
pub const BOUND: f32 = 5.0 * OUTPUT_BOUND;
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
#[must_use]
pub fn random(noise: &mut Noise, params: &[Param]) -> Event {
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
