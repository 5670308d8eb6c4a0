//! The kernels beside the closed form and beside each other.

use super::points::POINTS;
use super::*;
use crate::engine::losses::Drain;
use std::f64::consts::TAU;

/// The first pack alone.
const ONE: [Range<usize>; 1] = [Range { start: 0, end: 1 }];

const KERNELS: [Vectors; 3] = [Vectors::Widest, Vectors::Avx2, Vectors::Plain];

/// Modes at `hz` as built, all heard from y on the left and from x on the right.
fn tones(hz: &[f64]) -> (Vec<Tone>, Vec<Pack>) {
    let packs = hz.len().div_ceil(LANES);
    let mut tones = vec![Tone::NONE; packs];
    for (i, hz) in hz.iter().enumerate() {
        let (tone, lane) = (&mut tones[i / LANES], i % LANES);
        tone.omega[lane] = TAU * hz;
        tone.gain[0][1][lane] = 1.0;
        tone.gain[1][0][lane] = 1.0;
    }
    (tones, vec![Pack::STILL; packs])
}

fn tune(kernel: Kernel, tones: &mut [Tone], packs: &mut [Pack], drain: Drain, step_s: f64) {
    kernel.run(Tune {
        tones,
        packs,
        drain,
        ratio: 1.0,
        pitch: true,
        gains: true,
        causes: true,
        exact: true,
        off: &mut false,
        step_s,
    });
}

fn even(decay_per_s: f64) -> Drain {
    Drain {
        alpha2_per_s: 2.0 * decay_per_s,
        ..Drain::default()
    }
}

/// Thirty seconds of one mode whose T60 is a minute: what is off its closed form over the last cells, and
/// how much longer and higher it sounds.
#[test]
fn a_minute_s_decay_is_a_minute_s() {
    for vectors in KERNELS {
        let kernel = Kernel::new(vectors);
        for (hz, rate_hz) in [50.0, 440.0, 5000.0]
            .into_iter()
            .flat_map(|hz| [(hz, 48_000.0), (hz, 192_000.0)])
        {
            let decay = 1000f64.ln() / 60.0;
            let (mut tones, mut packs) = tones(&[hz]);
            tune(kernel, &mut tones, &mut packs, even(decay), 1.0 / rate_hz);
            packs[0].x[0] = 1.0;
            #[expect(clippy::cast_sign_loss, reason = "rates are positive")]
            let cells = (30.0 * rate_hz) as usize / GRID;
            let damped = ((TAU * hz).powi(2) - decay * decay).sqrt();
            let (mut error, mut size) = (0.0f64, 0.0f64);
            let mut out = SILENT;
            let mut room = Room::new();
            for cell in 0..cells {
                kernel.ring(&mut packs, &ONE, true, &mut room, &mut out);
                if cell + 100 < cells {
                    continue;
                }
                for (n, (y, x)) in out[0].iter().zip(&out[1]).enumerate() {
                    let t = (cell * GRID + n) as f64 / rate_hz;
                    let fall = (-decay * t).exp();
                    error += (y - fall * (damped * t).sin()).powi(2);
                    error += (x - fall * (damped * t).cos()).powi(2);
                    size += fall * fall;
                }
            }
            let db = 10.0 * (error / size).log10();
            let t = (cells * GRID) as f64 / rate_hz;
            let longer = packs[0].x[0].hypot(packs[0].y[0]).ln() / (-decay * t) - 1.0;
            let ahead = packs[0].y[0].atan2(packs[0].x[0]) - damped * t;
            let ahead = ahead - TAU * (ahead / TAU).round();
            let cents = 1200.0 / 2f64.ln() * ahead / (damped * t);
            println!(
                "{vectors:?}, {hz} Hz at {rate_hz}: {db:.0} dB, decay {longer:.1e}, {cents:.1e} cents"
            );
            assert!(db < -128.0, "{db} dB");
            assert!(longer.abs() < 1e-6, "{longer}");
            assert!(cents.abs() < 1e-9, "{cents}");
        }
    }
}

