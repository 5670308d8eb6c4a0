//! Finite elements against the Timoshenko beam.

use super::{CHIME, CheckError, Row, aluminium};
use crate::analytic::TimoshenkoBeam;
use crate::fem::CyclicTube;
use crate::shape::Tube;
use crate::solve::lowest;
use crate::tube::Fineness;

/// Finer than what ships, so that what is left is theory's share.
const FINE: Fineness = Fineness {
    around: 48,
    max_element_m: 0.004,
};

/// Tubes, and how many of their bending modes keep their sections round enough to be a beam's: the
/// wall of the 0.505 m chime gives way from its fifth mode on (0.13 %, then 0.23 % below the beam on
/// any mesh), that of a tube twice as long, or of a wall six times as thick, does not.
const TUBES: [(&str, Tube, usize); 3] = [
    ("0.505 m chime", CHIME, 4),
    (
        "chime of twice the length",
        Tube {
            length_m: 1.01,
            ..CHIME
        },
        6,
    ),
    (
        "0.505 m tube of 6 mm wall",
        Tube {
            wall_m: 0.006,
            ..CHIME
        },
        6,
    ),
];

pub(super) fn rows() -> Result<Vec<Row>, CheckError> {
    let mut rows = Vec::new();
    for (name, tube, count) in TUBES {
        let theory = TimoshenkoBeam::from_tube(&tube, &aluminium()).free_free_hz(count);
        let pencil = CyclicTube::new(&tube, FINE.grid(&tube), &aluminium())?.pencil(1);
        for (index, hz) in theory.into_iter().enumerate() {
            rows.push(Row::relative(
                format!("{name}, bending {}", index + 1),
                (hz, lowest(&pencil, index)?, "Hz"),
                1e-3,
                "Timoshenko beam, shear coefficient of Hutchinson 2001",
            ));
        }
    }
    Ok(rows)
}
