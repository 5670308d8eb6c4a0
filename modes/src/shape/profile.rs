//! Which profiles are those of a bowl, and what would do instead of those that are not.

use super::Bowl;

/// Why a profile is none of a bowl.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[error("{field} is {value}, but must be {allowed}")]
pub struct ProfileError {
    /// The dimension, by its name in [`Bowl`].
    pub field: &'static str,
    /// What it is, in m but for the squareness.
    pub value: f64,
    /// What it may be.
    pub allowed: String,
}

/// Squareness of profiles: below 2 they have a corner at the base, in which a wall folds.
const SQUARENESS: [f64; 2] = [2.0, 10.0];

/// Radii of the rim in thicknesses of the wall: a thinner one bends so much more easily than it stretches
/// that rounding decides.
const THINNEST: f64 = 200.0;

/// Points of the profile that are looked at for folds.
const LOOKS: usize = 400;

/// Where a wall bends, its inside may be so much shorter than its outside: cells keep their shape.
const SHORTEST: f64 = 0.2;

impl Bowl {
    /// Whether the profile is that of a bowl.
    ///
    /// # Errors
    ///
    /// [`ProfileError`] with what would work.
    pub fn check(&self) -> Result<(), ProfileError> {
        self.check_dimensions()?;
        let folded = |share| Err(self.folded(share));
        self.fold().map_or(Ok(()), folded)
    }

    fn check_dimensions(&self) -> Result<(), ProfileError> {
        within("rim_radius_m", self.rim_radius_m, [0.0, 2.0])?;
        within(
            "base_radius_m",
            self.base_radius_m,
            [0.0, self.rim_radius_m],
        )?;
        within("height_m", self.height_m, [0.0, 4.0])?;
        let [least, most] = SQUARENESS;
        if !(least..=most).contains(&self.squareness) {
            let allowed = format!("{least} to {most}");
            return Err(error("squareness", self.squareness, allowed));
        }
        let walls_m = [
            self.rim_radius_m / THINNEST,
            0.5 * self.height_m.min(self.rim_radius_m),
        ];
        within("base_wall_m", self.base_wall_m, walls_m)?;
        within("rim_wall_m", self.rim_wall_m, walls_m)
    }

    /// Where the wall's inside runs backwards, or nearly so, as a share of the way up.
    fn fold(&self) -> Option<f64> {
        let share = |i: usize| i as f64 / LOOKS as f64;
        let outer: Vec<[f64; 2]> = (0..=LOOKS).map(|i| self.outer_m(share(i))).collect();
        let inner = outer.windows(3).enumerate().map(|(i, three)| {
            let [dr, dz] = step(three[0], three[2]);
            let depth = self.wall_m(share(i + 1)) / dr.hypot(dz);
            [three[1][0] - dz * depth, three[1][1] + dr * depth]
        });
        let inner: Vec<[f64; 2]> = inner.collect();
        let sides = inner.windows(2).zip(outer[1..].windows(2));
        let folds = |(inner, outer): (&[[f64; 2]], &[[f64; 2]])| {
            let (inside, outside) = (step(inner[0], inner[1]), step(outer[0], outer[1]));
            let along = inside[0] * outside[0] + inside[1] * outside[1];
            along < SHORTEST * (outside[0].powi(2) + outside[1].powi(2))
        };
        sides
            .map(folds)
            .position(|folds| folds)
            .map(|i| share(i + 1))
    }

    /// What is wrong with a wall that folds at `share` of the way up, and which thinner walls, narrower base
    /// or greater height would do.
    fn folded(&self, share: f64) -> ProfileError {
        let thinner = |factor: f64| Self {
            base_wall_m: factor * self.base_wall_m,
            rim_wall_m: factor * self.rim_wall_m,
            ..*self
        };
        let narrower = |factor: f64| Self {
            base_radius_m: factor * self.base_radius_m,
            ..*self
        };
        let taller = |factor: f64| Self {
            height_m: self.height_m / factor,
            ..*self
        };
        let place = 100.0 * share;
        let mut allowed = format!("less: the wall runs into itself {place:.0} % of the way up");
        if let Some(bowl) = nearest(thinner) {
            let [base_m, rim_m] = [bowl.base_wall_m, bowl.rim_wall_m];
            allowed +=
                &format!("; base_wall_m = {base_m:.5} with rim_wall_m = {rim_m:.5} would do");
        }
        if let Some(bowl) = nearest(narrower) {
            allowed += &format!("; base_radius_m = {:.5} would do", bowl.base_radius_m);
        }
        if let Some(bowl) = nearest(taller) {
            allowed += &format!("; height_m = {:.5} would do", bowl.height_m);
        }
        if share < 0.5 {
            error("base_wall_m", self.base_wall_m, allowed)
        } else {
            error("rim_wall_m", self.rim_wall_m, allowed)
        }
    }
}

