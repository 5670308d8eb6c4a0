//! Harmonic elements: motions cos mθ of a body of revolution, solved in its meridian alone.
//!
//! u_r = U cos mθ, u_θ = V sin mθ, u_z = W cos mθ never mix with those of another m (Wilson 1965;
//! Zienkiewicz & Taylor 2000, vol. 2, §9.5). Eight-node quadrilaterals with 3×3 points.

use super::gauss::GAUSS_3;
use super::meridian::{CELL_NODES, Meridian};
use super::pencil::{Pattern, Pencil};
use crate::{Material, SolveError};
use std::f64::consts::{PI, TAU};
use std::sync::Arc;

/// K and M of one harmonic, and where its unknowns stand among those of all nodes.
#[derive(Clone, Debug)]
pub struct Harmonic {
    /// K and M, normalised to the whole body.
    pub pencil: Pencil,
    /// Unknown of component a (0 U, 1 V, 2 W) of node n at 3 n + a, or `u32::MAX` where it is held
    /// at zero.
    unknowns: Vec<u32>,
}

impl Harmonic {
    /// Motions with `order` waves around the axis of `meridian`.
    ///
    /// # Errors
    ///
    /// [`SolveError::BadElement`] if a cell is flat, inside out or across the axis.
    pub fn new(meridian: &Meridian, material: &Material, order: usize) -> Result<Self, SolveError> {
        let unknowns = free_unknowns(meridian, order);
        let pattern = pattern(meridian, &unknowns);
        let mut pencil = Pencil {
            stiffness: vec![0.0; pattern.entries()],
            mass: vec![0.0; pattern.entries()],
            pattern: Arc::new(pattern),
            rigid: if order < 2 { 2 } else { 0 },
        };
        let mut known: Vec<([[f64; 2]; 8], Cell)> = Vec::new();
        for (index, cell) in meridian.cells.iter().enumerate() {
            let nodes = cell.map(|node| meridian.nodes_m[node as usize]);
            let twin = known.iter().find(|(other, _)| is_shifted(other, &nodes));
            if let Some((_, element)) = twin {
                element.add(cell, &unknowns, &mut pencil);
                continue;
            }
            let element =
                Cell::new(&nodes, material, order).ok_or(SolveError::BadElement { index })?;
            element.add(cell, &unknowns, &mut pencil);
            known.truncate(REMEMBERED - 1);
            known.insert(0, (nodes, element));
        }
        Ok(Self { pencil, unknowns })
    }

    /// (U, V, W) of node `node` in `mode`.
    #[must_use]
    pub fn motion(&self, mode: &[f64], node: u32) -> [f64; 3] {
        [0, 1, 2].map(|a| {
            let unknown = self.unknowns[3 * node as usize + a];
            mode.get(unknown as usize).copied().unwrap_or(0.0)
        })
    }
}

/// Cells whose matrices are kept for those that follow: those of a tube are all alike but for where
/// they are along the axis.
const REMEMBERED: usize = 16;

/// Whether two cells are the same but for their place along the axis, to rounding.
fn is_shifted(a: &[[f64; 2]; 8], b: &[[f64; 2]; 8]) -> bool {
    let size_m = (a[2][0] - a[0][0]).abs() + (a[2][1] - a[0][1]).abs();
    let shift_m = b[0][1] - a[0][1];
    let near = |x: f64, y: f64| (x - y).abs() < 1e-11 * size_m;
    a.iter()
        .zip(b)
        .all(|(a, b)| near(a[0], b[0]) && near(a[1] + shift_m, b[1]))
}

/// On the axis a smooth motion of order 0 has only W, of order 1 only U = −V, of others nothing.
fn free_unknowns(meridian: &Meridian, order: usize) -> Vec<u32> {
    let mut count = 0;
    let mut unknowns = Vec::with_capacity(3 * meridian.nodes_m.len());
    for node in &meridian.nodes_m {
        for a in 0..3 {
            let free = node[0] > 0.0 || (order == 0 && a == 2) || (order == 1 && a < 2);
            unknowns.push(if free { count } else { u32::MAX });
            count += u32::from(free);
        }
    }
    unknowns
}

