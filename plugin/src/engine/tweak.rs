//! The same shape of another size or material, by scaling laws.

use super::range;
use super::settings::within;

/// What becomes of a body (O'Brien 2002 §3.3: frequencies go with the root of stiffness over density and
/// against size; shapes with the root of mass).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Tweak {
    /// Lengths over those as built.
    pub size: f64,
    /// Stiffness over the material's.
    pub stiffness: f64,
    /// Density over the material's.
    pub density: f64,
}

impl Tweak {
    /// As built.
    pub const NONE: Self = Self {
        size: 1.0,
        stiffness: 1.0,
        density: 1.0,
    };

    /// The same with every value in its range, and what is not a number as built.
    pub(super) fn sane(self) -> Self {
        Self {
            size: within(self.size, range::SIZE, 1.0),
            stiffness: within(self.stiffness, range::MATERIAL, 1.0),
            density: within(self.density, range::MATERIAL, 1.0),
        }
    }

    /// Frequencies over those as built.
    pub(crate) fn pitch(&self) -> f64 {
        (self.stiffness / self.density).sqrt() / self.size
    }

    /// Mass over that as built.
    pub(crate) fn mass(&self) -> f64 {
        self.density * self.size * self.size * self.size
    }
}
