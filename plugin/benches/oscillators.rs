//! Cost of ringing modes, beside a plain loop in the same run: bound by multiply-adds while the modes fit
//! the second cache, and by that cache when their damping moves.

#[path = "../tests/engine/support.rs"]
#[expect(dead_code, reason = "the tests use the rest")]
mod support;

use criterion::{Criterion, Throughput, criterion_group, criterion_main};
use idiophone::engine::{Engine, Hit, Losses, Settings, Vectors};
use modes::{Bank, Damping, Rayleigh};
use pulp::{Arch, Simd, WithSimd};
use std::f64::consts::{PI, TAU};
use std::hint::black_box;
use support::{Random, chimes};

const RATE_HZ: f64 = 48_000.0;
const BLOCK: usize = 64;

/// Losses by which every mode falls by 60 dB in this time.
fn lasting(t60_s: f64) -> Settings {
    Settings {
        losses: Losses::only(Damping {
            rayleigh: Rayleigh {
                alpha1_s: 0.0,
                alpha2_per_s: 2.0 * 1000f64.ln() / t60_s,
            },
            loss_factor: 0.0,
        }),
        ..Settings::default()
    }
}

/// `bodies` bodies of `modes` modes from 40 Hz to 18 kHz, each mode with one half-wave more than the last.
fn bank(bodies: u8, modes: usize) -> Bank {
    let mut bank = chimes(20..20 + bodies);
    for body in &mut bank.bodies {
        let first = body.modes[0].clone();
        let height = 2.0 / body.mass_kg.sqrt();
        let points = first.shape.len() as f64;
        body.modes = (0..modes)
            .map(|i| {
                let mut mode = first.clone();
                mode.hz = 40.0 * 450f64.powf(i as f64 / modes as f64);
                for (point, shape) in mode.shape.make_mut().iter_mut().enumerate() {
                    let turn = (i + 1) as f64 * PI * point as f64 / (points - 1.0);
                    shape[0] = (height * turn.cos()) as f32;
                }
                mode
            })
            .collect();
    }
    bank
}

/// All bodies of the bank struck and past their contacts.
fn ringing(bank: &Bank, vectors: Vectors) -> Engine {
    let mut engine = Engine::with_vectors(bank, RATE_HZ, vectors);
    // As good as for ever: a bench may ring for minutes.
    engine.set(&lasting(1e6));
    engine.reset();
    for body in &bank.bodies {
        engine.strike(body.key, 0.5);
    }
    let (mut left, mut right) = (vec![0.0; 24_000], vec![0.0; 24_000]);
    engine.process(&mut left, &mut right);
    engine
}

/// Phasors side by side, sample by sample: the obvious loop in single floats, stereo.
struct Plain {
    re: Vec<f32>,
    im: Vec<f32>,
    step_re: Vec<f32>,
    step_im: Vec<f32>,
    left: Vec<f32>,
    right: Vec<f32>,
}

impl Plain {
    fn new(modes: usize) -> Self {
        let turn = |i: usize| TAU * (40.0 + 3.0 * i as f64) / RATE_HZ;
        let all = |value: fn(f64) -> f64| (0..modes).map(|i| value(turn(i)) as f32).collect();
        Self {
            re: vec![1e-3; modes],
            im: vec![0.0; modes],
            step_re: all(f64::cos),
            step_im: all(f64::sin),
            left: vec![0.6; modes],
            right: vec![0.8; modes],
        }
    }
}

/// The loop as the compiler makes it for these vectors.
struct Render<'a>(&'a mut Plain, &'a mut [f32; BLOCK], &'a mut [f32; BLOCK]);