fn pattern(meridian: &Meridian, unknowns: &[u32]) -> Pattern {
    let count = unknowns.iter().filter(|&&u| u != u32::MAX).count();
    let mut columns: Vec<Vec<u32>> = vec![Vec::new(); count];
    for cell in &meridian.cells {
        let all: Vec<u32> = cell
            .iter()
            .flat_map(|&node| unknowns[3 * node as usize..][..3].iter().copied())
            .filter(|&unknown| unknown != u32::MAX)
            .collect();
        for &column in &all {
            columns[column as usize].extend(all.iter().copied().filter(|&row| row >= column));
        }
    }
    for column in &mut columns {
        column.sort_unstable();
        column.dedup();
    }
    Pattern::from_columns(&columns)
}

/// Stiffness and mass of one cell, 24 by 24.
struct Cell {
    stiffness: Box<[[f64; 24]; 24]>,
    mass: [[f64; 8]; 8],
}

impl Cell {
    fn new(nodes: &[[f64; 2]; 8], material: &Material, order: usize) -> Option<Self> {
        let around = if order == 0 { TAU } else { PI };
        let (lambda, mu) = (material.lambda_pa, material.mu_pa);
        let mut cell = Self {
            stiffness: Box::new([[0.0; 24]; 24]),
            mass: [[0.0; 8]; 8],
        };
        for (x, weight) in points() {
            let point = Point::new(nodes, x)?;
            let factor = around * weight * point.det * point.radius_m;
            let strains = point.strains(order as f64);
            let stress: Vec<[f64; 6]> = strains
                .iter()
                .map(|e| {
                    let pressure = lambda * (e[0] + e[1] + e[2]);
                    std::array::from_fn(|k| {
                        if k < 3 {
                            pressure + 2.0 * mu * e[k]
                        } else {
                            mu * e[k]
                        }
                    })
                })
                .collect();
            for (row, strain) in cell.stiffness.iter_mut().zip(&strains) {
                for (entry, stress) in row.iter_mut().zip(&stress) {
                    let work: f64 = strain.iter().zip(stress).map(|(e, s)| e * s).sum();
                    *entry += factor * work;
                }
            }
        }
        for (x, weight) in points() {
            let point = Point::new(nodes, x)?;
            let factor = around * weight * point.det * point.radius_m * material.density_kg_m3;
            for (row, a) in cell.mass.iter_mut().zip(&point.values) {
                for (entry, b) in row.iter_mut().zip(&point.values) {
                    *entry += factor * a * b;
                }
            }
        }
        Some(cell)
    }

    fn add(&self, cell: &[u32; 8], unknowns: &[u32], pencil: &mut Pencil) {
        let unknown = |local: usize| unknowns[3 * cell[local / 3] as usize + local % 3];
        for i in 0..24 {
            for j in 0..24 {
                let (row, column) = (unknown(i), unknown(j));
                if row == u32::MAX || column == u32::MAX || row < column {
                    continue;
                }
                let entry = pencil.pattern.entry(row, column);
                pencil.stiffness[entry] += self.stiffness[i][j];
                if i % 3 == j % 3 {
                    pencil.mass[entry] += self.mass[i / 3][j / 3];
                }
            }
        }
    }
}

fn points() -> impl Iterator<Item = ([f64; 2], f64)> {
    // With fewer points, which do for hexahedra, motions that no point sees would run along a single layer of
    // cells: many waves around a small circle do.
    let rule = GAUSS_3.into_iter();
    rule.flat_map(|(x, wx)| GAUSS_3.map(|(y, wy)| ([x, y], wx * wy)))
}

/// Shape functions and what they give at one point of a cell.
struct Point {
    values: [f64; 8],
    /// ∂N/∂r, ∂N/∂z.
    gradients: [[f64; 2]; 8],
    det: f64,
    radius_m: f64,
}

