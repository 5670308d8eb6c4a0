//! Every audible mode of a bar, as a body that can be struck.

use super::BarFineness;
use super::air::{radiation_per_s, rise_across};
use super::quarter::{Class, Face, Quarter};
use crate::radiation::Surface;
use crate::shape::Bar;
use crate::solve::{Band, Eigenmode, lowest_of, modes_in_band};
use crate::{Family, Material, Member, ModeLabel, SolveError, SolvedBody, SolvedMode, StrikeLine};
use rayon::prelude::*;

/// Samples of the strike line to each half-wave of the mode that has most of them.
const SAMPLES_TO_HALF_WAVE: usize = 5;

/// Fewest samples of the strike line.
const FEWEST_SAMPLES: usize = 33;

/// How far to the side of the middle line a bar is struck, in widths: on the line itself, where no
/// player keeps to, twist would be mute.
const STRUCK_ASIDE: f64 = 0.1;

/// How far to the side the cord's holes are drilled, in widths: it runs through each node line and
/// comes out on both sides.
const CORD_ASIDE: f64 = 0.35;

/// Where the felt presses from below: distance from the middle in lengths, and on both sides of it
/// in widths.
const FELT: [f64; 2] = [0.45, 0.25];

/// Node of a uniform bar's fundamental, in lengths from the middle (Blevins 1979, table 8-1): where
/// the cord runs if the fundamental is not in the band.
const UNIFORM_NODE: f64 = 0.5 - 0.2242;

/// What a bar is tuned by.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BarPartials {
    /// The first three bending modes, in Hz.
    pub bending_hz: [f64; 3],
    /// The first torsion mode, in Hz.
    pub torsion_hz: f64,
}

impl BarPartials {
    /// Second and third bending modes as multiples of the first.
    #[must_use]
    pub fn ratios(&self) -> [f64; 2] {
        [1, 2].map(|i| self.bending_hz[i] / self.bending_hz[0])
    }

    /// First torsion mode as a multiple of the fundamental.
    #[must_use]
    pub fn torsion_ratio(&self) -> f64 {
        self.torsion_hz / self.bending_hz[0]
    }

    /// From the second and the third bending mode up to the first torsion mode, in cents: makers
    /// keep it clear of both (La Favre, for marimbas).
    #[must_use]
    pub fn torsion_clearance_cents(&self) -> [f64; 2] {
        [1, 2].map(|i| 1200.0 * (self.torsion_hz / self.bending_hz[i]).log2())
    }
}

/// The partials that a bar is tuned by, without the rest.
///
/// # Errors
///
/// As [`lowest_of`].
pub fn bar_partials(
    bar: &Bar,
    material: &Material,
    fineness: BarFineness,
) -> Result<BarPartials, SolveError> {
    let quarter = Quarter::new(bar, fineness.grid(bar), material)?;
    Ok(BarPartials {
        bending_hz: bending_hz(&quarter)?,
        torsion_hz: lowest_of(&quarter.pencil(Class::BOTH_ODD).pencil, 1)?[0],
    })
}

/// The first three bending modes, in Hz: even, odd, even about the middle.
pub(super) fn bending_hz(quarter: &Quarter) -> Result<[f64; 3], SolveError> {
    let (even, odd) = rayon::join(
        || lowest_of(&quarter.pencil(Class::EVEN).pencil, 2),
        || lowest_of(&quarter.pencil(Class::X_ODD).pencil, 1),
    );
    let (even, odd) = (even?, odd?);
    Ok([even[0], odd[0], even[1]])
}

/// One solution, on all unknowns of the quarter and normalised to the mass of the whole bar.
struct Found {
    class: Class,
    mode: Eigenmode,
    family: Family,
}

