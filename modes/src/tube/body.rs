//! Every audible mode of a tube, as a body that can be struck.

use super::Fineness;
use crate::fem::CyclicTube;
use crate::radiation::coupling;
use crate::shape::Tube;
use crate::solve::{Band, Eigenmode, modes_in_band};
use crate::{Family, Material, Member, Mode, ModeLabel, SolveError, StrikeLine};
use std::f64::consts::TAU;

/// A tube's modes, and how well they solve the eigenproblem.
#[derive(Clone, Debug, PartialEq)]
pub struct TubeModes {
    /// The modes, by rising frequency.
    pub modes: Vec<Mode>,
    /// The generator of the tube along which it is struck, from end to end.
    pub line: StrikeLine,
    /// Largest entry of |ΦᵀMΦ − I| over modes of the same number of waves around the axis; those of
    /// different numbers are orthogonal by symmetry.
    pub orthonormality: f64,
}

/// Harmonics that have no mode, in a row, before the search for more ends: the more waves around
/// the axis, the stiffer the wall.
const EMPTY_HARMONICS: usize = 3;

/// Samples of the strike line to each half-wave of the mode that has most of them.
const SAMPLES_TO_HALF_WAVE: usize = 5;

/// Fewest samples of the strike line.
const FEWEST_SAMPLES: usize = 33;

/// One solution with what the strike line and the air see of it.
struct Found {
    order: usize,
    mode: Eigenmode,
    /// (u_r, u_θ, u_z) on the outer wall, a node every half cell.
    wall: Vec<[f64; 3]>,
    rectified_area: f64,
    family: Family,
}

/// Solves `tube` for every mode of `band`.
///
/// # Errors
///
/// As [`modes_in_band`].
pub fn tube_modes(
    tube: &Tube,
    material: &Material,
    fineness: Fineness,
    band: Band,
) -> Result<TubeModes, SolveError> {
    let sector = CyclicTube::new(tube, fineness.grid(tube), material)?;
    let (mut found, mut orthonormality) = (Vec::new(), 0.0f64);
    let mut empty = 0;
    for order in sector.harmonics() {
        let solution = modes_in_band(&sector.pencil(order), band)?;
        orthonormality = orthonormality.max(solution.orthonormality);
        empty = if solution.counted == 0 { empty + 1 } else { 0 };
        found.extend(
            solution
                .modes
                .into_iter()
                .map(|mode| see(&sector, tube, order, mode)),
        );
        if empty == EMPTY_HARMONICS {
            break;
        }
    }
    found.sort_by(|p, q| p.mode.hz.total_cmp(&q.mode.hz));
    let half_waves = found.iter().map(|f| half_waves(&f.wall)).max().unwrap_or(1);
    let samples = (SAMPLES_TO_HALF_WAVE * half_waves + 1).max(FEWEST_SAMPLES);
    Ok(TubeModes {
        modes: found
            .iter()
            .enumerate()
            .flat_map(|(i, f)| members(f, index(&found[..=i]), samples))
            .collect(),
        line: generator(tube, samples),
        orthonormality,
    })
}

fn see(sector: &CyclicTube, tube: &Tube, order: usize, mode: Eigenmode) -> Found {
    let wall = sector.along_wall(&mode.vector, 2);
    // ∫|cos mθ| dθ over the circle.
    let around = if order == 0 { TAU } else { 4.0 };
    let walls = [(0, tube.inner_radius_m()), (2, tube.outer_radius_m)];
    let sides: f64 = walls
        .iter()
        .map(|&(radial, radius_m)| {
            let radial_motion = sector
                .along_wall(&mode.vector, radial)
                .into_iter()
                .map(|u| u[0]);
            radius_m * tube.length_m * mean_rectified(&radial_motion.collect::<Vec<_>>())
        })
        .sum();
    let ends: f64 = [false, true]
        .into_iter()
        .map(|far| {
            let across = [0, 1, 2].map(|radial| {
                let line = sector.along_wall(&mode.vector, radial);
                line[if far { line.len() - 1 } else { 0 }][2]
            });
            tube.section_area_m2() / TAU * mean_rectified(&across)
        })
        .sum();
    let energy = |a: usize| wall.iter().map(|u| u[a] * u[a]).sum::<f64>();
    let family = match order {
        0 if energy(1) > energy(0) + energy(2) => Family::Torsion,
        0 => Family::Longitudinal,
        1 => Family::Bending,
        _ => Family::Wall,
    };
    Found {
        order,
        mode,
        rectified_area: around * (sides + ends),
        wall,
        family,
    }
}

