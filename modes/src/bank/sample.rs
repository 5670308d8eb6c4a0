//! A small bank for tests.

use super::{Bank, Body, Mode, Provenance};
use crate::{Damping, Family, Material, Member, ModeLabel, Rayleigh, StrikeLine};

/// Two bodies, of which the second has partners that vanish in some components at the line.
pub(super) fn bank() -> Bank {
    Bank {
        name: "two tubes \u{1f514} \"quoted\"".to_owned(),
        title: "Two tubes".to_owned(),
        material: Material {
            lambda_pa: 4.98e10,
            mu_pa: 2.57e10,
            density_kg_m3: 2700.1,
        },
        damping: Damping {
            rayleigh: Rayleigh {
                alpha1_s: 1e-7,
                alpha2_per_s: 0.0,
            },
            loss_factor: 2e-4,
        },
        ears_m: [[-0.1, -1.0, 0.5], [0.1, -1.0, 0.5]],
        provenance: Provenance {
            recipe: "name = \"two\"\n".to_owned(),
            code: "0.1.0 0123456789abcdef".to_owned(),
            mesh: "none".to_owned(),
            solver: "none".to_owned(),
            tolerance_cents: 1.0,
            max_residual: 0.1 + 0.2,
            max_orthonormality_error: f64::MIN_POSITIVE,
        },
        bodies: vec![
            body(36, vec![]),
            body(
                74,
                vec![
                    mode(587.33, Family::Bending, Member::A, |s| [0.0, s, 0.25]),
                    mode(587.33, Family::Bending, Member::B, |s| [s, 0.0, 0.0]),
                    mode(1.0 / 3.0 * 1e4, Family::Other, Member::Single, |_| [0.0; 3]),
                ],
            ),
        ],
    }
}

fn body(key: u8, modes: Vec<Mode>) -> Body {
    Body {
        key,
        pitch_hz: 440.0 * f64::from(key),
        length_m: 0.1 + 0.2,
        mass_kg: 1.0 / 3.0,
        line: StrikeLine {
            points_m: (0..6).map(|i| [0.0125, 0.0, f64::from(i) / 7.0]).collect(),
            normals: vec![[1.0, 0.0, 0.0]; 6],
        },
        modes,
    }
}

fn mode(hz: f64, family: Family, member: Member, shape: impl Fn(f32) -> [f32; 3]) -> Mode {
    Mode {
        hz,
        coupling: 1.0 / hz,
        ears: [[0.25, -0.5], [0.125, 3.0]],
        pipe_ears: [[1.0, 2.0], [3.0, 4.0]],
        radiation_per_s: 0.1,
        support_per_s: 0.2,
        felt_per_s: 30.0,
        pipe_per_s: 0.4,
        residual: 1e-12,
        label: ModeLabel {
            family,
            order: 0x1234,
            index: 0x5678,
            member,
        },
        shape: (0..6_u8).map(|i| shape(f32::from(i) / 3.0 - 1.0)).collect(),
    }
}