impl WithSimd for Render<'_> {
    type Output = ();

    #[inline(always)]
    fn with_simd<S: Simd>(self, _: S) {
        let Self(bank, left, right) = self;
        for (left, right) in left.iter_mut().zip(right.iter_mut()) {
            let (mut a, mut b) = ([0.0f32; 16], [0.0f32; 16]);
            let states = bank.re.as_chunks_mut::<16>().0.iter_mut();
            let states = states.zip(bank.im.as_chunks_mut::<16>().0);
            let steps = bank.step_re.as_chunks::<16>().0.iter();
            let steps = steps.zip(bank.step_im.as_chunks::<16>().0);
            let ears = bank.left.as_chunks::<16>().0.iter();
            let ears = ears.zip(bank.right.as_chunks::<16>().0);
            for (((re, im), (step_re, step_im)), (to_left, to_right)) in states.zip(steps).zip(ears)
            {
                for i in 0..16 {
                    a[i] += to_left[i] * im[i];
                    b[i] += to_right[i] * im[i];
                    let (x, y) = (re[i], im[i]);
                    re[i] = step_re[i] * x - step_im[i] * y;
                    im[i] = step_re[i] * y + step_im[i] * x;
                }
            }
            (*left, *right) = (a.iter().sum(), b.iter().sum());
        }
    }
}

fn oscillators(c: &mut Criterion) {
    let (mut left, mut right) = ([0.0; BLOCK], [0.0; BLOCK]);
    for (bodies, modes) in [(16, 64), (72, 64)] {
        let count = usize::from(bodies) * modes;
        let mut group = c.benchmark_group(format!("{count} modes of {bodies} bodies"));
        group.throughput(Throughput::Elements((count * BLOCK) as u64));
        let bank = bank(bodies, modes);
        for vectors in [Vectors::Widest, Vectors::Avx2, Vectors::Plain] {
            let mut engine = ringing(&bank, vectors);
            group.bench_function(format!("engine, {vectors:?}"), |b| {
                b.iter(|| engine.process(black_box(&mut left), black_box(&mut right)));
            });
        }
        let mut plain = Plain::new(count);
        let arch = Arch::new();
        group.bench_function("plain loop, widest vectors", |b| {
            b.iter(|| {
                arch.dispatch(Render(
                    black_box(&mut plain),
                    black_box(&mut left),
                    black_box(&mut right),
                ));
            });
        });
        let mut engine = ringing(&bank, Vectors::Widest);
        let mut longer = false;
        group.bench_function("engine, damping moving in every 32 samples", |b| {
            b.iter(|| {
                for half in 0..2 {
                    longer = !longer;
                    engine.set(&lasting(if longer { 1e6 } else { 0.9e6 }));
                    let part = half * 32..half * 32 + 32;
                    engine.process(
                        black_box(&mut left[part.clone()]),
                        black_box(&mut right[part]),
                    );
                }
            });
        });
        group.finish();
    }
}

fn playing(c: &mut Criterion) {
    let (mut left, mut right) = ([0.0; BLOCK], [0.0; BLOCK]);
    let bank = bank(88, 60);
    let mut group = c.benchmark_group("88 bodies of 60 modes");
    for vectors in [Vectors::Widest, Vectors::Avx2] {
        let mut engine = ringing(&bank, vectors);
        let (mut random, mut block) = (Random(2002), 0);
        // A block of 64 lasts 1333 µs.
        group.bench_function(format!("20 strikes a second, {vectors:?}"), |b| {
            b.iter(|| {
                block += 1;
                if block % 37 == 0 {
                    let key = bank.bodies[random.below(88)].key;
                    engine.hit(key, &Hit::plain(random.unit()));
                }
                engine.process(black_box(&mut left), black_box(&mut right));
            });
        });
        let mut engine = ringing(&bank, vectors);
        // Blocks of 32 last 667 µs; this is the first of a new blow on all.
        group.bench_function(
            format!("all struck at once, first 32 samples, {vectors:?}"),
            |b| {
                b.iter(|| {
                    engine.reset();
                    for body in &bank.bodies {
                        engine.strike(body.key, 1.0);
                    }
                    engine.process(black_box(&mut left[..32]), black_box(&mut right[..32]));
                });
            },
        );
    }
    group.finish();
    let mut silent = Engine::new(&bank, RATE_HZ);
    c.bench_function("silence", |b| {
        b.iter(|| silent.process(black_box(&mut left), black_box(&mut right)));
    });
}

criterion_group!(benches, oscillators, playing);
criterion_main!(benches);
