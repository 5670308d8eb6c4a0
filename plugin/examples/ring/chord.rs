//! What the first block costs when every key is struck at once.

use crate::{RATE_HZ, render};
use idiophone::engine::{Engine, GRID};
use idiophone::factory;
use std::time::Instant;

/// Samples between two chords, in which the bodies at rest are made ready.
const REST: usize = 48 * GRID;

/// Prints the least time of `runs` chords at fortissimo of each factory instrument, as lines of JSON.
pub(crate) fn time(runs: usize) {
    for (index, title) in factory::titles().enumerate() {
        let bank = factory::bank(index);
        let mut engine = Engine::new(bank, RATE_HZ);
        let (mut struck_s, mut block_s) = (f64::MAX, f64::MAX);
        for _ in 0..runs {
            engine.reset();
            render(&mut engine, REST);
            let start = Instant::now();
            for body in &bank.bodies {
                engine.strike(body.key, 1.0);
            }
            let struck = start.elapsed().as_secs_f64();
            render(&mut engine, GRID);
            let both = start.elapsed().as_secs_f64();
            if both < block_s {
                (struck_s, block_s) = (struck, both);
            }
        }
        println!(
            concat!(
                r#"{{"instrument": "{}", "keys": {}, "modes": {}, "strikes_ms": {:.4}, "#,
                r#""first_block_ms": {:.4}, "block_lasts_ms": {:.4}}}"#
            ),
            title,
            bank.bodies.len(),
            bank.bodies
                .iter()
                .map(|body| body.modes.len())
                .sum::<usize>(),
            1e3 * struck_s,
            1e3 * block_s,
            1e3 * GRID as f64 / RATE_HZ,
        );
    }
}