/// Solves `bar` for every mode of `band`: four quarter models, one for each symmetry.
///
/// The strike line runs over the top from end to end, a tenth of the width beside the middle.
///
/// # Errors
///
/// As [`modes_in_band`].
pub fn bar_modes(
    bar: &Bar,
    material: &Material,
    fineness: BarFineness,
    band: Band,
) -> Result<SolvedBody, SolveError> {
    let grid = fineness.grid(bar);
    let quarter = Quarter::new(bar, grid, material)?;
    let (mut found, mut orthonormality) = (Vec::new(), 0.0f64);
    let solve = |class| {
        let constrained = quarter.pencil(class);
        let solution = modes_in_band(&constrained.pencil, band);
        (class, constrained, solution)
    };
    let solutions: Vec<_> = Class::ALL.into_par_iter().map(solve).collect();
    for (class, constrained, solution) in solutions {
        let solution = solution?;
        orthonormality = orthonormality.max(solution.orthonormality);
        for mut mode in solution.modes {
            mode.vector = constrained.expand(&mode.vector);
            // The whole bar has four times the quarter's mass.
            for u in &mut mode.vector {
                *u *= 0.5;
            }
            found.push(Found {
                class,
                family: family(&quarter, bar, class, &mode.vector, grid.along),
                mode,
            });
        }
    }
    found.sort_by(|p, q| p.mode.hz.total_cmp(&q.mode.hz));
    let half_waves = found
        .iter()
        .map(|f| half_waves(&quarter, bar, f, grid.along));
    let samples = SAMPLES_TO_HALF_WAVE * half_waves.max().unwrap_or(1) + 1;
    let samples = samples.max(FEWEST_SAMPLES);
    let cord_m = node_m(&quarter, bar, &found);
    let faces = quarter.faces();
    let surface = surface(&faces);
    let modes = (0..found.len()).map(|i| {
        let Found {
            class,
            mode,
            family,
        } = &found[i];
        let index = found[..=i].iter().filter(|f| f.family == *family).count();
        let index = u16::try_from(index).unwrap_or(u16::MAX);
        let energy_at = |x_m: f64, y_m: f64, height: f64| {
            let u = quarter.at(&mode.vector, x_m, y_m, height);
            u.iter().map(|u| u * u).sum::<f64>()
        };
        let motion = motion(&quarter, &faces, *class, &mode.vector);
        SolvedMode {
            hz: mode.hz,
            residual: mode.residual,
            label: ModeLabel {
                family: *family,
                order: 0,
                index,
                member: Member::Single,
            },
            shape: along_line(&quarter, bar, &mode.vector, samples),
            rectified_area: surface.rectified_area(&motion),
            motion,
            held: 4.0 * energy_at(cord_m, CORD_ASIDE * bar.width_m, 0.5),
            felt: 2.0 * energy_at(FELT[0] * bar.length_m, FELT[1] * bar.width_m, 0.0),
            radiation_per_s: radiation_per_s(
                &quarter,
                bar,
                (*class, *family),
                mode.hz,
                &mode.vector,
            ),
        }
    });
    Ok(SolvedBody {
        modes: modes.collect(),
        length_m: bar.length_m,
        mass_kg: quarter.mass_kg(),
        line: strike_line(bar, samples),
        surface,
        orthonormality,
    })
}

/// The kind of motion that carries most of the energy.
fn family(quarter: &Quarter, bar: &Bar, class: Class, vector: &[f64], along: usize) -> Family {
    let [x, y, z] = quarter.energies(vector);
    if class.y_odd {
        return if y > z {
            Family::Lateral
        } else {
            Family::Torsion
        };
    }
    if x > y && x > z {
        return Family::Longitudinal;
    }
    // A beam's sections move as one; those of a plate bend across.
    let (mut together, mut all) = (0.0, 0.0);
    for i in 0..=2 * along {
        let x_m = 0.5 * bar.length_m * i as f64 / (2 * along) as f64;
        let rises = rise_across(quarter, bar, vector, x_m);
        together += rises.iter().sum::<f64>().powi(2) / rises.len() as f64;
        all += rises.iter().map(|u| u * u).sum::<f64>();
    }
    if z > y && together > 0.5 * all {
        Family::Bending
    } else {
        Family::Other
    }
}