impl Point {
    fn new(nodes: &[[f64; 2]; 8], x: [f64; 2]) -> Option<Self> {
        let values = CELL_NODES.map(|node| shape(node, x));
        let local = CELL_NODES.map(|node| shape_gradient(node, x));
        let mut jacobian = [[0.0; 2]; 2];
        let mut radius_m = 0.0;
        for ((value, slope), place) in values.iter().zip(&local).zip(nodes) {
            radius_m += value * place[0];
            for (row, d) in jacobian.iter_mut().zip(slope) {
                row[0] += d * place[0];
                row[1] += d * place[1];
            }
        }
        let [[a, b], [c, d]] = jacobian;
        let det = a * d - b * c;
        // NaN is not above 0 either.
        if !(det > 0.0 && radius_m > 0.0) {
            return None;
        }
        let gradients = local.map(|[x, y]| [(d * x - b * y) / det, (a * y - c * x) / det]);
        Some(Self {
            values,
            gradients,
            det,
            radius_m,
        })
    }

    /// ε_rr, ε_θθ, ε_zz, γ_rθ, γ_θz, γ_rz of each unknown's motion, without their cos or sin mθ.
    fn strains(&self, m: f64) -> [[f64; 6]; 24] {
        let r = self.radius_m;
        std::array::from_fn(|unknown| {
            let n = self.values[unknown / 3];
            let [dr, dz] = self.gradients[unknown / 3];
            match unknown % 3 {
                0 => [dr, n / r, 0.0, -m * n / r, 0.0, dz],
                1 => [0.0, m * n / r, 0.0, dr - n / r, dz, 0.0],
                _ => [0.0, 0.0, dz, 0.0, -m * n / r, dr],
            }
        })
    }
}

/// Volume in m³ that a cell sweeps around the axis; NaN if it is no proper cell.
pub(super) fn volume_m3(nodes: &[[f64; 2]; 8]) -> f64 {
    points()
        .map(|(x, weight)| {
            Point::new(nodes, x).map_or(f64::NAN, |p| TAU * weight * p.det * p.radius_m)
        })
        .sum()
}

/// Shape function of the node at local coordinates `node`, at `x`.
fn shape(node: [f64; 2], x: [f64; 2]) -> f64 {
    let [p, q] = [0, 1].map(|a| 1.0 + node[a] * x[a]);
    if node[0] == 0.0 {
        0.5 * (1.0 - x[0] * x[0]) * q
    } else if node[1] == 0.0 {
        0.5 * p * (1.0 - x[1] * x[1])
    } else {
        0.25 * p * q * (node[0] * x[0] + node[1] * x[1] - 1.0)
    }
}

