//! Tubes given as OBJ meshes, through the whole path from a file's text to modes, against the tubes of recipes.

use super::{CHIME, CheckError, Row, SHIPPED, aluminium};
use crate::Material;
use crate::factory::Silent;
use crate::fem::{CyclicTube, Harmonic, Meridian, Pencil};
use crate::freeform::{Limits, free_body};
use crate::shape::Tube;
use crate::solid::gallery::{cylinder, revolve};
use crate::solid::{Meshing, Repair, Resolution, Soup, mesh_solid, parse_obj, repair, write_obj};
use crate::solve::{Band, modes_in_band};

/// Elastic modes that are compared, each as often as it occurs.
const MODES: usize = 10;

/// Frequencies are compared up to this, in Hz: it is above the tenth of each tube here.
const HIGHEST_HZ: f64 = 7_500.0;

/// Triangles' sides around a tube: the polygon's radius is 0.1 % off the circle's at most.
const AROUND: usize = 72;

/// Harmonics around the axis with modes among the compared, and more.
const HARMONICS: std::ops::Range<usize> = 0..4;

/// Cells of a closed tube's meridian: across its ends, through its wall, along its side.
const CELLS: [usize; 3] = [4, 1, 100];

/// A tube that fills its section as chimes do not.
const THICK: Tube = Tube {
    wall_m: 0.006,
    ..CHIME
};

/// A tube as long and thin as wind chimes are.
const LONG: Tube = Tube {
    outer_radius_m: 0.019,
    wall_m: 0.001,
    length_m: 1.0,
};

/// A tube to be closed, of a wall that is much thinner than the elements are wide: in the last of the compared modes its
/// sections give way.
const THIN: Tube = CHIME;

/// Nodes of full quality.
const NODES: usize = 20_000;

/// What the thick, the long and the closed tube out of files may be off the recipes': the first shows its 72 sides, the
/// others how far a thin wall of wedges is from bending freely.
const BOUNDS: [f64; 3] = [0.001, 0.003, 0.002];

pub(super) fn rows() -> Result<Vec<Row>, CheckError> {
    let material = aluminium();
    let both_walls = compared(&annulus(&THICK), None, &recipe_hz(&THICK, &material)?)?;
    let long = compared(&annulus(&LONG), None, &recipe_hz(&LONG, &material)?)?;
    let outside = cylinder(THIN.outer_radius_m, THIN.length_m, AROUND);
    let outside = compared(&outside, Some(THIN.wall_m), &closed_hz(&THIN, &material)?)?;
    let [thick, thin, closed] = BOUNDS;
    let named = |name: &'static str, source, bound, pairs: Vec<[f64; 2]>| {
        pairs.into_iter().enumerate().map(move |(i, [exact, hz])| {
            let name = format!("{name}, elastic mode {}", i + 1);
            Row::relative(name, (exact, hz, "Hz"), bound, source)
        })
    };
    Ok(named(
        "0.505 m tube of 6 mm wall out of an OBJ file with both walls",
        "one sector of the tube, 20-node hexahedra, as the factory's chimes",
        thick,
        both_walls,
    )
    .chain(named(
        "1 m tube of 1 mm wall, 38 mm wide, out of an OBJ file with both walls",
        "one sector of the tube, 20-node hexahedra, as the factory's chimes",
        thin,
        long,
    ))
    .chain(named(
        "0.505 m tube of 1 mm wall with closed ends out of an OBJ file of its outside",
        "the same by harmonics, 8-node quadrilaterals of its meridian",
        closed,
        outside,
    ))
    .collect())
}

/// The tube's outer and inner wall and the rings at its ends.
fn annulus(tube: &Tube) -> Soup {
    let [outer_m, inner_m] = [tube.outer_radius_m, tube.inner_radius_m()];
    let outline = [
        [inner_m, 0.0],
        [outer_m, 0.0],
        [outer_m, tube.length_m],
        [inner_m, tube.length_m],
    ];
    revolve(&outline, AROUND)
}

