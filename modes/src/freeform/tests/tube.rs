//! A tube out of a file with both its walls, against the sector of a recipe's tube.

use super::made::{Folder, hz, recipe};
use super::{material, worst};
use crate::fem::CyclicTube;
use crate::mesh::TubeGrid;
use crate::shape::Tube;
use crate::solid::gallery::revolve;
use crate::solve::{Band, modes_in_band};

const TUBE: Tube = Tube {
    outer_radius_m: 0.02,
    wall_m: 0.01,
    length_m: 0.25,
};

/// By the solver of the factory's chimes, each as often as it occurs.
fn sector_hz() -> Vec<f64> {
    let grid = TubeGrid {
        around: 32,
        along: 40,
    };
    let sector = CyclicTube::new(&TUBE, grid, &material()).unwrap();
    let mut all = Vec::new();
    for m in 0..4 {
        let members = if m == 0 { 1 } else { 2 };
        for mode in modes_in_band(&sector.pencil(m), Band::AUDIBLE)
            .unwrap()
            .modes
        {
            all.extend(std::iter::repeat_n(mode.hz, members));
        }
    }
    all.sort_by(f64::total_cmp);
    all
}

#[test]
fn a_tube_out_of_a_file_has_the_modes_of_a_recipe_s() {
    let [outer_m, inner_m] = [TUBE.outer_radius_m, TUBE.inner_radius_m()];
    let outline = [
        [inner_m, 0.0],
        [outer_m, 0.0],
        [outer_m, TUBE.length_m],
        [inner_m, TUBE.length_m],
    ];
    let folder = Folder::with("tube", &revolve(&outline, 96));
    let expected = sector_hz();
    let at = |nodes| worst(&hz(&recipe(&folder.0, "", nodes)), &expected, 10);
    let (coarse, fine) = (at(8_000), at(20_000));
    println!("tube from a file: {coarse:.2e}, {fine:.2e}");
    assert!(coarse < 0.01 && fine < 0.003, "{coarse} {fine}");
}
