//! A quarter of a bar in place of the whole: what lies at x ≥ 0, y ≥ 0, for modes that are even or
//! odd about each plane of symmetry.

use crate::fem::{Constrained, Pencil, TetMass, assemble, hex20_weights};
use crate::mesh::{BarGrid, BarPart, Elements, Mesh, bar_hex20};
use crate::shape::Bar;
use crate::{Material, SolveError};

/// Modes of one symmetry: even means the mirror image of the motion is the motion, odd its opposite.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Class {
    /// Odd about the plane x = 0, across the middle of the bar.
    pub(super) x_odd: bool,
    /// Odd about the plane y = 0, along the bar.
    pub(super) y_odd: bool,
}

impl Class {
    pub(super) const EVEN: Self = Self {
        x_odd: false,
        y_odd: false,
    };
    pub(super) const X_ODD: Self = Self {
        x_odd: true,
        y_odd: false,
    };
    pub(super) const BOTH_ODD: Self = Self {
        x_odd: true,
        y_odd: true,
    };
    pub(super) const ALL: [Self; 4] = [
        Self::EVEN,
        Self::X_ODD,
        Self {
            x_odd: false,
            y_odd: true,
        },
        Self::BOTH_ODD,
    ];

    /// Rigid motions of this symmetry: rise; slide along x and tilt about y; slide along y and roll
    /// about x; turn about z.
    fn rigid(self) -> usize {
        if self.x_odd == self.y_odd { 1 } else { 2 }
    }

    /// Whether displacement along `axis` vanishes on the plane across axis `plane`: along the
    /// plane's normal it does in even motion, in the plane in odd motion.
    fn vanishes(self, plane: usize, axis: usize) -> bool {
        let odd = [self.x_odd, self.y_odd][plane];
        (axis == plane) != odd
    }

    /// Signs of (u_x, u_y, u_z) at the image of a point behind the plane across axis `plane`.
    pub(super) fn mirrored(self, plane: usize) -> [f64; 3] {
        let odd = [self.x_odd, self.y_odd][plane];
        [0, 1, 2].map(|axis| if (axis == plane) == odd { 1.0 } else { -1.0 })
    }
}

/// The mesh of a quarter and its K and M, free on all sides.
pub(super) struct Quarter {
    mesh: Mesh,
    grid: BarGrid,
    pencil: Pencil,
    half_length_m: f64,
    half_width_m: f64,
}

impl Quarter {
    pub(super) fn new(bar: &Bar, grid: BarGrid, material: &Material) -> Result<Self, SolveError> {
        let mesh = bar_hex20(bar, grid, BarPart::Quarter);
        let pencil = assemble(&mesh, material, TetMass::Consistent)?;
        Ok(Self {
            mesh,
            grid,
            pencil,
            half_length_m: 0.5 * bar.length_m,
            half_width_m: 0.5 * bar.width_m,
        })
    }

    /// Kφ = λMφ of the modes of one symmetry.
    pub(super) fn pencil(&self, class: Class) -> Constrained {
        Constrained::new(&self.pencil, class.rigid(), |unknown| {
            let (node, axis) = (self.mesh.nodes[unknown / 3], unknown % 3);
            (0..2).all(|plane| node[plane] != 0.0 || !class.vanishes(plane, axis))
        })
    }

    /// Mass of the whole bar, in kg.
    pub(super) fn mass_kg(&self) -> f64 {
        let pattern = &self.pencil.pattern;
        let along_x = (0..pattern.unknowns()).step_by(3).flat_map(|j| {
            pattern.column(j).map(move |at| {
                let twice = if pattern.rows[at] as usize == j {
                    1.0
                } else {
                    2.0
                };
                twice * self.pencil.mass[at]
            })
        });
        4.0 * along_x.sum::<f64>()
    }

    /// Shares of the motion along x, y and z in a mode's kinetic energy, but for what nodes share.
    pub(super) fn energies(&self, vector: &[f64]) -> [f64; 3] {
        let mut energies = [0.0; 3];
        for (unknown, u) in vector.iter().enumerate() {
            let diagonal = self.pencil.pattern.column_start[unknown] as usize;
            energies[unknown % 3] += self.pencil.mass[diagonal] * u * u;
        }
        energies
    }

