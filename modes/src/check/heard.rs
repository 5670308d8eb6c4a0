//! What reaches the ears: the sum over patches of 2001 beside the one number of 2002.

use super::{CHIME, CheckError, Row, aluminium};
use crate::Member;
use crate::radiation::{AIR_KG_M3, Listener, SOUND_M_S, Surface, Transfers, coupling};
use crate::revolution::{Bell, LAYERS, revolution_modes};
use crate::solve::Band;
use std::f64::consts::{PI, TAU};

/// Ears 20 cm apart, a metre away (O'Brien, Cook & Essl 2001, §4).
const LISTENER: Listener = Listener {
    ears_m: [[-0.1, -1.0, 0.0], [0.1, -1.0, 0.0]],
};

pub(super) fn rows() -> Result<Vec<Row>, CheckError> {
    let mut rows: Vec<Row> = [100.0, 1000.0, 4000.0].map(sphere).into();
    rows.push(far_sphere());
    rows.extend(chime()?);
    Ok(rows)
}

/// A breathing sphere of unit amplitude: |p| = ρω²a²/(r √(1 + k²a²)) at r.
fn sphere(hz: f64) -> Row {
    const RADIUS_M: f64 = 0.05;
    let surface = sphere_surface(RADIUS_M);
    let motion = vec![1.0; surface.len()];
    let (omega, ka) = (TAU * hz, TAU * hz / SOUND_M_S * RADIUS_M);
    let radiates = ka * ka / (1.0 + ka * ka);
    // Power 2πa² ρc ω² (ka)²/(1 + (ka)²), which is 'radiation_per_s' times ω² of a unit mode.
    let rate_per_s = TAU * RADIUS_M.powi(2) * AIR_KG_M3 * SOUND_M_S * radiates;
    let transfers = Transfers::new(&surface, &LISTENER);
    let [left, _] = transfers.ears(hz, &motion, rate_per_s);
    let [distance_m, _] = transfers.distances_m();
    let expected =
        AIR_KG_M3 * omega.powi(2) * RADIUS_M.powi(2) / (distance_m * (1.0 + ka * ka).sqrt());
    Row::relative(
        format!("breathing sphere of 5 cm at {hz:.0} Hz, pressure at an ear"),
        (
            expected,
            f64::from(left[0]).hypot(f64::from(left[1])),
            "Pa/m",
        ),
        0.02,
        "spherical wave (Kinsler 2000, §7.1)",
    )
}

/// Far from a breathing sphere that is small against the wave, Eq. 10 leaves a quarter of what the
/// coefficient of 2002 counts: half of the patches are seen, at a mean cosine of a half.
fn far_sphere() -> Row {
    const HZ: f64 = 100.0;
    let surface = sphere_surface(0.05);
    let motion = vec![1.0; surface.len()];
    let listener = Listener {
        ears_m: LISTENER.ears_m.map(|[x, y, z]| [x, 20.0 * y, z]),
    };
    let transfers = Transfers::new(&surface, &listener);
    let share = over_omni(&transfers, HZ, &motion, surface.rectified_area(&motion));
    Row::relative(
        "breathing sphere of 5 cm at 100 Hz from 20 m: Eq. 10 of 2001 over the omni of 2002",
        (0.25, share, ""),
        0.01,
        "mean of max(cos θ, 0) over a sphere",
    )
}

/// Pressure at the left ear by Eq. 10 over that of all patches in step, face on and as far as the middle.
fn over_omni(transfers: &Transfers, hz: f64, motion: &[f32], rectified_area: f64) -> f64 {
    let [left, _] = transfers.raw(hz, motion);
    let [distance_m, _] = transfers.distances_m();
    let omni = coupling(rectified_area, hz);
    left[0].hypot(left[1]) * distance_m / (AIR_KG_M3 * SOUND_M_S * omni)
}

/// Equal patches along a spiral from pole to pole.
fn sphere_surface(radius_m: f64) -> Surface {
    const PATCHES: u16 = 4000;
    let golden = PI * (3.0 - 5f64.sqrt());
    let normals: Vec<[f64; 3]> = (0..PATCHES)
        .map(|i| {
            let z = 1.0 - (2.0 * f64::from(i) + 1.0) / f64::from(PATCHES);
            let (sin, cos) = (golden * f64::from(i)).sin_cos();
            let s = (1.0 - z * z).sqrt();
            [s * cos, s * sin, z]
        })
        .collect();
    Surface {
        points_m: normals.iter().map(|n| n.map(|x| radius_m * x)).collect(),
        areas_m2: vec![4.0 * PI * radius_m * radius_m / f64::from(PATCHES); normals.len()],
        normals,
        mouth_m: None,
    }
}

/// The chime's first modes: Eq. 10 never gives more than all patches in step and face on, which is
/// what the coefficient of 2002 stands for; direction and delay, and the halves of a mode that
/// silence each other, take the rest.
fn chime() -> Result<Vec<Row>, CheckError> {
    const MODES: usize = 4;
    let wall = Bell::open(CHIME).wall(0.006, LAYERS);
    let body = revolution_modes(wall, &aluminium(), Band::AUDIBLE, None)?;
    // Beside the middle of the tube, so that no symmetry silences a mode.
    let listener = Listener {
        ears_m: LISTENER.ears_m.map(|[x, y, z]| [x, y, z + 0.3]),
    };
    let transfers = Transfers::new(&body.surface, &listener);
    // Members a move towards the ears, members b past them.
    let modes = body
        .modes
        .iter()
        .filter(|mode| mode.label.member == Member::A);
    Ok(modes
        .take(MODES)
        .map(|mode| {
            let share = over_omni(&transfers, mode.hz, &mode.motion, mode.rectified_area);
            Row::within(
                format!(
                    "chime D3, {}: Eq. 10 of 2001 over the omni of 2002",
                    mode.label
                ),
                (0.0, 20.0 * share.log10(), "dB"),
                (share, 1.0),
                "O'Brien 2001, Eqs. 2, 5, 10; O'Brien 2002, §3.4",
            )
        })
        .collect())
}