fn step(from: [f64; 2], to: [f64; 2]) -> [f64; 2] {
    [to[0] - from[0], to[1] - from[1]]
}

/// The bowl of the greatest factor below 1, a whole number of hundredths, that passes.
fn nearest(bowl: impl Fn(f64) -> Bowl) -> Option<Bowl> {
    let bowls = (1..100).rev().map(|i| bowl(f64::from(i) / 100.0));
    bowls
        .filter(|bowl| bowl.check_dimensions().is_ok())
        .find(|bowl| bowl.fold().is_none())
}

fn error(field: &'static str, value: f64, allowed: String) -> ProfileError {
    ProfileError {
        field,
        value,
        allowed,
    }
}

fn within(field: &'static str, value: f64, [low, high]: [f64; 2]) -> Result<(), ProfileError> {
    if value > low && value < high {
        return Ok(());
    }
    let allowed = format!("above {low} and below {high}");
    Err(error(field, value, allowed))
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
    fn what_is_out_of_range_is_told_with_the_range() {
        assert_eq!(BOWL.check(), Ok(()));
        let cases = [
            (
                Bowl {
                    base_radius_m: 0.1,
                    ..BOWL
                },
                "base_radius_m is 0.1, but must be above 0 and below 0.09",
            ),
            (
                Bowl {
                    height_m: f64::NAN,
                    ..BOWL
                },
                "height_m is NaN, but must be above 0 and below 4",
            ),
            (
                Bowl {
                    squareness: 1.5,
                    ..BOWL
                },
                "squareness is 1.5, but must be 2 to 10",
            ),
            (
                Bowl {
                    rim_wall_m: -0.004,
                    ..BOWL
                },
                "rim_wall_m is -0.004, but must be above 0.00045 and below 0.04",
            ),
        ];
        for (bowl, expected) in cases {
            assert_eq!(bowl.check().unwrap_err().to_string(), expected);
        }
    }

    /// The figure that follows `name` in `text`.
    fn told(text: &str, name: &str) -> f64 {
        let (_, rest) = text.split_once(&format!("{name} = ")).unwrap();
        let figure = rest.split([' ', ';']).next().unwrap();
        figure.parse().unwrap()
    }

    #[test]
    fn a_wall_that_folds_gets_cures_that_cure() {
        let thick = Bowl {
            squareness: 9.0,
            base_wall_m: 0.03,
            ..BOWL
        };
        let error = thick.check().unwrap_err();
        assert_eq!((error.field, error.value), ("base_wall_m", 0.03));
        let thinner = Bowl {
            base_wall_m: told(&error.allowed, "base_wall_m"),
            rim_wall_m: told(&error.allowed, "rim_wall_m"),
            ..thick
        };
        assert_eq!(thinner.check(), Ok(()));
        let upright = Bowl {
            squareness: 2.0,
            base_radius_m: 0.0899,
            ..BOWL
        };
        let error = upright.check().unwrap_err();
        let narrower = Bowl {
            base_radius_m: told(&error.allowed, "base_radius_m"),
            ..upright
        };
        assert_eq!(narrower.check(), Ok(()));
        let flat = Bowl {
            height_m: 0.01,
            ..BOWL
        };
        let error = flat.check().unwrap_err();
        assert_eq!(error.field, "rim_wall_m");
        let taller = Bowl {
            height_m: told(&error.allowed, "height_m"),
            ..flat
        };
        assert_eq!(taller.check(), Ok(()));
    }
}
