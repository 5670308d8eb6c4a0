//! Where and how hard a body is struck is heard, and strikes add up.

use crate::support::head;
use crate::support::{Random, beam_shape, chimes, db, expected, fit, left};
use idiophone::engine::{Discs, Engine, Hold, Listener, Losses, Mallet, Settings};
use modes::{Damping, Rayleigh};

const RATE_HZ: f64 = 48_000.0;

fn struck(settings: &Settings, velocity: f32, samples: usize) -> Vec<f64> {
    let mut engine = Engine::new(&chimes([74]), RATE_HZ);
    engine.set(settings);
    engine.strike(74, velocity);
    left(&mut engine, samples)
}

fn at(strike_position: f64) -> Settings {
    Settings {
        strike_position,
        ..Settings::default()
    }
}

/// Energy-weighted mean frequency of the first 40 ms, in Hz.
fn centroid_hz(signal: &[f64]) -> f64 {
    let spectrum = crate::support::spectrum(&signal[..2048]);
    let energy: f64 = spectrum.iter().map(|v| v * v).sum();
    let moment: f64 = spectrum
        .iter()
        .enumerate()
        .map(|(bin, v)| bin as f64 * RATE_HZ / 2048.0 * v * v)
        .sum();
    moment / energy
}

#[test]
fn a_node_silences_its_mode() {
    let bank = chimes([74]);
    let expected = expected(&bank.bodies[0], bank.damping);
    for k in 1..=4 {
        let (mut low, mut high) = (0.0, 0.5 - 0.4 * f64::from(u8::from(k % 2 == 0)));
        if k % 2 == 0 {
            (low, high) = (0.02, 0.2);
        }
        for _ in 0..60 {
            let middle = 0.5 * (low + high);
            if beam_shape(k, middle) * beam_shape(k, low) > 0.0 {
                low = middle;
            } else {
                high = middle;
            }
        }
        let level = |position: f64| {
            let signal = struck(&at(position), 0.8, 9600);
            fit(&signal, RATE_HZ, &expected, 96..9600)[k - 1].amplitude
        };
        let drop = db(level(low) / level(0.0));
        println!("mode {k} at {low:.4}: {drop:.1} dB");
        assert!(drop < -120.0, "mode {k} at {low}: {drop} dB");
    }
}

#[test]
fn mirror_positions_sound_equal() {
    // Odd modes move alike at both ends, even ones against each other: levels are equal, not signs.
    let bank = chimes([74]);
    let expected = expected(&bank.bodies[0], bank.damping);
    let partials = |position: f64| {
        let signal = struck(&at(position), 0.7, 9600);
        fit(&signal, RATE_HZ, &expected, 96..9600)
    };
    for (a, b) in partials(0.17).iter().zip(partials(0.83)) {
        let difference = db(a.amplitude / b.amplitude);
        println!("{:.0} Hz: {difference:.1e} dB", a.hz);
        // Shapes are kept in single precision.
        assert!(difference.abs() < 3e-3, "{} Hz: {difference} dB", a.hz);
    }
}

#[test]
fn the_end_is_bright_and_the_middle_dull() {
    // The harder the head, the more the odd modes that the middle keeps brighten it too.
    let rawhide = |strike_position: f64| Settings {
        mallet: head(1e9),
        ..at(strike_position)
    };
    let end = centroid_hz(&struck(&rawhide(0.01), 0.8, 2048));
    let middle = centroid_hz(&struck(&rawhide(0.5), 0.8, 2048));
    println!("centroid {end:.0} Hz at the end, {middle:.0} Hz in the middle");
    assert!(end > 1.2 * middle, "{end} Hz against {middle} Hz");
}

#[test]
fn harder_blows_and_harder_heads_are_brighter() {
    let soft = centroid_hz(&struck(&at(0.03), 0.1, 2048));
    let hard = centroid_hz(&struck(&at(0.03), 1.0, 2048));
    assert!(hard > 1.2 * soft, "{hard} Hz against {soft} Hz");
    let yarn = Settings {
        mallet: head(1e7),
        ..at(0.03)
    };
    assert!(centroid_hz(&struck(&yarn, 1.0, 2048)) < 0.7 * hard);
}

