//! What a body is made of.

use serde::{Deserialize, Serialize};
use thiserror::Error;

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

/// Numbers that no elastic solid has.
#[derive(Clone, Copy, Debug, PartialEq, Error)]
pub enum MaterialError {
    /// Young's modulus is not positive.
    #[error("Young's modulus {0} Pa is out of range: give a number above 0")]
    Young(f64),
    /// Poisson's ratio leaves the open interval of stable solids.
    #[error("Poisson's ratio {0} is out of range: give a number above -1 and below 0.5")]
    Poisson(f64),
    /// The shear modulus is not positive.
    #[error("shear modulus mu {0} Pa is out of range: give a number above 0")]
    Shear(f64),
    /// The bulk modulus λ + 2μ/3 is not positive.
    #[error("first Lamé constant lambda {0} Pa is out of range: give a number above -2/3 mu")]
    Lambda(f64),
    /// The density is not positive.
    #[error("density {0} kg/m³ is out of range: give a number above 0")]
    Density(f64),
}

impl Material {
    /// From Lamé's constants in Pa and density in kg/m³.
    ///
    /// # Errors
    ///
    /// If μ, λ + 2μ/3 or ρ is not positive and finite.
    pub fn from_lame(
        lambda_pa: f64,
        mu_pa: f64,
        density_kg_m3: f64,
    ) -> Result<Self, MaterialError> {
        let material = Self {
            lambda_pa,
            mu_pa,
            density_kg_m3,
        };
        material.check()?;
        Ok(material)
    }

    /// From Young's modulus in Pa, Poisson's ratio and density in kg/m³.
    ///
    /// # Errors
    ///
    /// If E or ρ is not positive and finite, or ν is not within −1…0.5.
    pub fn from_young(
        young_pa: f64,
        poisson: f64,
        density_kg_m3: f64,
    ) -> Result<Self, MaterialError> {
        if !is_positive(young_pa) {
            return Err(MaterialError::Young(young_pa));
        }
        if !(poisson > -1.0 && poisson < 0.5) {
            return Err(MaterialError::Poisson(poisson));
        }
        let material = Self::lame_of(young_pa, poisson, density_kg_m3);
        material.check()?;
        Ok(material)
    }

    /// λ and μ of E and ν, unchecked: for tables that a test checks.
    pub(crate) const fn lame_of(young_pa: f64, poisson: f64, density_kg_m3: f64) -> Self {
        Self {
            lambda_pa: young_pa * poisson / ((1.0 + poisson) * (1.0 - 2.0 * poisson)),
            mu_pa: young_pa / (2.0 * (1.0 + poisson)),
            density_kg_m3,
        }
    }

    /// Whether a solid can have these numbers: its energy must rise with any strain.
    ///
    /// # Errors
    ///
    /// If μ, λ + 2μ/3 or ρ is not positive and finite.
    pub fn check(&self) -> Result<(), MaterialError> {
        if !is_positive(self.mu_pa) {
            return Err(MaterialError::Shear(self.mu_pa));
        }
        if !is_positive(self.lambda_pa + self.mu_pa / 1.5) {
            return Err(MaterialError::Lambda(self.lambda_pa));
        }
        if !is_positive(self.density_kg_m3) {
            return Err(MaterialError::Density(self.density_kg_m3));
        }
        Ok(())
    }

    /// Young's modulus E, in Pa.
    #[must_use]
    pub fn young_pa(&self) -> f64 {
        self.mu_pa * (3.0 * self.lambda_pa + 2.0 * self.mu_pa) / (self.lambda_pa + self.mu_pa)
    }

    /// Poisson's ratio ν.
    #[must_use]
    pub fn poisson(&self) -> f64 {
        self.lambda_pa / (2.0 * (self.lambda_pa + self.mu_pa))
    }
}

fn is_positive(x: f64) -> bool {
    x > 0.0 && x.is_finite()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn assert_close(found: f64, expected: f64, relative: f64) {
        assert!(
            (found - expected).abs() <= relative * expected.abs(),
            "{found} is not {expected}"
        );
    }

    #[test]
    fn young_and_poisson_come_back() {
        for poisson in [-0.9, -0.3, 0.1, 0.25, 0.33, 0.49] {
            for young_pa in [1e6, 6.89e10, 4e12] {
                let m = Material::from_young(young_pa, poisson, 2700.0).unwrap();
                assert_close(m.young_pa(), young_pa, 1e-14);
                assert_close(m.poisson(), poisson, 1e-14);
            }
        }
    }

    #[test]
    fn zero_poisson_has_no_lambda() {
        let cork = Material::from_young(2e7, 0.0, 200.0).unwrap();
        assert_eq!((cork.lambda_pa, cork.mu_pa), (0.0, 1e7));
    }

    /// λ = μ is ν = 1/4 and E = 5μ/2 (Poisson's own solid).
    #[test]
    fn equal_lame_constants() {
        let m = Material::from_lame(4e9, 4e9, 1000.0).unwrap();
        assert_eq!((m.poisson(), m.young_pa()), (0.25, 1e10));
    }

    /// O'Brien 2002, Table 1: by hand 2.57·(3·4.98 + 2·2.57)/(4.98 + 2.57) and 4.98/(2·7.55).
    #[test]
    fn the_papers_aluminium() {
        let m = Material::from_lame(4.98e10, 2.57e10, 2700.0).unwrap();
        assert_close(m.young_pa(), 6.835_178_807_947e10, 1e-12);
        assert_close(m.poisson(), 0.329_801_324_503, 1e-11);
    }

    #[test]
    fn impossible_solids_are_refused() {
        use MaterialError as E;
        let young = |e, nu, rho| Material::from_young(e, nu, rho).unwrap_err();
        assert_eq!(young(0.0, 0.3, 1.0), E::Young(0.0));
        assert_eq!(young(f64::INFINITY, 0.3, 1.0), E::Young(f64::INFINITY));
        assert_eq!(young(1e9, 0.5, 1.0), E::Poisson(0.5));
        assert_eq!(young(1e9, -1.0, 1.0), E::Poisson(-1.0));
        assert!(matches!(young(1e9, f64::NAN, 1.0), E::Poisson(_)));
        assert_eq!(young(1e9, 0.3, -2.0), E::Density(-2.0));
        let lame = |l, m| Material::from_lame(l, m, 1.0).unwrap_err();
        assert_eq!(lame(1e9, 0.0), E::Shear(0.0));
        assert_eq!(lame(-2e9, 3e9), E::Lambda(-2e9));
        assert!(Material::from_lame(-1.99e9, 3e9, 1.0).is_ok());
    }
}
