//! Every mode of a body of revolution, harmonic by harmonic, before anything tells its pairs apart.

use super::Wall;
use super::line::path_m;
use super::patches::side_normal;
use crate::fem::Harmonic;
use crate::radiation::cylinder_decay_per_s;
use crate::solve::{Band, Eigenmode, modes_in_band};
use crate::{Family, Material, SolveError};

/// A perfect body of revolution with all modes of a band.
pub struct SolvedWall {
    /// The body.
    pub wall: Wall,
    /// Its mass, in kg.
    pub mass_kg: f64,
    /// Its modes by rising frequency, a pair counted once.
    pub(super) found: Vec<Found>,
    /// Largest entry of |ΦᵀMΦ − I| over modes of the same number of waves around the axis; those of
    /// different numbers are orthogonal by symmetry.
    pub(super) orthonormality: f64,
}

/// One solution with what the strike line and the air see of it.
pub(super) struct Found {
    /// Waves around the axis.
    pub(super) order: usize,
    pub(super) hz: f64,
    pub(super) residual: f64,
    pub(super) family: Family,
    /// (U, V, W) along the strike line, a node every half cell.
    pub(super) line: Vec<[f64; 3]>,
    /// (U, V, W)·n on the sides that are heard.
    pub(super) sides: Vec<f64>,
    pub(super) held: f64,
    pub(super) felt: f64,
    pub(super) radiation_per_s: f64,
}

/// Harmonics that have no mode, in a row, before the search for more ends: the more waves around
/// the axis, the stiffer the wall.
const EMPTY_HARMONICS: usize = 3;

impl SolvedWall {
    /// Solves `wall` for every mode of `band`.
    ///
    /// # Errors
    ///
    /// As [`modes_in_band`].
    pub fn new(wall: Wall, material: &Material, band: Band) -> Result<Self, SolveError> {
        let (mut found, mut orthonormality) = (Vec::new(), 0.0f64);
        let mut empty = 0;
        for order in 0.. {
            let harmonic = Harmonic::new(&wall.meridian, material, order)?;
            let solution = modes_in_band(&harmonic.pencil, band)?;
            orthonormality = orthonormality.max(solution.orthonormality);
            empty = if solution.counted == 0 { empty + 1 } else { 0 };
            let modes = solution.modes.iter();
            found.extend(modes.map(|mode| see(&wall, &harmonic, order, mode)));
            if empty == EMPTY_HARMONICS {
                break;
            }
        }
        found.sort_by(|p, q| p.hz.total_cmp(&q.hz));
        Ok(Self {
            mass_kg: wall.meridian.volume_m3() * material.density_kg_m3,
            wall,
            found,
            orthonormality,
        })
    }
}

fn see(wall: &Wall, harmonic: &Harmonic, order: usize, mode: &Eigenmode) -> Found {
    let motion = |node: u32| harmonic.motion(&mode.vector, node);
    let line: Vec<[f64; 3]> = wall.line.iter().map(|&node| motion(node)).collect();
    let around = |nodes: &[u32]| {
        let share = if order == 0 { 1.0 } else { 0.5 };
        let squares = nodes.iter().map(|&node| motion(node));
        share * squares.flatten().map(|u| u * u).sum::<f64>()
    };
    let sides = wall
        .heard
        .iter()
        .map(|side| {
            let [nr, nz] = side_normal(wall, side);
            let u = mean(side.map(motion));
            u[0] * nr + u[2] * nz
        })
        .collect();
    let energy = |a: usize| line.iter().map(|u| u[a] * u[a]).sum::<f64>();
    Found {
        order,
        hz: mode.hz,
        residual: mode.residual,
        family: match order {
            0 if energy(1) > energy(0) + energy(2) => Family::Torsion,
            0 => Family::Longitudinal,
            1 => Family::Bending,
            _ => wall.family,
        },
        held: around(&wall.held),
        felt: around(&wall.felt),
        radiation_per_s: radiation_per_s(wall, order, mode.hz, &line),
        line,
        sides,
    }
}

/// What the air takes, by the cylinder that it takes the wall for: its radius where it moves.
fn radiation_per_s(wall: &Wall, order: usize, hz: f64, line: &[[f64; 3]]) -> f64 {
    let normal: Vec<f64> = line
        .iter()
        .zip(&wall.line_normals)
        .map(|(u, n)| u[0] * n[0] + u[2] * n[1])
        .collect();
    let (mut turning, mut weight) = (0.0, 0.0);
    for (motion, &node) in normal.iter().zip(&wall.line) {
        turning += motion * motion * wall.meridian.nodes_m[node as usize][0];
        weight += motion * motion;
    }
    let radius_m = if weight > 0.0 { turning / weight } else { 1.0 };
    let step_m = path_m(wall) / (line.len() - 1) as f64;
    cylinder_decay_per_s(hz, order, radius_m, step_m, &normal)
}

/// Simpson's mean over a side.
fn mean(u: [[f64; 3]; 3]) -> [f64; 3] {
    [0, 1, 2].map(|a| (u[0][a] + 4.0 * u[1][a] + u[2][a]) / 6.0)
}
