//! The body whose partials are shown.

use super::frame::Frame;
use super::kind::{Kind, Noun};
use crate::engine::Partial;
use crate::key_name::key_name;
use crate::shelf::Shelved;
use modes::Matter;

/// The partials of one body, worked out once.
pub(super) struct Shown {
    /// Number of the instrument.
    pub(super) instrument: usize,
    pub(super) bank: Shelved,
    pub(super) key: u8,
    pub(super) partials: Vec<Partial>,
    /// Loudest level since the last blow, as an amplitude over full scale.
    pub(super) peak: f32,
    /// Number of that blow.
    count: Option<u32>,
}

impl Shown {
    /// A body of the instrument of that number: that of `key`, or else the one in the middle.
    pub(super) fn new(instrument: usize, bank: Shelved, key: Option<u8>) -> Self {
        let bodies = &bank.bodies;
        let body = bodies
            .iter()
            .find(|body| Some(body.key) == key)
            .or_else(|| bodies.iter().min_by_key(|body| body.key.abs_diff(60)));
        Self {
            instrument,
            key: body.map_or(60, |body| body.key),
            partials: body.map_or_else(Vec::new, Partial::all),
            bank,
            peak: 0.0,
            count: None,
        }
    }

    /// Follows instrument, drawing and blows; `bank` is that of the instrument.
    pub(super) fn follow(&mut self, instrument: usize, bank: Shelved, frame: &Frame) {
        let struck = frame.struck;
        let key = struck.map(|struck| struck.key);
        let same = instrument == self.instrument;
        if !same || key.is_some_and(|key| key != self.key) {
            let known = key.filter(|_| same);
            *self = Self::new(instrument, bank, known.or(Some(self.key)));
        } else if !bank.is(&self.bank) {
            // What rings goes on in the new drawing.
            let (peak, count) = (self.peak, self.count);
            *self = Self {
                peak,
                count,
                ..Self::new(instrument, bank, Some(self.key))
            };
        }
        if self.count != struck.map(|struck| struck.count) {
            self.count = struck.map(|struck| struck.count);
            self.peak = 0.0;
        }
        if key == Some(self.key) {
            self.peak = frame.levels.iter().fold(self.peak, |most, x| most.max(*x));
        }
    }

    /// How loud a partial is now beside the loudest since the last blow, 0…1.
    pub(super) fn live(&self, frame: &Frame, number: usize) -> f32 {
        let ours = frame.struck.is_some_and(|struck| struck.key == self.key);
        match frame.levels.get(number) {
            Some(level) if ours && self.peak > 1e-9 => level / self.peak,
            _ => 0.0,
        }
    }

    /// What the body is made of.
    pub(super) fn matter(&self) -> Matter {
        let body = self.bank.bodies.iter().find(|body| body.key == self.key);
        body.map_or_else(|| self.bank.matter(), |body| self.bank.matter_of(body))
    }

    /// Which body it is, in words.
    pub(super) fn title(&self) -> String {
        let body = self.bank.bodies.iter().find(|body| body.key == self.key);
        body.map_or_else(String::new, |body| {
            let long_m = match Kind::of(body) {
                Kind::Bowl => 2.0 * body.line.points_m.first().map_or(0.0, |rim| rim[0]),
                Kind::Bar | Kind::Tube | Kind::Other => body.length_m,
            };
            let size = if long_m < 1.0 {
                format!("{:.1} cm", 1e2 * long_m)
            } else {
                format!("{long_m:.2} m")
            };
            let Noun { name, measured } = Noun::of(body);
            let mass = if body.mass_kg < 1.0 {
                format!("{:.0} g", 1e3 * body.mass_kg)
            } else {
                format!("{:.2} kg", body.mass_kg)
            };
            format!("{}: a {name} {size} {measured}, {mass}", key_name(self.key))
        })
    }
}
