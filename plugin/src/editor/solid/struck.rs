//! Which place of the strike grid a point of the surface is struck as, and where a place is.

use super::nearest::Finder;
use super::{Solid, Vector, add, between, dot, unit};
use modes::StrikeGrid;

/// Where a blow lands.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Place {
    /// Along the strike line, 0…1.
    pub along: f32,
    /// Across the lines, 0…1; nothing on a body struck wherever that is set.
    pub across: Option<f32>,
}

/// The strike grid as it is drawn: rows of points.
#[derive(Clone, Debug)]
pub(super) struct Lines {
    pub(super) points_m: Vec<Vector>,
    pub(super) normals: Vec<Vector>,
    pub(super) grid: StrikeGrid,
    finder: Finder,
}

impl Lines {
    pub(super) fn of(line: &modes::StrikeLine) -> Self {
        let single = |v: &[f64; 3]| v.map(|x| x as f32);
        let points_m: Vec<Vector> = line.points_m.iter().map(single).collect();
        Self {
            finder: Finder::of(&points_m),
            points_m,
            normals: line.normals.iter().map(single).collect(),
            grid: line.grid(),
        }
    }

    /// The row after `row`, as far as there is one, or the one before.
    fn beside(&self, row: usize, after: bool) -> usize {
        let rows = self.grid.rows;
        match (after, self.grid.closed) {
            (true, true) => (row + 1) % rows,
            (false, true) => (row + rows - 1) % rows,
            (true, false) => (row + 1).min(rows - 1),
            (false, false) => row.saturating_sub(1),
        }
    }

    /// The nearest place: that of the nearest point, and on from it as far as the way to its neighbours
    /// tells.
    fn nearest(&self, point: Vector) -> [f32; 2] {
        let nearest = self.finder.nearest(&self.points_m, point);
        let (Some(nearest), StrikeGrid { columns, rows, .. }) = (nearest, self.grid) else {
            return [0.0; 2];
        };
        let (row, column) = (nearest / columns, nearest % columns);
        let apart = add(point, -1.0, self.points_m[nearest]);
        let step = |from: [usize; 2], to: [usize; 2]| {
            let at = |[row, column]: [usize; 2]| self.points_m[row * columns + column];
            let way = add(at(to), -1.0, at(from));
            let steps = if from == [row, column] || to == [row, column] {
                1.0
            } else {
                2.0
            };
            let long = dot(way, way);
            if long > 0.0 {
                (steps * dot(apart, way) / long).clamp(-0.5, 0.5)
            } else {
                0.0
            }
        };
        let along = step(
            [row, column.saturating_sub(1)],
            [row, (column + 1).min(columns - 1)],
        );
        let across = step(
            [self.beside(row, false), column],
            [self.beside(row, true), column],
        );
        let [first, second] = self.grid.place(nearest).map(|x| x as f32);
        let last = (columns - 1).max(1) as f32;
        let along = (first + along / last).clamp(0.0, 1.0);
        if self.grid.closed {
            return [along, (second + across / rows as f32).rem_euclid(1.0)];
        }
        let last = (rows - 1).max(1) as f32;
        [along, (second + across / last).clamp(0.0, 1.0)]
    }

    /// Between the four points around a place.
    fn at(&self, [along, across]: [f32; 2]) -> (Vector, Vector) {
        let StrikeGrid {
            columns,
            rows,
            closed,
        } = self.grid;
        if columns < 2 || self.points_m.len() < columns * rows {
            return Default::default();
        }
        let (column, right) = cell(along, columns - 1);
        let steps = if closed { rows } else { rows - 1 };
        let turn = if closed {
            across.rem_euclid(1.0)
        } else {
            across
        };
        let (row, down) = if steps == 0 {
            (0, 0.0)
        } else {
            cell(turn, steps)
        };
        let other = self.beside(row, true);
        let mean = |of: &[Vector]| {
            let in_row = |row: usize| {
                let first = row * columns + column;
                between(of[first], of[first + 1], right)
            };
            between(in_row(row), in_row(other), down)
        };
        (mean(&self.points_m), unit(mean(&self.normals)))
    }
}

/// Of `steps` equal steps, that in which a share of the way 0…1 ends, and how far into it.
fn cell(share: f32, steps: usize) -> (usize, f32) {
    let x = share.clamp(0.0, 1.0) * steps as f32;
    #[expect(clippy::cast_sign_loss, reason = "shares are not negative")]
    let cell = (x as usize).min(steps - 1);
    (cell, x - cell as f32)
}

impl Solid {
    /// What a blow on each of the points counts as: along and across the strike grid, 0…1.
    #[must_use]
    pub(crate) fn places_struck(&self) -> Vec<[f32; 2]> {
        if self.places.is_empty() {
            let points = self.points_m.iter();
            return points.map(|point| self.lines.nearest(*point)).collect();
        }
        self.places.iter().map(|along| [*along, 0.0]).collect()
    }

    /// What a blow on a triangle counts as, at a point with these shares of the corners.
    #[must_use]
    pub(crate) fn struck_as(&self, point_m: Vector, triangle: usize, shares: [f32; 3]) -> Place {
        if self.places.is_empty() {
            let [along, across] = self.lines.nearest(point_m);
            return Place {
                along,
                across: (self.lines.grid.rows > 1).then_some(across),
            };
        }
        let corners = self.triangles[triangle].iter().zip(shares);
        let along: f32 = corners
            .map(|(i, share)| share * self.places[*i as usize])
            .sum();
        Place {
            along: along.clamp(0.0, 1.0),
            across: None,
        }
    }

    /// The point in m and the normal at a place along and across the strike grid, each 0…1.
    #[must_use]
    pub fn at(&self, place: [f32; 2]) -> (Vector, Vector) {
        self.lines.at(place)
    }
}
