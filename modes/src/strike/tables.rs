//! Functions of one coordinate whose products are the mode shapes of a flat body.

use super::grid::{Spot, StrikeGrid};

/// Samples of functions along the rows of a strike grid, and of others across them, from which the
/// shapes of a body's modes are multiplied together: J(kr) by cos mθ on a disc, sine by sine on a
/// rectangle. The body moves along the normals of its strike line.
///
/// Samples lie closer than the points of the grid, whose every step has a whole number of them.
#[derive(Clone, Debug, PartialEq)]
pub struct ShapeTables {
    strike: StrikeGrid,
    /// Samples to a step of the strike grid along and across.
    finer: [usize; 2],
    /// The functions' values at one sample along after the other.
    along: Vec<f32>,
    /// The same across.
    across: Vec<f32>,
}

impl ShapeTables {
    /// Tables for `strike` with `finer` samples to each of its steps along and across; at one sample
    /// after the other, the values of all functions `along` and of all functions `across`. None if a
    /// grid is empty or an array does not hold the same number of functions for each sample, at least
    /// one.
    #[must_use]
    pub fn new(
        strike: StrikeGrid,
        finer: [usize; 2],
        [along, across]: [Vec<f32>; 2],
    ) -> Option<Self> {
        let samples = Self::samples_of(strike, finer)?;
        let fit = |values: &[f32], samples: usize| {
            !values.is_empty() && values.len().is_multiple_of(samples)
        };
        let whole = fit(&along, samples[0]) && fit(&across, samples[1]);
        whole.then_some(Self {
            strike,
            finer,
            along,
            across,
        })
    }

    /// Samples along and across of tables for `strike` with `finer` samples to its steps; none if there
    /// are none or more than can be counted.
    #[must_use]
    pub fn samples_of(strike: StrikeGrid, finer: [usize; 2]) -> Option<[usize; 2]> {
        let StrikeGrid {
            columns,
            rows,
            closed,
        } = strike;
        let ending = |points: usize, finer: usize| {
            let steps = points.checked_sub(1)?.checked_mul(finer)?;
            steps.checked_add(1)
        };
        let across = if closed {
            rows.checked_mul(finer[1])?
        } else {
            ending(rows, finer[1])?
        };
        let along = ending(columns, finer[0])?;
        let some = finer.iter().all(|steps| *steps > 0) && across > 0;
        some.then_some([along, across])
    }

    /// How the samples lie.
    #[must_use]
    pub fn grid(&self) -> StrikeGrid {
        let [columns, rows] = Self::samples_of(self.strike, self.finer).unwrap_or([0; 2]);
        StrikeGrid {
            columns,
            rows,
            closed: self.strike.closed,
        }
    }

    /// The strike grid that they are for.
    #[must_use]
    pub fn strike(&self) -> StrikeGrid {
        self.strike
    }

    /// Samples to a step of the strike grid along and across.
    #[must_use]
    pub fn finer(&self) -> [usize; 2] {
        self.finer
    }

    /// Number of functions along and across.
    #[must_use]
    pub fn counts(&self) -> [usize; 2] {
        let StrikeGrid { columns, rows, .. } = self.grid();
        [
            self.along.len() / columns.max(1),
            self.across.len() / rows.max(1),
        ]
    }

    /// The values along and across, of all functions at one sample after the other.
    #[must_use]
    pub fn values(&self) -> [&[f32]; 2] {
        [&self.along, &self.across]
    }

    /// Function `along` times function `across` at point `i` of the strike grid.
    ///
    /// # Panics
    ///
    /// If there is no such function or point.
    #[must_use]
    pub fn at_point(&self, [along, across]: [usize; 2], i: usize) -> f32 {
        let [columns, rows] = self.counts();
        let (row, column) = (i / self.strike.columns, i % self.strike.columns);
        self.along[self.finer[0] * column * columns + along]
            * self.across[self.finer[1] * row * rows + across]
    }

