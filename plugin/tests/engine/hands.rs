//! What hands, listeners and neighbours do to a body that rings.

use crate::support::{chimes, db, expected, fit, left};
use idiophone::engine::{Bow, Engine, Hold, Listener, Losses, Mallet, Settings};
use modes::{Bank, Damping, Rayleigh};

const RATE_HZ: f64 = 48_000.0;

fn rms(signal: &[f64]) -> f64 {
    (signal.iter().map(|x| x * x).sum::<f64>() / signal.len() as f64).sqrt()
}

/// The channels of the next samples.
fn both(engine: &mut Engine, samples: usize) -> [Vec<f64>; 2] {
    let (mut left, mut right) = (vec![0.0; samples], vec![0.0; samples]);
    engine.process(&mut left, &mut right);
    [left, right].map(|channel| channel.into_iter().map(f64::from).collect())
}

/// A bow makes a bar sound, up to a level that stays, near the pitch of one of its modes; without the bow
/// it dies away.
#[test]
fn a_bow_builds_up_a_tone_that_holds_itself() {
    let mut engine = Engine::new(&chimes([60]), RATE_HZ);
    engine.set(&Settings {
        bow: Bow {
            rubs: true,
            ..Bow::DEFAULT
        },
        losses: Losses::only(Damping {
            rayleigh: Rayleigh {
                alpha1_s: 1e-7,
                alpha2_per_s: 2.0,
            },
            loss_factor: 0.0,
        }),
        ..Settings::default()
    });
    engine.strike(60, 1.0);
    let signal = left(&mut engine, 4 * 48_000);
    let second = |n: usize| db(rms(&signal[n * 48_000..][..48_000]));
    let levels = [second(0), second(1), second(2), second(3)];
    println!("{levels:.1?} dB");
    assert!((levels[3] - levels[2]).abs() < 1.0, "{levels:?}");
    assert!(levels[3] > -80.0 && levels[3] < -20.0, "{levels:?}");
    engine.release(60);
    let after = left(&mut engine, 4 * 48_000);
    assert!(db(rms(&after[3 * 48_000..])) < levels[3] - 6.0);
}

#[test]
fn a_faster_bow_is_louder_and_more_pressure_starts_sooner() {
    let level = |force_n: f64, speed_m_s: f64, from: usize, to: usize| {
        let mut engine = Engine::new(&chimes([60]), RATE_HZ);
        engine.set(&Settings {
            bow: Bow {
                force_n,
                speed_m_s,
                rubs: false,
            },
            ..Settings::default()
        });
        engine.hold(
            60,
            &Hold {
                bow_pressure: 1.0,
                ..Hold::FREE
            },
        );
        db(rms(&left(&mut engine, to)[from..]))
    };
    let (slow, fast) = (
        level(20.0, 0.1, 96_000, 144_000),
        level(20.0, 0.3, 96_000, 144_000),
    );
    println!("{slow:.1} dB at 0.1 m/s, {fast:.1} dB at 0.3 m/s");
    assert!(fast > slow + 3.0, "{slow}, {fast}");
    let (light, firm) = (level(2.0, 0.2, 0, 9600), level(20.0, 0.2, 0, 9600));
    println!("{light:.1} dB lightly, {firm:.1} dB firmly in the first 0.2 s");
    assert!(firm > light, "{light}, {firm}");
}

/// A mallet that is pressed on takes the tone that it has made: a dead stroke.
#[test]
fn a_dead_stroke_is_short() {
    let tail = |press_n: f64| {
        let mut engine = Engine::new(&chimes([60]), RATE_HZ);
        engine.set(&Settings {
            mallet: Mallet {
                press_n,
                loss_s_m: 0.5,
                hardness_pa: 1e7,
                ..Mallet::DEFAULT
            },
            ..Settings::default()
        });
        engine.strike(60, 0.8);
        db(rms(&left(&mut engine, 48_000)[24_000..]))
    };
    let (free, dead) = (tail(0.0), tail(10.0));
    println!("{free:.1} dB free, {dead:.1} dB dead after 0.5 s");
    assert!(dead < free - 10.0, "{free}, {dead}");
}

#[test]
fn roughness_is_heard_while_the_mallet_is_on_the_body() {
    let struck = |roughness: f64| {
        let mut engine = Engine::new(&chimes([60]), RATE_HZ);
        engine.set(&Settings {
            mallet: Mallet {
                roughness,
                hardness_pa: 1e7,
                ..Mallet::DEFAULT
            },
            ..Settings::default()
        });
        engine.strike(60, 0.8);
        left(&mut engine, 2048)
    };
    let bright = |signal: &[f64]| {
        let spectrum = crate::support::spectrum(signal);
        let energy = |bins: &[f64]| bins.iter().map(|v| v * v).sum::<f64>();
        energy(&spectrum[256..]) / energy(&spectrum)
    };
    let (smooth, rough) = (bright(&struck(0.0)), bright(&struck(0.5)));
    println!(
        "above 6 kHz: {:.1} dB smooth, {:.1} dB rough",
        0.5 * db(smooth),
        0.5 * db(rough)
    );
    assert!(rough > 10.0 * smooth);
    assert_eq!(struck(0.5), struck(0.5), "always the same");
}

