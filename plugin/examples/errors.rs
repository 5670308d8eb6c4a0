//! How far one ringing mode is off its closed form after 30 s, T60 60 s, as a Markdown table.

#[path = "../tests/engine/support.rs"]
#[expect(dead_code, reason = "the tests use the rest")]
mod support;

use idiophone::engine::{Engine, Losses, Settings};
use modes::{Damping, Rayleigh};
use std::f64::consts::TAU;
use support::{chimes, db, fit, left};

const T60_S: f64 = 60.0;

/// What was found.
struct Off {
    /// Error over the last tenth of a second, in dB of the mode's level then.
    error_db: f64,
    cents: f64,
    /// Share of the T60.
    t60: f64,
}

/// One mode at `hz`, struck, and heard at 1 s and at 30 s.
fn measure(hz: f64, rate_hz: f64) -> Off {
    let decay_per_s = 1000f64.ln() / T60_S;
    let mut bank = chimes([60]);
    bank.bodies[0].modes.truncate(1);
    bank.bodies[0].modes[0].hz = hz;
    let mut engine = Engine::new(&bank, rate_hz);
    engine.set(&Settings {
        losses: Losses::only(Damping {
            rayleigh: Rayleigh {
                alpha1_s: 0.0,
                alpha2_per_s: 2.0 * decay_per_s,
            },
            loss_factor: 0.0,
        }),
        gain_db: 12.0,
        ..Settings::default()
    });
    engine.reset();
    engine.strike(60, 1.0);
    #[expect(clippy::cast_sign_loss, reason = "times and rates are positive")]
    let frame = |seconds: f64| (seconds * rate_hz).round() as usize;
    let signal = left(&mut engine, frame(30.0));
    let damped_hz = (hz * hz - (decay_per_s / TAU).powi(2)).sqrt();
    let expected = [(damped_hz, decay_per_s)];
    let found = fit(&signal, rate_hz, &expected, frame(29.0)..frame(30.0))[0];
    // The mode as it is in its second second, without help from what it should be later.
    let (early, late) = (frame(1.0)..frame(2.0), frame(29.9)..frame(30.0));
    let shape = |n: usize| {
        let t = n as f64 / rate_hz;
        let (sin, cos) = (TAU * damped_hz * t).sin_cos();
        let fall = (-decay_per_s * t).exp();
        [fall * cos, fall * sin]
    };
    let (mut aa, mut ab, mut bb, mut ax, mut bx) = (0.0, 0.0, 0.0, 0.0, 0.0);
    for n in early {
        let ([a, b], x) = (shape(n), signal[n]);
        (aa, ab, bb) = (aa + a * a, ab + a * b, bb + b * b);
        (ax, bx) = (ax + a * x, bx + b * x);
    }
    let square = aa * bb - ab * ab;
    let (p, q) = ((bb * ax - ab * bx) / square, (aa * bx - ab * ax) / square);
    let (mut error, mut size) = (0.0, 0.0);
    for n in late {
        let [a, b] = shape(n);
        error += (signal[n] - p * a - q * b).powi(2);
        size += (p * a + q * b).powi(2);
    }
    Off {
        error_db: 0.5 * db(error / size),
        cents: 1200.0 * (found.hz / damped_hz).log2(),
        t60: decay_per_s / found.decay_per_s - 1.0,
    }
}

fn main() {
    println!("| mode | at | error after 30 s | pitch off, cents | T60 off, % |");
    println!("| --- | --- | ---: | ---: | ---: |");
    for rate_hz in [48_000.0, 192_000.0] {
        for hz in [50.0, 440.0, 5000.0] {
            let off = measure(hz, rate_hz);
            println!(
                "| {hz} Hz | {} kHz | {:.0} dB | {:.0e} | {:.0e} |",
                rate_hz / 1000.0,
                off.error_db,
                off.cents.abs(),
                100.0 * off.t60.abs()
            );
        }
    }
}