/// Derivatives of [`shape`] by the local coordinates.
fn shape_gradient(node: [f64; 2], x: [f64; 2]) -> [f64; 2] {
    let [p, q] = [0, 1].map(|a| 1.0 + node[a] * x[a]);
    if node[0] == 0.0 {
        [-x[0] * q, 0.5 * (1.0 - x[0] * x[0]) * node[1]]
    } else if node[1] == 0.0 {
        [0.5 * node[0] * (1.0 - x[1] * x[1]), -p * x[1]]
    } else {
        let sum = node[0] * x[0] + node[1] * x[1];
        [
            0.25 * node[0] * q * (sum - 1.0 + p),
            0.25 * node[1] * p * (sum - 1.0 + q),
        ]
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::solve::count_below;

    const STEEL: Material = Material {
        lambda_pa: 1.1e11,
        mu_pa: 8.0e10,
        density_kg_m3: 7800.0,
    };

    /// A ring of curved cells, 30 mm to 50 mm from the axis.
    fn ring() -> Meridian {
        Meridian::new(
            [2, 3],
            |_, _| true,
            |i, j| {
                let (x, y) = (0.005 * i as f64, 0.01 * j as f64);
                [0.03 + x + 0.002 * y, y + 0.1 * x]
            },
        )
    }

    fn energy(order: usize, motion: impl Fn([f64; 2]) -> [f64; 3]) -> f64 {
        let meridian = ring();
        let harmonic = Harmonic::new(&meridian, &STEEL, order).unwrap();
        let n = harmonic.pencil.unknowns();
        let mut x = vec![0.0; n];
        for (node, place) in meridian.nodes_m.iter().enumerate() {
            x[3 * node..][..3].copy_from_slice(&motion(*place));
        }
        let mut y = vec![0.0; n];
        harmonic
            .pencil
            .multiply(&harmonic.pencil.stiffness, &x, &mut y);
        0.5 * x.iter().zip(&y).map(|(x, y)| x * y).sum::<f64>()
    }

    #[test]
    fn shape_functions_are_one_at_home_and_slopes_match_differences() {
        let (x, h) = ([0.3, -0.2], 1e-6);
        for (i, &node) in CELL_NODES.iter().enumerate() {
            for (j, &at) in CELL_NODES.iter().enumerate() {
                assert!((shape(node, at) - f64::from(u8::from(i == j))).abs() < 1e-15);
            }
            let slopes = shape_gradient(node, x);
            for a in 0..2 {
                let (mut up, mut down) = (x, x);
                up[a] += h;
                down[a] -= h;
                assert!(
                    (slopes[a] - (shape(node, up) - shape(node, down)) / (2.0 * h)).abs() < 1e-9
                );
            }
        }
    }

    #[test]
    fn rigid_motions_cost_nothing_and_stretching_what_it_should() {
        let stretch = energy(0, |[_, z]| [0.0, 0.0, 1e-3 * z]);
        let volume = ring().volume_m3();
        let expected = 0.5 * (STEEL.lambda_pa + 2.0 * STEEL.mu_pa) * 1e-6 * volume;
        assert!((stretch / expected - 1.0).abs() < 1e-9);
        assert!(energy(0, |_| [0.0, 0.0, 1e-4]).abs() < 1e-12 * expected);
        assert!(energy(0, |[r, _]| [0.0, 1e-3 * r, 0.0]).abs() < 1e-12 * expected);
        assert!(energy(1, |_| [1e-4, -1e-4, 0.0]).abs() < 1e-12 * expected);
        // A turn about a diameter: u = ω × x.
        assert!(energy(1, |[r, z]| [1e-3 * z, -1e-3 * z, -1e-3 * r]).abs() < 1e-12 * expected);
    }

    #[test]
    fn a_translation_weighs_the_whole_body() {
        let meridian = ring();
        let harmonic = Harmonic::new(&meridian, &STEEL, 1).unwrap();
        let n = harmonic.pencil.unknowns();
        let mut x = vec![0.0; n];
        for node in 0..meridian.nodes_m.len() {
            (x[3 * node], x[3 * node + 1]) = (1.0, -1.0);
        }
        let mut y = vec![0.0; n];
        harmonic.pencil.multiply(&harmonic.pencil.mass, &x, &mut y);
        let mass: f64 = x.iter().zip(&y).map(|(x, y)| x * y).sum();
        let expected = STEEL.density_kg_m3 * meridian.volume_m3();
        assert!((mass / expected - 1.0).abs() < 1e-12);
    }

    /// Fewer Gauss points let motions through that cost next to nothing, more of them the finer the mesh.
    #[test]
    fn many_waves_around_a_disc_are_stiff_on_any_mesh() {
        let counted = [20, 40, 80].map(|cells| {
            let disc = Meridian::new(
                [cells, 1],
                |_, _| true,
                |i, j| [0.06 * i as f64 / (2 * cells) as f64, 0.004 * j as f64],
            );
            let pencil = Harmonic::new(&disc, &STEEL, 16).unwrap().pencil;
            count_below(&pencil, 200_000.0)
        });
        assert_eq!(counted, [counted[2]; 3]);
        assert!(counted[2] > 0);
    }

    #[test]
    fn a_cell_inside_out_is_refused() {
        let inverted = Meridian::new(
            [1, 1],
            |_, _| true,
            |i, j| [0.05 - 0.005 * i as f64, 0.01 * j as f64],
        );
        assert!(matches!(
            Harmonic::new(&inverted, &STEEL, 2),
            Err(SolveError::BadElement { index: 0 })
        ));
    }
}
