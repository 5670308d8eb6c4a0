//! A solid cylinder against quadrilaterals of its meridian, harmonic by harmonic.

use super::{material, modes_hz, worst};
use crate::fem::{Harmonic, Meridian};
use crate::mesh::cylinder_tet10;
use crate::solve::{Band, modes_in_band};

const RADIUS_M: f64 = 0.02;
const LENGTH_M: f64 = 0.1;
const HIGHEST_HZ: f64 = 50e3;

/// Each as often as it occurs.
fn meridian_hz() -> Vec<f64> {
    let cells = [4, 20];
    let place = |i: usize, j: usize| {
        let along = j as f64 / (2 * cells[1]) as f64;
        [
            RADIUS_M * i as f64 / (2 * cells[0]) as f64,
            LENGTH_M * along,
        ]
    };
    let meridian = Meridian::new(cells, |_, _| true, place);
    let band = Band {
        low_hz: 20.0,
        high_hz: HIGHEST_HZ,
    };
    let mut all = Vec::new();
    for m in 0..8 {
        let pencil = Harmonic::new(&meridian, &material(), m).unwrap().pencil;
        let members = if m == 0 { 1 } else { 2 };
        for mode in modes_in_band(&pencil, band).unwrap().modes {
            all.extend(std::iter::repeat_n(mode.hz, members));
        }
    }
    all.sort_by(f64::total_cmp);
    all
}

#[test]
fn a_solid_cylinder_has_its_modes() {
    let expected = meridian_hz();
    let shear = (material().mu_pa / material().density_kg_m3).sqrt();
    let twist = shear / (2.0 * LENGTH_M);
    let nearest = expected.iter().map(|hz| (hz / twist - 1.0).abs());
    assert!(nearest.fold(f64::INFINITY, f64::min) < 1e-6);
    let mesh = |cells| cylinder_tet10([RADIUS_M, LENGTH_M], cells);
    let coarse = worst(&modes_hz(&mesh([1, 1, 6]), HIGHEST_HZ), &expected, 10);
    let fine = worst(&modes_hz(&mesh([2, 1, 8]), HIGHEST_HZ), &expected, 10);
    println!("cylinder: {coarse:.2e}, {fine:.2e}");
    assert!(coarse < 0.01 && fine < 0.003, "{coarse} {fine}");
}