/// A chime that swings comes nearer and goes away (louder and softer) and its pitch goes up and down.
#[test]
fn a_swinging_chime_wavers() {
    let bank = chimes([74]);
    let windows = |swing: f64| {
        let mut engine = Engine::new(&bank, RATE_HZ);
        engine.set(&Settings {
            swing,
            ..Settings::default()
        });
        engine.reset();
        engine.strike(74, 1.0);
        let signal = left(&mut engine, 96_000);
        let expected = expected(&bank.bodies[0], bank.damping);
        let at = |from: usize| {
            let found = fit(&signal, RATE_HZ, &expected[..1], from..from + 2400)[0];
            (found.hz, rms(&signal[from..from + 2400]))
        };
        (0..18).map(|n| at(9600 + n * 4400)).collect::<Vec<_>>()
    };
    let pairs: Vec<_> = windows(0.0).into_iter().zip(windows(1.0)).collect();
    let cents: Vec<f64> = pairs
        .iter()
        .map(|(a, b)| 1200.0 * (b.0 / a.0).log2())
        .collect();
    let levels: Vec<f64> = pairs.iter().map(|(a, b)| db(b.1 / a.1)).collect();
    println!("{cents:.1?} cents, {levels:.1?} dB");
    let span = |values: &[f64]| {
        let most = values.iter().fold(f64::MIN, |a, b| a.max(*b));
        most - values.iter().fold(f64::MAX, |a, b| a.min(*b))
    };
    assert!(span(&cents) > 1.0 && span(&cents) < 20.0);
    assert!(span(&levels) > 0.3 && span(&levels) < 6.0);
}

#[test]
fn the_listener_s_place_is_heard() {
    let heard = |listener: Listener| {
        let mut engine = Engine::new(&chimes([60]), RATE_HZ);
        engine.set(&Settings {
            listener,
            ..Settings::default()
        });
        engine.reset();
        engine.strike(60, 0.8);
        both(&mut engine, 9600)
    };
    let near = heard(Listener::AS_BUILT);
    let far = heard(Listener {
        distance: 4.0,
        ..Listener::AS_BUILT
    });
    for (near, far) in near.iter().zip(&far) {
        let drop = db(rms(far) / rms(near));
        assert!((drop + db(4.0)).abs() < 0.01, "{drop}");
    }
    let [left, right] = heard(Listener {
        angle_deg: 90.0,
        ..Listener::AS_BUILT
    });
    let side = db(rms(&right) / rms(&left));
    println!("{side:.2} dB louder on the right");
    assert!(side > 1.0, "{side}");
}

/// Two chimes a hair apart on one support: the silent one answers, and more the firmer they are joined;
/// one at another pitch hardly does.
#[test]
fn a_silent_body_answers_its_neighbour() {
    let joined = |ratio: f64, sympathy: f64| {
        let mut bank: Bank = chimes([60, 62]);
        let mut twin = crate::support::chime(62, bank.bodies[0].pitch_hz * ratio);
        for body in [&mut bank.bodies[0], &mut twin] {
            for mode in &mut body.modes {
                mode.support_per_s = 1.0;
            }
        }
        bank.bodies[1] = twin;
        let mut engine = Engine::new(&bank, RATE_HZ);
        engine.set(&Settings {
            sympathy,
            losses: Losses {
                added: Damping {
                    rayleigh: Rayleigh {
                        alpha1_s: 0.0,
                        alpha2_per_s: 0.0,
                    },
                    loss_factor: 0.0,
                },
                ..Losses::AS_BUILT
            },
            ..Settings::default()
        });
        engine.reset();
        engine.strike(60, 0.8);
        let mut level = rms(&left(&mut engine, 24_000));
        let before = level;
        // A hand stops the one that was struck; what is left is the answer.
        engine.choke(60);
        left(&mut engine, 12_000);
        level = rms(&left(&mut engine, 24_000)) / level;
        assert!(before.is_finite());
        db(level)
    };
    let (tuned, weaker, off) = (joined(1.0005, 1.0), joined(1.0005, 0.2), joined(1.06, 1.0));
    println!(
        "answers at {tuned:.1} dB, {weaker:.1} dB if joined loosely, {off:.1} dB a semitone off"
    );
    assert!(tuned > -40.0, "{tuned}");
    assert!((tuned - weaker - db(5.0)).abs() < 3.0, "{weaker}");
    assert!(off < tuned - 15.0, "{off}");
    assert!(joined(1.0005, 0.0) < -200.0);
}

/// Modes bent beyond half the sample rate are silent, whatever their decay would be, and are back with the
/// hand.
#[test]
fn bodies_bent_beyond_hearing_are_silent_and_come_back() {
    for bend_semitones in [60.0, 72.0, 96.0, 120.0] {
        let mut engine = Engine::new(&chimes([60, 90]), RATE_HZ);
        let bent = Hold {
            bend_semitones,
            ..Hold::FREE
        };
        for key in [60, 90] {
            engine.hold(key, &bent);
            engine.strike(key, 0.9);
        }
        let peak = |signal: &[f64]| signal.iter().fold(0.0, |most: f64, x| most.max(x.abs()));
        assert!(peak(&left(&mut engine, 9600)) < 1.0, "{bend_semitones}");
        for key in [60, 90] {
            engine.hold(key, &Hold::FREE);
            engine.strike(key, 0.9);
        }
        let ringing = peak(&left(&mut engine, 9600));
        assert!((1e-3..1.0).contains(&ringing), "{ringing}");
        engine.choke_all();
        left(&mut engine, 24_000);
        assert_eq!(peak(&left(&mut engine, 480)), 0.0, "{bend_semitones}");
    }
}
