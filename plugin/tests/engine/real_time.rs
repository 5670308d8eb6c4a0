//! The audio thread: no allocation, no cost of silence, nothing but finite sound.

use crate::support::{Random, chimes, head};
use idiophone::engine::{
    Bow, Discs, Engine, Hold, Listener, Losses, Mallet, OUTPUT_BOUND, Settings, Split, Tweak,
};
use modes::{Damping, Rayleigh};
use nice_assert_no_alloc::assert_no_alloc;

/// With the feature, the plug-in brings this allocator along.
#[cfg(not(feature = "assert_process_allocs"))]
#[global_allocator]
static ALLOCATOR: nice_assert_no_alloc::AllocDisabler = nice_assert_no_alloc::AllocDisabler;

#[test]
fn playing_allocates_nothing() {
    let mut engine = Engine::new(&chimes(55..=90), 48_000.0);
    let (mut left, mut right) = ([0.0; 300], [0.0; 300]);
    // Aborts on the first allocation.
    assert_no_alloc(|| {
        for round in 0..40_u8 {
            for key in 55..=90 {
                engine.strike(key, f32::from(round) / 40.0);
                engine.strike(key, 0.5);
            }
            engine.set(&Settings {
                losses: Losses {
                    added: Damping {
                        rayleigh: Rayleigh {
                            alpha1_s: 1e-7 * f64::from(round),
                            alpha2_per_s: 0.0,
                        },
                        loss_factor: 0.0,
                    },
                    ..Losses::AS_BUILT
                },
                note_off_damps: round % 2 == 0,
                ..Settings::default()
            });
            engine.process(&mut left, &mut right);
            engine.release(60);
            engine.choke(61);
            engine.process(&mut left[..7], &mut right[..7]);
        }
        engine.choke_all();
        engine.reset();
        engine.process(&mut left, &mut right);
    });
}

#[test]
fn anything_at_all_leaves_the_output_finite_and_bounded() {
    let mut random = Random(2002);
    let odd = [f64::NAN, f64::INFINITY, f64::NEG_INFINITY, -1.0, 1e300, 0.0];
    let wild = |random: &mut Random, scale: f64| {
        if random.below(4) == 0 {
            odd[random.below(odd.len())]
        } else {
            scale * random.unit()
        }
    };
    let mut events = 0;
    let mut peak = 0.0_f32;
    let rates = [
        1e3,
        8e3,
        44_100.0,
        48_000.0,
        96_000.0,
        192_000.0,
        768e3,
        0.0,
        f64::NAN,
        1e9,
    ];
    for rate_hz in rates {
        let mut engine = Engine::new(&chimes([60, 71, 74, 90]), rate_hz);
        let (mut left, mut right) = ([0.0; 256], [0.0; 256]);
        for _ in 0..10_000 {
            let key = [60, 71, 74, 90, 61, 127, 255][random.below(7)];
            match random.below(12) {
                0..=5 => {
                    let velocity = wild(&mut random, 1.0) as f32;
                    engine.strike(key, velocity);
                }
                6 => engine.release(key),
                7 => engine.hold(
                    key,
                    &Hold {
                        bend_semitones: wild(&mut random, 48.0),
                        level: wild(&mut random, 2.0),
                        pan: wild(&mut random, 1.0),
                        felt: wild(&mut random, 1.0),
                        hand_per_s: wild(&mut random, 100.0),
                        bow_pressure: wild(&mut random, 1.0),
                        bow_speed_octaves: wild(&mut random, 2.0),
                    },
                ),
                8 => engine.choke(key),
                9 => match random.below(50) {
                    0 => engine.reset(),
                    1 => engine.choke_all(),
                    _ => {}
                },
                _ => engine.set(&Settings {
                    strike_position: wild(&mut random, 1.0),
                    strike_across: wild(&mut random, 1.0),
                    velocity_to_position: wild(&mut random, 1.0),
                    position_scatter: wild(&mut random, 1.0),
                    mallet: Mallet {
                        mass_kg: wild(&mut random, 0.2),
                        head_radius_m: wild(&mut random, 0.05),
                        hardness_pa: wild(&mut random, 1e11),
                        loss_s_m: wild(&mut random, 1.0),
                        roughness: wild(&mut random, 1.0),
                        press_n: wild(&mut random, 20.0),
                    },
                    velocity_range_db: wild(&mut random, 60.0),
                    losses: Losses {
                        added: Damping {
                            rayleigh: Rayleigh {
                                alpha1_s: wild(&mut random, 2e-5),
                                alpha2_per_s: wild(&mut random, 100.0),
                            },
                            loss_factor: 0.0,
                        },
                        ..Losses::AS_BUILT
                    },
                    note_off_damps: random.below(2) == 0,
                    motor: Discs {
                        speed_hz: wild(&mut random, 12.0),
                        depth: wild(&mut random, 1.0),
                        phase_deg: wild(&mut random, 180.0),
                    },
                    speed_scatter_db: wild(&mut random, 12.0),
                    bow: Bow {
                        force_n: wild(&mut random, 20.0),
                        speed_m_s: wild(&mut random, 2.0),
                        rubs: random.below(8) == 0,
                    },
                    tweak: Tweak {
                        size: wild(&mut random, 4.0),
                        stiffness: wild(&mut random, 16.0),
                        density: wild(&mut random, 16.0),
                    },
                    listener: Listener {
                        width: wild(&mut random, 1.0),
                        distance: wild(&mut random, 8.0),
                        angle_deg: wild(&mut random, 90.0),
                    },
                    swing: wild(&mut random, 1.0),
                    sympathy: wild(&mut random, 1.0),
                    limiter: random.below(2) == 0,
                    split: Split::ALL[random.below(4)],
                    gain_db: wild(&mut random, 12.0),
                }),
            }
            let longest = if random.below(20) == 0 { 256 } else { 16 };
            let frames = random.below(longest);
            left.fill(f32::NAN);
            right.fill(f32::NAN);
            engine.process(&mut left[..frames], &mut right[..frames]);
            for sample in left[..frames].iter().chain(&right[..frames]) {
                assert!(sample.abs() <= OUTPUT_BOUND, "{sample} at {rate_hz} Hz");
                assert!(*sample == 0.0 || sample.is_normal());
                peak = peak.max(sample.abs());
            }
            events += 1;
        }
    }
    println!("peak {peak}");
    assert_eq!(events, 100_000);
    assert!(peak > 0.1);
}

