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
/// wall of the 0.505 m chime gives way from its fifth mode on, on any mesh; that of a tube twice as
/// long, or of a wall six times as thick, does not.
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

/// A beam's section stays as it is: to this fraction.
const BEAM: f64 = 1e-3;

/// What a thin wall may take off a beam's frequency before something else must be wrong.
const THIN_WALL: f64 = 2.5e-3;

pub(super) fn rows() -> Result<Vec<Row>, CheckError> {
    let mut rows = Vec::new();
    for (name, tube, beam_like) in TUBES {
        let theory = TimoshenkoBeam::from_tube(&tube, &aluminium()).free_free_hz(6);
        let pencil = CyclicTube::new(&tube, FINE.grid(&tube), &aluminium())?.pencil(1);
        for (index, hz) in theory.into_iter().enumerate() {
            let (note, bound) = if index < beam_like {
                ("", BEAM)
            } else {
                (", where the wall gives way", THIN_WALL)
            };
            rows.push(Row::relative(
                format!("{name}, bending {}{note}", index + 1),
                (hz, lowest(&pencil, index)?, "Hz"),
                bound,
                "Timoshenko beam, shear coefficient of Hutchinson 2001",
            ));
        }
    }
    Ok(rows)
}