/// Mean of |u| over cells whose end, middle, end, … values are given.
fn mean_rectified(values: &[f64]) -> f64 {
    const STEPS: usize = 8;
    let cells = values.len() / 2;
    let sum: f64 = (0..cells * STEPS)
        .map(|i| {
            let position = (i as f64 + 0.5) / (cells * STEPS) as f64;
            quadratic(values, position).abs()
        })
        .sum();
    sum / (cells * STEPS) as f64
}

/// The element's own interpolation at `position` in 0…1 of end, middle, end, … values of cells.
fn quadratic(values: &[f64], position: f64) -> f64 {
    let cells = values.len() / 2;
    let x = position * cells as f64;
    #[expect(clippy::cast_sign_loss, reason = "positions are not negative")]
    let cell = (x as usize).min(cells - 1);
    let t = 2.0 * (x - cell as f64) - 1.0;
    let [start, middle, end] = [0, 1, 2].map(|i| values[2 * cell + i]);
    0.5 * t * (t - 1.0) * start + (1.0 - t * t) * middle + 0.5 * t * (t + 1.0) * end
}

/// Half-waves of the largest component along the line.
fn half_waves(wall: &[[f64; 3]]) -> usize {
    let component = (0..3)
        .max_by(|&a, &b| {
            let energy = |c: usize| wall.iter().map(|u| u[c] * u[c]).sum::<f64>();
            energy(a).total_cmp(&energy(b))
        })
        .unwrap_or(0);
    1 + wall
        .windows(2)
        .filter(|pair| pair[0][component] * pair[1][component] < 0.0)
        .count()
}

/// Which of its family and order the last of `found` is, from 1.
fn index(found: &[Found]) -> usize {
    let last = &found[found.len() - 1];
    found
        .iter()
        .filter(|f| f.family == last.family && f.order == last.order)
        .count()
}

/// The one mode of a solution without waves around the axis, or the pair that one with them is.
///
/// At the strike line, θ = 0, the partner A has u_r, u_z at their crests and u_θ at its node; B is A
/// turned by a quarter wave.
fn members(found: &Found, index: usize, samples: usize) -> Vec<Mode> {
    let sample = |keep: [f64; 3]| -> Vec<[f32; 3]> {
        let components = [0, 1, 2].map(|a| found.wall.iter().map(|u| u[a]).collect::<Vec<_>>());
        (0..samples)
            .map(|i| {
                let position = i as f64 / (samples - 1) as f64;
                [0, 1, 2].map(|a| {
                    if keep[a] == 0.0 {
                        0.0
                    } else {
                        (keep[a] * quadratic(&components[a], position)) as f32
                    }
                })
            })
            .collect()
    };
    let mode = |member: Member, keep: [f64; 3]| Mode {
        hz: found.mode.hz,
        coupling: coupling(found.rectified_area, found.mode.hz),
        ears: [[coupling(found.rectified_area, found.mode.hz) as f32, 0.0]; 2],
        pipe_ears: [[0.0; 2]; 2],
        radiation_per_s: 0.0,
        support_per_s: 0.0,
        felt_per_s: 27.6,
        pipe_per_s: 0.0,
        residual: found.mode.residual,
        label: ModeLabel {
            family: found.family,
            order: u16::try_from(found.order).unwrap_or(u16::MAX),
            index: u16::try_from(index).unwrap_or(u16::MAX),
            member,
        },
        shape: sample(keep),
    };
    match found.family {
        Family::Torsion => vec![mode(Member::Single, [0.0, 1.0, 0.0])],
        Family::Longitudinal => vec![mode(Member::Single, [1.0, 0.0, 1.0])],
        _ => vec![
            mode(Member::A, [1.0, 0.0, 1.0]),
            mode(Member::B, [0.0, -1.0, 0.0]),
        ],
    }
}

