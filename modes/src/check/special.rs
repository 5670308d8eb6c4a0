//! Symmetry and harmonics against the whole body on the general sparse path.

use super::{CHIME, CheckError, Row, aluminium, bowl_wall, cents, factory, greater};
use crate::Material;
use crate::fem::{Meridian, TetMass, assemble};
use crate::mesh::revolve_hex20;
use crate::revolution::{Bell, LAYERS, SolvedWall, Wall, bell};
use crate::shape::Tube;
use crate::solve::{Band, modes_in_band};

/// Modes that are compared.
const MODES: usize = 20;

/// Radius in m of a hole along the axis, without which hexahedra would meet in it.
const HOLE_M: f64 = 0.001;

/// Cells of the bowl here, in lengths of the recipe's: both paths take the same.
const BOWL_COARSER: f64 = 1.2;

pub(super) fn rows() -> Result<Vec<Row>, CheckError> {
    let bells = factory("tubular-bells")?;
    let bowls = factory("singing-bowls")?;
    let tube = Tube {
        outer_radius_m: 0.016,
        wall_m: 0.0015,
        length_m: 0.6,
    };
    let plugged = Bell {
        plug_m: 0.016,
        ..Bell::open(tube)
    };
    let mut rows = vec![row(
        "0.505 m chime by harmonics",
        &bell(&Bell::open(CHIME), [0, 60], LAYERS),
        (&aluminium(), 24),
        10_000.0,
    )?];
    rows.push(row(
        "0.6 m bell with plug by harmonics",
        &pierced(&bell(&plugged, [2, 48], LAYERS)),
        (&bells.material, 26),
        7_500.0,
    )?);
    rows.push(row(
        "singing bowl by harmonics",
        &pierced(&bowl_wall(&bowls, BOWL_COARSER)?),
        (&bowls.material, 44),
        7_000.0,
    )?);
    Ok(rows)
}

/// `wall` with what is nearest the axis drawn away from it.
fn pierced(wall: &Wall) -> Wall {
    let mut wall = wall.clone();
    let reach_m = wall.meridian.nodes_m.iter().map(|node| node[0]);
    let reach_m = reach_m.fold(0.0, f64::max);
    for node in &mut wall.meridian.nodes_m {
        node[0] = HOLE_M + node[0] * (reach_m - HOLE_M) / reach_m;
    }
    wall
}

fn row(
    name: &str,
    wall: &Wall,
    (material, around): (&Material, usize),
    high_hz: f64,
) -> Result<Row, CheckError> {
    let band = Band {
        high_hz,
        ..Band::AUDIBLE
    };
    let judge = whole_hz(&wall.meridian, material, around, band)?;
    let body = SolvedWall::new(wall.clone(), material, band)?.body(None);
    let pairs = body.modes.iter().zip(&judge).take(MODES);
    let worst = pairs.clone().fold(0.0, |worst, (mode, &judge)| {
        greater(worst, cents(mode.hz, judge))
    });
    Ok(Row::absolute(
        format!("{name}, first {} modes: greatest difference", pairs.len()),
        (0.0, worst, "cents"),
        1.0,
        "the same body whole, general sparse path",
    ))
}

fn whole_hz(
    meridian: &Meridian,
    material: &Material,
    around: usize,
    band: Band,
) -> Result<Vec<f64>, CheckError> {
    let mesh = revolve_hex20(meridian, around);
    let pencil = assemble(&mesh, material, TetMass::Consistent)?;
    let solution = modes_in_band(&pencil, band)?;
    Ok(solution.modes.iter().map(|mode| mode.hz).collect())
}
