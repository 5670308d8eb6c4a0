//! The pair of symmetric sparse matrices (K, M) on one pattern.

use std::sync::Arc;

/// Where the lower triangles (diagonal included) of K and M have entries, column by column.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Pattern {
    /// First entry of each column, then the number of entries.
    pub column_start: Vec<u32>,
    /// Row of each entry, rising within a column.
    pub rows: Vec<u32>,
}

impl Pattern {
    /// From the rows of each column's lower triangle, rising, diagonal included.
    pub(crate) fn from_columns(columns: &[Vec<u32>]) -> Self {
        let mut column_start = Vec::with_capacity(columns.len() + 1);
        let mut rows = Vec::with_capacity(columns.iter().map(Vec::len).sum());
        column_start.push(0);
        for column in columns {
            rows.extend_from_slice(column);
            column_start.push(u32::try_from(rows.len()).expect("fewer than 2^32 entries"));
        }
        Self { column_start, rows }
    }

    /// Number of unknowns.
    #[must_use]
    pub fn unknowns(&self) -> usize {
        self.column_start.len() - 1
    }

    /// Number of entries stored.
    #[must_use]
    pub fn entries(&self) -> usize {
        self.rows.len()
    }

    /// Entries of column `j` as a range into values and rows.
    #[must_use]
    pub fn column(&self, j: usize) -> std::ops::Range<usize> {
        self.column_start[j] as usize..self.column_start[j + 1] as usize
    }

    /// Index of the entry (`row`, `column`) of the lower triangle.
    ///
    /// # Panics
    ///
    /// If the pattern has no such entry.
    pub(crate) fn entry(&self, row: u32, column: u32) -> usize {
        let range = self.column(column as usize);
        range.start
            + self.rows[range]
                .binary_search(&row)
                .expect("elements couple only unknowns of the pattern")
    }
}

/// Kφ = λMφ: stiffness K in N/m, mass M in kg, symmetric, lower triangles stored.
#[derive(Clone, Debug, PartialEq)]
pub struct Pencil {
    /// Where K and M have entries.
    pub pattern: Arc<Pattern>,
    /// Entries of K, in N/m.
    pub stiffness: Vec<f64>,
    /// Entries of M, in kg.
    pub mass: Vec<f64>,
    /// Rigid motions that K leaves free.
    pub rigid: usize,
}

impl Pencil {
    /// Number of unknowns.
    #[must_use]
    pub fn unknowns(&self) -> usize {
        self.pattern.unknowns()
    }

    /// y ← A x for the symmetric matrix whose entries are `values`, for as many columns as `x` and
    /// `y` hold back to back.
    ///
    /// # Panics
    ///
    /// If `x` and `y` differ in length or are no whole number of columns.
    pub fn multiply(&self, values: &[f64], x: &[f64], y: &mut [f64]) {
        let n = self.unknowns();
        assert!(
            x.len() == y.len() && x.len().is_multiple_of(n),
            "whole columns"
        );
        y.fill(0.0);
        let mut xs = x.chunks_exact(4 * n);
        let mut ys = y.chunks_exact_mut(4 * n);
        for (x, y) in xs.by_ref().zip(ys.by_ref()) {
            self.multiply_add::<4>(values, x, y);
        }
        let rest = ys.into_remainder();
        for (x, y) in xs.remainder().chunks_exact(n).zip(rest.chunks_exact_mut(n)) {
            self.multiply_add::<1>(values, x, y);
        }
    }

    /// Reads each entry once for `C` columns: the matrix, not the arithmetic, is what takes time.
    fn multiply_add<const C: usize>(&self, values: &[f64], x: &[f64], y: &mut [f64]) {
        let n = self.unknowns();
        for j in 0..n {
            let range = self.pattern.column(j);
            let xj: [f64; C] = std::array::from_fn(|c| x[c * n + j]);
            let mut yj = [0.0; C];
            for (&row, &value) in self.pattern.rows[range.clone()].iter().zip(&values[range]) {
                let i = row as usize;
                if i == j {
                    for c in 0..C {
                        yj[c] += value * xj[c];
                    }
                } else {
                    for c in 0..C {
                        yj[c] += value * x[c * n + i];
                        y[c * n + i] += value * xj[c];
                    }
                }
            }
            for c in 0..C {
                y[c * n + j] += yj[c];
            }
        }
    }
}
