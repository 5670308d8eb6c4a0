//! An open tube along the z axis, one end at the origin.

/// A tube's dimensions.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Tube {
    /// Outer radius, in m.
    pub outer_radius_m: f64,
    /// Wall thickness, in m.
    pub wall_m: f64,
    /// Length, in m.
    pub length_m: f64,
}

impl Tube {
    /// The chime that O'Brien 2002 calls D3 (Table 2): 587.33 Hz, MIDI key 74.
    pub const D5: Self = Self {
        outer_radius_m: 0.0125,
        wall_m: 0.001,
        length_m: 0.505,
    };

    /// Inner radius, in m.
    #[must_use]
    pub fn inner_radius_m(&self) -> f64 {
        self.outer_radius_m - self.wall_m
    }

    /// Area of the ring that a cut across the axis shows, in m².
    #[must_use]
    pub fn section_area_m2(&self) -> f64 {
        std::f64::consts::PI * (self.outer_radius_m.powi(2) - self.inner_radius_m().powi(2))
    }

    /// Second moment of area about a diameter, in m⁴.
    #[must_use]
    pub fn second_moment_m4(&self) -> f64 {
        std::f64::consts::FRAC_PI_4 * (self.outer_radius_m.powi(4) - self.inner_radius_m().powi(4))
    }

    /// Volume of the wall, in m³.
    #[must_use]
    pub fn volume_m3(&self) -> f64 {
        self.section_area_m2() * self.length_m
    }
}
