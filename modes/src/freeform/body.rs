//! A mesh as a body that can be struck, heard and drawn.

use super::air::Waves;
use super::axes::{Frame, area_m2, doubled_area};
use super::grid::Grid;
use super::outside::Outside;
use super::skin::{Skin, displacement};
use super::solve::{Limits, mass_kg, solve};
use crate::mesh::Mesh;
use crate::radiation::Surface as Patches;
use crate::solve::{Eigenmode, Watch};
use crate::{Family, Material, Member, ModeLabel, SolveError, SolvedBody, SolvedMode, Surface};

/// A body of any shape, solved.
#[derive(Clone, Debug, PartialEq)]
pub struct FreeBody {
    /// Its modes with all that air, supports and felt see of them.
    pub solved: SolvedBody,
    /// What it looks like, and how it moves.
    pub surface: Surface,
    /// Nodes of the mesh.
    pub nodes: usize,
    /// Elements of the mesh.
    pub elements: usize,
}

/// Points of the strike grid to a half-wave of the highest mode.
const TO_HALF_WAVE: f64 = 3.0;

/// Fewest and most points along and across the strike grid.
const COLUMNS: [usize; 2] = [25, 49];
const ROWS: [usize; 2] = [12, 24];

/// Places where a body lies or hangs: those of the strike grid that its lowest mode moves least.
const HELD_AT: usize = 3;

/// Solves a free body of any shape: every elastic mode within `limits`, on `mesh`.
/// Modes are numbered by rising frequency.
///
/// The strike grid goes around the body's longest axis, outside only. It is held where its lowest mode
/// moves least; felt touches it where that moves most.
///
/// # Errors
///
/// As [`crate::solve::modes_in_band_with`], and [`SolveError::BadElement`] for a flat or inverted
/// element.
pub fn free_body(
    mesh: &Mesh,
    material: &Material,
    limits: Limits,
    watch: &dyn Watch,
) -> Result<FreeBody, SolveError> {
    let (pencil, solution) = solve(mesh, material, limits, watch)?;
    let outside = Outside::of(mesh);
    let frame = Frame::of(&mesh.nodes, &outside.triangles);
    let length_m = 2.0 * frame.half_m[0];
    let waves: Vec<Waves> = solution
        .modes
        .iter()
        .map(|mode| {
            Waves::of(&mesh.nodes, &outside.triangles, |node| {
                displacement(&mode.vector, node)
            })
        })
        .collect();
    let shortest = waves
        .iter()
        .fold(0.0, |most: f64, waves| most.max(waves.number_per_m));
    let grid = Grid::new(
        (&mesh.nodes, &outside.triangles),
        &frame,
        counts(&frame, shortest),
    );
    let patches = patches(mesh, &outside);
    let touch = Touched::of(&grid, solution.modes.first());
    let modes = solution.modes.iter().zip(&waves).enumerate();
    let modes = modes.map(|(i, (mode, waves))| {
        let motion = motion(mesh, &outside, &mode.vector);
        SolvedMode {
            hz: mode.hz,
            residual: mode.residual,
            label: ModeLabel {
                family: Family::Other,
                order: 0,
                index: u16::try_from(i + 1).unwrap_or(u16::MAX),
                member: Member::Single,
            },
            shape: grid
                .feet
                .iter()
                .map(|foot| {
                    foot.at(|node| displacement(&mode.vector, node))
                        .map(|x| x as f32)
                })
                .collect(),
            rectified_area: patches.rectified_area(&motion),
            radiation_per_s: waves.radiation_per_s(mode.hz, patches.areas_m2.iter().sum()),
            motion,
            held: Touched::squares(&grid, mode, &touch.held),
            felt: Touched::squares(&grid, mode, &touch.felt),
        }
    });
    let solved = SolvedBody {
        length_m,
        mass_kg: mass_kg(&pencil),
        modes: modes.collect(),
        line: grid.line.clone(),
        orthonormality: solution.orthonormality,
        surface: patches,
    };
    let vectors = solution.modes.iter().map(|mode| mode.vector.as_slice());
    Ok(FreeBody {
        surface: Skin::of(&outside).surface(mesh, length_m, vectors),
        solved,
        nodes: mesh.nodes.len(),
        elements: mesh.elements.iter().count(),
    })
}

