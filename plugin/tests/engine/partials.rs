//! What rings is what the bank says, at any sample rate.

use crate::support::{chimes, db, expected, fit, left};
use idiophone::engine::{Engine, Hold, Listener, Losses, Settings, Tweak};
use idiophone::factory;
use modes::{Damping, Rayleigh};

#[test]
fn frequencies_decays_and_levels_at_every_rate() {
    let bank = chimes([74]);
    let expected = expected(&bank.bodies[0], bank.damping);
    let mut levels: Vec<Vec<f64>> = Vec::new();
    for rate_hz in [44_100.0, 48_000.0, 96_000.0, 192_000.0] {
        let mut engine = Engine::new(&bank, rate_hz);
        assert!(engine.strike(74, 1.0));
        #[expect(clippy::cast_sign_loss, reason = "times and rates are positive")]
        let samples = |seconds: f64| (seconds * rate_hz) as usize;
        let signal = left(&mut engine, samples(0.2));
        let seen = fit(&signal, rate_hz, &expected, samples(1e-3)..samples(0.2));
        let (mut worst_cents, mut worst_decay) = (0.0_f64, 0.0_f64);
        for (seen, (hz, decay)) in seen.iter().zip(&expected) {
            worst_cents = worst_cents.max((1200.0 * (seen.hz / hz).log2()).abs());
            worst_decay = worst_decay.max((seen.decay_per_s / decay - 1.0).abs());
        }
        println!("{rate_hz} Hz: {worst_cents:.6} cents, decay {worst_decay:.2e}");
        assert!(worst_cents < 1e-3, "{worst_cents} cents at {rate_hz} Hz");
        assert!(worst_decay < 1e-4, "{worst_decay} at {rate_hz} Hz");
        levels.push(seen.iter().map(|partial| partial.amplitude).collect());
    }
    // Where the blow's spectrum has its notches little makes much: there what counts is the share of the
    // strongest partial.
    let most = levels[0].iter().fold(0.0, |most: f64, x| most.max(*x));
    for other in &levels[1..] {
        for ((a, b), (hz, _)) in levels[0].iter().zip(other).zip(&expected) {
            let (off, share) = (db(a / b), db((a - b).abs() / most));
            println!("{hz:.0} Hz: {off:.4} dB, {share:.0} dB of the strongest");
            assert!(off.abs() < 0.02 || share < -90.0, "{off} dB at {hz} Hz");
        }
    }
}

#[test]
fn a_hard_blow_peaks_at_fifteen_below_full_scale_at_most() {
    let bank = chimes(60..=84);
    let mut loudest = 0.0_f64;
    for key in 60..=84 {
        let mut engine = Engine::new(&bank, 48_000.0);
        engine.set(&Settings {
            listener: Listener {
                width: 0.0,
                ..Listener::AS_BUILT
            },
            ..Settings::default()
        });
        engine.reset();
        engine.strike(key, 1.0);
        loudest = left(&mut engine, 9600)
            .iter()
            .fold(loudest, |peak, s| peak.max(s.abs()));
    }
    println!("{:.3} dB", db(loudest));
    assert!((-40.0..-14.5).contains(&db(loudest)), "{} dB", db(loudest));
}