/// Frequencies in Hz of the tube that a recipe would build, by the solver of the factory's chimes.
fn recipe_hz(tube: &Tube, material: &Material) -> Result<Vec<f64>, CheckError> {
    let sector = CyclicTube::new(tube, SHIPPED.grid(tube), material)?;
    by_harmonics(HARMONICS.map(|m| (m, sector.pencil(m))))
}

/// Frequencies in Hz of a tube closed at both ends by plates as thick as its wall.
fn closed_hz(tube: &Tube, material: &Material) -> Result<Vec<f64>, CheckError> {
    let [ends, through, along] = CELLS;
    let wall = (through, tube.wall_m);
    let r_m = half_steps(&[(ends, tube.inner_radius_m()), wall]);
    let z_m = half_steps(&[wall, (along, tube.length_m - 2.0 * tube.wall_m), wall]);
    let meridian = Meridian::new(
        [ends + through, 2 * through + along],
        |i, j| i >= ends || !(through..through + along).contains(&j),
        |i, j| [r_m[i], z_m[j]],
    );
    let pencils = HARMONICS.map(|m| Ok((m, Harmonic::new(&meridian, material, m)?.pencil)));
    let pencils: Result<Vec<_>, CheckError> = pencils.collect();
    by_harmonics(pencils?.into_iter())
}

/// Places in m of the half steps of cells: so many to each length in m, one after the other.
fn half_steps(lengths_m: &[(usize, f64)]) -> Vec<f64> {
    let mut places_m = vec![0.0];
    for &(cells, length_m) in lengths_m {
        let from_m = places_m[places_m.len() - 1];
        let step_m = length_m / (2 * cells) as f64;
        places_m.extend((1..=2 * cells).map(|step| from_m + step as f64 * step_m));
    }
    places_m
}

/// Frequencies in Hz of all `pencils` by harmonic, each as often as it occurs.
fn by_harmonics(pencils: impl Iterator<Item = (usize, Pencil)>) -> Result<Vec<f64>, CheckError> {
    let band = Band {
        high_hz: HIGHEST_HZ,
        ..Band::AUDIBLE
    };
    let mut all = Vec::new();
    for (m, pencil) in pencils {
        let members = if m == 0 { 1 } else { 2 };
        for mode in modes_in_band(&pencil, band)?.modes {
            all.extend(std::iter::repeat_n(mode.hz, members));
        }
    }
    all.sort_by(f64::total_cmp);
    Ok(all)
}

/// The first frequencies in Hz that are `expected`, and those of `soup` written as an OBJ file, read again, repaired,
/// filled or walled and solved.
fn compared(
    soup: &Soup,
    wall_m: Option<f64>,
    expected: &[f64],
) -> Result<Vec<[f64; 2]>, CheckError> {
    let file = parse_obj(write_obj(soup).as_bytes(), "tube.obj", None)
        .expect("what is written can be read");
    let surface = repair(&file.soup, &Repair::default())?;
    let meshing = Meshing {
        wall_m,
        resolution: Resolution::Nodes(NODES),
        ..Meshing::default()
    };
    let meshed = mesh_solid(&surface, &meshing, &Silent)?;
    let limits = Limits {
        highest_hz: HIGHEST_HZ,
        most: 4 * MODES,
        tuned: None,
    };
    let body = free_body(&meshed.mesh, &aluminium(), limits, &())?;
    let found: Vec<f64> = body.solved.modes.iter().map(|mode| mode.hz).collect();
    // One that is missing is out of bounds.
    let nth = |hz: &[f64], i: usize| hz.get(i).copied().unwrap_or(f64::NAN);
    let pairs = (0..MODES).map(|i| [nth(expected, i), nth(&found, i)]);
    Ok(pairs.collect())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn tubes_out_of_files_have_the_modes_of_recipes() {
        let rows = rows().unwrap();
        assert_eq!(rows.len(), 3 * MODES);
        for row in &rows {
            println!("{}: {:.2} Hz, {:.1e}", row.name, row.value, row.error);
        }
        let wrong = rows.iter().find(|row| !row.ok);
        assert!(wrong.is_none(), "{wrong:?}");
    }
}
