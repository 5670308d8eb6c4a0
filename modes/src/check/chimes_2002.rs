//! Table 2 of O'Brien 2002: six real chimes and the paper's models of them.

use super::{CHIME, CheckError, Row, SHIPPED, aluminium};
use crate::TABLE_2;
use crate::fem::CyclicTube;
use crate::revolution::Bell;
use crate::shape::Tube;
use crate::solve::lowest;
use crate::tube::{Fineness, TubeTuning, tune_tube};

/// The paper's own agreement of computed and measured frequencies (§4).
const PAPER: f64 = 0.02;

pub(super) fn rows() -> Result<Vec<Row>, CheckError> {
    let mut rows = Vec::new();
    for chime in &TABLE_2 {
        let hz = fundamental_hz(chime.measured_length_m, SHIPPED)?;
        let name = |what: &str| {
            format!(
                "chime {}, {} m, {what}",
                chime.note, chime.measured_length_m
            )
        };
        rows.push(Row::relative(
            name("beside the measured"),
            (chime.measured_hz, hz, "Hz"),
            PAPER,
            "O'Brien 2002, Table 2",
        ));
        rows.push(Row::relative(
            name("beside the paper's computed"),
            (chime.computed_hz, hz, "Hz"),
            PAPER,
            "O'Brien 2002, Table 2",
        ));
        let tuning = TubeTuning {
            pitch_hz: chime.adjusted_hz,
            partial: 1,
            tolerance_cents: 0.01,
        };
        let tube = tune_tube(
            &Bell::open(CHIME),
            &aluminium(),
            SHIPPED.max_element_m,
            &tuning,
        )?
        .tube;
        rows.push(Row::relative(
            format!("chime {}, length for {} Hz", chime.note, chime.adjusted_hz),
            (chime.adjusted_length_m, tube.length_m, "m"),
            PAPER / 2.0,
            "O'Brien 2002, Table 2, adjusted",
        ));
    }
    let finer = Fineness {
        around: 2 * SHIPPED.around,
        max_element_m: 0.5 * SHIPPED.max_element_m,
    };
    rows.push(Row::relative(
        "chime D3, 0.505 m, beside a mesh twice as fine",
        (
            fundamental_hz(CHIME.length_m, finer)?,
            fundamental_hz(CHIME.length_m, SHIPPED)?,
            "Hz",
        ),
        1e-6,
        "converged value of the same element",
    ));
    Ok(rows)
}

fn fundamental_hz(length_m: f64, fineness: Fineness) -> Result<f64, CheckError> {
    let tube = Tube { length_m, ..CHIME };
    let sector = CyclicTube::new(&tube, fineness.grid(&tube), &aluminium())?;
    Ok(lowest(&sector.pencil(1), 0)?)
}
