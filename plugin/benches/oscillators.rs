//! Cost of a ringing mode and sample, beside a plain loop in the same run.

#[path = "../tests/engine/support.rs"]
#[expect(dead_code, reason = "the tests use the rest")]
mod support;

use criterion::{Criterion, Throughput, criterion_group, criterion_main};
use idiophone::engine::{Engine, Losses, Settings};
use modes::{Bank, Damping, Rayleigh};
use std::f64::consts::TAU;
use std::hint::black_box;
use support::chimes;

const RATE_HZ: f64 = 48_000.0;
const BLOCK: usize = 64;
const UNDAMPED: Damping = Damping {
    rayleigh: Rayleigh {
        alpha1_s: 0.0,
        alpha2_per_s: 0.0,
    },
    loss_factor: 0.0,
};

/// `bodies` bodies of `modes` modes that ring for ever.
fn bank(bodies: u8, modes: usize) -> Bank {
    let mut bank = chimes(40..40 + bodies);
    bank.damping = UNDAMPED;
    for body in &mut bank.bodies {
        let first = body.modes[0].clone();
        body.modes = (0..modes)
            .map(|i| modes::Mode {
                hz: 40.0 * 450f64.powf(i as f64 / modes as f64),
                ..first.clone()
            })
            .collect();
    }
    bank
}

/// All bodies of the bank struck and past their contacts.
fn ringing(bank: &Bank) -> Engine {
    let mut engine = Engine::new(bank, RATE_HZ);
    engine.set(&Settings {
        losses: Losses::only(UNDAMPED),
        ..Settings::default()
    });
    engine.reset();
    for body in &bank.bodies {
        engine.strike(body.key, 0.5);
    }
    let mut out = [[0.0; 4800]; 2];
    let [left, right] = &mut out;
    engine.process(left, right);
    engine
}

/// One phasor after the other, sample by sample: the obvious loop in f64, stereo.
struct Plain {
    state: Vec<(f64, f64)>,
    step: Vec<(f64, f64)>,
    ears: Vec<(f64, f64)>,
}

impl Plain {
    fn new(modes: usize) -> Self {
        Self {
            state: vec![(1e-3, 0.0); modes],
            step: (0..modes)
                .map(|i| {
                    let (sin, cos) = (TAU * (40.0 + 17.0 * i as f64) / RATE_HZ).sin_cos();
                    (cos, sin)
                })
                .collect(),
            ears: vec![(0.6, 0.8); modes],
        }
    }

    fn process(&mut self, left: &mut [f32], right: &mut [f32]) {
        for (left, right) in left.iter_mut().zip(right) {
            let mut sum = (0.0, 0.0);
            for ((state, step), ears) in self.state.iter_mut().zip(&self.step).zip(&self.ears) {
                sum.0 += ears.0 * state.1;
                sum.1 += ears.1 * state.1;
                *state = (
                    step.0 * state.0 - step.1 * state.1,
                    step.0 * state.1 + step.1 * state.0,
                );
            }
            (*left, *right) = (sum.0 as f32, sum.1 as f32);
        }
    }
}

fn oscillators(c: &mut Criterion) {
    let (mut left, mut right) = ([0.0; BLOCK], [0.0; BLOCK]);
    for (bodies, modes) in [(16, 64), (64, 24)] {
        let count = usize::from(bodies) * modes;
        let mut group = c.benchmark_group(format!("{bodies} bodies of {modes} modes"));
        group.throughput(Throughput::Elements((count * BLOCK) as u64));
        let bank = bank(bodies, modes);
        let mut engine = ringing(&bank);
        group.bench_function("engine", |b| {
            b.iter(|| engine.process(black_box(&mut left), black_box(&mut right)));
        });
        let mut plain = Plain::new(count);
        group.bench_function("plain loop", |b| {
            b.iter(|| plain.process(black_box(&mut left), black_box(&mut right)));
        });
        let mut engine = ringing(&bank);
        let mut alpha2_per_s = 0.0;
        group.bench_function("engine, damping moving", |b| {
            b.iter(|| {
                alpha2_per_s = 1e-6 - alpha2_per_s;
                engine.set(&Settings {
                    losses: Losses {
                        added: Damping {
                            rayleigh: Rayleigh {
                                alpha2_per_s,
                                ..UNDAMPED.rayleigh
                            },
                            loss_factor: 0.0,
                        },
                        ..Losses::AS_BUILT
                    },
                    ..Settings::default()
                });
                engine.process(black_box(&mut left), black_box(&mut right));
            });
        });
        let mut engine = ringing(&bank);
        group.bench_function("engine, a strike on every body in every block", |b| {
            b.iter(|| {
                for body in &bank.bodies {
                    engine.strike(body.key, 0.0);
                }
                engine.process(black_box(&mut left), black_box(&mut right));
            });
        });
        group.finish();
    }
    let mut silent = Engine::new(&bank(16, 64), RATE_HZ);
    c.bench_function("silence", |b| {
        b.iter(|| silent.process(black_box(&mut left), black_box(&mut right)));
    });
}

criterion_group!(benches, oscillators);
criterion_main!(benches);