    /// Displacement at `x_m` ≥ 0, `y_m` ≥ 0 and `height` from 0, the underside, to 1, the top.
    pub(super) fn at(&self, vector: &[f64], x_m: f64, y_m: f64, height: f64) -> [f64; 3] {
        let BarGrid {
            along,
            across,
            through,
        } = self.grid;
        let cell = |share: f64, cells: usize| {
            let position = share * cells as f64;
            #[expect(clippy::cast_sign_loss, reason = "shares are not negative")]
            let cell = (position as usize).min(cells - 1);
            (cell, 2.0 * (position - cell as f64) - 1.0)
        };
        let (i, xi) = cell(x_m / self.half_length_m, along);
        let (j, eta) = cell(y_m / self.half_width_m, across);
        let (k, zeta) = cell(height, through);
        self.in_cell([i, j, k], vector, [xi, eta, zeta])
    }

    fn hex(&self, [i, j, k]: [usize; 3]) -> &[u32; 20] {
        let Elements::Hex20(hexes) = &self.mesh.elements else {
            unreachable!("bars are meshed with hexahedra")
        };
        &hexes[(i * self.grid.across + j) * self.grid.through + k]
    }

    fn in_cell(&self, cell: [usize; 3], vector: &[f64], local: [f64; 3]) -> [f64; 3] {
        let mut sum = [0.0; 3];
        for (&node, weight) in self.hex(cell).iter().zip(hex20_weights(local)) {
            for (axis, sum) in sum.iter_mut().enumerate() {
                *sum += weight * vector[3 * node as usize + axis];
            }
        }
        sum
    }

    /// The outer faces of the quarter's cells.
    pub(super) fn faces(&self) -> Vec<Face> {
        let BarGrid {
            along,
            across,
            through,
        } = self.grid;
        let positions = self.mesh.nodes.concat();
        let mut faces = Vec::new();
        for i in 0..along {
            for j in 0..across {
                for k in 0..through {
                    let outer = [
                        (k + 1 == through, 2, 1.0),
                        (k == 0, 2, -1.0),
                        (j + 1 == across, 1, 1.0),
                        (i + 1 == along, 0, 1.0),
                    ];
                    let outer = outer.into_iter().filter(|(is_outer, ..)| *is_outer);
                    faces.extend(
                        outer.map(|(_, axis, side)| self.face(&positions, [i, j, k], axis, side)),
                    );
                }
            }
        }
        faces
    }

    fn face(&self, positions: &[f64], cell: [usize; 3], axis: usize, side: f64) -> Face {
        let place = |p: f64, q: f64| {
            let mut local = [0.0; 3];
            local[axis] = side;
            local[(axis + 1) % 3] = p;
            local[(axis + 2) % 3] = q;
            local
        };
        let corner = |p: f64, q: f64| self.in_cell(cell, positions, place(p, q));
        let diagonal = |from: [f64; 3], to: [f64; 3]| [0, 1, 2].map(|a| to[a] - from[a]);
        let (u, v) = (
            diagonal(corner(-1.0, -1.0), corner(1.0, 1.0)),
            diagonal(corner(1.0, -1.0), corner(-1.0, 1.0)),
        );
        // Half the product of the diagonals is the vector area of any quadrangle.
        let area = [0, 1, 2].map(|a| {
            let (b, c) = ((a + 1) % 3, (a + 2) % 3);
            0.5 * side * (u[b] * v[c] - u[c] * v[b])
        });
        let area_m2 = area.iter().map(|a| a * a).sum::<f64>().sqrt();
        Face {
            cell,
            local: place(0.0, 0.0),
            middle_m: corner(0.0, 0.0),
            normal: area.map(|a| a / area_m2),
            area_m2,
        }
    }

    /// φ·n in the middle of `face`.
    pub(super) fn normal_motion(&self, face: &Face, vector: &[f64]) -> f64 {
        let u = self.in_cell(face.cell, vector, face.local);
        (0..3).map(|a| u[a] * face.normal[a]).sum()
    }
}

/// One cell's side that touches the air.
pub(super) struct Face {
    cell: [usize; 3],
    /// Its middle in the cell's own coordinates.
    local: [f64; 3],
    /// Its middle, in m.
    pub(super) middle_m: [f64; 3],
    /// Outward unit normal.
    pub(super) normal: [f64; 3],
    /// Area, in m².
    pub(super) area_m2: f64,
}