/// Bodies are tuned ahead of blows while nothing sounds, which no sound may tell.
#[test]
fn bodies_made_ready_sound_as_those_that_are_not() {
    let settings = |hardness_pa| Settings {
        mallet: head(hardness_pa),
        losses: Losses {
            added: Damping {
                rayleigh: Rayleigh {
                    alpha1_s: 0.0,
                    alpha2_per_s: 0.05,
                },
                loss_factor: 0.0,
            },
            ..Losses::AS_BUILT
        },
        // Open to the last bit as after a reset: else every blow tunes its body anew, made ready or not.
        motor: Discs {
            depth: 0.0,
            ..Discs::OPEN
        },
        // Bodies are to be tuned and heard otherwise than as they were made, in every respect.
        tweak: Tweak {
            size: 1.1,
            ..Tweak::NONE
        },
        listener: Listener {
            angle_deg: 30.0,
            ..Listener::AS_BUILT
        },
        ..Settings::default()
    };
    let chord = |silent: usize, hardness_pa: f64| {
        let mut engine = Engine::new(&chimes(60..=71), 48_000.0);
        engine.set(&settings(hardness_pa));
        crate::support::left(&mut engine, silent);
        // Back to the same place in the song, on which the scatter of blows depends.
        engine.reset();
        for key in 60..=71 {
            engine.strike(key, 1.0);
        }
        crate::support::left(&mut engine, 4800)
    };
    // A soft head is followed in the steps that are made ahead, a hard one in finer ones.
    for hardness_pa in [1e7, 2e9] {
        let at_once = chord(0, hardness_pa);
        assert!(at_once.iter().any(|sample| *sample != 0.0));
        for cells in [1, 2, 100] {
            let ready = chord(32 * cells, hardness_pa);
            assert!(ready == at_once, "after {cells} cells, {hardness_pa} Pa");
        }
    }
}

/// Losses set while nothing sounds hold from the first touch on, as if the bank had them.
#[test]
fn losses_set_in_silence_hold_from_the_blow_on() {
    let lossy = Damping {
        rayleigh: Rayleigh {
            alpha1_s: 0.0,
            alpha2_per_s: 50.0,
        },
        loss_factor: 0.0,
    };
    let plain = chimes([60]);
    let mut dull = plain.clone();
    dull.damping.rayleigh.alpha2_per_s += lossy.rayleigh.alpha2_per_s;
    let mut set = Engine::new(&plain, 48_000.0);
    set.set(&Settings {
        losses: Losses {
            added: lossy,
            ..Losses::AS_BUILT
        },
        ..Settings::default()
    });
    set.reset();
    let mut built = Engine::new(&dull, 48_000.0);
    let [set, built] = [&mut set, &mut built].map(|engine| {
        engine.strike(60, 1.0);
        crate::support::left(engine, 2400)
    });
    // Banks are made equally loud, so the two differ by one factor.
    let product = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(a, b)| a * b).sum::<f64>();
    let share = product(&set, &built) / product(&built, &built);
    let off: Vec<f64> = set.iter().zip(&built).map(|(a, b)| a - share * b).collect();
    let rest = (product(&off, &off) / product(&set, &set)).sqrt();
    println!("rest {rest:.1e}");
    assert!(rest < 1e-6, "{rest:e}");
}

#[test]
fn bodies_fall_asleep_and_silence_is_exact() {
    let mut engine = Engine::new(&chimes([60, 74]), 48_000.0);
    engine.strike(60, 1.0);
    engine.strike(74, 1.0);
    let (mut left, mut right) = (vec![0.0; 480], vec![0.0; 480]);
    engine.process(&mut left, &mut right);
    assert_eq!(engine.awake(), (1 << 60) | (1 << 74));
    engine.choke(60);
    for _ in 0..20 {
        engine.process(&mut left, &mut right);
    }
    assert_eq!(engine.awake(), 1 << 74, "choked within 0.2 s");
    let mut seconds = 0.2;
    while engine.awake() != 0 {
        engine.process(&mut left, &mut right);
        seconds += 0.01;
        assert!(seconds < 60.0);
    }
    println!("key 74 sleeps after {seconds:.1} s");
    engine.process(&mut left, &mut right);
    assert!(left.iter().chain(&right).all(|s| *s == 0.0));
}

#[test]
fn a_choke_does_not_click() {
    let mut engine = Engine::new(&chimes([74]), 48_000.0);
    engine.strike(74, 1.0);
    let mut signal = crate::support::left(&mut engine, 24_000);
    engine.choke(74);
    signal.extend(crate::support::left(&mut engine, 24_000));
    let steepest = |part: &[f64]| {
        part.windows(3)
            .map(|w| (w[0] - 2.0 * w[1] + w[2]).abs())
            .fold(0.0, f64::max)
    };
    assert!(steepest(&signal[23_900..25_000]) < 1.05 * steepest(&signal[23_500..23_990]));
    assert_eq!(signal[24_000 + 9600..], vec![0.0; 24_000 - 9600]);
}
