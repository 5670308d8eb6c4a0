//! Products of K and M with panels.

use super::panel::{Kernel, rows, rows_mut, run};
use crate::fem::Pencil;
use pulp::Simd;

/// M in the order of a factor, row by row, without the zeros that it stores where K has entries.
pub(super) struct Mass {
    row_start: Vec<usize>,
    columns: Vec<u32>,
    values: Vec<f64>,
}

impl Mass {
    /// `place` is where the factor puts each unknown.
    pub(super) fn new(pencil: &Pencil, place: &[u32]) -> Self {
        let n = pencil.unknowns();
        let each = |visit: &mut dyn FnMut(usize, usize, f64)| {
            for j in 0..n {
                for at in pencil.pattern.column(j) {
                    let (i, value) = (pencil.pattern.rows[at] as usize, pencil.mass[at]);
                    if value != 0.0 {
                        visit(i, j, value);
                        if i != j {
                            visit(j, i, value);
                        }
                    }
                }
            }
        };
        let mut row_start = vec![0; n + 1];
        each(&mut |i, _, _| row_start[place[i] as usize + 1] += 1);
        for i in 0..n {
            row_start[i + 1] += row_start[i];
        }
        let mut next = row_start.clone();
        let (mut columns, mut values) = (vec![0; row_start[n]], vec![0.0; row_start[n]]);
        each(&mut |i, j, value| {
            let at = &mut next[place[i] as usize];
            (columns[*at], values[*at]) = (place[j], value);
            *at += 1;
        });
        Self {
            row_start,
            columns,
            values,
        }
    }

    /// `product` ← M X for the panel `x`.
    pub(super) fn multiply(&self, x: &[f64], product: &mut [f64]) {
        run(Multiply {
            matrix: self,
            x,
            product,
        });
    }
}

struct Multiply<'a> {
    matrix: &'a Mass,
    x: &'a [f64],
    product: &'a mut [f64],
}

impl Kernel for Multiply<'_> {
    #[inline(always)]
    fn run<S: Simd, const N: usize>(self, simd: S) {
        let x = rows::<S, N>(self.x);
        let matrix = self.matrix;
        for (row, bounds) in rows_mut::<S, N>(self.product)
            .iter_mut()
            .zip(matrix.row_start.windows(2))
        {
            let entries = bounds[0]..bounds[1];
            let mut sum = [simd.splat_f64s(0.0); N];
            for (&j, &value) in matrix.columns[entries.clone()]
                .iter()
                .zip(&matrix.values[entries])
            {
                let value = simd.splat_f64s(value);
                for v in 0..N {
                    sum[v] = simd.mul_add_e_f64s(value, x[j as usize][v], sum[v]);
                }
            }
            *row = sum;
        }
    }
}

/// `forces` ← K X and `inertias` ← M X for the panel `x` in the pencil's own order.
pub(super) fn forces_and_inertias(
    pencil: &Pencil,
    x: &[f64],
    forces: &mut [f64],
    inertias: &mut [f64],
) {
    forces.fill(0.0);
    inertias.fill(0.0);
    run(Both {
        pencil,
        x,
        forces,
        inertias,
    });
}

struct Both<'a> {
    pencil: &'a Pencil,
    x: &'a [f64],
    forces: &'a mut [f64],
    inertias: &'a mut [f64],
}

impl Kernel for Both<'_> {
    #[inline(always)]
    fn run<S: Simd, const N: usize>(self, simd: S) {
        let x = rows::<S, N>(self.x);
        let forces = rows_mut::<S, N>(self.forces);
        let inertias = rows_mut::<S, N>(self.inertias);
        let Pencil {
            pattern,
            stiffness,
            mass,
            ..
        } = self.pencil;
        for j in 0..x.len() {
            let (mut force, mut inertia) = (forces[j], inertias[j]);
            for at in pattern.column(j) {
                let i = pattern.rows[at] as usize;
                let k = simd.splat_f64s(stiffness[at]);
                for v in 0..N {
                    force[v] = simd.mul_add_e_f64s(k, x[i][v], force[v]);
                    if i != j {
                        forces[i][v] = simd.mul_add_e_f64s(k, x[j][v], forces[i][v]);
                    }
                }
                // Most of M is zero: it does not couple directions.
                if mass[at] == 0.0 {
                    continue;
                }
                let m = simd.splat_f64s(mass[at]);
                for v in 0..N {
                    inertia[v] = simd.mul_add_e_f64s(m, x[i][v], inertia[v]);
                    if i != j {
                        inertias[i][v] = simd.mul_add_e_f64s(m, x[j][v], inertias[i][v]);
                    }
                }
            }
            (forces[j], inertias[j]) = (force, inertia);
        }
    }
}