/// Sixty modes between 40 Hz and 20 kHz, with all vectors.
#[test]
fn all_vectors_sound_alike() {
    let hz: Vec<f64> = (0..60).map(|i| 40.0 * 1.11f64.powi(i)).collect();
    let mut all = Vec::new();
    for vectors in KERNELS {
        let kernel = Kernel::new(vectors);
        let (mut tones, mut packs) = tones(&hz);
        let drain = Drain {
            alpha1_s: 1e-8,
            ..even(0.3)
        };
        tune(kernel, &mut tones, &mut packs, drain, 1.0 / 48_000.0);
        for (i, pack) in packs.iter_mut().enumerate() {
            pack.x = std::array::from_fn(|lane| (1.0 + (i * LANES + lane) as f64).recip());
        }
        let mut sound = Vec::new();
        let mut room = Room::new();
        for _ in 0..1500 {
            let mut out = SILENT;
            kernel.ring(&mut packs, &[0..1, 1..4], true, &mut room, &mut out);
            sound.extend(out.concat());
        }
        all.push(sound);
    }
    let peak = all[0].iter().fold(0.0, |peak: f64, x| peak.max(x.abs()));
    for other in &all[1..] {
        let pairs = all[0].iter().zip(other);
        let worst = pairs.fold(0.0, |worst: f64, (a, b)| worst.max((a - b).abs()));
        let db = 20.0 * (worst / peak).log10();
        println!("{db:.1} dB apart");
        assert!(db < -120.0, "{db} dB");
    }
}

/// The steps for any damping, at any rate, beside those of the library's exp, sin and cos.
#[test]
fn steps_agree_with_the_library_for_any_damping() {
    let hz: Vec<f64> = (0..64).map(|i| 20.0 * 1.115f64.powi(i)).collect();
    let (mut heard, mut silent) = (0, 0);
    let (mut hop_off, mut cell_off) = (0.0f64, 0.0f64);
    for rate_hz in [44_100.0, 48_000.0, 192_000.0] {
        for alpha1_s in [0.0, 1e-7, 1e-6, 8e-6, 2e-5] {
            for alpha2_per_s in [0.0, 0.5, 50.0, 100.0, 2000.0] {
                let (mut tones, mut packs) = tones(&hz);
                for tone in &mut tones {
                    tone.rates = [[0.5; LANES], [0.3; LANES], [0.8; LANES], [20.0; LANES]];
                }
                let drain = Drain {
                    alpha1_s,
                    alpha2_per_s,
                    loss_factor: 1e-3,
                    radiation: 2.0,
                    supports: 0.5,
                    resonator: 0.25,
                    felt: 0.25,
                    hand_per_s: 1.5,
                };
                let kernel = Kernel::new(Vectors::Widest);
                tune(kernel, &mut tones, &mut packs, drain, 1.0 / rate_hz);
                for (i, &hz) in hz.iter().enumerate() {
                    let (pack, lane) = (&packs[i / LANES], i % LANES);
                    let omega = TAU * hz;
                    let decay = 0.5 * (alpha1_s * omega * omega + alpha2_per_s)
                        + 0.5e-3 * omega
                        + 1.0
                        + 0.15
                        + 0.2
                        + 5.0
                        + 1.5;
                    let off = |samples: f64, re: f64, im: f64| {
                        let square = omega * omega - decay * decay;
                        let fall = (-decay * samples / rate_hz).exp();
                        let (sin, cos) = (square.sqrt() * samples / rate_hz).sin_cos();
                        (re - fall * cos).hypot(im - fall * sin)
                    };
                    let hop = [pack.hop_re[lane], pack.hop_im[lane]].map(f64::from);
                    let cell = [pack.cell_re[lane], pack.cell_im[lane]];
                    if decay > 0.99 * omega || hz > 0.5 * rate_hz {
                        assert_eq!((hop, cell), ([0.0; 2], [0.0; 2]));
                        silent += 1;
                    } else if decay < 0.98 * omega && hz < 0.49 * rate_hz {
                        let here = off(8.0 * POINTS[pack.points].apart, hop[0], hop[1]);
                        hop_off = hop_off.max(here);
                        let late = off(GRID as f64, cell[0], cell[1]);
                        // Relative to what damping takes in a cell; the nearer Ω is to zero, the more
                        // a single float's rounding of ω and d moves it.
                        let near = 1.0 - (decay / omega).powi(2);
                        let lost = (decay * GRID as f64 / rate_hz).min(1.0);
                        cell_off = cell_off.max(late * near / lost);
                        heard += 1;
                    }
                }
            }
        }
    }
    println!(
        "{heard} heard, {silent} silent; hop {hop_off:.1e}, cell {cell_off:.1e} of its damping off"
    );
    assert!(heard > 3000 && silent > 100);
    assert!(hop_off < 2e-7, "{hop_off}");
    assert!(cell_off < 5e-7, "{cell_off}");
}

