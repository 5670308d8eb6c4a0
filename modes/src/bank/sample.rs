//! A small bank for tests.

use super::{Bank, Body, Mode, Provenance, Spread, SpreadRule, Surface, SurfaceMotion, Zone};
use crate::{Damping, Family, Material, Member, ModeLabel, Rayleigh, StrikeLine};
use std::sync::Arc;

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
        spread: None,
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

/// One body struck on two rows of points, drawn as a tetrahedron, for three octaves of keys.
pub(super) fn grid_bank() -> Bank {
    let wave = |s: f32| [1.0 + s, 0.5, -s];
    let mut modes = vec![
        mode(200.0, Family::Other, Member::Single, wave),
        mode(300.0, Family::Other, Member::Single, |s| [s, 1.0, 0.0]),
        mode(6000.0, Family::Other, Member::Single, |s| [s, 0.0, 0.0]),
    ];
    for mode in &mut modes {
        mode.shape = mode.shape.iter().chain(mode.shape.iter().rev()).collect();
        (mode.pipe_ears, mode.pipe_per_s) = ([[0.0; 2]; 2], 0.0);
    }
    let mut body = body(60, modes);
    body.line.points_m.extend_from_within(..);
    body.line.normals.extend_from_within(..);
    (body.line.rows, body.line.closed) = (2, true);
    let motion = |sign: f32| {
        SurfaceMotion::of(&[
            [sign, 0.0, 0.5],
            [0.0; 3],
            [0.25, -1.0, 0.0],
            [0.0, 0.1, -0.1],
        ])
    };
    body.surface = Some(Arc::new(Surface {
        length_m: body.length_m,
        points_m: vec![[0.0; 3], [0.1, 0.0, 0.0], [0.0, 0.1, 0.0], [0.0, 0.0, 0.1]],
        triangles: vec![[0, 2, 1], [0, 1, 3], [1, 2, 3], [0, 3, 2]],
        motions: vec![motion(1.0), motion(-0.5)],
    }));
    Bank {
        bodies: vec![body],
        spread: Some(Spread {
            rule: SpreadRule::Size,
            a4_hz: 442.0,
            zones: vec![Zone {
                low: 48,
                high: 84,
                tuned: 1,
                rule: None,
            }],
            enough: None,
        }),
        ..bank()
    }
}

fn body(key: u8, modes: Vec<Mode>) -> Body {
    Body {
        key,
        pitch_hz: 440.0 * f64::from(key),
        length_m: 0.1 + 0.2,
        mass_kg: 1.0 / 3.0,
        matter: None,
        line: StrikeLine::single(
            (0..6).map(|i| [0.0125, 0.0, f64::from(i) / 7.0]).collect(),
            vec![[1.0, 0.0, 0.0]; 6],
        ),
        surface: None,
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
