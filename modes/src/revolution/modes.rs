//! Every mode of a body of revolution, harmonic by harmonic.

use super::Wall;
use crate::fem::Harmonic;
use crate::radiation::{Surface, cylinder_decay_per_s};
use crate::solve::{Band, Eigenmode, modes_in_band};
use crate::{Family, Material, Member, ModeLabel, SolveError, SolvedBody, SolvedMode, StrikeLine};
use std::f64::consts::TAU;

/// A small mass on the outside of a body of revolution, which splits its pairs of modes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Imperfection {
    /// The mass, in kg.
    pub mass_kg: f64,
    /// Its angle from the strike line, in degrees.
    pub angle_deg: f64,
}

/// Harmonics that have no mode, in a row, before the search for more ends: the more waves around
/// the axis, the stiffer the wall.
const EMPTY_HARMONICS: usize = 3;

/// Samples of the strike line to each half-wave of the mode that has most of them.
const SAMPLES_TO_HALF_WAVE: usize = 5;

/// Fewest samples of the strike line.
const FEWEST_SAMPLES: usize = 33;

/// Patches of the surface around the axis.
const PATCHES_AROUND: usize = 24;

/// One solution with what the strike line and the air see of it.
struct Found {
    order: usize,
    mode: Eigenmode,
    family: Family,
    /// (U, V, W) along the strike line, a node every half cell.
    line: Vec<[f64; 3]>,
    /// (U, V, W)·n on the sides that are heard.
    sides: Vec<f64>,
    held: f64,
    felt: f64,
    radiation_per_s: f64,
}

/// Solves `wall` for every mode of `band`.
///
/// # Errors
///
/// As [`modes_in_band`].
pub fn revolution_modes(
    wall: &Wall,
    material: &Material,
    band: Band,
    imperfection: Option<Imperfection>,
) -> Result<SolvedBody, SolveError> {
    let (mut found, mut orthonormality) = (Vec::new(), 0.0f64);
    let mut empty = 0;
    for order in 0.. {
        let harmonic = Harmonic::new(&wall.meridian, material, order)?;
        let solution = modes_in_band(&harmonic.pencil, band)?;
        orthonormality = orthonormality.max(solution.orthonormality);
        empty = if solution.counted == 0 { empty + 1 } else { 0 };
        let modes = solution.modes.into_iter();
        found.extend(modes.map(|mode| see(wall, &harmonic, order, mode)));
        if empty == EMPTY_HARMONICS {
            break;
        }
    }
    found.sort_by(|p, q| p.mode.hz.total_cmp(&q.mode.hz));
    let half_waves = found.iter().map(|f| half_waves(&f.line)).max().unwrap_or(1);
    let samples = (SAMPLES_TO_HALF_WAVE * half_waves + 1).max(FEWEST_SAMPLES);
    let mut modes: Vec<SolvedMode> = found
        .iter()
        .enumerate()
        .flat_map(|(i, f)| members(wall, f, index(&found[..=i]), samples, imperfection))
        .collect();
    modes.sort_by(|p, q| p.hz.total_cmp(&q.hz));
    Ok(SolvedBody {
        length_m: wall.length_m,
        mass_kg: wall.meridian.volume_m3() * material.density_kg_m3,
        line: strike_line(wall, samples),
        surface: surface(wall),
        modes,
        orthonormality,
    })
}

fn see(wall: &Wall, harmonic: &Harmonic, order: usize, mode: Eigenmode) -> Found {
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
    let normal: Vec<f64> = line
        .iter()
        .zip(&wall.line_normals)
        .map(|(u, n)| u[0] * n[0] + u[2] * n[1])
        .collect();
    // The cylinder that the air takes the wall for: its radius where it moves.
    let (mut turning, mut weight) = (0.0, 0.0);
    for (motion, &node) in normal.iter().zip(&wall.line) {
        turning += motion * motion * wall.meridian.nodes_m[node as usize][0];
        weight += motion * motion;
    }
    let radius_m = if weight > 0.0 { turning / weight } else { 1.0 };
    let step_m = path_m(wall) / (line.len() - 1) as f64;
    let energy = |a: usize| line.iter().map(|u| u[a] * u[a]).sum::<f64>();
    Found {
        order,
        family: match order {
            0 if energy(1) > energy(0) + energy(2) => Family::Torsion,
            0 => Family::Longitudinal,
            1 => Family::Bending,
            _ => wall.family,
        },
        held: around(&wall.held),
        felt: around(&wall.felt),
        radiation_per_s: cylinder_decay_per_s(mode.hz, order, radius_m, step_m, &normal),
        mode,
        line,
        sides,
    }
}

