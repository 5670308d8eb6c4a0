//! Where flat bodies are struck.

use super::outline::Outline;
use crate::StrikeLine;
use std::f64::consts::FRAC_1_SQRT_2;

/// Samples along a row to each half-wave of the shortest mode.
const ALONG_TO_HALF_WAVE: f64 = 4.0;

/// Rows to each wave of it across, between which is interpolated by cubics.
const ROWS_TO_WAVE: f64 = 6.0;

/// Samples of a table across to each half-wave, of which four are taken together: they are right to two
/// thousandths of its height.
const TABLED_TO_HALF_WAVE: f64 = 6.0;

/// Fewest samples of a row.
const FEWEST: usize = 33;

/// How the points of a body's strike grid lie.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Grid {
    /// Where position 0 lies, as a share of the way.
    pub(super) start: f64,
    /// Where the first row lies across.
    pub(super) aside: f64,
    /// Whether the ways along and across go over the edge and on from the other, where the body rests
    /// on both: any point is reached, and position 0 is where it is usually struck.
    pub(super) wraps: bool,
    /// Whether positions rise against the way.
    pub(super) backwards: bool,
    /// Points of a row, and rows.
    pub(super) columns: usize,
    pub(super) rows: usize,
}

impl Grid {
    /// The same line from the other end.
    pub(super) fn reversed(self) -> Self {
        Self {
            start: 1.0,
            backwards: true,
            ..self
        }
    }

    /// The points, row by row, in m in the frame of the closed form.
    pub(super) fn points_m(&self, outline: Outline) -> Vec<[f64; 2]> {
        (0..self.rows)
            .flat_map(|row| (0..self.columns).map(move |column| (row, column)))
            .map(|(row, column)| {
                let along = column as f64 / (self.columns - 1) as f64;
                if let Outline::Disc { radius_m } = outline {
                    return self.spoke_m(radius_m, along, row);
                }
                let across = row as f64 / (self.rows.max(2) - 1) as f64;
                outline
                    .place([self.on(self.start, along), self.on(self.aside, across)])
                    .0
            })
            .collect()
    }

    /// The first coordinate of a point so far along, 0…1: on a disc the distance from the middle as a share of
    /// the radius, below 0 beyond it; else the share of the way.
    pub(super) fn first(&self, outline: Outline, along: f64) -> f64 {
        match outline {
            Outline::Disc { .. } => self.start - (1.0 + self.start) * along,
            _ => self.on(self.start, along),
        }
    }

    /// The second coordinate of a point so far across, 0…1: on a disc the turn; else the share of the way.
    pub(super) fn second(&self, outline: Outline, across: f64) -> f64 {
        match outline {
            Outline::Disc { .. } => across,
            _ => self.on(self.aside, across),
        }
    }

    /// On a disc rows go through the middle and turn about it.
    fn spoke_m(&self, radius_m: f64, along: f64, row: usize) -> [f64; 2] {
        let (sin, cos) = (std::f64::consts::TAU * row as f64 / self.rows as f64).sin_cos();
        let r_m = radius_m * self.first(Outline::Disc { radius_m }, along);
        [r_m * cos, r_m * sin]
    }

    fn on(&self, start: f64, way: f64) -> f64 {
        let at = if self.backwards {
            start - way
        } else {
            start + way
        };
        if self.wraps && at > 1.0 { at - 1.0 } else { at }
    }

    /// The grid as a strike line, its middle at the origin.
    pub(super) fn line(&self, outline: Outline) -> StrikeLine {
        let [x, y] = outline.middle_m();
        let points = self.points_m(outline);
        StrikeLine {
            normals: vec![[0.0, 0.0, 1.0]; points.len()],
            points_m: points
                .into_iter()
                .map(|p| [p[0] - x, p[1] - y, 0.0])
                .collect(),
            rows: self.rows,
            closed: matches!(outline, Outline::Disc { .. }),
        }
    }
}

/// Counts along and across `half_waves` each way, at least `fewest`.
fn counts([along, across]: [f64; 2]) -> [usize; 2] {
    #[expect(clippy::cast_sign_loss, reason = "counts of waves are positive")]
    let count = |x: f64| x.ceil() as usize + 1;
    [
        count(ALONG_TO_HALF_WAVE * along).max(FEWEST),
        count(0.5 * ROWS_TO_WAVE * across).max(5),
    ]
}

/// A line from `start` of the way.
pub(super) fn single(half_waves: f64, start: f64, wraps: bool) -> Grid {
    let [columns, _] = counts([half_waves, 0.0]);
    Grid {
        start: whole_steps(start, columns),
        aside: 0.0,
        wraps,
        backwards: false,
        columns,
        rows: 1,
    }
}

/// Rows over a film that is held all around, from a third of its length and two fifths of its width.
pub(super) fn film(half_waves: [f64; 2]) -> Grid {
    spread(counts(half_waves))
}

/// Points on a film whose shapes are told between them by tables: enough to draw it by, and so many that the
/// first of them, where it is usually struck, lies on no node line of any but a few modes.
pub(super) fn coarse() -> Grid {
    spread([43, 32])
}

/// As many columns and rows over a film.
fn spread([columns, rows]: [usize; 2]) -> Grid {
    Grid {
        start: whole_steps(0.3, columns),
        aside: whole_steps(0.4, rows),
        wraps: true,
        backwards: false,
        columns,
        rows,
    }
}

/// The same on a disc: rows about its middle, from two thirds of the radius.
pub(super) fn spokes() -> Grid {
    Grid {
        start: FRAC_1_SQRT_2,
        aside: 0.0,
        wraps: false,
        backwards: false,
        columns: 41,
        rows: 48,
    }
}

/// Samples to a step of `grid` for so many half-waves along and across it, across a disc around it.
pub(super) fn finer(grid: &Grid, [along, across]: [f64; 2], closed: bool) -> [usize; 2] {
    #[expect(clippy::cast_sign_loss, reason = "counts of waves are positive")]
    let whole = |samples: f64, steps: usize| (samples / steps as f64).ceil().max(1.0) as usize;
    let turns = if closed { grid.rows } else { grid.rows - 1 };
    [
        whole(ALONG_TO_HALF_WAVE * along, grid.columns - 1),
        whole(TABLED_TO_HALF_WAVE * across, turns),
    ]
}

/// The share nearest to `start` that is a whole number of steps, so that a sample falls on the edge.
fn whole_steps(start: f64, samples: usize) -> f64 {
    let steps = (samples - 1) as f64;
    (start * steps).round() / steps
}
