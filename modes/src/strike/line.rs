//! The line or the grid of lines on a body's surface along which it is struck.

use super::grid::StrikeGrid;

/// The line over the surface that the keyboard strikes, or rows of such lines side by side, sampled at
/// equal steps.
///
/// Position 0 is a row's first point and 1 its last. Rows follow each other in the arrays.
#[derive(Clone, Debug, PartialEq)]
pub struct StrikeLine {
    /// Points on the surface, in m.
    pub points_m: Vec<[f64; 3]>,
    /// Outward unit normals at the points.
    pub normals: Vec<[f64; 3]>,
    /// Rows of equally many points; 1 for a line.
    pub rows: usize,
    /// Whether the rows go around the body, the first following the last.
    pub closed: bool,
}

impl StrikeLine {
    /// A single line.
    #[must_use]
    pub fn single(points_m: Vec<[f64; 3]>, normals: Vec<[f64; 3]>) -> Self {
        Self {
            points_m,
            normals,
            rows: 1,
            closed: false,
        }
    }

    /// Number of points of all rows.
    #[must_use]
    pub fn len(&self) -> usize {
        self.points_m.len()
    }

    /// Whether the line has no points.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.points_m.is_empty()
    }

    /// How the points lie.
    #[must_use]
    pub fn grid(&self) -> StrikeGrid {
        let rows = self.rows.max(1);
        StrikeGrid {
            columns: self.len() / rows,
            rows,
            closed: self.closed,
        }
    }

    /// Position and place across, each 0…1, of the point that is nearest to `point_m`.
    #[must_use]
    pub fn nearest(&self, point_m: [f64; 3]) -> [f64; 2] {
        let square = |p: &[f64; 3]| (0..3).map(|a| (p[a] - point_m[a]).powi(2)).sum::<f64>();
        let squares = self.points_m.iter().map(square).enumerate();
        let nearest = squares.min_by(|(_, p), (_, q)| p.total_cmp(q));
        nearest.map_or([0.0; 2], |(i, _)| self.grid().place(i))
    }

    /// The same with all lengths times `factor`.
    #[must_use]
    pub fn scaled(&self, factor: f64) -> Self {
        Self {
            points_m: self
                .points_m
                .iter()
                .map(|p| p.map(|x| factor * x))
                .collect(),
            ..self.clone()
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::ModeShape;

    #[test]
    fn the_nearest_point_is_told_by_its_place() {
        let rows = 4_u8;
        let point = |i: u8| {
            let turn = std::f64::consts::TAU * f64::from(i / 6) / f64::from(rows);
            [turn.cos(), turn.sin(), f64::from(i % 6)]
        };
        let points_m: Vec<_> = (0..6 * rows).map(point).collect();
        let line = StrikeLine {
            normals: points_m.iter().map(|p| [p[0], p[1], 0.0]).collect(),
            points_m,
            rows: rows.into(),
            closed: true,
        };
        assert_eq!(line.nearest([0.1, 2.0, 3.2]), [0.6, 0.25]);
        assert_eq!(line.nearest([0.0, -2.0, 9.0]), [1.0, 0.75]);
        let shape: ModeShape = (0..6 * rows)
            .map(|i| [0.0, f32::from(i / 6), 0.0])
            .collect();
        let moved = shape.normal_motion(&line, [0.6, 0.25]);
        assert!((moved - 1.0).abs() < 1e-12);
    }
}
