//! A bowl: a flat base and a wall that rises to the rim, a body of revolution about the z axis.

use std::f64::consts::FRAC_PI_2;

/// A bowl's dimensions.
///
/// The outer profile runs flat from the axis to `base_radius_m`, then along a superellipse
/// ((r − base)/(rim − base))^p + (1 − z/height)^p = 1, so that p = 2 is an ellipse and more is squarer.
/// Its share t from 0 to 1 stands for the point that lies, both fractions taken as coordinates, at
/// the angle πt/2. The wall lies inside it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bowl {
    /// Outer radius of the rim, in m.
    pub rim_radius_m: f64,
    /// Radius of the flat base, in m.
    pub base_radius_m: f64,
    /// Height of the rim above the base, in m.
    pub height_m: f64,
    /// Squareness p of the wall's profile.
    pub squareness: f64,
    /// Thickness of the wall at the base, in m.
    pub base_wall_m: f64,
    /// Thickness of the wall at the rim, in m.
    pub rim_wall_m: f64,
}

impl Bowl {
    /// The same bowl with all its dimensions times `factor`.
    #[must_use]
    pub fn scaled(&self, factor: f64) -> Self {
        Self {
            rim_radius_m: factor * self.rim_radius_m,
            base_radius_m: factor * self.base_radius_m,
            height_m: factor * self.height_m,
            squareness: self.squareness,
            base_wall_m: factor * self.base_wall_m,
            rim_wall_m: factor * self.rim_wall_m,
        }
    }

    /// (r, z) in m of the outer profile at the `share` of its wall, 0 at the base and 1 at the rim.
    #[must_use]
    pub fn outer_m(&self, share: f64) -> [f64; 2] {
        let (sin, cos) = (FRAC_PI_2 * share.clamp(0.0, 1.0)).sin_cos();
        let [sin, cos] = [sin, cos].map(|x| x.max(0.0));
        let reach = sin.powf(self.squareness) + cos.powf(self.squareness);
        let stretch = reach.powf(-1.0 / self.squareness);
        let across = self.rim_radius_m - self.base_radius_m;
        [
            self.base_radius_m + across * stretch * sin,
            self.height_m * (1.0 - stretch * cos),
        ]
    }

    /// Thickness of the wall in m at the `share` of it.
    #[must_use]
    pub fn wall_m(&self, share: f64) -> f64 {
        self.base_wall_m + (self.rim_wall_m - self.base_wall_m) * share
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const BOWL: Bowl = Bowl {
        rim_radius_m: 0.09,
        base_radius_m: 0.03,
        height_m: 0.08,
        squareness: 2.5,
        base_wall_m: 0.003,
        rim_wall_m: 0.004,
    };

    #[test]
    fn the_profile_runs_from_base_to_rim() {
        assert_eq!(BOWL.outer_m(0.0), [0.03, 0.0]);
        let [r, z] = BOWL.outer_m(1.0);
        assert!((r - 0.09).abs() < 1e-12 && (z - 0.08).abs() < 1e-9);
    }
}
