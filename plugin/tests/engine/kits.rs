//! Bodies of several materials in one bank: each sounds as it does in a bank of its own.

use crate::support::{chimes, left};
use idiophone::engine::{Engine, Settings};
use modes::{Bank, Damping, Material, Matter, Rayleigh};

const RATE_HZ: f64 = 48_000.0;

/// Softer than the chimes' aluminium, and much duller.
fn oak() -> Matter {
    Matter {
        material: Material::from_young(11e9, 0.35, 700.0).expect("oak is possible"),
        damping: Damping {
            rayleigh: Rayleigh {
                alpha1_s: 1e-6,
                alpha2_per_s: 8.0,
            },
            loss_factor: 0.01,
        },
    }
}

/// Two chimes, of which the higher says what it is made of.
fn kit() -> Bank {
    let mut kit = chimes([60, 72]);
    kit.bodies[1].matter = Some(oak());
    kit
}

fn struck(bank: &Bank, keys: &[u8]) -> Vec<f64> {
    let mut engine = Engine::new(bank, RATE_HZ);
    engine.set(&Settings {
        limiter: false,
        ..Settings::default()
    });
    let mut sound = left(&mut engine, 480);
    for key in keys {
        engine.strike(*key, 0.8);
    }
    sound.extend(left(&mut engine, 9600));
    sound
}

#[test]
fn a_body_of_its_own_matter_sounds_as_in_a_bank_of_it() {
    let Matter { material, damping } = oak();
    let of_oak = Bank {
        material,
        damping,
        ..chimes([60, 72])
    };
    assert_eq!(struck(&kit(), &[72]), struck(&of_oak, &[72]));
    assert_eq!(struck(&kit(), &[60]), struck(&chimes([60, 72]), &[60]));
    assert_ne!(struck(&of_oak, &[72]), struck(&chimes([60, 72]), &[72]));
}

/// Struck at once, they add up.
#[test]
fn bodies_of_two_materials_sound_together() {
    let [low, high, both] = [&[60][..], &[72], &[60, 72]].map(|keys| struck(&kit(), keys));
    let loudest = both.iter().fold(0.0f64, |most, x| most.max(x.abs()));
    for ((low, high), both) in low.iter().zip(&high).zip(&both) {
        assert!((low + high - both).abs() < 1e-6 * loudest, "{both}");
    }
}