/// Bodies do not hear of each other: what sounds together is the sum of what sounds alone.
#[test]
fn bodies_add_up() {
    let bank = chimes([60, 67, 74]);
    let blows = [
        (74, 0.9, 0),
        (60, 0.5, 1000),
        (74, 0.6, 5003),
        (74, 1.0, 5010),
        (67, 1.0, 5010),
    ];
    let render = |keys: &[u8]| {
        let mut engine = Engine::new(&bank, RATE_HZ);
        engine.set(&Settings {
            position_scatter: 0.3,
            ..Settings::default()
        });
        let mut signal = Vec::new();
        for (key, velocity, time) in blows {
            let wait = time - signal.len();
            signal.extend(left(&mut engine, wait));
            if keys.contains(&key) {
                engine.strike(key, velocity);
            }
        }
        let rest = 48_000 - signal.len();
        signal.extend(left(&mut engine, rest));
        signal
    };
    let together = render(&[60, 67, 74]);
    let alone = [60, 67, 74].map(|key| render(&[key]));
    let peak = together.iter().fold(0.0, |p: f64, v| p.max(v.abs()));
    let worst = (0..48_000)
        .map(|n| (together[n] - alone.iter().map(|a| a[n]).sum::<f64>()).abs())
        .fold(0.0, f64::max);
    println!("superposition {:.1} dB", db(worst / peak));
    assert!(db(worst / peak) < -126.0, "{} dB", db(worst / peak));
}

/// A mallet that meets a ringing body takes from it or gives to it, as their motions meet: the same soft
/// blow, a sixteenth of a period later each time.
#[test]
fn a_strike_on_a_ringing_body_may_take_from_it() {
    let bank = chimes([60]);
    let hz = bank.bodies[0].modes[0].hz;
    let soft = Settings {
        mallet: Mallet {
            mass_kg: 0.05,
            loss_s_m: 0.5,
            ..head(5e7)
        },
        strike_position: 0.5,
        ..Settings::default()
    };
    let level = |delay: usize, second: bool| {
        let mut engine = Engine::new(&bank, RATE_HZ);
        engine.set(&soft);
        engine.strike(60, 0.9);
        left(&mut engine, 4800 + delay);
        if second {
            engine.strike(60, 0.7);
        }
        let signal = left(&mut engine, 12_000);
        let expected = expected(&bank.bodies[0], bank.damping);
        fit(&signal, RATE_HZ, &expected[..1], 4800..12_000)[0].amplitude
    };
    let period = RATE_HZ / hz;
    let changes: Vec<f64> = (0..16)
        .map(|k| {
            #[expect(clippy::cast_sign_loss, reason = "a time is not negative")]
            let delay = (period * f64::from(k) / 16.0) as usize;
            db(level(delay, true) / level(delay, false))
        })
        .collect();
    println!("{changes:.1?}");
    let least = changes.iter().fold(0.0, |a: f64, b| a.min(*b));
    let most = changes.iter().fold(0.0, |a: f64, b| a.max(*b));
    assert!(least < -2.0, "takes {least} dB");
    assert!(most > 0.5, "gives {most} dB");
}

/// Air that is pushed and not accelerated is silent: whatever the mallet, the pressure adds up to
/// nothing, as that of no real blow does not.
#[test]
fn a_blow_leaves_no_thump() {
    for hardness_pa in [1e6, 5e7, 2e9, 1e11] {
        let settings = Settings {
            mallet: head(hardness_pa),
            losses: Losses::only(Damping {
                rayleigh: Rayleigh {
                    alpha1_s: 0.0,
                    alpha2_per_s: 100.0,
                },
                loss_factor: 0.0,
            }),
            ..Settings::default()
        };
        let signal = struck(&settings, 1.0, 48_000);
        let (sum, size) = signal
            .iter()
            .fold((0.0, 0.0), |(sum, size), s| (sum + s, size + s.abs()));
        println!("{hardness_pa:.0e} Pa: {:.1} dB", db(f64::abs(sum) / size));
        assert!(db(f64::abs(sum) / size) < -40.0, "{hardness_pa:e} Pa");
    }
}

