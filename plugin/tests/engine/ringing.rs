//! The bank by which the engine's cost is measured really rings, every mode of it.

#[path = "../../examples/ring/bank.rs"]
mod bank;

use crate::support::{db, expected, fit, left};
use idiophone::engine::Engine;

const RATE_HZ: f64 = 48_000.0;

#[test]
fn every_mode_of_the_measured_bank_is_struck_and_rings_for_a_minute() {
    let bank = bank::bank(2, 64, bank::WIDE);
    let mut all_hz: Vec<f64> = bank
        .bodies
        .iter()
        .flat_map(|b| &b.modes)
        .map(|m| m.hz)
        .collect();
    all_hz.sort_by(f64::total_cmp);
    assert_eq!(all_hz.len(), 128);
    for (index, hz) in all_hz.iter().enumerate() {
        let even = 50.0 + 15_000.0 * index as f64 / 128.0;
        assert!((hz - even).abs() < 1e-9, "{hz} Hz instead of {even} Hz");
    }
    let mut engine = Engine::new(&bank, RATE_HZ);
    engine.set(&bank::MALLET);
    assert!(engine.strike(1, 1.0));
    let signal = left(&mut engine, 4800 + 16_384);
    let expected = expected(&bank.bodies[1], bank.damping);
    let seen = fit(&signal, RATE_HZ, &expected, 4800..signal.len());
    let loudest = seen
        .iter()
        .fold(0.0, |most: f64, mode| most.max(mode.amplitude));
    for (seen, (hz, decay_per_s)) in seen.iter().zip(&expected) {
        let t60_s = 1000f64.ln() / decay_per_s;
        assert!((t60_s - 60.0).abs() < 1e-3, "{hz} Hz: T60 {t60_s} s");
        let level_db = db(seen.amplitude / loudest);
        println!("{hz:.0} Hz: {level_db:.1} dB, {:.5} 1/s", seen.decay_per_s);
        assert!(level_db > -20.0, "{hz} Hz: {level_db} dB");
        let off = seen.decay_per_s / decay_per_s - 1.0;
        assert!(off.abs() < 0.01, "{hz} Hz: decay off by {off}");
    }
}
