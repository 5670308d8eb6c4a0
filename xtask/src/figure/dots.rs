//! What a body's modes sound like: pitch, length and level.

use modes::{Body, Damping, Mode, ModeLabel, t60_s};
use std::f64::consts::TAU;

/// Where on its line the body is struck, 0…1: where the plug-in strikes unless told otherwise.
pub const STRIKE_POSITION: f64 = 0.03;

/// Over how long levels are taken, in s: the momentary window of EBU R 128. A mode that is over in
/// milliseconds is a click, however high it starts.
pub(super) const WINDOW_S: f64 = 0.4;

/// A mode as it is heard.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Dot {
    pub(super) label: ModeLabel,
    pub(super) hz: f64,
    pub(super) t60_s: f64,
    /// Level over the first [`WINDOW_S`], in dB of the loudest mode's; −∞ for one that the strike
    /// does not reach.
    pub(super) level_db: f64,
}

/// The modes of `body`, made of a material of this `damping`, after an impulse at `position`.
pub(super) fn dots(body: &Body, damping: &Damping, position: f64) -> Vec<Dot> {
    let levels: Vec<f64> = body
        .modes
        .iter()
        .map(|mode| {
            let start = pressure_pa(body, mode, [position, 0.0]);
            start * lasting(mode.decay_per_s(damping))
        })
        .collect();
    let loudest = levels.iter().copied().fold(0.0, f64::max);
    body.modes
        .iter()
        .zip(levels)
        .map(|(mode, level)| Dot {
            label: mode.label,
            hz: mode.hz,
            t60_s: t60_s(mode.decay_per_s(damping)),
            level_db: 20.0 * (level / loudest).log10(),
        })
        .collect()
}

/// Root of the mean square over the window of exp(−`decay_per_s` t).
fn lasting(decay_per_s: f64) -> f64 {
    let fall = 2.0 * decay_per_s * WINDOW_S;
    if fall > 1e-9 {
        (-(-fall).exp_m1() / fall).sqrt()
    } else {
        1.0
    }
}

/// Pressure that a mode sends to the nearer ear after 1 N·s along the normal at a place along and
/// across the strike grid: the impulse gives the mode an amplitude φ·n/ω (O'Brien 2002, Eq. 18 without its 2).
pub(crate) fn pressure_pa(body: &Body, mode: &Mode, place: [f64; 2]) -> f64 {
    let normal = mode.shape.normal_motion(&body.line, place);
    let ear = (0..2)
        .map(|ear| {
            let [real, imaginary] = [0, 1]
                .map(|part| f64::from(mode.ears[ear][part]) + f64::from(mode.pipe_ears[ear][part]));
            real.hypot(imaginary)
        })
        .fold(0.0, f64::max);
    normal.abs() / (TAU * mode.hz) * ear
}

#[cfg(test)]
mod tests {
    use super::*;
    use modes::{Family, Member, Rayleigh, StrikeLine};

    /// A mode that moves by `radial` along the normal everywhere and by 9 across it.
    fn mode(hz: f64, radial: f32) -> Mode {
        Mode {
            hz,
            coupling: 1.0,
            ears: [[1.0, 0.0], [3.0, 1.0]],
            pipe_ears: [[0.0, 0.0], [0.0, 3.0]],
            radiation_per_s: 0.5,
            support_per_s: 0.25,
            felt_per_s: 9.0,
            pipe_per_s: 0.25,
            residual: 0.0,
            label: ModeLabel {
                family: Family::Bending,
                order: 1,
                index: 1,
                member: Member::Single,
            },
            shape: vec![[9.0, 0.0, radial]; 8].into(),
        }
    }

    fn body(modes: Vec<Mode>) -> Body {
        Body {
            key: 60,
            pitch_hz: 100.0,
            length_m: 1.0,
            mass_kg: 1.0,
            matter: None,
            line: StrikeLine::single(vec![[0.0; 3]; 8], vec![[0.0, 0.0, 1.0]; 8]),
            surface: None,
            modes,
        }
    }

    const NONE: Damping = Damping {
        rayleigh: Rayleigh {
            alpha1_s: 0.0,
            alpha2_per_s: 0.0,
        },
        loss_factor: 0.0,
    };

    #[test]
    fn pressure_is_motion_over_frequency_at_the_nearer_ear() {
        let mode = mode(100.0, 2.0);
        let found = pressure_pa(&body(vec![mode.clone()]), &mode, [0.5, 0.0]);
        assert!((found / (2.0 * 5.0 / (TAU * 100.0)) - 1.0).abs() < 1e-6);
    }

    #[test]
    fn a_click_counts_by_the_little_time_it_lasts() {
        assert_eq!(lasting(0.0), 1.0);
        // 1/(2dT) of the window, to e^(−800): −29.03 dB.
        assert!((lasting(1000.0) - (1.0 / 800.0f64).sqrt()).abs() < 1e-12);
    }

    #[test]
    fn levels_are_those_of_the_loudest() {
        let body = body(vec![mode(100.0, 1.0), mode(200.0, 0.2), mode(300.0, 0.0)]);
        let found = dots(&body, &NONE, STRIKE_POSITION);
        assert_eq!(found[0].level_db, 0.0);
        assert!((found[1].level_db + 20.0).abs() < 1e-5);
        assert_eq!(found[2].level_db, f64::NEG_INFINITY);
        // Felt lies on no body that was just struck: 1 per second in all.
        assert!((found[0].t60_s - 1000f64.ln()).abs() < 1e-12);
    }
}
