//! Which of equally spaced samples, weighted how, give the value between them.

/// Which samples of a line, weighted how, give the value at a position.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Stencil {
    /// Index of the first sample.
    pub first: usize,
    /// Weights of the samples from `first` on.
    pub weights: [f64; Self::POINTS],
}

impl Stencil {
    /// Samples that take part: enough that five samples to a half-wave give 3·10⁻⁴ of its height.
    pub const POINTS: usize = 6;

    /// Lagrange interpolation at `position` in 0…1 on `samples` equally spaced samples.
    ///
    /// Positions outside 0…1 (and NaN) are taken as the nearer end (NaN as 0). Does not allocate.
    ///
    /// # Panics
    ///
    /// If there are fewer than [`Self::POINTS`] samples.
    #[must_use]
    pub fn at(position: f64, samples: usize) -> Self {
        assert!(
            samples >= Self::POINTS,
            "a strike line has at least 6 points"
        );
        let x = inside(position) * (samples - 1) as f64;
        let first = first_of(x, samples, Self::POINTS);
        Self {
            first,
            weights: lagrange(x - first as f64),
        }
    }
}

/// Which rows of a grid, weighted how, give the value at a place across them.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Across {
    rows: [usize; Self::ROWS],
    weights: [f64; Self::ROWS],
    count: usize,
}

impl Across {
    /// Rows that take part at most.
    pub const ROWS: usize = 4;

    /// At `across` in 0…1 on `rows` rows: cubic on four and more, linear on two and three, the row
    /// itself on one. Rows that are `closed` go around the body, 1 being 0 again; others end at 0 and 1.
    ///
    /// Outside 0…1 closed rows go on around, others stay at the nearer end; NaN is 0. Does not
    /// allocate.
    ///
    /// # Panics
    ///
    /// If there are no rows.
    #[must_use]
    pub fn at(across: f64, rows: usize, closed: bool) -> Self {
        assert!(rows > 0, "a strike grid has at least one row");
        if rows == 1 {
            return Self {
                rows: [0; Self::ROWS],
                weights: [1.0, 0.0, 0.0, 0.0],
                count: 1,
            };
        }
        let (x, steps) = if closed {
            let turn = if across.is_finite() {
                across - across.floor()
            } else {
                0.0
            };
            (turn * rows as f64, rows + 1)
        } else {
            (inside(across) * (rows - 1) as f64, rows)
        };
        if rows < Self::ROWS {
            let first = first_of(x, steps, 2);
            let share = x - first as f64;
            return Self {
                rows: [first, (first + 1) % rows, 0, 0],
                weights: [1.0 - share, share, 0.0, 0.0],
                count: 2,
            };
        }
        if closed {
            #[expect(clippy::cast_sign_loss, reason = "x is at least 0")]
            let cell = x as usize;
            return Self {
                rows: std::array::from_fn(|i| (cell + rows - 1 + i) % rows),
                weights: lagrange(x - cell as f64 + 1.0),
                count: Self::ROWS,
            };
        }
        let first = first_of(x, rows, Self::ROWS);
        Self {
            rows: std::array::from_fn(|i| first + i),
            weights: lagrange(x - first as f64),
            count: Self::ROWS,
        }
    }

    /// The rows that take part, each with its weight.
    pub fn rows(&self) -> impl Iterator<Item = (usize, f64)> + '_ {
        let pairs = self.rows.iter().zip(&self.weights);
        pairs.take(self.count).map(|(&row, &weight)| (row, weight))
    }
}

/// `position` within 0…1. NaN is not above 0, so that it too becomes the first end.
fn inside(position: f64) -> f64 {
    if position > 0.0 {
        position.min(1.0)
    } else {
        0.0
    }
}

/// First of the `points` samples out of `samples` that are around `x`, in samples from the first.
fn first_of(x: f64, samples: usize, points: usize) -> usize {
    #[expect(clippy::cast_sign_loss, reason = "x is at least 0")]
    let cell = x as usize;
    cell.saturating_sub(points / 2 - 1).min(samples - points)
}

/// Lagrange's weights at `t`, in samples from the first.
fn lagrange<const N: usize>(t: f64) -> [f64; N] {
    let mut weights = [1.0; N];
    for (i, weight) in weights.iter_mut().enumerate() {
        for j in (0..N).filter(|&j| j != i) {
            *weight *= (t - j as f64) / (i as f64 - j as f64);
        }
    }
    weights
}

