//! Convergence of the elements, and the reduced sector against the whole mesh.

use super::{CHIME, CheckError, Row, SHIPPED, aluminium};
use crate::fem::{CyclicTube, TetMass, assemble};
use crate::mesh::{TubeGrid, tube_hex20, tube_tet4, tube_tet10};
use crate::shape::Tube;
use crate::solve::{Band, count_below, lowest, modes_in_band};

/// A short thick tube: its mesh can be refined in all directions within seconds.
const THICK: Tube = Tube {
    outer_radius_m: 0.02,
    wall_m: 0.01,
    length_m: 0.2,
};

pub(super) fn rows() -> Result<Vec<Row>, CheckError> {
    let mut rows = vec![hex_order()?, tet_order()?];
    rows.extend(tet10()?);
    rows.extend(sector()?);
    Ok(rows)
}

/// Order p of an error h^p from values on meshes of sizes h, h/2, h/4.
fn order([coarse, middle, fine]: [f64; 3]) -> f64 {
    ((coarse - middle) / (middle - fine)).abs().log2()
}

fn hex_order() -> Result<Row, CheckError> {
    let hz = |n: usize| -> Result<f64, CheckError> {
        let grid = TubeGrid {
            around: 4 * n,
            along: 2 * n,
        };
        Ok(lowest(
            &CyclicTube::new(&CHIME, grid, &aluminium())?.pencil(1),
            1,
        )?)
    };
    Ok(Row::absolute(
        "20-node hexahedra, order of the error of bending 2",
        (4.0, order([hz(6)?, hz(12)?, hz(24)?]), ""),
        0.1,
        "h^2p for elements of degree p = 2 (Strang & Fix 1973)",
    ))
}

fn tet_order() -> Result<Row, CheckError> {
    let hz = |n: usize| -> Result<f64, CheckError> {
        let grid = TubeGrid {
            around: 8 * n,
            along: 8 * n,
        };
        let mesh = tube_tet4(&THICK, grid, n);
        let pencil = assemble(&mesh, &aluminium(), TetMass::Consistent)?;
        Ok(lowest(&pencil, 0)?)
    };
    Ok(Row::absolute(
        "linear tetrahedra, order of the error of bending 1",
        (2.0, order([hz(1)?, hz(2)?, hz(4)?]), ""),
        0.2,
        "h^2p for elements of degree p = 1 (Strang & Fix 1973)",
    ))
}

/// One layer through the wall carries the strain of bending, which is linear across it.
fn tet10() -> Result<[Row; 2], CheckError> {
    let hz = |n: usize| -> Result<f64, CheckError> {
        let grid = TubeGrid {
            around: 6 * n,
            along: 12 * n,
        };
        let mesh = tube_tet10(&CHIME, grid, 1);
        let pencil = assemble(&mesh, &aluminium(), TetMass::Consistent)?;
        Ok(lowest(&pencil, 0)?)
    };
    let hz = [hz(1)?, hz(2)?, hz(4)?];
    let converged = CyclicTube::new(&CHIME, SHIPPED.grid(&CHIME), &aluminium())?;
    Ok([
        Row::absolute(
            "10-node tetrahedra, order of the error of bending 1",
            (4.0, order(hz), ""),
            0.2,
            "h^2p for elements of degree p = 2 (Strang & Fix 1973)",
        ),
        Row::relative(
            "0.505 m chime in 3,528 nodes of 10-node tetrahedra: fundamental",
            (lowest(&converged.pencil(1), 0)?, hz[1], "Hz"),
            1e-3,
            "20-node hexahedra, converged",
        ),
    ])
}

fn sector() -> Result<Vec<Row>, CheckError> {
    let grid = TubeGrid {
        around: 12,
        along: 16,
    };
    let whole = assemble(&tube_hex20(&CHIME, grid), &aluminium(), TetMass::Consistent)?;
    let judge = modes_in_band(&whole, Band::AUDIBLE)?;
    let sector = CyclicTube::new(&CHIME, grid, &aluminium())?;
    let (mut hz, mut counted) = (Vec::new(), 0);
    for m in sector.harmonics() {
        let pencil = sector.pencil(m);
        let members = if m == 0 { 1 } else { 2 };
        counted += members * count_below(&pencil, Band::AUDIBLE.high_hz);
        for mode in modes_in_band(&pencil, Band::AUDIBLE)?.modes {
            hz.extend(std::iter::repeat_n(mode.hz, members));
        }
    }
    hz.sort_by(f64::total_cmp);
    let pairs = hz.iter().zip(&judge.modes);
    let cents = pairs.fold(0.0, |worst: f64, (hz, mode)| {
        let cents = 1200.0 * (hz / mode.hz).log2().abs();
        if cents <= worst { worst } else { cents }
    });
    let source = "the same mesh whole, general sparse path";
    Ok(vec![
        Row::absolute(
            "one sector, 12 × 16 cells: eigenvalues below 20 kHz by inertia",
            (judge.counted as f64, counted as f64, ""),
            0.0,
            source,
        ),
        Row::absolute(
            "one sector, 12 × 16 cells: modes found",
            (judge.modes.len() as f64, hz.len() as f64, ""),
            0.0,
            source,
        ),
        Row::absolute(
            "one sector, 12 × 16 cells: greatest difference of a mode",
            (0.0, cents, "cents"),
            1e-5,
            source,
        ),
    ])
}
