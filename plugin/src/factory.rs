//! The banks that come with the plug-in.

use modes::{
    Bank, Body, Family, Material, Member, Mode, ModeLabel, Provenance, Rayleigh, StrikeLine,
};
use std::f64::consts::{PI, TAU};

/// Tuned chimes for the keys 48 to 108: thin free tubes after Euler and Bernoulli, their shapes
/// simplified to cosines.
#[must_use]
pub fn chimes() -> Bank {
    Bank {
        name: "chimes".into(),
        material: Material::from_young(70e9, 0.33, 2700.0),
        damping: Rayleigh {
            alpha1_s: 1e-7,
            alpha2_per_s: 0.0,
        },
        provenance: Provenance::default(),
        bodies: (48..=108).map(chime).collect(),
    }
}

fn chime(key: u8) -> Body {
    const POINTS: u32 = 61;
    const RADIUS_M: f64 = 0.0125;
    let pitch_hz = 440.0 * 2f64.powf((f64::from(key) - 69.0) / 12.0);
    let length_m = 0.505 * (587.33 / pitch_hz).sqrt();
    let mass_kg = 0.35 * length_m / 0.505;
    let height = 2.0 / mass_kg.sqrt();
    let along = |i: u32| f64::from(i) / f64::from(POINTS - 1);
    let mode = |k: u16| {
        let ratio = f64::from(2 * k + 1) / 3.0;
        let hz = pitch_hz * ratio * ratio;
        Mode {
            hz,
            coupling: TAU * hz * height * 0.6 * 4.0 * RADIUS_M * length_m,
            residual: 0.0,
            label: ModeLabel {
                family: Family::Bending,
                order: 1,
                index: k,
                member: Member::A,
            },
            shape: (0..POINTS)
                .map(|i| {
                    [
                        (height * (PI * f64::from(k + 1) * along(i)).cos()) as f32,
                        0.0,
                        0.0,
                    ]
                })
                .collect(),
        }
    };
    Body {
        key,
        pitch_hz,
        length_m,
        mass_kg,
        line: StrikeLine {
            points_m: (0..POINTS)
                .map(|i| [RADIUS_M, 0.0, length_m * along(i)])
                .collect(),
            normals: vec![[1.0, 0.0, 0.0]; POINTS as usize],
        },
        modes: (1..).map(mode).take_while(|mode| mode.hz < 20e3).collect(),
    }
}