/// One event of a busy song.
enum Event {
    Strike(u8, f32),
    Release(u8),
    Hold(u8, Hold),
    Choke(u8),
    Set(Box<Settings>),
}

/// A song of many events, some at the same sample.
fn song(keys: &[u8], samples: usize) -> Vec<(usize, Event)> {
    let mut random = Random(7);
    let mut song: Vec<(usize, Event)> = (0..300)
        .map(|_| {
            let key = keys[random.below(keys.len())];
            let event = match random.below(8) {
                0..=3 => Event::Strike(key, random.unit() as f32),
                4 => Event::Release(key),
                5 => Event::Hold(
                    key,
                    Hold {
                        bend_semitones: 4.0 * random.unit() - 2.0,
                        level: random.unit(),
                        pan: random.unit(),
                        felt: random.unit(),
                        bow_pressure: (random.unit() - 0.7).max(0.0),
                        ..Hold::FREE
                    },
                ),
                6 => Event::Choke(key),
                _ => Event::Set(Box::new(Settings {
                    strike_position: random.unit(),
                    position_scatter: random.unit(),
                    mallet: head(1e6 * 1e5f64.powf(random.unit())),
                    losses: Losses {
                        added: Damping {
                            rayleigh: Rayleigh {
                                alpha1_s: 1e-6 * random.unit(),
                                alpha2_per_s: 5.0 * random.unit(),
                            },
                            loss_factor: 0.0,
                        },
                        ..Losses::AS_BUILT
                    },
                    note_off_damps: random.below(2) == 0,
                    motor: Discs {
                        speed_hz: 12.0 * random.unit(),
                        depth: random.unit(),
                        phase_deg: 180.0 * random.unit(),
                    },
                    listener: Listener {
                        width: random.unit(),
                        distance: 1.0 + random.unit(),
                        angle_deg: 90.0 * random.unit(),
                    },
                    swing: random.unit(),
                    gain_db: -20.0 * random.unit(),
                    ..Settings::default()
                })),
            };
            (random.below(samples), event)
        })
        .collect();
    song.sort_by_key(|(time, _)| *time);
    song
}

#[test]
fn the_same_bits_at_every_block_size() {
    let keys = [60, 64, 67, 74];
    let mut bank = chimes(keys);
    for body in &mut bank.bodies {
        body.modes[0].pipe_ears = body.modes[0].ears;
        body.modes[0].pipe_per_s = 1.0;
    }
    let samples = 60_000;
    let song = song(&keys, samples);
    let render = |block: usize| {
        let mut engine = Engine::new(&bank, RATE_HZ);
        let (mut l, mut r) = (vec![f32::NAN; samples], vec![f32::NAN; samples]);
        let mut events = song.iter().peekable();
        for start in (0..samples).step_by(block) {
            let end = (start + block).min(samples);
            let mut done = start;
            while done < end {
                while let Some((_, event)) = events.next_if(|(time, _)| *time == done) {
                    match event {
                        Event::Strike(key, velocity) => {
                            engine.strike(*key, *velocity);
                        }
                        Event::Release(key) => engine.release(*key),
                        Event::Hold(key, hold) => engine.hold(*key, hold),
                        Event::Choke(key) => engine.choke(*key),
                        Event::Set(settings) => engine.set(settings),
                    }
                }
                let next = events.peek().map_or(end, |(time, _)| end.min(*time));
                engine.process(&mut l[done..next], &mut r[done..next]);
                done = next;
            }
        }
        l.iter().chain(&r).map(|s| s.to_bits()).collect::<Vec<_>>()
    };
    let reference = render(512);
    assert!(
        reference
            .iter()
            .any(|bits| f32::from_bits(*bits).abs() > 0.01)
    );
    for block in [1, 7, 64, 4096] {
        assert!(render(block) == reference, "block size {block}");
    }
}
