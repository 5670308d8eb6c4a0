//! One knob's worth of curvature.

/// Greatest slope at an end of a curve; the least is its inverse.
const STEEPEST: f64 = 8.0;

/// A monotone curve through (−1, −1), (0, 0) and (1, 1), odd about the middle.
///
/// y = x/(|x| + (1 − |x|)r) on each side: one division, and no power (Schlick, Fast Alternatives to
/// Perlin's Bias and Gain Functions, Graphics Gems IV, 1994). The curve of −c undoes the curve of c.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Curve {
    ratio: f64,
}

impl Curve {
    /// The straight line.
    pub const STRAIGHT: Self = Self { ratio: 1.0 };

    /// The curve of `bend` −1…1: 0 is straight, above 0 small values count for more (1 makes 8/9 of a
    /// half), below 0 for less (−1 makes 1/9 of it). What is no number is straight.
    #[must_use]
    pub fn new(bend: f64) -> Self {
        let most = (STEEPEST - 1.0) / (STEEPEST + 1.0);
        let bend = most * super::tame::bipolar(bend);
        Self {
            ratio: (1.0 - bend) / (1.0 + bend),
        }
    }

    /// Its value at `x` −1…1.
    #[must_use]
    pub fn at(self, x: f64) -> f64 {
        let size = x.abs();
        x / (size + (1.0 - size) * self.ratio)
    }
}

#[cfg(test)]
mod tests {
    use super::Curve;

    fn steps() -> impl Iterator<Item = f64> {
        (-100..=100).map(|i| f64::from(i) / 100.0)
    }

    #[test]
    fn ends_and_middle_stay_and_half_is_as_stated() {
        for bend in steps() {
            let curve = Curve::new(bend);
            assert_eq!([-1.0, 0.0, 1.0].map(|x| curve.at(x)), [-1.0, 0.0, 1.0]);
            assert_eq!(curve.at(0.3), -curve.at(-0.3));
        }
        assert!((Curve::new(1.0).at(0.5) - 8.0 / 9.0).abs() < 1e-15);
        assert!((Curve::new(-1.0).at(0.5) - 1.0 / 9.0).abs() < 1e-15);
        for x in steps() {
            assert_eq!(Curve::new(0.0).at(x), x);
        }
    }

    #[test]
    fn they_rise_all_the_way_with_the_stated_slopes() {
        for bend in steps() {
            let curve = Curve::new(bend);
            let values: Vec<f64> = steps().map(|x| curve.at(x)).collect();
            assert!(values.windows(2).all(|pair| pair[0] < pair[1]), "{bend}");
        }
        let slope = |bend: f64, x: f64| Curve::new(bend).at(x) / x;
        assert!((slope(1.0, 1e-9) - 8.0).abs() < 1e-6);
        assert!((slope(-1.0, 1e-9) - 0.125).abs() < 1e-8);
    }

    #[test]
    fn the_opposite_curve_undoes_it() {
        for bend in steps() {
            for x in steps() {
                let back = Curve::new(-bend).at(Curve::new(bend).at(x));
                assert!((back - x).abs() < 1e-14, "{bend} at {x}");
            }
        }
    }

    #[test]
    fn nonsense_is_straight_or_as_bent_as_can_be() {
        assert_eq!(Curve::new(f64::NAN), Curve::STRAIGHT);
        assert_eq!(Curve::new(f64::INFINITY), Curve::new(1.0));
        assert_eq!(Curve::new(-7.0), Curve::new(-1.0));
    }
}
