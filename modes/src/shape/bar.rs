//! A bar lying along the x axis, flat on top, hollowed from below by an arch.

/// The arch cut into a bar's underside.
///
/// At a distance x from the middle it takes (`T` − `centre_thickness_m`)·(1 − uⁿ)² off the thickness
/// `T`, with u = |x| / `half_length_m`: its slope vanishes in the middle and where it runs out.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Undercut {
    /// Thickness left in the middle, in m.
    pub centre_thickness_m: f64,
    /// From the middle to where the arch runs out, in m.
    pub half_length_m: f64,
    /// n, above 1: the greater, the longer the thin part and the steeper the flanks.
    pub exponent: f64,
}

/// A bar's dimensions. Its middle is at x = y = 0, its top at z = 0.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bar {
    /// Length along x, in m.
    pub length_m: f64,
    /// Width along y, in m.
    pub width_m: f64,
    /// Thickness along z beyond the arch, in m.
    pub thickness_m: f64,
    /// What is cut out of it.
    pub undercut: Undercut,
}

impl Bar {
    /// A bar of one thickness throughout.
    #[must_use]
    pub fn uniform(length_m: f64, width_m: f64, thickness_m: f64) -> Self {
        Self {
            length_m,
            width_m,
            thickness_m,
            undercut: Undercut {
                centre_thickness_m: thickness_m,
                half_length_m: 0.5 * length_m,
                exponent: 2.0,
            },
        }
    }

    /// Thickness in m at `x_m` from the middle.
    #[must_use]
    pub fn thickness_at_m(&self, x_m: f64) -> f64 {
        let u = (x_m.abs() / self.undercut.half_length_m).min(1.0);
        let depth_m = self.thickness_m - self.undercut.centre_thickness_m;
        self.thickness_m - depth_m * (1.0 - u.powf(self.undercut.exponent)).powi(2)
    }

    /// Volume in m³: the arch's share is ∫(1 − uⁿ)² du = 1 − 2/(n + 1) + 1/(2n + 1), as long as the
    /// arch ends within the bar.
    #[must_use]
    pub fn volume_m3(&self) -> f64 {
        let Undercut {
            centre_thickness_m,
            half_length_m,
            exponent,
        } = self.undercut;
        let share = 1.0 - 2.0 / (exponent + 1.0) + 1.0 / (2.0 * exponent + 1.0);
        let cut_m2 = 2.0 * half_length_m * share * (self.thickness_m - centre_thickness_m);
        self.width_m * (self.length_m * self.thickness_m - cut_m2)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn volume_is_the_integral_of_the_thickness() {
        let bar = Bar {
            undercut: Undercut {
                centre_thickness_m: 0.005,
                half_length_m: 0.11,
                exponent: 3.7,
            },
            ..Bar::uniform(0.36, 0.05, 0.0127)
        };
        let steps = 20_000;
        let step_m = bar.length_m / f64::from(steps);
        let middles = (0..steps).map(|i| (f64::from(i) + 0.5) * step_m - 0.5 * bar.length_m);
        let area_m2: f64 = middles.map(|x_m| bar.thickness_at_m(x_m) * step_m).sum();
        let error = bar.volume_m3() / (bar.width_m * area_m2) - 1.0;
        assert!(error.abs() < 1e-8, "{error:e}");
        assert_eq!(bar.thickness_at_m(0.0), 0.005);
        assert_eq!(bar.thickness_at_m(-0.12), 0.0127);
    }
}
