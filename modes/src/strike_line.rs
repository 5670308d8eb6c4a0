//! The line on a body's surface along which it is struck.

/// The line over the surface that the keyboard strikes, sampled at equal steps.
///
/// Position 0 is the line's first point and 1 its last.
#[derive(Clone, Debug, PartialEq)]
pub struct StrikeLine {
    /// Points on the surface, in m.
    pub points_m: Vec<[f64; 3]>,
    /// Outward unit normals at the points.
    pub normals: Vec<[f64; 3]>,
}

/// Which samples of a strike line, weighted how, give the value at a position.
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
        let last = (samples - 1) as f64;
        // NaN is not above 0, so that it too becomes the first end.
        let inside = if position > 0.0 {
            position.min(1.0)
        } else {
            0.0
        };
        let x = inside * last;
        #[expect(clippy::cast_sign_loss, reason = "x is at least 0")]
        let cell = x as usize;
        let first = cell
            .saturating_sub(Self::POINTS / 2 - 1)
            .min(samples - Self::POINTS);
        let t = x - first as f64;
        let mut weights = [1.0; Self::POINTS];
        for (i, weight) in weights.iter_mut().enumerate() {
            for j in (0..Self::POINTS).filter(|&j| j != i) {
                *weight *= (t - j as f64) / (i as f64 - j as f64);
            }
        }
        Self { first, weights }
    }
}

impl StrikeLine {
    /// Number of points.
    #[must_use]
    pub fn len(&self) -> usize {
        self.points_m.len()
    }

    /// φ·n where `stencil` says, of a mode whose displacement at the line's points is `shape`.
    ///
    /// # Panics
    ///
    /// If the stencil is none for this line, or `shape` has fewer points.
    #[must_use]
    pub fn normal_motion(&self, shape: &[[f32; 3]], stencil: &Stencil) -> f64 {
        let points = shape[stencil.first..]
            .iter()
            .zip(&self.normals[stencil.first..]);
        let motions = points.map(|(u, n)| (0..3).map(|a| f64::from(u[a]) * n[a]).sum::<f64>());
        stencil
            .weights
            .iter()
            .zip(motions)
            .map(|(weight, motion)| weight * motion)
            .sum()
    }

    /// Whether the line has no points.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.points_m.is_empty()
    }
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
    }
}