#[test]
fn damping_moved_in_mid_note_acts_at_once_and_adds_nothing() {
    let rate_hz = 48_000.0;
    let bank = chimes([74]);
    let after = Damping {
        rayleigh: Rayleigh {
            alpha1_s: 2e-7,
            alpha2_per_s: 0.5,
        },
        loss_factor: 3e-4,
    };
    let mut engine = Engine::new(&bank, rate_hz);
    engine.strike(74, 1.0);
    let step = 6000;
    let mut signal = left(&mut engine, step);
    engine.set(&Settings {
        losses: Losses::only(after),
        ..Settings::default()
    });
    signal.extend(left(&mut engine, 24_000));
    // 15 ms later the damping is there.
    let moved = step + 800;
    let expected = expected(&bank.bodies[0], after);
    let alive = &expected[..4];
    for (seen, (hz, decay)) in fit(&signal, rate_hz, alive, moved..moved + 9600)
        .iter()
        .zip(alive)
    {
        println!("{hz:.1} Hz: {:.4} for {decay:.4} 1/s", seen.decay_per_s);
        assert!((seen.decay_per_s / decay - 1.0).abs() < 1e-3, "{hz} Hz");
    }

    let around = &signal[..16_384];
    let spectrum = crate::support::spectrum(around);
    let peak = spectrum.iter().fold(0.0, |p: f64, v| p.max(*v));
    let bin_hz = rate_hz / 16_384.0;
    let elsewhere = spectrum
        .iter()
        .enumerate()
        .filter(|(bin, _)| {
            let hz = *bin as f64 * bin_hz;
            bank.bodies[0]
                .modes
                .iter()
                .all(|mode| (hz - mode.hz).abs() > 100.0)
        })
        .fold(0.0, |most: f64, (_, v)| most.max(*v));
    println!("elsewhere {:.1} dB", db(elsewhere / peak));
    assert!(db(elsewhere / peak) < -88.0, "{} dB", db(elsewhere / peak));
}

#[test]
fn the_damper_takes_what_its_weight_and_the_hand_take() {
    let rate_hz = 48_000.0;
    let bank = chimes([74]);
    let full_per_s = 1000f64.ln() / 0.25;
    for (note_off_damps, felt, hand_per_s, extra) in [
        (true, 1.0, 0.0, full_per_s),
        (true, 0.25, 3.0, 0.25 * full_per_s + 3.0),
        (false, 1.0, 0.0, 0.0),
    ] {
        let mut engine = Engine::new(&bank, rate_hz);
        engine.set(&Settings {
            note_off_damps,
            ..Settings::default()
        });
        engine.strike(74, 1.0);
        let mut signal = left(&mut engine, 4800);
        engine.hold(
            74,
            &Hold {
                felt,
                hand_per_s,
                ..Hold::FREE
            },
        );
        signal.extend(left(&mut engine, 9600));
        let mut damping = bank.damping;
        damping.rayleigh.alpha2_per_s += 2.0 * extra;
        let expected = expected(&bank.bodies[0], damping);
        let seen = fit(&signal, rate_hz, &expected[..3], 4864..14_400);
        for (seen, (hz, decay)) in seen.iter().zip(&expected) {
            let error = seen.decay_per_s / decay - 1.0;
            assert!(error.abs() < 1e-3, "{hz} Hz, felt {felt}: {error}");
        }
    }
}

/// Bend, tuning, size and material move what rings, where they are asked to.
#[test]
fn ringing_partials_move_where_they_are_sent() {
    let rate_hz = 48_000.0;
    let bank = chimes([62]);
    let wanted = [
        (
            Hold {
                bend_semitones: 2.0,
                ..Hold::FREE
            },
            Tweak::NONE,
            2f64.powf(2.0 / 12.0),
        ),
        (
            Hold {
                bend_semitones: -0.37,
                ..Hold::FREE
            },
            Tweak::NONE,
            2f64.powf(-0.37 / 12.0),
        ),
        (
            Hold::FREE,
            Tweak {
                size: 1.25,
                ..Tweak::NONE
            },
            0.8,
        ),
        (
            Hold::FREE,
            Tweak {
                stiffness: 1.44,
                density: 4.0,
                ..Tweak::NONE
            },
            0.6,
        ),
    ];
    for (hold, tweak, ratio) in wanted {
        let mut engine = Engine::new(&bank, rate_hz);
        engine.strike(62, 1.0);
        let mut signal = left(&mut engine, 4800);
        engine.hold(62, &hold);
        engine.set(&Settings {
            tweak,
            ..Settings::default()
        });
        signal.extend(left(&mut engine, 16_000));
        let moved: Vec<(f64, f64)> = expected(&bank.bodies[0], bank.damping)[..3]
            .iter()
            .map(|(hz, decay)| (hz * ratio, decay * ratio * ratio))
            .collect();
        let seen = fit(&signal, rate_hz, &moved, 6400..20_800);
        for (seen, (hz, decay)) in seen.iter().zip(&moved) {
            let cents = 1200.0 * (seen.hz / hz).log2();
            println!(
                "{hz:.1} Hz: {cents:.1e} cents, {:.4} of the decay",
                seen.decay_per_s / decay
            );
            assert!(cents.abs() < 0.01, "{cents} cents");
            assert!((seen.decay_per_s / decay - 1.0).abs() < 0.005);
        }
        let steepest = |part: &[f64]| {
            part.windows(3)
                .map(|w| (w[0] - 2.0 * w[1] + w[2]).abs())
                .fold(0.0, f64::max)
        };
        let (before, after) = (steepest(&signal[4000..4790]), steepest(&signal[4790..6000]));
        assert!(after < 1.5 * before * ratio.max(1.0).powi(2), "no click");
    }
}

