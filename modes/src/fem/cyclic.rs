//! A tube of identical sectors, reduced exactly to one sector per number of waves around it.
//!
//! The mesh of [`tube_hex20`](crate::mesh::tube_hex20) repeats itself around the axis, so K and M
//! are block-circulant and the motions u_r, u_z ∝ cos mθ, u_θ ∝ sin mθ at the node planes never mix
//! with those of another m (Thomas 1979). What is left for each m has the size of one sector and
//! the very eigenvalues of the whole mesh; every m ≥ 1 stands for a degenerate pair.

use super::hex20::{HEX20_NODES, Hex20};
use super::pencil::{Pattern, Pencil};
use crate::mesh::TubeGrid;
use crate::shape::Tube;
use crate::{Material, SolveError};
use std::sync::Arc;

/// Unknowns of one hexahedron.
const UNKNOWNS: usize = 60;

/// One sector of a tube: what K and M of every harmonic are made from.
pub struct CyclicTube {
    around: usize,
    pattern: Arc<Pattern>,
    /// Unknowns of each axial cell's hexahedron, in its local order.
    cells: Vec<[u32; UNKNOWNS]>,
    /// Element matrices in the cylindrical frame (r, θ, z) of each node, row by row.
    stiffness: Vec<f64>,
    mass: Vec<f64>,
}

/// Numbers of the nodes on the two planes that a sector keeps: its edge and its middle.
struct Section {
    ids: Vec<u32>,
    count: u32,
}

impl Section {
    fn new(along: usize) -> Self {
        let rows = 2 * along + 1;
        let mut section = Self {
            ids: vec![u32::MAX; 6 * rows],
            count: 0,
        };
        for z in 0..rows {
            for plane in 0..2 {
                for r in 0..3 {
                    // Corners and edge middles: at most one odd index.
                    if r % 2 + plane + z % 2 <= 1 {
                        let slot = section.slot(plane, r, z);
                        section.ids[slot] = section.count;
                        section.count += 1;
                    }
                }
            }
        }
        section
    }

    fn slot(&self, plane: usize, r: usize, z: usize) -> usize {
        (z * 2 + plane) * 3 + r
    }

    fn id(&self, plane: usize, r: usize, z: usize) -> u32 {
        self.ids[self.slot(plane, r, z)]
    }
}

impl CyclicTube {
    /// The sector of a tube of `material` cut into `grid`.
    ///
    /// # Errors
    ///
    /// [`SolveError::BadElement`] if the tube has no wall or no length.
    pub fn new(tube: &Tube, grid: TubeGrid, material: &Material) -> Result<Self, SolveError> {
        let angle = std::f64::consts::TAU / grid.around as f64;
        let cell_m = tube.length_m / grid.along as f64;
        let turn = |node: [f64; 3]| 0.5 * angle * (1.0 + node[1]);
        let nodes = HEX20_NODES.map(|node| {
            let radius = tube.inner_radius_m() + 0.5 * (1.0 + node[0]) * tube.wall_m;
            let (sin, cos) = turn(node).sin_cos();
            [radius * cos, radius * sin, 0.5 * (1.0 + node[2]) * cell_m]
        });
        let element = Hex20::new(&nodes, material).ok_or(SolveError::BadElement { index: 0 })?;
        let frames = HEX20_NODES.map(|node| {
            let (sin, cos) = turn(node).sin_cos();
            [[cos, sin, 0.0], [-sin, cos, 0.0], [0.0, 0.0, 1.0]]
        });
        let (mut stiffness, mut mass) = (
            vec![0.0; UNKNOWNS * UNKNOWNS],
            vec![0.0; UNKNOWNS * UNKNOWNS],
        );
        for i in 0..20 {
            for j in 0..20 {
                for a in 0..3 {
                    for b in 0..3 {
                        let at = (3 * i + a) * UNKNOWNS + 3 * j + b;
                        for c in 0..3 {
                            mass[at] += frames[i][a][c] * element.mass[i][j] * frames[j][b][c];
                            for d in 0..3 {
                                stiffness[at] += frames[i][a][c]
                                    * element.stiffness[i][j][c][d]
                                    * frames[j][b][d];
                            }
                        }
                    }
                }
            }
        }
        let section = Section::new(grid.along);
        let cells: Vec<_> = (0..grid.along)
            .map(|z| cell_unknowns(&section, z))
            .collect();
        Ok(Self {
            around: grid.around,
            pattern: Arc::new(section_pattern(3 * section.count, &cells)),
            cells,
            stiffness,
            mass,
        })
    }

