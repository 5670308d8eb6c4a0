//! The discs in the resonators shut what they shut, and nothing else.

use crate::support::{chimes, db, expected, fit, left, window};
use idiophone::engine::{Discs, Engine, Settings};
use modes::Bank;
use std::f64::consts::TAU;

const RATE_HZ: f64 = 48_000.0;

/// What the resonator adds to the fundamental: in quadrature, as a tuned tube's is, three times what
/// the body sends itself, and so many 1/s of decay.
const PIPE: f32 = 3.0;
const PIPE_PER_S: f32 = 0.4;

fn bank() -> Bank {
    let mut bank = chimes([60]);
    let mode = &mut bank.bodies[0].modes[0];
    mode.pipe_ears = mode.ears.map(|[y, _]| [0.0, PIPE * y]);
    mode.pipe_per_s = PIPE_PER_S;
    bank
}

fn struck(motor: Discs, samples: usize) -> Vec<f64> {
    let mut engine = Engine::new(&bank(), RATE_HZ);
    engine.set(&Settings {
        motor,
        ..Settings::default()
    });
    // The parameters arrive, and the discs with them.
    left(&mut engine, 4096);
    engine.strike(60, 0.8);
    left(&mut engine, samples)
}

/// Amplitudes and decay rates of the first two partials.
fn partials(signal: &[f64], pipe_per_s: f64) -> [(f64, f64); 2] {
    let bank = bank();
    let mut expected = expected(&bank.bodies[0], bank.damping);
    expected[0].1 += pipe_per_s;
    let found = fit(signal, RATE_HZ, &expected, 480..24_000);
    [0, 1].map(|i| (found[i].amplitude, found[i].decay_per_s))
}

const SHUT: Discs = Discs {
    phase_deg: 0.0,
    ..Discs::OPEN
};

#[test]
fn shut_discs_take_the_resonator_away() {
    let open = partials(&struck(Discs::OPEN, 24_000), f64::from(PIPE_PER_S));
    let shut = partials(&struck(SHUT, 24_000), 0.0);
    let louder = open[0].0 / shut[0].0;
    let expected = 1f64.hypot(f64::from(PIPE));
    assert!(db(louder / expected).abs() < 0.01, "{louder}");
    let shorter = open[0].1 - shut[0].1;
    assert!(
        (shorter / f64::from(PIPE_PER_S) - 1.0).abs() < 1e-3,
        "{shorter}"
    );
    // The mallet meets a fundamental that has lost a little more: nothing else tells the two apart.
    let second = db(open[1].0 / shut[1].0);
    println!("second: {second:.1e} dB");
    assert!(second.abs() < 1e-4, "the second is the same: {second} dB");
}

/// Levels every 10 ms, of 40 ms under a window, of the partial at `hz`.
fn levels(signal: &[f64], hz: f64) -> Vec<f64> {
    const LENGTH: usize = 1920;
    let windows = signal.windows(LENGTH).step_by(480);
    windows
        .map(|samples| {
            let (mut re, mut im) = (0.0, 0.0);
            for (n, sample) in samples.iter().enumerate() {
                let (sin, cos) = (TAU * hz * n as f64 / RATE_HZ).sin_cos();
                re += window(n, LENGTH) * sample * cos;
                im += window(n, LENGTH) * sample * sin;
            }
            f64::hypot(re, im)
        })
        .collect()
}

#[test]
fn a_running_motor_beats_the_fundamental_alone() {
    let motor = Discs {
        speed_hz: 4.0,
        ..Discs::OPEN
    };
    let (turning, open) = (struck(motor, 96_000), struck(Discs::OPEN, 96_000));
    let modes = &bank().bodies[0].modes;
    let swing = |hz: f64| {
        let (moved, still) = (levels(&turning, hz), levels(&open, hz));
        let ratios: Vec<f64> = moved.iter().zip(&still).map(|(a, b)| a / b).collect();
        let (low, high) = ratios
            .iter()
            .fold((f64::MAX, 0.0), |(low, high): (f64, f64), r| {
                (low.min(*r), high.max(*r))
            });
        let middle = 0.5 * (low + high);
        let falls = ratios
            .windows(2)
            .filter(|w| w[0] >= middle && w[1] < middle);
        (falls.count(), db(high / low))
    };
    let (beats, depth_db) = swing(modes[0].hz);
    // Four a second for two seconds; the first may have begun before.
    assert!((7..=8).contains(&beats), "{beats}");
    assert!(depth_db > 6.0, "{depth_db} dB");
    let (_, depth_db) = swing(modes[1].hz);
    assert!(depth_db < 0.1, "{depth_db} dB");
}
