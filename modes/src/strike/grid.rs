//! How the points of a strike grid lie, and the place of a strike among them.

use super::stencil::{Across, Stencil};

/// Rows of equally many points over a surface: along a row goes the position, across the rows the
/// second coordinate. A line is one row.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct StrikeGrid {
    /// Points of a row, at least [`Stencil::POINTS`].
    pub columns: usize,
    /// Rows, at least one.
    pub rows: usize,
    /// Whether the rows go around the body, the first following the last.
    pub closed: bool,
}

/// Where a strike lands on a grid.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Spot {
    along: Stencil,
    across: Across,
    columns: usize,
}

impl StrikeGrid {
    /// The place at `position` along and `across` the rows, both 0…1. Does not allocate.
    ///
    /// # Panics
    ///
    /// If there is no row or a row has fewer than [`Stencil::POINTS`] points.
    #[must_use]
    pub fn spot(self, position: f64, across: f64) -> Spot {
        Spot {
            along: Stencil::at(position, self.columns),
            across: Across::at(across, self.rows, self.closed),
            columns: self.columns,
        }
    }

    /// Position and place across of point `i`, each 0…1.
    #[must_use]
    pub fn place(self, i: usize) -> [f64; 2] {
        let (row, column) = (i / self.columns, i % self.columns);
        let steps = if self.closed {
            self.rows
        } else {
            (self.rows - 1).max(1)
        };
        [
            column as f64 / (self.columns - 1) as f64,
            row as f64 / steps as f64,
        ]
    }
}

impl Spot {
    /// The points that take part, each with its weight, row by row.
    pub fn points(&self) -> impl Iterator<Item = (usize, f64)> + '_ {
        self.across.rows().flat_map(|(row, share)| {
            let first = row * self.columns + self.along.first;
            let weights = self.along.weights.iter().enumerate();
            weights.map(move |(i, weight)| (first + i, weight * share))
        })
    }

    /// The columns that take part, each with its weight.
    pub(super) fn columns(&self) -> impl Iterator<Item = (usize, f64)> + '_ {
        (self.along.first..).zip(self.along.weights)
    }

    /// The rows that take part, each with its weight.
    pub(super) fn rows(&self) -> impl Iterator<Item = (usize, f64)> + '_ {
        self.across.rows()
    }

    /// The value here of what is `of` each point.
    pub fn value(&self, of: impl Fn(usize) -> f64) -> f64 {
        self.points().map(|(i, weight)| weight * of(i)).sum()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn points_have_their_places_and_places_their_points() {
        for (rows, closed) in [(1, false), (3, false), (5, false), (6, true)] {
            let grid = StrikeGrid {
                columns: 7,
                rows,
                closed,
            };
            for i in 0..7 * rows {
                let [position, across] = grid.place(i);
                let spot = grid.spot(position, across);
                let value = spot.value(|point| f64::from(u8::from(point == i)));
                assert!((value - 1.0).abs() < 1e-12, "{rows} {i}");
                let rest = spot.value(|point| f64::from(u8::from(point != i)));
                assert!(rest.abs() < 1e-12, "{rows} {i}");
            }
        }
    }

    #[test]
    fn one_row_is_its_stencil_to_the_bit() {
        let grid = StrikeGrid {
            columns: 9,
            rows: 1,
            closed: false,
        };
        for i in 0..=50 {
            let position = f64::from(i) / 50.0;
            let stencil = Stencil::at(position, 9);
            let expected = stencil.weights.iter().enumerate();
            let expected: Vec<_> = expected.map(|(k, w)| (stencil.first + k, *w)).collect();
            let points: Vec<_> = grid.spot(position, 0.7).points().collect();
            assert_eq!(points, expected);
        }
    }
}
