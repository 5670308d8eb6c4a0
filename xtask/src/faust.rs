//! A body's modes as a program in Faust.

use crate::figure::{STRIKE_POSITION, pressure_pa};
use crate::note;
use anyhow::{Result, bail};
use modes::{Bank, Body, t60_s};
use std::fmt::Write as _;

/// Highest frequency written, in Hz: below half of the lowest usual sample rate.
const HIGHEST_HZ: f64 = 20_000.0;

/// Level in dB of the loudest mode's below which a mode is left out.
const QUIET_DB: f64 = -100.0;

/// The program: `modalModel(n, freq, t60, gain)`, a bank of resonators that an impulse sets going as a
/// blow at `position` along the body and `across` it would, its modes' frequencies, T60 and gains as lists.
pub(crate) fn program(bank: &Bank, body: &Body, [position, across]: [f64; 2]) -> Result<String> {
    let spot = [position, across];
    let damping = bank.matter_of(body).damping;
    let mut modes: Vec<[f64; 3]> = body
        .modes
        .iter()
        .filter(|mode| mode.hz <= HIGHEST_HZ)
        .map(|mode| {
            let decay_per_s = mode.decay_per_s(&damping);
            [mode.hz, t60_s(decay_per_s), pressure_pa(body, mode, spot)]
        })
        .collect();
    let loudest = modes.iter().fold(0.0, |most: f64, mode| most.max(mode[2]));
    let least = loudest * 10f64.powf(QUIET_DB / 20.0);
    modes.retain(|mode| mode[2] > least && mode[1].is_finite());
    if modes.is_empty() {
        bail!("key {}: no mode is heard from a blow there", body.key);
    }
    for mode in &mut modes {
        mode[2] /= loudest;
    }
    let list = |part: usize| {
        let numbers: Vec<String> = modes
            .iter()
            .map(|mode| format!("{:e}", mode[part]))
            .collect();
        numbers.join(", ")
    };
    let mut text = String::new();
    // Writing to a string cannot fail.
    let _ = write!(
        text,
        "// {}, key {} ({}), {:.2} Hz, struck at {:.1} % along and {:.1} % across.\n\
         import(\"stdfaust.lib\");\n\n\
         modalModel(n, freq, t60, gain) = _ <: par(i, n, pm.modeFilter(freq(i), t60(i), gain(i))) :> _;\n\n\
         modes = {};\n\
         hz(i) = ba.take(i + 1, ({}));\n\
         t60_s(i) = ba.take(i + 1, ({}));\n\
         gain(i) = ba.take(i + 1, ({}));\n\n\
         process = modalModel(modes, hz, t60_s, gain);\n",
        bank.title,
        body.key,
        note::name(body.key),
        body.pitch_hz,
        100.0 * position,
        100.0 * across,
        modes.len(),
        list(0),
        list(1),
        list(2),
    );
    Ok(text)
}

/// Where a body is struck unless told otherwise.
pub(crate) const STRUCK: [f64; 2] = [STRIKE_POSITION, 0.0];

#[cfg(test)]
mod tests {
    use super::*;
    use modes::{
        Damping, Family, Material, Member, Mode, ModeLabel, Provenance, Rayleigh, StrikeLine,
    };
    use std::process::Command;

    /// A body with a mode that moves where the row begins and one that moves there half as far.
    fn bank() -> Bank {
        let mode = |hz: f64, motion: f32| Mode {
            hz,
            coupling: 1.0,
            ears: [[hz as f32, 0.0]; 2],
            pipe_ears: [[0.0; 2]; 2],
            radiation_per_s: 0.0,
            support_per_s: 1000f32.ln(),
            felt_per_s: 0.0,
            pipe_per_s: 0.0,
            residual: 0.0,
            label: ModeLabel {
                family: Family::Other,
                order: 0,
                index: 1,
                member: Member::Single,
            },
            shape: vec![[0.0, 0.0, motion]; 8].into(),
        };
        Bank {
            name: "test".into(),
            title: "Test".into(),
            material: Material::from_young(70e9, 0.33, 2700.0).unwrap(),
            damping: Damping {
                rayleigh: Rayleigh {
                    alpha1_s: 0.0,
                    alpha2_per_s: 0.0,
                },
                loss_factor: 0.0,
            },
            ears_m: [[0.0, -1.0, 0.0]; 2],
            provenance: Provenance::default(),
            bodies: vec![Body {
                key: 69,
                pitch_hz: 440.0,
                length_m: 0.3,
                mass_kg: 0.1,
                matter: None,
                line: StrikeLine::single(vec![[0.0; 3]; 8], vec![[0.0, 0.0, 1.0]; 8]),
                surface: None,
                modes: vec![mode(440.0, 1.0), mode(1000.0, -0.5), mode(30_000.0, 1.0)],
            }],
            spread: None,
        }
    }

    #[test]
    fn modes_are_listed_with_the_loudest_at_one() {
        let bank = bank();
        let text = program(&bank, &bank.bodies[0], STRUCK).unwrap();
        assert!(text.starts_with("// Test, key 69 (A4), 440.00 Hz, struck at 3.0 % along"));
        assert!(
            text.contains("modes = 2;\nhz(i) = ba.take(i + 1, (4.4e2, 1e3));"),
            "{text}"
        );
        assert!(
            text.contains("gain(i) = ba.take(i + 1, (1e0, 5e-1));"),
            "{text}"
        );
        let t60 = text.split("t60_s(i) = ba.take(i + 1, (").nth(1).unwrap();
        let t60: f64 = t60.split(',').next().unwrap().parse().unwrap();
        assert!((t60 - 1.0).abs() < 1e-6, "{t60}");
    }

    #[test]
    fn a_body_that_no_blow_moves_is_told() {
        let mut bank = bank();
        for mode in &mut bank.bodies[0].modes {
            mode.shape = vec![[1.0, 0.0, 0.0]; 8].into();
        }
        let error = program(&bank, &bank.bodies[0], STRUCK).unwrap_err();
        assert!(error.to_string().contains("key 69: no mode is heard"));
    }

    /// Where Faust's compiler is installed, it takes the program.
    #[test]
    fn faust_takes_it() {
        let bank = bank();
        let text = program(&bank, &bank.bodies[0], STRUCK).unwrap();
        let folder = tempfile::tempdir().unwrap();
        let file = folder.path().join("test.dsp");
        std::fs::write(&file, text).unwrap();
        let Ok(output) = Command::new("faust").arg(&file).output() else {
            println!("no faust here");
            return;
        };
        let told = String::from_utf8_lossy(&output.stderr);
        assert!(output.status.success(), "{told}");
    }
}
