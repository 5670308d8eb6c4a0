//! The membrane of three squares in the shape of an L (van den Doel & Pai 1998, §6.6).

mod corner;
mod spectrum;

pub use spectrum::LSpectrum;

use super::ClosedMode;
use crate::{Family, Member, ModeLabel};
use spectrum::UnitMode;
use std::f64::consts::TAU;

/// A membrane held along the edges of an L: the square from the origin to (2 a, 2 a) without its upper
/// right quarter.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LMembrane {
    /// Side a of each of the three squares, in m.
    pub square_m: f64,
    /// Tension, in N/m.
    pub tension_n_m: f64,
    /// Mass per area, in kg/m².
    pub mass_kg_m2: f64,
}

/// A mode of an L-shaped membrane.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LMode<'a> {
    membrane: LMembrane,
    unit: &'a UnitMode,
    /// Counted from 1 by frequency.
    index: u16,
}

impl LMembrane {
    /// Frequency in Hz of the mode whose wave number times the side of a square is `root`.
    #[must_use]
    pub fn hz(&self, root: f64) -> f64 {
        root * (self.tension_n_m / self.mass_kg_m2).sqrt() / (TAU * self.square_m)
    }

    /// The modes of `spectrum` up to `highest_hz`, rising.
    #[must_use]
    pub fn modes<'a>(&self, spectrum: &'a LSpectrum, highest_hz: f64) -> Vec<LMode<'a>> {
        let all = spectrum.modes.iter().zip(1..).map(|(unit, index)| LMode {
            membrane: *self,
            unit,
            index,
        });
        all.take_while(|mode| mode.hz() <= highest_hz).collect()
    }

    /// Mass, in kg.
    #[must_use]
    pub fn mass_kg(&self) -> f64 {
        3.0 * self.mass_kg_m2 * self.square_m * self.square_m
    }
}

impl ClosedMode for LMode<'_> {
    fn hz(&self) -> f64 {
        self.membrane.hz(self.unit.root())
    }

    fn displacement(&self, at_m: [f64; 2]) -> f64 {
        let side_m = self.membrane.square_m;
        let [x, y] = at_m.map(|length_m| length_m / side_m);
        let inside = (0.0..=2.0).contains(&x) && (0.0..=2.0).contains(&y);
        if !inside || (x > 1.0 && y > 1.0) {
            return 0.0;
        }
        self.unit.value([x, y]) / (self.membrane.mass_kg_m2.sqrt() * side_m)
    }

    fn label(&self) -> ModeLabel {
        ModeLabel {
            family: Family::Other,
            order: 0,
            index: self.index,
            member: Member::Single,
        }
    }
}

#[cfg(test)]
mod tests;