    /// Harmonics below the one whose waves the sectors can no longer carry.
    #[must_use]
    pub fn harmonics(&self) -> std::ops::Range<usize> {
        0..self.around / 2
    }

    /// K and M of the motions with `m` waves around the axis, normalised to the whole tube.
    #[must_use]
    pub fn pencil(&self, m: usize) -> Pencil {
        let weights = self.weights(m);
        let mut pencil = Pencil {
            stiffness: vec![0.0; self.pattern.entries()],
            mass: vec![0.0; self.pattern.entries()],
            pattern: Arc::clone(&self.pattern),
            rigid: if m < 2 { 2 } else { 0 },
        };
        for cell in &self.cells {
            for (i, &row) in cell.iter().enumerate() {
                for (j, &column) in cell.iter().enumerate() {
                    if row >= column {
                        let entry = self.pattern.entry(row, column);
                        let at = i * UNKNOWNS + j;
                        pencil.stiffness[entry] += weights[at] * self.stiffness[at];
                        pencil.mass[entry] += weights[at] * self.mass[at];
                    }
                }
            }
        }
        pencil
    }

    /// Sums over all sectors of the products of the waves that two unknowns of an element follow.
    fn weights(&self, m: usize) -> Vec<f64> {
        let (n, order) = (self.around as f64, m as f64);
        let half_step = std::f64::consts::PI * order / n;
        let phase = |unknown: usize| half_step * (1.0 + HEX20_NODES[unknown / 3][1]);
        let turns = |unknown: usize| unknown % 3 == 1;
        let mut weights = Vec::with_capacity(UNKNOWNS * UNKNOWNS);
        for i in 0..UNKNOWNS {
            for j in 0..UNKNOWNS {
                weights.push(match (turns(i), turns(j)) {
                    // Twist and stretch are uncoupled by the sector's mirror symmetry.
                    (a, b) if m == 0 => n * f64::from(u8::from(a == b)),
                    (false, true) => 0.5 * n * (phase(j) - phase(i)).sin(),
                    (true, false) => 0.5 * n * (phase(i) - phase(j)).sin(),
                    _ => 0.5 * n * (phase(i) - phase(j)).cos(),
                });
            }
        }
        weights
    }
}

fn cell_unknowns(section: &Section, cell: usize) -> [u32; UNKNOWNS] {
    let step = |local: f64| [0, 1, 2][usize::from(local > -0.5) + usize::from(local > 0.5)];
    std::array::from_fn(|unknown| {
        let [r, t, z] = HEX20_NODES[unknown / 3].map(step);
        // The sector's far edge is the near edge of the next one.
        let id = section.id(t % 2, r, 2 * cell + z);
        3 * id + (unknown % 3) as u32
    })
}

fn section_pattern(unknowns: u32, cells: &[[u32; UNKNOWNS]]) -> Pattern {
    let mut columns: Vec<Vec<u32>> = vec![Vec::new(); unknowns as usize];
    for cell in cells {
        for &column in cell {
            columns[column as usize].extend(cell.iter().copied().filter(|&row| row >= column));
        }
    }
    for column in &mut columns {
        column.sort_unstable();
        column.dedup();
    }
    Pattern::from_columns(&columns)
}