/// Simpson's mean over a side.
fn mean(u: [[f64; 3]; 3]) -> [f64; 3] {
    [0, 1, 2].map(|a| (u[0][a] + 4.0 * u[1][a] + u[2][a]) / 6.0)
}

/// Outward unit normal (r, z) of a side: the body is on its left.
fn side_normal(wall: &Wall, side: &[u32; 3]) -> [f64; 2] {
    let [start, _, end] = side.map(|node| wall.meridian.nodes_m[node as usize]);
    let (dr, dz) = (end[0] - start[0], end[1] - start[1]);
    let length = dr.hypot(dz);
    [dz / length, -dr / length]
}

/// Length of the strike line, in m.
fn path_m(wall: &Wall) -> f64 {
    wall.line
        .windows(2)
        .map(|pair| {
            let [p, q] = [pair[0], pair[1]].map(|node| wall.meridian.nodes_m[node as usize]);
            (q[0] - p[0]).hypot(q[1] - p[1])
        })
        .sum()
}

/// The element's own interpolation at `position` in 0…1 of end, middle, end, … values of cells.
fn quadratic(value: impl Fn(usize) -> f64, count: usize, position: f64) -> f64 {
    let cells = count / 2;
    let x = position * cells as f64;
    #[expect(clippy::cast_sign_loss, reason = "positions are not negative")]
    let cell = (x as usize).min(cells - 1);
    let t = 2.0 * (x - cell as f64) - 1.0;
    let [start, middle, end] = [0, 1, 2].map(|i| value(2 * cell + i));
    0.5 * t * (t - 1.0) * start + (1.0 - t * t) * middle + 0.5 * t * (t + 1.0) * end
}

