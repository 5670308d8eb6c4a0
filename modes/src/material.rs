//! What a body is made of.

use serde::{Deserialize, Serialize};

/// A linear isotropic solid.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Material {
    /// First Lamé constant λ, in Pa.
    pub lambda_pa: f64,
    /// Second Lamé constant μ (shear modulus), in Pa.
    pub mu_pa: f64,
    /// Density ρ, in kg/m³.
    pub density_kg_m3: f64,
}

impl Material {
    /// From Young's modulus in Pa, Poisson's ratio and density in kg/m³.
    #[must_use]
    pub fn from_young(young_pa: f64, poisson: f64, density_kg_m3: f64) -> Self {
        Self {
            lambda_pa: young_pa * poisson / ((1.0 + poisson) * (1.0 - 2.0 * poisson)),
            mu_pa: young_pa / (2.0 * (1.0 + poisson)),
            density_kg_m3,
        }
    }

    /// Young's modulus, in Pa.
    #[must_use]
    pub fn young_pa(&self) -> f64 {
        self.mu_pa * (3.0 * self.lambda_pa + 2.0 * self.mu_pa) / (self.lambda_pa + self.mu_pa)
    }

    /// Poisson's ratio.
    #[must_use]
    pub fn poisson(&self) -> f64 {
        self.lambda_pa / (2.0 * (self.lambda_pa + self.mu_pa))
    }
}
