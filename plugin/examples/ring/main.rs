//! The engine with bodies of 64 modes that ring for a minute, at 48 kHz: timed, or only rendered.
//!
//! ```text
//! ring time BODIES RUNS [VECTORS]    least times of so many short runs, as one line of JSON
//! ring chord RUNS                    first blocks of chords of all keys, a line for each instrument
//! ring render BODIES SAMPLES         so many samples after a tenth of a second of strikes
//! ```

mod bank;
mod chord;
mod cost;
mod vectors;

use cost::Cost;
use idiophone::engine::Engine;
use modes::Bank;
use std::process::ExitCode;
use vectors::Vectors;

/// Sample rate, in Hz.
const RATE_HZ: f64 = 48_000.0;

/// Samples in a block.
const BLOCK: usize = 64;

/// Modes of a body.
const MODES: usize = 64;

/// After so many blocks the mallets are off.
const STRUCK_BLOCKS: usize = 75;

const USAGE: &str =
    "usage: ring time BODIES RUNS [VECTORS] | ring chord RUNS | ring render BODIES SAMPLES";

fn main() -> ExitCode {
    let words: Vec<String> = std::env::args().skip(1).collect();
    let words: Vec<&str> = words.iter().map(String::as_str).collect();
    match run(&words) {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("{error}");
            ExitCode::from(2)
        }
    }
}

fn run(words: &[&str]) -> Result<(), String> {
    match *words {
        ["time", bodies, runs, ref vectors @ ..] if vectors.len() < 2 => {
            let vectors = Vectors::choose(vectors.first().copied())?;
            let (bodies, runs) = (bodies_of(bodies)?, number(runs)?);
            println!("{}", Cost::of(bodies, runs, vectors).json());
        }
        ["chord", runs] => chord::time(number(runs)?),
        ["render", bodies, samples] => {
            let mut engine = ringing(bodies_of(bodies)?, bank::WIDE, Vectors::choose(None)?);
            render(&mut engine, number(samples)?);
        }
        _ => return Err(USAGE.into()),
    }
    Ok(())
}

fn number(word: &str) -> Result<usize, String> {
    let number = word.parse().ok().filter(|number| *number > 0);
    number.ok_or_else(|| format!("{word}: must be a whole number above 0"))
}

fn bodies_of(word: &str) -> Result<u8, String> {
    let bodies = word
        .parse()
        .ok()
        .filter(|bodies| (1..=128).contains(bodies));
    bodies.ok_or_else(|| format!("{word}: bodies must be 1 to 128, one for a key"))
}

/// An engine whose bodies, of [`MODES`] modes each over `band`, have been struck hard and are left alone.
fn ringing(bodies: u8, band: bank::Band, vectors: Vectors) -> Engine {
    struck(&bank::bank(bodies, MODES, band), bodies, vectors)
}

/// An engine whose bodies have been struck hard and are left alone.
fn struck(bank: &Bank, bodies: u8, vectors: Vectors) -> Engine {
    let mut engine = vectors.engine(bank, RATE_HZ);
    engine.set(&bank::MALLET);
    for key in 0..bodies {
        engine.strike(key, 1.0);
    }
    render(&mut engine, STRUCK_BLOCKS * BLOCK);
    engine
}

/// Renders in blocks, the last of them shorter if need be.
fn render(engine: &mut Engine, samples: usize) {
    let (mut left, mut right) = ([0.0; BLOCK], [0.0; BLOCK]);
    let mut rest = samples;
    while rest > 0 {
        let block = rest.min(BLOCK);
        engine.process(&mut left[..block], &mut right[..block]);
        std::hint::black_box((&left, &right));
        rest -= block;
    }
}
