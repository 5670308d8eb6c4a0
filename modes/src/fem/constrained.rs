//! Unknowns held at zero: clamps, and the planes of symmetry of part of a body.

use super::pencil::{Pattern, Pencil};
use std::sync::Arc;

/// The pencil of the unknowns that are left when others are held at zero.
#[derive(Clone, Debug, PartialEq)]
pub struct Constrained {
    /// K and M of the unknowns that are left.
    pub pencil: Pencil,
    /// Which unknown of the free pencil each of them is, rising.
    kept: Vec<u32>,
    /// Unknowns of the free pencil.
    unknowns: usize,
}

impl Constrained {
    /// What is left of `free` with the unknowns for which `keep` is false held at zero; unknown
    /// 3·node + axis of a volume mesh. `rigid` motions must be left.
    #[must_use]
    pub fn new(free: &Pencil, rigid: usize, keep: impl Fn(usize) -> bool) -> Self {
        const HELD: u32 = u32::MAX;
        let unknowns = free.unknowns();
        let mut reduced = vec![HELD; unknowns];
        let mut kept = Vec::with_capacity(unknowns);
        for unknown in (0..unknowns).filter(|&unknown| keep(unknown)) {
            reduced[unknown] = number(kept.len());
            kept.push(number(unknown));
        }
        let (mut columns, mut stiffness, mut mass) = (Vec::new(), Vec::new(), Vec::new());
        for &unknown in &kept {
            let mut column = Vec::new();
            for at in free.pattern.column(unknown as usize) {
                let row = reduced[free.pattern.rows[at] as usize];
                if row != HELD {
                    column.push(row);
                    stiffness.push(free.stiffness[at]);
                    mass.push(free.mass[at]);
                }
            }
            columns.push(column);
        }
        Self {
            pencil: Pencil {
                pattern: Arc::new(Pattern::from_columns(&columns)),
                stiffness,
                mass,
                rigid,
            },
            kept,
            unknowns,
        }
    }

    /// `vector` of the unknowns left as one of all unknowns, zero where they are held.
    #[must_use]
    pub fn expand(&self, vector: &[f64]) -> Vec<f64> {
        let mut all = vec![0.0; self.unknowns];
        for (&unknown, value) in self.kept.iter().zip(vector) {
            all[unknown as usize] = *value;
        }
        all
    }
}

fn number(index: usize) -> u32 {
    u32::try_from(index).expect("pencils have fewer than 2^32 unknowns")
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Material;
    use crate::fem::{TetMass, assemble};
    use crate::mesh::{BarGrid, BarPart, bar_hex20};
    use crate::shape::Bar;
    use crate::solve::lowest;

    #[test]
    fn a_clamped_bar_is_a_cantilever() {
        // No Poisson effect at the clamp.
        let material = Material::from_young(70e9, 0.0, 2700.0).unwrap();
        let bar = Bar::uniform(0.5, 0.01, 0.005);
        let grid = BarGrid {
            along: 20,
            across: 1,
            through: 1,
        };
        let mesh = bar_hex20(&bar, grid, BarPart::Whole);
        let free = assemble(&mesh, &material, TetMass::Consistent).unwrap();
        let end_m = -0.5 * bar.length_m;
        let clamped = Constrained::new(&free, 0, |unknown| mesh.nodes[unknown / 3][0] != end_m);
        // 1.875104² √(EI/ρA) / 2πL² (Blevins 1979, table 8-1); I/A = t²/12.
        let speed = (material.young_pa() / material.density_kg_m3 / 12.0).sqrt();
        let expected = 1.875_104f64.powi(2) * speed * bar.thickness_m
            / (std::f64::consts::TAU * bar.length_m.powi(2));
        let error = lowest(&clamped.pencil, 0).unwrap() / expected - 1.0;
        assert!(error.abs() < 2e-4, "{error:e}");
        let vector = clamped.expand(&vec![1.0; clamped.pencil.unknowns()]);
        assert_eq!(vector.len(), free.unknowns());
        let held = vector.iter().filter(|u| **u == 0.0).count();
        assert_eq!(held, free.unknowns() - clamped.pencil.unknowns());
    }
}