/// Points along and across, enough for waves of `number_per_m` within the allowed.
fn counts(frame: &Frame, number_per_m: f64) -> (usize, usize) {
    let half_waves = |way_m: f64| way_m * number_per_m / std::f64::consts::PI;
    let points = |way_m: f64, [fewest, most]: [usize; 2]| {
        #[expect(clippy::cast_sign_loss, reason = "lengths are positive")]
        let wanted = (TO_HALF_WAVE * half_waves(way_m)) as usize;
        wanted.clamp(fewest, most)
    };
    let around_m = std::f64::consts::PI * (frame.half_m[1] + frame.half_m[2]);
    (
        points(2.0 * frame.half_m[0], COLUMNS),
        points(around_m, ROWS),
    )
}

/// One flat patch to each face of an element.
fn patches(mesh: &Mesh, outside: &Outside) -> Patches {
    let mut patches = Patches::default();
    for face in outside.faces() {
        let corners = || face.iter().map(|t| t.map(|i| mesh.nodes[i as usize]));
        let area: f64 = corners().map(|t| area_m2(&t)).sum();
        let mut doubled = [0.0; 3];
        let mut middle = [0.0; 3];
        for triangle in corners() {
            let (part, own) = (area_m2(&triangle), doubled_area(&triangle));
            for a in 0..3 {
                doubled[a] += own[a];
                middle[a] += part * triangle.iter().map(|p| p[a]).sum::<f64>() / 3.0;
            }
        }
        let length = doubled.iter().map(|x| x * x).sum::<f64>().sqrt();
        patches.points_m.push(middle.map(|x| x / area));
        patches.normals.push(doubled.map(|x| x / length));
        patches.areas_m2.push(area);
    }
    patches
}

/// Mean of φ·n over each patch.
fn motion(mesh: &Mesh, outside: &Outside, vector: &[f64]) -> Vec<f32> {
    let flow = |face: &[[u32; 3]]| {
        let (mut flow, mut area) = (0.0, 0.0);
        for triangle in face {
            let corners = triangle.map(|i| mesh.nodes[i as usize]);
            let half = doubled_area(&corners).map(|x| 0.5 * x);
            let moved = triangle.map(|i| displacement(vector, i));
            flow += (0..3)
                .map(|a| half[a] * moved.iter().map(|u| u[a]).sum::<f64>() / 3.0)
                .sum::<f64>();
            area += area_m2(&corners);
        }
        (flow / area) as f32
    };
    outside.faces().map(flow).collect()
}

/// Points of the strike grid where something touches the body.
struct Touched {
    held: Vec<usize>,
    felt: Vec<usize>,
}

impl Touched {
    /// By the motion of the lowest mode; the points of the ends, where all rows meet, count once.
    fn of(grid: &Grid, lowest: Option<&Eigenmode>) -> Self {
        let Some(lowest) = lowest else {
            return Self {
                held: Vec::new(),
                felt: Vec::new(),
            };
        };
        let columns = grid.line.grid().columns;
        let inner = |&i: &usize| (1..columns - 1).contains(&(i % columns));
        let mut points: Vec<(usize, f64)> = (0..grid.feet.len())
            .filter(inner)
            .map(|i| (i, square(grid, lowest, i)))
            .collect();
        points.sort_by(|(i, p), (j, q)| p.total_cmp(q).then(i.cmp(j)));
        Self {
            held: points.iter().take(HELD_AT).map(|(i, _)| *i).collect(),
            felt: points.last().map(|(i, _)| *i).into_iter().collect(),
        }
    }

    /// Σ|φ|² over `points`, in 1/kg.
    fn squares(grid: &Grid, mode: &Eigenmode, points: &[usize]) -> f64 {
        points.iter().map(|&i| square(grid, mode, i)).sum()
    }
}

/// |φ|² at a point of the grid, in 1/kg.
fn square(grid: &Grid, mode: &Eigenmode, i: usize) -> f64 {
    let u = grid.feet[i].at(|node| displacement(&mode.vector, node));
    u.iter().map(|x| x * x).sum()
}
