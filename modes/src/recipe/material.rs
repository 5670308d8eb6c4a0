//! What a recipe says of the material.

use super::error::Fault;
use super::raw::RawMaterial;
use crate::{Material, MaterialError, NamedMaterial, Rayleigh};
use std::ops::RangeInclusive;

/// Poisson's ratios that can be computed: towards ½ a solid keeps its volume, which cells of finite size
/// cannot follow, and towards −1 its shape.
const POISSON: RangeInclusive<f64> = -0.5..=0.49;

/// The same in words: ν itself, and λ/μ = 2ν/(1 − 2ν).
const POISSON_TOLD: [&str; 2] = ["-0.5 to 0.49", "-0.5 to 49 times material.mu_pa"];

/// The material, and the damping that belongs to its name.
pub(super) fn check_material(raw: &RawMaterial) -> Result<(Material, Option<Rayleigh>), Fault> {
    match *raw {
        RawMaterial {
            name: Some(ref name),
            lambda_pa: None,
            mu_pa: None,
            young_pa: None,
            poisson: None,
            density_kg_m3: None,
        } => {
            let found = NamedMaterial::find(name).map_err(|unknown| {
                let allowed = format!("a known one ({unknown})");
                Fault::field("material.name", format!("{name:?}"), allowed)
            })?;
            Ok((found.material, Some(found.damping)))
        }
        RawMaterial {
            name: None,
            lambda_pa: Some(lambda),
            mu_pa: Some(mu),
            young_pa: None,
            poisson: None,
            density_kg_m3: Some(density),
        } => {
            let told = ("material.lambda_pa", lambda, POISSON_TOLD[1]);
            material(Material::from_lame(lambda, mu, density), told)
        }
        RawMaterial {
            name: None,
            lambda_pa: None,
            mu_pa: None,
            young_pa: Some(young),
            poisson: Some(poisson),
            density_kg_m3: Some(density),
        } => {
            let told = ("material.poisson", poisson, POISSON_TOLD[0]);
            material(Material::from_young(young, poisson, density), told)
        }
        _ => Err(Fault::field(
            "material",
            "not told in one way",
            "name alone; or lambda_pa, mu_pa and density_kg_m3; or young_pa, poisson and \
             density_kg_m3",
        )),
    }
}

/// `poisson` is the field that decides Poisson's ratio, its value and its range.
fn material(
    result: Result<Material, MaterialError>,
    poisson: (&'static str, f64, &'static str),
) -> Result<(Material, Option<Rayleigh>), Fault> {
    let (field, value, allowed) = match result {
        Ok(material) if POISSON.contains(&material.poisson()) => return Ok((material, None)),
        Ok(_) | Err(MaterialError::Poisson(_) | MaterialError::Lambda(_)) => poisson,
        Err(MaterialError::Young(e)) => ("material.young_pa", e, "finite and above 0"),
        Err(MaterialError::Shear(mu)) => ("material.mu_pa", mu, "finite and above 0"),
        Err(MaterialError::Density(rho)) => ("material.density_kg_m3", rho, "finite and above 0"),
    };
    Err(Fault::field(field, value, allowed))
}