#[test]
fn modes_above_half_the_rate_are_silent() {
    let (mut tones, mut packs) = tones(&[400.0, 499.0, 700.0]);
    let kernel = Kernel::new(Vectors::Widest);
    tune(kernel, &mut tones, &mut packs, even(1.0), 1e-3);
    assert!(packs[0].hop_re[0] != 0.0);
    for lane in [1, 2] {
        assert!(tones[0].is_silent(lane));
        assert_eq!((packs[0].hop_re[lane], packs[0].cell_im[lane]), (0.0, 0.0));
    }
}

#[test]
fn a_cell_taken_back_is_where_it_was() {
    let (mut tones, mut packs) = tones(&[100.0, 3000.0, 15_000.0]);
    let kernel = Kernel::new(Vectors::Widest);
    tune(kernel, &mut tones, &mut packs, even(200.0), 1.0 / 48_000.0);
    packs[0].x = std::array::from_fn(|lane| 1.0 + lane as f64);
    packs[0].y = [-0.5; LANES];
    let before = packs[0].clone();
    kernel.ring(
        &mut packs,
        &ONE,
        true,
        &mut Room::new(),
        &mut [[0.0; GRID]; 2],
    );
    assert!(packs[0].x != before.x);
    packs[0].rewind();
    for lane in 0..LANES {
        assert!((packs[0].x[lane] - before.x[lane]).abs() < 1e-13);
        assert!((packs[0].y[lane] - before.y[lane]).abs() < 1e-13);
    }
}

/// Low modes whose damping grows past what their points allow and back, cell by cell, beside what each cell
/// is in closed form.
#[test]
fn damping_may_come_and_go_between_points() {
    const RATE_HZ: f64 = 48_000.0;
    let hz = [60.0, 300.0, 700.0, 900.0, 2000.0, 3400.0];
    for vectors in KERNELS {
        let kernel = Kernel::new(vectors);
        // In packs of their own, for points of their own.
        let spread: Vec<f64> = hz.iter().flat_map(|hz| [*hz; LANES]).collect();
        let (mut tones, mut packs) = tones(&spread);
        let mut states = hz.map(|_| (1.0f64, 0.0f64));
        for (pack, tone) in packs.iter_mut().zip(&mut tones) {
            pack.x[0] = 1.0;
            for lane in 1..LANES {
                tone.gain[0][1][lane] = 0.0;
                tone.gain[1][0][lane] = 0.0;
            }
        }
        let (mut room, mut out) = (Room::new(), SILENT);
        let (mut worst, mut kinds) = (0.0f64, [0; 3]);
        for cell in 0..60 {
            let decay = 200.0 * (std::f64::consts::PI * f64::from(cell) / 60.0).sin();
            tune(kernel, &mut tones, &mut packs, even(decay), 1.0 / RATE_HZ);
            kinds[packs[0].points] += 1;
            kernel.ring(&mut packs, &[0..1, 1..hz.len()], true, &mut room, &mut out);
            let (mut left, mut right) = ([0.0; GRID], [0.0; GRID]);
            for ((x, y), hz) in states.iter_mut().zip(hz) {
                let damped = ((TAU * hz).powi(2) - decay * decay).sqrt();
                let turned = |samples: usize| {
                    let t = samples as f64 / RATE_HZ;
                    let (sin, cos) = (damped * t).sin_cos();
                    let fall = (-decay * t).exp();
                    (fall * (*x * cos - *y * sin), fall * (*x * sin + *y * cos))
                };
                for n in 0..GRID {
                    let (x, y) = turned(n);
                    left[n] += y;
                    right[n] += x;
                }
                (*x, *y) = turned(GRID);
            }
            for n in 0..GRID {
                worst = worst.max((out[0][n] - left[n]).abs());
                worst = worst.max((out[1][n] - right[n]).abs());
            }
        }
        // Of the level of all modes together, each of which began at 1.
        let db = 20.0 * (worst / hz.len() as f64).log10();
        println!("{vectors:?}: {db:.1} dB off, {kinds:?} cells at points of each kind");
        assert!(db < -125.0, "{vectors:?}: {db} dB");
        assert!(kinds[0] > 5 && kinds[2] > 10, "{kinds:?}");
    }
}
