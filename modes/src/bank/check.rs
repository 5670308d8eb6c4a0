//! Whether a bank is one that can be played.

use super::check_surface::check_surface;
use super::check_tables::{check_product, check_tables};
use super::{Bank, BankError, Body, Matter, Mode};
use crate::{Stencil, StrikeLine};

/// Bounds beyond anything that can be struck, within which single precision stays finite.
const MAX_HZ: f64 = 1e6;
pub(super) const MAX_SHAPE: f32 = 1e9;
const MAX_COUPLING: f64 = 1e12;
const MAX_EARS: f32 = 1e12;

impl Bank {
    /// Whether every number is possible, and the keys and frequencies are in order.
    ///
    /// # Errors
    ///
    /// [`BankError::Inconsistent`], with the first field that is not.
    pub fn check(&self) -> Result<(), BankError> {
        check_matter(&self.matter())?;
        if let Some(x) = self.ears_m.iter().flatten().find(|x| !x.is_finite()) {
            return Err(BankError::inconsistent("ears_m", x, "finite"));
        }
        let provenance = &self.provenance;
        not_negative("tolerance_cents", provenance.tolerance_cents)?;
        not_negative("max_residual", provenance.max_residual)?;
        not_negative(
            "max_orthonormality_error",
            provenance.max_orthonormality_error,
        )?;
        let mut least_key = 0;
        for body in &self.bodies {
            if !(least_key..128).contains(&u16::from(body.key)) {
                let allowed = "0 to 127 and above the key before";
                return Err(BankError::inconsistent("key", body.key, allowed));
            }
            least_key = u16::from(body.key) + 1;
            check_body(body).map_err(|error| error.within(format!("key {}", body.key)))?;
        }
        match &self.spread {
            Some(spread) => self.check_spread(spread),
            None => Ok(()),
        }
    }
}

pub(super) fn check_body(body: &Body) -> Result<(), BankError> {
    positive("pitch_hz", body.pitch_hz)?;
    positive("length_m", body.length_m)?;
    positive("mass_kg", body.mass_kg)?;
    body.matter.as_ref().map_or(Ok(()), check_matter)?;
    check_line(&body.line)?;
    if let Some(surface) = &body.surface {
        check_surface(surface)?;
    }
    check_tables(body)?;
    let mut least_hz = 0.0;
    for (i, mode) in body.modes.iter().enumerate() {
        check_mode(mode, least_hz, body.line.len())
            .map_err(|error| error.within(format!("mode {}", i + 1)))?;
        least_hz = mode.hz;
    }
    Ok(())
}

fn check_matter(matter: &Matter) -> Result<(), BankError> {
    let Matter { material, damping } = matter;
    material
        .check()
        .map_err(|error| BankError::inconsistent("material", error, "that of an elastic solid"))?;
    not_negative("alpha1_s", damping.rayleigh.alpha1_s)?;
    not_negative("alpha2_per_s", damping.rayleigh.alpha2_per_s)?;
    not_negative("loss_factor", damping.loss_factor)
}

fn check_line(line: &StrikeLine) -> Result<(), BankError> {
    if line.rows == 0 || !line.len().is_multiple_of(line.rows) {
        let allowed = "at least 1, of equally many points";
        return Err(BankError::inconsistent("rows", line.rows, allowed));
    }
    if line.grid().columns < Stencil::POINTS {
        let allowed = "at least 6 to a row, to interpolate between them";
        return Err(BankError::inconsistent("points", line.len(), allowed));
    }
    if line.normals.len() != line.len() {
        let allowed = "as many as the points";
        return Err(BankError::inconsistent(
            "normals",
            line.normals.len(),
            allowed,
        ));
    }
    for (i, point) in line.points_m.iter().enumerate() {
        if !point.iter().all(|x| x.is_finite()) {
            let field = format!("point {}", i + 1);
            return Err(BankError::inconsistent(
                field,
                format!("{point:?}"),
                "finite",
            ));
        }
    }
    for (i, normal) in line.normals.iter().enumerate() {
        let length = normal.iter().map(|x| x * x).sum::<f64>().sqrt();
        if !(1.0 - 1e-6..=1.0 + 1e-6).contains(&length) {
            let field = format!("length of normal {}", i + 1);
            return Err(BankError::inconsistent(field, length, "1"));
        }
    }
    Ok(())
}

fn check_mode(mode: &Mode, least_hz: f64, points: usize) -> Result<(), BankError> {
    positive("hz", mode.hz)?;
    if mode.hz > MAX_HZ || mode.hz < least_hz {
        let allowed = "no less than that of the mode before, and at most 1000000";
        return Err(BankError::inconsistent("hz", mode.hz, allowed));
    }
    if !(0.0..=MAX_COUPLING).contains(&mode.coupling) {
        return Err(BankError::inconsistent(
            "coupling",
            mode.coupling,
            "0 to 1e12",
        ));
    }
    let loud = |x: &&f32| !(-MAX_EARS..=MAX_EARS).contains(*x);
    let mut ears = mode.ears.iter().chain(&mode.pipe_ears).flatten();
    if let Some(x) = ears.find(loud) {
        return Err(BankError::inconsistent("ears", x, "-1e12 to 1e12"));
    }
    not_negative("radiation_per_s", f64::from(mode.radiation_per_s))?;
    not_negative("support_per_s", f64::from(mode.support_per_s))?;
    not_negative("felt_per_s", f64::from(mode.felt_per_s))?;
    not_negative("pipe_per_s", f64::from(mode.pipe_per_s))?;
    not_negative("residual", mode.residual)?;
    if mode.label.index == 0 {
        return Err(BankError::inconsistent("index", 0, "counted from 1"));
    }
    if let Some(product) = mode.shape.as_product() {
        return check_product(product);
    }
    if mode.shape.len() != points {
        let allowed = "one for each point of the strike line";
        let count = format!("of {} points", mode.shape.len());
        return Err(BankError::inconsistent("shape", count, allowed));
    }
    let inside = |x: &f32| (-MAX_SHAPE..=MAX_SHAPE).contains(x);
    if let Some(phi) = mode.shape.iter().flatten().find(|x| !inside(x)) {
        return Err(BankError::inconsistent("shape", phi, "-1e9 to 1e9"));
    }
    Ok(())
}

pub(super) fn positive(field: &str, x: f64) -> Result<(), BankError> {
    if x > 0.0 && x.is_finite() {
        return Ok(());
    }
    Err(BankError::inconsistent(field, x, "finite and above 0"))
}

fn not_negative(field: &str, x: f64) -> Result<(), BankError> {
    if x >= 0.0 && x.is_finite() {
        return Ok(());
    }
    Err(BankError::inconsistent(field, x, "finite and not below 0"))
}
