//! Rings and shells against the bending of thin walls.

use super::{CheckError, Row, aluminium};
use crate::fem::{Harmonic, Meridian};
use crate::revolution::LAYERS;
use crate::solve::lowest;
use std::f64::consts::{FRAC_PI_2, TAU};

/// Radius of the middle surface of the ring and the cylinder, in m.
const RADIUS_M: f64 = 0.1;

/// Waves around the axis that are compared.
const ORDERS: [usize; 4] = [2, 3, 4, 5];

pub(super) fn rows() -> Result<Vec<Row>, CheckError> {
    let mut rows = ring()?;
    rows.extend(cylinder()?);
    rows.extend(hemisphere()?);
    Ok(rows)
}

/// n(n² − 1)/√(n² + 1), which rings and cylinders share.
fn ring_factor(order: usize) -> f64 {
    let n = order as f64;
    n * (n * n - 1.0) / (n * n + 1.0).sqrt()
}

/// A square-cornered section of `across` (r) by `along` (z) about the circle of [`RADIUS_M`].
fn section([across_m, along_m]: [f64; 2], cells: [usize; 2]) -> Meridian {
    Meridian::new(
        cells,
        |_, _| true,
        |i, j| {
            let share = |step: usize, cells: usize| step as f64 / (2 * cells) as f64 - 0.5;
            let r_m = RADIUS_M + across_m * share(i, cells[0]);
            [r_m, along_m * share(j, cells[1])]
        },
    )
}

fn lowest_hz(meridian: &Meridian, order: usize) -> Result<f64, CheckError> {
    let pencil = Harmonic::new(meridian, &aluminium(), order)?.pencil;
    Ok(lowest(&pencil, 0)?)
}

/// Bending in the plane of a ring: ω² = EI/ρAR⁴ · n²(n² − 1)²/(n² + 1).
fn ring() -> Result<Vec<Row>, CheckError> {
    let (thick_m, wide_m) = (0.001, 0.003);
    let meridian = section([thick_m, wide_m], [LAYERS, 2]);
    let speed = (aluminium().young_pa() / aluminium().density_kg_m3 / 12.0).sqrt();
    let row = |order| {
        let expected = ring_factor(order) * speed * thick_m / (TAU * RADIUS_M.powi(2));
        Ok(Row::relative(
            format!("ring 1 mm thick of 0.1 m radius, ({order},0)"),
            (expected, lowest_hz(&meridian, order)?, "Hz"),
            2e-3,
            "thin ring (Hoppe 1871; Love 1927, §293)",
        ))
    };
    ORDERS.into_iter().map(row).collect()
}

/// Free cylinder, bent without being stretched and alike all along: the ring's formula with
/// E/(1 − ν²) for E.
fn cylinder() -> Result<Vec<Row>, CheckError> {
    let (wall_m, length_m) = (0.0005, 1.0);
    let meridian = section([wall_m, length_m], [LAYERS, 60]);
    let material = aluminium();
    let stiffness = material.young_pa() / (1.0 - material.poisson().powi(2));
    let speed = (stiffness / material.density_kg_m3 / 12.0).sqrt();
    let row = |order| {
        let expected = ring_factor(order) * speed * wall_m / (TAU * RADIUS_M.powi(2));
        Ok(Row::relative(
            format!("free cylinder 0.5 mm thick, 0.1 m radius, 1 m long, ({order},0)"),
            (expected, lowest_hz(&meridian, order)?, "Hz"),
            5e-3,
            "inextensional bending (Rayleigh 1894, §235)",
        ))
    };
    ORDERS.into_iter().map(row).collect()
}

/// Radius of the hemisphere's middle surface, in m: small, so that its modes are not far below a kilohertz.
const HEMISPHERE_M: f64 = 0.002;

/// Thickness of the hemisphere's wall, in radii, and four times that.
const HEMISPHERE_WALLS: [f64; 2] = [5e-4, 2e-3];

/// Rayleigh's hemisphere is the limit of a thin wall: at the rim, where no moment holds, a wall gives
/// way over a length √(R·wall), which takes as large a share off the frequency. From two walls, one
/// four times the other, that share is drawn to nothing.
fn hemisphere() -> Result<Vec<Row>, CheckError> {
    let walls_m = HEMISPHERE_WALLS.map(|wall| wall * HEMISPHERE_M);
    let meridians = walls_m.map(hemisphere_meridian);
    let row = |order| {
        let [thin, thick] = [0, 1].map(|i| lowest_hz(&meridians[i], order));
        let limit = 2.0 * thin? / walls_m[0] - thick? / walls_m[1];
        Ok(Row::relative(
            format!("free hemisphere of 2 mm radius, ({order},0), thin limit, per µm of wall"),
            (rayleigh_hemisphere_hz(order, 1e-6), 1e-6 * limit, "Hz"),
            5e-3,
            "inextensional bending (Rayleigh 1894, §235c)",
        ))
    };
    ORDERS.into_iter().map(row).collect()
}

/// Cells get shorter towards the rim.
fn hemisphere_meridian(wall_m: f64) -> Meridian {
    let cells = 200;
    Meridian::new(
        [cells, LAYERS],
        |_, _| true,
        |i, j| {
            let share = i as f64 / (2 * cells) as f64;
            let angle = FRAC_PI_2 * (1.0 - (1.0 - share).powi(2));
            let r_m = HEMISPHERE_M + wall_m * (0.5 - j as f64 / (2 * LAYERS) as f64);
            if i == 0 {
                return [0.0, -r_m];
            }
            [r_m * angle.sin(), -r_m * angle.cos()]
        },
    )
}

/// Rayleigh's frequency of a hemisphere bent without being stretched: sin θ tanⁿ(θ/2) along and
/// around, (n + cos θ) tanⁿ(θ/2) outwards; ω² = 2Gh²/3ρR⁴ · (n³ − n)² ∫tan²ⁿ(θ/2)/sin³θ dθ over
/// ∫tan²ⁿ(θ/2) (2 sin²θ + (n + cos θ)²) sin θ dθ, from the pole to the rim.
fn rayleigh_hemisphere_hz(order: usize, wall_m: f64) -> f64 {
    const STEPS: usize = 4000;
    let n = order as f64;
    let (mut bending, mut motion) = (0.0, 0.0);
    for i in 0..STEPS {
        let angle = FRAC_PI_2 * (i as f64 + 0.5) / STEPS as f64;
        let (sin, cos) = angle.sin_cos();
        let weight = (0.5 * angle).tan().powf(2.0 * n);
        bending += weight / sin.powi(3);
        motion += weight * (2.0 * sin * sin + (n + cos).powi(2)) * sin;
    }
    let material = aluminium();
    let speed = (2.0 * material.mu_pa / (3.0 * material.density_kg_m3)).sqrt();
    speed * wall_m * (n.powi(3) - n) * (bending / motion).sqrt() / (TAU * HEMISPHERE_M.powi(2))
}
