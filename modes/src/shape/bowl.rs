//! A bowl: a flat base and a wall that rises to the rim, a body of revolution about the z axis.

use std::f64::consts::FRAC_PI_2;

/// A bowl's dimensions.
///
/// The outer profile runs flat from the axis to `base_radius_m`, then along a superellipse: with t
/// from 0 to 1, r = base + (rim − base) sin^(2/p)(πt/2), z = height (1 − cos^(2/p)(πt/2)), so that
/// p = 2 is an ellipse and more is squarer. The wall lies inside it.
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

/// Why a profile is none of a bowl.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum ProfileError {
    /// A dimension out of its range.
    #[error("{field} is {value} m, but must be {allowed}")]
    Dimension {
        /// The field.
        field: &'static str,
        /// What it is, in m.
        value: f64,
        /// What it may be.
        allowed: String,
    },
    /// The wall's inside folds over itself.
    #[error(
        "the wall runs into itself {place:.0} % of the way from the base to the rim: it must be \
         thinner than {limit_m:.4} m there (base_wall_m, rim_wall_m)"
    )]
    Folded {
        /// Share of the way from base to rim, in %.
        place: f64,
        /// Radius of curvature there, in m.
        limit_m: f64,
    },
}

/// Points of the profile that are looked at for folds.
const LOOKS: usize = 400;

impl Bowl {
    /// Whether the profile is that of a bowl.
    ///
    /// # Errors
    ///
    /// [`ProfileError`] with what would work.
    pub fn check(&self) -> Result<(), ProfileError> {
        let dimension = |field, value: f64, low: f64, high: f64| {
            if value > low && value < high {
                return Ok(());
            }
            let allowed = format!("above {low} and below {high}");
            Err(ProfileError::Dimension {
                field,
                value,
                allowed,
            })
        };
        dimension("rim_radius_m", self.rim_radius_m, 0.0, 2.0)?;
        dimension("base_radius_m", self.base_radius_m, 0.0, self.rim_radius_m)?;
        dimension("height_m", self.height_m, 0.0, 4.0)?;
        let thickest = 0.5 * self.height_m.min(self.rim_radius_m);
        dimension("base_wall_m", self.base_wall_m, 0.0, thickest)?;
        dimension("rim_wall_m", self.rim_wall_m, 0.0, thickest)?;
        let points: Vec<[f64; 2]> = (0..=LOOKS)
            .map(|i| self.outer_m(i as f64 / LOOKS as f64))
            .collect();
        for (i, three) in points.windows(3).enumerate() {
            let share = (i + 1) as f64 / LOOKS as f64;
            let limit_m = radius_of_curvature_m(three);
            if self.wall_m(share) >= limit_m {
                return Err(ProfileError::Folded {
                    place: 100.0 * share,
                    limit_m,
                });
            }
        }
        Ok(())
    }

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
        let power = 2.0 / self.squareness;
        let across = self.rim_radius_m - self.base_radius_m;
        [
            self.base_radius_m + across * sin.max(0.0).powf(power),
            self.height_m * (1.0 - cos.max(0.0).powf(power)),
        ]
    }

    /// Thickness of the wall in m at the `share` of it.
    #[must_use]
    pub fn wall_m(&self, share: f64) -> f64 {
        self.base_wall_m + (self.rim_wall_m - self.base_wall_m) * share
    }
}

/// Radius in m of the circle through three points.
fn radius_of_curvature_m(points: &[[f64; 2]]) -> f64 {
    let side =
        |i: usize, j: usize| (points[i][0] - points[j][0]).hypot(points[i][1] - points[j][1]);
    let [p, q, r] = [points[0], points[1], points[2]];
    let area = 0.5 * ((q[0] - p[0]) * (r[1] - p[1]) - (r[0] - p[0]) * (q[1] - p[1]));
    // Only where it bends towards the inside, to the left on the way up.
    if area <= 0.0 {
        return f64::INFINITY;
    }
    side(0, 1) * side(1, 2) * side(2, 0) / (4.0 * area)
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
        assert_eq!(BOWL.check(), Ok(()));
        assert_eq!(BOWL.outer_m(0.0), [0.03, 0.0]);
        let [r, z] = BOWL.outer_m(1.0);
        assert!((r - 0.09).abs() < 1e-12 && (z - 0.08).abs() < 1e-9);
    }

    #[test]
    fn impossible_profiles_say_what_would_do() {
        let wide = Bowl {
            base_radius_m: 0.1,
            ..BOWL
        };
        let error = wide.check().unwrap_err().to_string();
        assert_eq!(
            error,
            "base_radius_m is 0.1 m, but must be above 0 and below 0.09"
        );
        let thick = Bowl {
            squareness: 9.0,
            base_wall_m: 0.03,
            ..BOWL
        };
        assert!(matches!(thick.check(), Err(ProfileError::Folded { .. })));
        let nothing = Bowl {
            height_m: f64::NAN,
            ..BOWL
        };
        assert!(nothing.check().is_err());
    }
}