/// Half-waves of the largest component along the strike line.
fn half_waves(quarter: &Quarter, bar: &Bar, found: &Found, along: usize) -> usize {
    let line: Vec<[f64; 3]> = (0..=2 * along)
        .map(|i| {
            let x_m = 0.5 * bar.length_m * i as f64 / (2 * along) as f64;
            quarter.at(&found.mode.vector, x_m, STRUCK_ASIDE * bar.width_m, 1.0)
        })
        .collect();
    let energy = |axis: usize| line.iter().map(|u| u[axis] * u[axis]).sum::<f64>();
    let axis = (0..3)
        .max_by(|&a, &b| energy(a).total_cmp(&energy(b)))
        .unwrap_or(2);
    let changes = line
        .windows(2)
        .filter(|pair| pair[0][axis] * pair[1][axis] < 0.0);
    let middle = usize::from(found.class.mirrored(0)[axis] < 0.0);
    1 + 2 * changes.count() + middle
}

/// Where the fundamental's rise vanishes half-way up the bar, in m from the middle.
fn node_m(quarter: &Quarter, bar: &Bar, found: &[Found]) -> f64 {
    let fundamental = found
        .iter()
        .find(|f| f.class == Class::EVEN && f.family == Family::Bending);
    let Some(fundamental) = fundamental else {
        return UNIFORM_NODE * bar.length_m;
    };
    let rise = |x_m: f64| quarter.at(&fundamental.mode.vector, x_m, 0.0, 0.5)[2];
    let (mut inside, mut outside) = (0.0, 0.5 * bar.length_m);
    let sign = rise(inside).is_sign_positive();
    for _ in 0..50 {
        let middle = 0.5 * (inside + outside);
        if rise(middle).is_sign_positive() == sign {
            inside = middle;
        } else {
            outside = middle;
        }
    }
    0.5 * (inside + outside)
}

/// Distance of sample `i` of the strike line from the middle, in m.
fn sample_m(bar: &Bar, i: usize, samples: usize) -> f64 {
    0.5 * bar.length_m * i as f64 / (samples - 1) as f64
}

/// φ at each sample.
fn along_line(quarter: &Quarter, bar: &Bar, vector: &[f64], samples: usize) -> Vec<[f32; 3]> {
    (0..samples)
        .map(|i| {
            let x_m = sample_m(bar, i, samples);
            let u = quarter.at(vector, x_m, STRUCK_ASIDE * bar.width_m, 1.0);
            // Adding 0 turns −0 to 0.
            u.map(|u| u as f32 + 0.0)
        })
        .collect()
}

/// Points and normals of the top, from the middle, where bars are struck, to an end.
fn strike_line(bar: &Bar, samples: usize) -> StrikeLine {
    StrikeLine::single(
        (0..samples)
            .map(|i| [sample_m(bar, i, samples), STRUCK_ASIDE * bar.width_m, 0.0])
            .collect(),
        vec![[0.0, 0.0, 1.0]; samples],
    )
}

/// Signs of x and y in the four quarters.
const QUARTERS: [[f64; 2]; 4] = [[1.0, 1.0], [-1.0, 1.0], [1.0, -1.0], [-1.0, -1.0]];

/// The patches of all four quarters, one after the other.
fn surface(faces: &[Face]) -> Surface {
    let place = |[x, y, z]: [f64; 3], [sx, sy]: [f64; 2]| [sx * x, sy * y, z];
    let mut surface = Surface::default();
    for signs in QUARTERS {
        for face in faces {
            surface.points_m.push(place(face.middle_m, signs));
            surface.normals.push(place(face.normal, signs));
            surface.areas_m2.push(face.area_m2);
        }
    }
    surface
}

/// φ·n on the patches: the same in each quarter but for the sign.
fn motion(quarter: &Quarter, faces: &[Face], class: Class, vector: &[f64]) -> Vec<f32> {
    let motion: Vec<f32> = faces
        .iter()
        .map(|face| quarter.normal_motion(face, vector) as f32)
        .collect();
    QUARTERS
        .iter()
        .flat_map(|[sx, sy]| {
            let flips = (class.x_odd && *sx < 0.0) != (class.y_odd && *sy < 0.0);
            motion.iter().map(move |u| if flips { -u } else { *u })
        })
        .collect()
}