#[cfg(test)]
mod tests {
    use super::*;

    fn value(position: f64, samples: &[f64]) -> f64 {
        let stencil = Stencil::at(position, samples.len());
        stencil
            .weights
            .iter()
            .zip(&samples[stencil.first..])
            .map(|(w, s)| w * s)
            .sum()
    }

    fn across(place: f64, rows: &[f64], closed: bool) -> f64 {
        let stencil = Across::at(place, rows.len(), closed);
        stencil.rows().map(|(row, weight)| weight * rows[row]).sum()
    }

    #[test]
    fn quintics_are_exact() {
        let quintic = |x: f64| ((((2.0 * x - 3.0) * x + 0.5) * x + 1.0) * x - 4.0) * x + 7.0;
        let samples: Vec<f64> = (0..9).map(|i| quintic(f64::from(i) / 8.0)).collect();
        for i in 0..=1000 {
            let x = f64::from(i) / 1000.0;
            assert!((value(x, &samples) - quintic(x)).abs() < 1e-12, "at {x}");
        }
    }

    #[test]
    fn five_samples_to_a_half_wave_suffice() {
        let waves = 8.0 * std::f64::consts::PI;
        let samples: Vec<f64> = (0..=40)
            .map(|i| (waves * f64::from(i) / 40.0).sin())
            .collect();
        for i in 0..=1000 {
            let x = 0.1 + 0.8 * f64::from(i) / 1000.0;
            assert!((value(x, &samples) - (waves * x).sin()).abs() < 3.2e-4);
        }
    }

    #[test]
    fn outside_is_the_nearer_end() {
        let samples = [3.0, 1.0, 4.0, 1.0, 5.0, 9.0, 2.0];
        assert_eq!(value(-1.0, &samples), 3.0);
        assert_eq!(value(7.0, &samples), 2.0);
        assert_eq!(value(f64::NAN, &samples), 3.0);
        let rows = [3.0, 1.0, 4.0, 1.0, 5.0];
        assert_eq!(across(-1.0, &rows, false), 3.0);
        assert_eq!(across(2.0, &rows, false), 5.0);
        assert_eq!(across(f64::NAN, &rows, false), 3.0);
        assert_eq!(across(f64::INFINITY, &rows, true), 3.0);
    }

    #[test]
    fn rows_that_end_take_cubics_exactly_and_few_of_them_lines() {
        let cubic = |x: f64| ((2.0 * x - 3.0) * x + 0.5) * x + 1.0;
        let line = |x: f64| 3.0 - 2.0 * x;
        let rows: Vec<f64> = (0..7).map(|i| cubic(f64::from(i) / 6.0)).collect();
        let few: Vec<f64> = (0..3).map(|i| line(f64::from(i) / 2.0)).collect();
        for i in 0..=100 {
            let x = f64::from(i) / 100.0;
            assert!((across(x, &rows, false) - cubic(x)).abs() < 1e-13, "at {x}");
            assert!((across(x, &few, false) - line(x)).abs() < 1e-13, "at {x}");
            assert_eq!(across(x, &[5.0], false), 5.0);
            assert_eq!(across(x, &[5.0], true), 5.0);
        }
    }

    /// Cubic interpolation misses a wave of n samples by (2π/n)⁴ · 9/16 / 24 of its height at most.
    #[test]
    fn closed_rows_go_around() {
        let wave = |x: f64| (std::f64::consts::TAU * x + 0.3).sin();
        let rows: Vec<f64> = (0..16).map(|i| wave(f64::from(i) / 16.0)).collect();
        let bound = (std::f64::consts::TAU / 16.0).powi(4) * 9.0 / 16.0 / 24.0;
        for i in -100..=300 {
            let x = f64::from(i) / 100.0;
            assert!((across(x, &rows, true) - wave(x)).abs() < bound, "at {x}");
        }
        let three = [1.0, 2.0, 4.0];
        assert!((across(5.0 / 6.0, &three, true) - 2.5).abs() < 1e-12);
        assert_eq!(across(1.0, &three, true), 1.0);
    }
}