/// Half-waves of the largest component along the line.
fn half_waves(line: &[[f64; 3]]) -> usize {
    let component = (0..3)
        .max_by(|&a, &b| {
            let energy = |c: usize| line.iter().map(|u| u[c] * u[c]).sum::<f64>();
            energy(a).total_cmp(&energy(b))
        })
        .unwrap_or(0);
    1 + line
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

/// (U, V, W) at the samples of the strike line.
fn sampled(wall: &Wall, line: &[[f64; 3]], samples: usize) -> Vec<[f64; 3]> {
    let mut sampled: Vec<[f64; 3]> = (0..samples)
        .map(|i| {
            let position = i as f64 / (samples - 1) as f64;
            [0, 1, 2].map(|a| quadratic(|i| line[i][a], line.len(), position))
        })
        .collect();
    if wall.mirrors {
        // Each component is even or odd about the middle; rounding is shared out.
        let twin = |i: usize| samples - 1 - i;
        let signs = [0, 1, 2].map(|a| {
            let overlap: f64 = (0..samples)
                .map(|i| sampled[i][a] * sampled[twin(i)][a])
                .sum();
            if overlap < 0.0 { -1.0 } else { 1.0 }
        });
        for i in 0..samples.div_ceil(2) {
            let (p, q) = (sampled[i], sampled[twin(i)]);
            let mean = [0, 1, 2].map(|a| 0.5 * (p[a] + signs[a] * q[a]));
            sampled[twin(i)] = [0, 1, 2].map(|a| signs[a] * mean[a]);
            sampled[i] = mean;
        }
    }
    sampled
}

/// The one mode of a solution without waves around the axis, or the pair that one with them is.
///
/// Of a pair, A has the crest of U and W at the imperfection's angle (or at the strike line, θ = 0)
/// and B its node. The imperfection lowers each by the mass that it moves there: λ/(1 + δm |φ|²),
/// first order in δm (Rayleigh 1894, §90).
fn members(
    wall: &Wall,
    found: &Found,
    index: usize,
    samples: usize,
    imperfection: Option<Imperfection>,
) -> Vec<SolvedMode> {
    let order = found.order as f64;
    let (mass_kg, angle) =
        imperfection.map_or((0.0, 0.0), |i| (i.mass_kg, i.angle_deg.to_radians()));
    let rim = found.line[0];
    let line = sampled(wall, &found.line, samples);
    let member = |member: Member, turn: f64, moved: f64| {
        // Amplitudes of cos m(θ − turn) and sin m(θ − turn) at the strike line.
        let (sin, cos) = (-order * turn).sin_cos();
        let keep = match (found.family, found.order) {
            (Family::Torsion, _) => [0.0, 1.0, 0.0],
            (_, 0) => [1.0, 0.0, 1.0],
            _ => [cos, sin, cos],
        };
        SolvedMode {
            hz: found.mode.hz / (1.0 + mass_kg * moved).sqrt(),
            residual: found.mode.residual,
            label: ModeLabel {
                family: found.family,
                order: u16::try_from(found.order).unwrap_or(u16::MAX),
                index: u16::try_from(index).unwrap_or(u16::MAX),
                member,
            },
            shape: line
                .iter()
                .map(|u| {
                    [0, 1, 2]
                        .map(|a| exact(keep[a]) * u[a])
                        .map(|x| x as f32 + 0.0)
                })
                .collect(),
            motion: around(&found.sides, order, turn),
            held: found.held,
            felt: found.felt,
            radiation_per_s: found.radiation_per_s,
        }
    };
    if found.order == 0 {
        let moved = rim[0] * rim[0] + rim[1] * rim[1] + rim[2] * rim[2];
        return vec![member(Member::Single, 0.0, moved)];
    }
    let quarter = std::f64::consts::FRAC_PI_2 / order;
    vec![
        member(Member::A, angle, rim[0] * rim[0] + rim[2] * rim[2]),
        member(Member::B, angle + quarter, rim[1] * rim[1]),
    ]
}

/// A factor that is 0 but for rounding is 0.
fn exact(factor: f64) -> f64 {
    if factor.abs() < 1e-12 { 0.0 } else { factor }
}

/// Normal motion on the patches: side by side, around the axis.
fn around(sides: &[f64], order: f64, turn: f64) -> Vec<f32> {
    let waves: Vec<f64> = (0..PATCHES_AROUND)
        .map(|i| (order * (patch_angle(i) - turn)).cos())
        .collect();
    sides
        .iter()
        .flat_map(|side| waves.iter().map(move |wave| (side * wave) as f32))
        .collect()
}

fn patch_angle(i: usize) -> f64 {
    TAU * (i as f64 + 0.5) / PATCHES_AROUND as f64
}

/// A point or direction (r, z) at the angle θ, in the frame of the row: the strike line, θ = 0,
/// faces the player, towards −y; z is up.
fn turned([r, z]: [f64; 2], angle: f64) -> [f64; 3] {
    let (sin, cos) = angle.sin_cos();
    [r * sin, -r * cos, z]
}

fn surface(wall: &Wall) -> Surface {
    let (mut low, mut high) = (f64::INFINITY, f64::NEG_INFINITY);
    for node in &wall.meridian.nodes_m {
        (low, high) = (low.min(node[1]), high.max(node[1]));
    }
    let middle = 0.5 * (low + high);
    let mut surface = Surface {
        mouth_m: wall.mouth_m.map(|[r, z]| [r, z - middle]),
        ..Surface::default()
    };
    for side in &wall.heard {
        let [p, q, r] = side.map(|node| wall.meridian.nodes_m[node as usize]);
        let normal = side_normal(wall, side);
        let area = (r[0] - p[0]).hypot(r[1] - p[1]) * q[0] * TAU / PATCHES_AROUND as f64;
        for i in 0..PATCHES_AROUND {
            surface
                .points_m
                .push(turned([q[0], q[1] - middle], patch_angle(i)));
            surface.normals.push(turned(normal, patch_angle(i)));
            surface.areas_m2.push(area);
        }
    }
    surface
}

/// Points and normals of the strike line, in the body's cylindrical frame (r, θ, z) at θ = 0.
fn strike_line(wall: &Wall, samples: usize) -> StrikeLine {
    let count = wall.line.len();
    let at = |i: usize| (i as f64) / (samples - 1) as f64;
    let place = |i: usize, a: usize| wall.meridian.nodes_m[wall.line[i] as usize][a];
    StrikeLine {
        points_m: (0..samples)
            .map(|i| [0, 1].map(|a| quadratic(|k| place(k, a), count, at(i))))
            .map(|[r, z]| [r, 0.0, z])
            .collect(),
        normals: (0..samples)
            .map(|i| [0, 1].map(|a| quadratic(|k| wall.line_normals[k][a], count, at(i))))
            .map(|[r, z]| {
                let length = r.hypot(z);
                [r / length, 0.0, z / length]
            })
            .collect(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::TABLE_1;
    use crate::fem::{TetMass, assemble};
    use crate::mesh::{TubeGrid, tube_hex20};
    use crate::revolution::Bell;
    use crate::shape::Tube;

    fn chime() -> SolvedBody {
        let bell = Bell::open(Tube::D5);
        revolution_modes(&bell.wall(0.02), &TABLE_1[0].material, Band::AUDIBLE, None).unwrap()
    }

    #[test]
    fn the_whole_mesh_has_the_same_first_twenty_modes() {
        let grid = TubeGrid {
            around: 32,
            along: 26,
        };
        let mesh = tube_hex20(&Tube::D5, grid);
        let pencil = assemble(&mesh, &TABLE_1[0].material, TetMass::Consistent).unwrap();
        let band = Band {
            high_hz: 11_000.0,
            ..Band::AUDIBLE
        };
        let whole = modes_in_band(&pencil, band).unwrap();
        assert!(whole.modes.len() > 20);
        for (mode, judge) in chime().modes.iter().zip(&whole.modes).take(20) {
            let cents = 1200.0 * (mode.hz / judge.hz).log2();
            assert!(cents.abs() < 1.0, "{}: {cents}", mode.label);
        }
    }

    #[test]
    fn shapes_on_the_line_are_those_of_a_beam_and_mirror() {
        let body = chime();
        let first = &body.modes[0];
        assert_eq!(first.label.to_string(), "bending 1 a");
        let last = body.line.len() - 1;
        assert_eq!(first.shape[0][0], first.shape[last][0]);
        // Mass-normalised, a thin free beam moves 2/√m at its ends (Blevins 1979, table 8-1).
        let expected = 2.0 / body.mass_kg.sqrt();
        let end = f64::from(first.shape[0][0].abs());
        assert!((end / expected - 1.0).abs() < 0.02, "{end} {expected}");
        assert!((body.mass_kg / (Tube::D5.volume_m3() * 2700.0) - 1.0).abs() < 1e-9);
        // Held near its node it moves little there, beside the next mode.
        assert!(first.held < 0.1 * body.modes[2].held);
    }

    #[test]
    fn partners_share_a_frequency_until_a_mass_splits_them() {
        let body = chime();
        for pair in body.modes.windows(2) {
            if pair[0].label.member == Member::A {
                assert_eq!(pair[1].label.member, Member::B);
                assert_eq!(pair[0].hz, pair[1].hz);
                assert!(pair[0].shape.iter().all(|u| u[1] == 0.0));
                assert!(pair[1].shape.iter().all(|u| u[0] == 0.0 && u[2] == 0.0));
            }
        }
        let bell = Bell::open(Tube::D5);
        let mass_kg = 1e-4;
        let imperfection = Some(Imperfection {
            mass_kg,
            angle_deg: 30.0,
        });
        let material = &TABLE_1[0].material;
        let split =
            revolution_modes(&bell.wall(0.02), material, Band::AUDIBLE, imperfection).unwrap();
        // δf/f = −½ δm φ² with φ² = 4/m at the end of a beam.
        let expected = 0.5 * mass_kg * 4.0 / body.mass_kg;
        let shift = 1.0 - split.modes[0].hz / body.modes[0].hz;
        assert!((shift / expected - 1.0).abs() < 0.05, "{shift} {expected}");
        let of = |member| {
            let found = split
                .modes
                .iter()
                .find(|m| m.label.order == 1 && m.label.member == member);
            found.unwrap().shape[0][0] / body.modes[0].shape[0][0]
        };
        assert!((of(Member::A) - 0.75f32.sqrt()).abs() < 1e-3);
        assert!((of(Member::B).abs() - 0.5).abs() < 1e-3);
    }
}
