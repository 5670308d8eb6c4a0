//! A bank whose modes ring for a minute, in any number.

use idiophone::engine::{Mallet, Settings};
use modes::{
    Bank, Body, Damping, Family, Material, Member, Mode, ModeLabel, Provenance, Rayleigh,
    StrikeLine,
};

/// Points of a strike line.
const POINTS: usize = 8;

/// Time in which a mode falls by 60 dB, in s.
const T60_S: f64 = 60.0;

/// Frequencies of the first mode and after the last, in Hz.
pub(crate) type Band = (f64, f64);

/// All that people hear of most bodies.
pub(crate) const WIDE: Band = (50.0, 15_050.0);

/// A mallet of brass, off before the highest mode has turned, so that all are struck.
pub(crate) const MALLET: Settings = Settings {
    mallet: Mallet {
        hardness_pa: 1e11,
        ..Mallet::DEFAULT
    },
    ..Settings::DEFAULT
};

/// As many bodies (keys from 0), each with `modes` modes; all frequencies differ, evenly spaced over `band`.
///
/// Every strike reaches every mode, and each ear hears it with a level and a phase of its own.
pub(crate) fn bank(bodies: u8, modes: usize, band: Band) -> Bank {
    let count = usize::from(bodies) * modes;
    let spacing_hz = (band.1 - band.0) / count as f64;
    let hz = |key: u8, index: usize| {
        band.0 + spacing_hz * (index * usize::from(bodies) + usize::from(key)) as f64
    };
    Bank {
        name: "ring".into(),
        title: "Ringing modes".into(),
        material: Material {
            lambda_pa: 5e10,
            mu_pa: 2.6e10,
            density_kg_m3: 2700.0,
        },
        damping: Damping {
            rayleigh: Rayleigh {
                alpha1_s: 0.0,
                alpha2_per_s: 2.0 * 1000f64.ln() / T60_S,
            },
            loss_factor: 0.0,
        },
        ears_m: [[-0.1, -1.0, 0.0], [0.1, -1.0, 0.0]],
        provenance: Provenance::default(),
        bodies: (0..bodies)
            .map(|key| body(key, (0..modes).map(|index| mode(hz(key, index), index))))
            .collect(),
        spread: None,
    }
}

fn body(key: u8, modes: impl Iterator<Item = Mode>) -> Body {
    let modes: Vec<Mode> = modes.collect();
    let length_m = 0.5;
    let along = |point: usize| length_m * point as f64 / (POINTS - 1) as f64;
    Body {
        key,
        pitch_hz: modes.first().map_or(0.0, |mode| mode.hz),
        length_m,
        mass_kg: 0.35,
        matter: None,
        line: StrikeLine::single(
            (0..POINTS).map(|point| [0.0, 0.0, along(point)]).collect(),
            vec![[1.0, 0.0, 0.0]; POINTS],
        ),
        surface: None,
        modes,
    }
}

fn mode(hz: f64, index: usize) -> Mode {
    // Pressure goes with frequency, so that an impulse makes all modes about equally loud.
    let ear = |turn: f64| {
        let (sin, cos) = (turn * (1 + index) as f64).sin_cos();
        [(1e-3 * hz * cos) as f32, (1e-3 * hz * sin) as f32]
    };
    Mode {
        hz,
        coupling: hz,
        ears: [ear(0.3), ear(-0.7)],
        pipe_ears: [[0.0; 2]; 2],
        radiation_per_s: 0.0,
        support_per_s: 0.0,
        felt_per_s: 0.0,
        pipe_per_s: 0.0,
        residual: 0.0,
        label: ModeLabel {
            family: Family::Bending,
            order: 1,
            index: u16::try_from(index).unwrap_or(u16::MAX),
            member: Member::A,
        },
        shape: vec![[1.0, 0.0, 0.0]; POINTS].into(),
    }
}