/// A mode's ears are complex: what is heard is the imaginary part of the transfer times the state.
#[test]
fn each_ear_hears_size_and_phase_of_its_transfer() {
    let mut bank = chimes([74]);
    let body = &mut bank.bodies[0];
    body.modes.truncate(1);
    body.modes[0].ears = [[3.0, 4.0], [0.0, -10.0]];
    body.modes[0].radiation_per_s = 1.5;
    body.modes[0].support_per_s = 2.5;
    let decay = bank.damping.decay_per_s(body.modes[0].hz) + 4.0;
    let expected = [(body.modes[0].hz, decay)];
    let mut engine = Engine::new(&bank, 48_000.0);
    engine.strike(74, 1.0);
    let (mut left, mut right) = (vec![0.0; 9600], vec![0.0; 9600]);
    engine.process(&mut left, &mut right);
    let seen = [left, right].map(|channel| {
        let channel: Vec<f64> = channel.into_iter().map(f64::from).collect();
        (fit(&channel, 48_000.0, &expected, 480..9600)[0], channel)
    });
    for (partial, _) in &seen {
        assert!((partial.decay_per_s / decay - 1.0).abs() < 1e-4);
    }
    assert!((seen[1].0.amplitude / seen[0].0.amplitude - 2.0).abs() < 1e-4);
    // (3 + 4i)/5 leads by atan 4/3, −i lags by a quarter turn: 2.5 rad between them.
    let phase = |channel: &[f64]| {
        let (mut re, mut im) = (0.0, 0.0);
        for (n, sample) in channel.iter().enumerate().skip(480) {
            let t = n as f64 / 48_000.0;
            let (sin, cos) = (std::f64::consts::TAU * expected[0].0 * t).sin_cos();
            (re, im) = (re + sample * cos, im - sample * sin);
        }
        f64::atan2(im, re)
    };
    let between = phase(&seen[0].1) - phase(&seen[1].1);
    let turns =
        (between - (4f64 / 3.0).atan() - std::f64::consts::FRAC_PI_2) / std::f64::consts::TAU;
    assert!((turns - turns.round()).abs() < 2e-3, "{between}");
}

#[test]
fn a_fortissimo_chord_on_any_factory_instrument_does_not_clip() {
    for index in 0..factory::BANKS.len() {
        let bank = factory::bank(index);
        let mut engine = Engine::new(bank, 48_000.0);
        for key in [48, 52, 55, 60, 64, 67, 72, 76, 79, 84] {
            engine.strike(key, 1.0);
        }
        let (mut left, mut right) = (vec![0.0; 9600], vec![0.0; 9600]);
        engine.process(&mut left, &mut right);
        let peak = left
            .iter()
            .chain(&right)
            .fold(0.0, |p: f32, s| p.max(s.abs()));
        println!("{}: {:.1} dB", bank.name, db(f64::from(peak)));
        assert!(peak < 1.0 && peak > 0.01, "{}: {peak}", bank.name);
    }
}