    /// The same at `place` along and across, 0…1 each. Does not allocate.
    ///
    /// # Panics
    ///
    /// If there is no such function, or there are fewer than [`super::Stencil::POINTS`] samples along.
    #[must_use]
    pub fn at(&self, [along, across]: [usize; 2], place: [f64; 2]) -> f64 {
        let spot = self.spot(place);
        let [columns, rows] = self.counts();
        let value = |table: &[f32], count: usize, number: usize, (sample, weight): (usize, f64)| {
            weight * f64::from(table[sample * count + number])
        };
        let first = spot.columns();
        let first = first.map(|at| value(&self.along, columns, along, at));
        let second = spot.rows();
        let second = second.map(|at| value(&self.across, rows, across, at));
        first.sum::<f64>() * second.sum::<f64>()
    }

    /// Writes the values of the first functions along and of the first across at `place` along and
    /// across, 0…1 each: as many as there is room for. Does not allocate.
    ///
    /// # Panics
    ///
    /// If there are fewer than [`super::Stencil::POINTS`] samples along.
    pub fn blend(&self, place: [f64; 2], [along, across]: [&mut [f64]; 2]) {
        let spot = self.spot(place);
        let [columns, rows] = self.counts();
        blend(&self.along, columns, spot.columns(), along);
        blend(&self.across, rows, spot.rows(), across);
    }

    fn spot(&self, [along, across]: [f64; 2]) -> Spot {
        self.grid().spot(along, across)
    }
}

fn blend(table: &[f32], count: usize, samples: impl Iterator<Item = (usize, f64)>, to: &mut [f64]) {
    to.fill(0.0);
    for (sample, weight) in samples {
        let there = &table[sample * count..][..count];
        for (to, value) in to.iter_mut().zip(there) {
            *to += weight * f64::from(*value);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const STRIKE: StrikeGrid = StrikeGrid {
        columns: 7,
        rows: 5,
        closed: false,
    };

    /// Two functions along, which six points give exactly, and one across, for which four do.
    fn tables(strike: StrikeGrid, finer: [usize; 2]) -> ShapeTables {
        let [along, across] = ShapeTables::samples_of(strike, finer).unwrap();
        let share = |i: usize, count: usize| i as f32 / (count - 1) as f32;
        let first = (0..along).flat_map(|i| {
            let x = share(i, along);
            [1.0 + x * x, x * x * x - 0.5]
        });
        let second = (0..across).map(|i| 2.0 - share(i, across));
        ShapeTables::new(strike, finer, [first.collect(), second.collect()]).unwrap()
    }

    #[test]
    fn products_are_those_of_the_functions() {
        let tables = tables(STRIKE, [3, 2]);
        assert_eq!(tables.counts(), [2, 1]);
        assert_eq!((tables.grid().columns, tables.grid().rows), (19, 9));
        for i in 0..=20 {
            let place = [f64::from(i) / 20.0, f64::from(20 - i) / 20.0];
            let expected = (place[0].powi(3) - 0.5) * (2.0 - place[1]);
            let found = tables.at([1, 0], place);
            assert!((found - expected).abs() < 1e-6, "{found} {expected}");
            let (mut along, mut across) = ([0.0; 2], [0.0; 1]);
            tables.blend(place, [&mut along, &mut across]);
            assert!((along[1] * across[0] - found).abs() < 1e-15);
        }
    }

    #[test]
    fn points_of_the_grid_are_samples() {
        for closed in [false, true] {
            let strike = StrikeGrid { closed, ..STRIKE };
            let tables = tables(strike, [3, 4]);
            for i in 0..35 {
                let at_point = f64::from(tables.at_point([1, 0], i));
                let between = tables.at([1, 0], strike.place(i));
                assert!((at_point - between).abs() < 1e-6, "{i}");
            }
        }
    }

    #[test]
    fn arrays_that_do_not_fit_are_none() {
        let none = |finer, lengths: [usize; 2]| {
            let values = lengths.map(|length| vec![0.0; length]);
            assert_eq!(ShapeTables::new(STRIKE, finer, values), None);
        };
        none([0, 1], [7, 5]);
        none([1, 1], [0, 5]);
        none([1, 1], [7, 6]);
        none([usize::MAX, 1], [7, 5]);
    }
}