/// Points and normals of the outer wall at θ = 0.
fn generator(tube: &Tube, samples: usize) -> StrikeLine {
    StrikeLine {
        points_m: (0..samples)
            .map(|i| {
                [
                    tube.outer_radius_m,
                    0.0,
                    tube.length_m * i as f64 / (samples - 1) as f64,
                ]
            })
            .collect(),
        normals: vec![[1.0, 0.0, 0.0]; samples],
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::TABLE_1;
    use crate::fem::{TetMass, assemble};
    use crate::mesh::tube_hex20;
    use crate::radiation::rectified_area;

    const COARSE: Fineness = Fineness {
        around: 24,
        max_element_m: 0.02,
    };

    fn chime() -> TubeModes {
        tube_modes(&Tube::D5, &TABLE_1[0].material, COARSE, Band::AUDIBLE).unwrap()
    }

    /// The whole mesh, solved and summed over its triangles as the paper does.
    #[test]
    fn couplings_are_those_of_the_whole_mesh() {
        let mesh = tube_hex20(&Tube::D5, COARSE.grid(&Tube::D5));
        let pencil = assemble(&mesh, &TABLE_1[0].material, TetMass::Consistent).unwrap();
        let band = Band {
            high_hz: 5_000.0,
            ..Band::AUDIBLE
        };
        let whole = modes_in_band(&pencil, band).unwrap();
        let surface = mesh.surface();
        let sector = chime();
        for (mode, judge) in sector.modes.iter().zip(&whole.modes) {
            assert!((mode.hz / judge.hz - 1.0).abs() < 1e-8, "{}", mode.label);
            let area = rectified_area(&mesh.nodes, &surface, &judge.vector);
            let expected = coupling(area, judge.hz);
            // Wall modes of nearly the same frequency may mix in the whole mesh; twist is silent.
            if mode.label.family == Family::Bending {
                let error = mode.coupling / expected - 1.0;
                assert!(error.abs() < 0.013, "{}: {error}", mode.label);
            }
        }
    }

    #[test]
    fn shapes_on_the_line_are_those_of_a_beam() {
        let body = chime();
        let first = &body.modes[0];
        assert_eq!(first.label.to_string(), "bending 1 a");
        let ends = [first.shape[0][0], first.shape[body.line.len() - 1][0]];
        assert!((ends[0] - ends[1]).abs() < 1e-4 * ends[0].abs());
        // Mass-normalised, a thin free beam moves 2/√m at its ends (Blevins 1979, table 8-1).
        let mass_kg = Tube::D5.volume_m3() * TABLE_1[0].material.density_kg_m3;
        let expected = 2.0 / mass_kg.sqrt();
        assert!(
            (f64::from(ends[0].abs()) / expected - 1.0).abs() < 0.02,
            "{ends:?} {expected}"
        );
    }

    #[test]
    fn partners_share_a_frequency_and_split_the_motion() {
        let body = chime();
        for pair in body.modes.windows(2) {
            if pair[0].label.member == Member::A {
                assert_eq!(pair[1].label.member, Member::B);
                assert_eq!(pair[0].hz, pair[1].hz);
                assert!(pair[0].shape.iter().all(|u| u[1] == 0.0));
                assert!(pair[1].shape.iter().all(|u| u[0] == 0.0 && u[2] == 0.0));
            }
        }
        let torsion = body
            .modes
            .iter()
            .find(|m| m.label.family == Family::Torsion)
            .unwrap();
        // √(μ/ρ)/2L: twist is exact in a round section.
        let expected = (TABLE_1[0].material.mu_pa / 2700.0).sqrt() / (2.0 * Tube::D5.length_m);
        assert!((torsion.hz / expected - 1.0).abs() < 1e-4, "{}", torsion.hz);
    }
}
