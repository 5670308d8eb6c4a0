//! One body, many keys: what is solved once is scaled to each key by exact laws.

use super::{Bank, Body, Ears, Matter, Mode};
use crate::equal_temperament_hz;
use serde::{Deserialize, Serialize};
use std::sync::Arc;

/// Highest frequency that a mode is kept for, in Hz: what people hear.
const HIGHEST_HZ: f64 = 20_000.0;

/// How the bodies of a bank are given to keys.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Spread {
    /// What changes from key to key, but in zones that say otherwise ([`Zone::rule`]).
    pub rule: SpreadRule,
    /// Pitch of key 69, in Hz.
    pub a4_hz: f64,
    /// The keys of each body of the bank, in the order of the bodies.
    pub zones: Vec<Zone>,
    /// Which of a body's modes are enough for a key; without, all that people hear.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub enough: Option<Enough>,
}

/// The modes that a key is given: all up to a frequency, and at least so many.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Enough {
    /// The frequency, in Hz.
    pub hz: f64,
    /// Modes that a key is given however high they are, up to what people hear.
    pub modes: u32,
}

/// What is changed of a body so that it sounds at a key's pitch.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum SpreadRule {
    /// All lengths, those of what holds it included.
    Size,
    /// The density (O'Brien 2002 §3.3); the air sees the same motion at another frequency.
    Density,
    /// The stiffness (the same).
    Stiffness,
    /// Nothing: all keys of a zone sound alike.
    Fixed,
}

/// Keys of one body.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Zone {
    /// Lowest key.
    pub low: u8,
    /// Highest key, no less than `low`.
    pub high: u8,
    /// Which mode carries the pitch, counted from 0.
    pub tuned: u32,
    /// What changes from key to key; without, what the spread says.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub rule: Option<SpreadRule>,
}

/// What the fields of a body and its modes are multiplied by.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Factors {
    length: f64,
    mass: f64,
    hz: f64,
    shape: f64,
    /// Pressure at the ears for a unit modal displacement.
    ears: f64,
    coupling: f64,
    radiation: f64,
    /// Decay rates by what touches the body.
    touch: f64,
}

impl SpreadRule {
    /// What it takes to multiply frequencies by `ratio`.
    ///
    /// A body γ times as large has ω/γ and φ γ^(−3/2), for ∫ρφ² dV is 1. Waves in the air are γ
    /// times as long too, so that the share of its energy that a mode radiates in a cycle stays, as does
    /// what supports γ times as large take: every decay rate goes with ω. Pressure at a distance goes
    /// with the root of the power, that is ω²d.
    ///
    /// Of another density β, M is βM: ω β^(−1/2), φ β^(−1/2). Of another stiffness κ, ω κ^(1/2)
    /// and φ as it is. In both the body stays as large, and what radiates as well at one frequency as
    /// at the other does so by its velocity ωφ: exactly where the waves in air are short beside it.
    fn factors(self, ratio: f64) -> Factors {
        match self {
            Self::Size => Factors {
                length: ratio.recip(),
                mass: ratio.powi(-3),
                hz: ratio,
                shape: ratio.powf(1.5),
                ears: ratio.powf(1.5),
                coupling: ratio.sqrt(),
                radiation: ratio,
                touch: ratio,
            },
            Self::Density => Factors {
                length: 1.0,
                mass: ratio.powi(-2),
                hz: ratio,
                shape: ratio,
                ears: ratio * ratio,
                coupling: ratio * ratio,
                radiation: ratio * ratio,
                touch: ratio * ratio,
            },
            Self::Stiffness => Factors {
                length: 1.0,
                mass: 1.0,
                hz: ratio,
                shape: 1.0,
                ears: ratio,
                coupling: ratio,
                radiation: 1.0,
                touch: 1.0,
            },
            Self::Fixed => Factors {
                length: 1.0,
                mass: 1.0,
                hz: 1.0,
                shape: 1.0,
                ears: 1.0,
                coupling: 1.0,
                radiation: 1.0,
                touch: 1.0,
            },
        }
    }
}

/// `matter` changed by `rule` so that frequencies are multiplied by `ratio` (O'Brien 2002 §3.3); none
/// if it is the same stuff.
fn changed(rule: SpreadRule, matter: Matter, ratio: f64) -> Option<Matter> {
    let Matter {
        mut material,
        damping,
    } = matter;
    let square = ratio * ratio;
    match rule {
        SpreadRule::Size | SpreadRule::Fixed => return None,
        SpreadRule::Density => material.density_kg_m3 /= square,
        SpreadRule::Stiffness => {
            material.lambda_pa *= square;
            material.mu_pa *= square;
        }
    }
    Some(Matter { material, damping })
}

impl Bank {
    /// The bank with a body of its own for each key that [`Bank::spread`] gives it: what engines play.
    /// Modes that come to lie above 20 kHz, and those beyond what is [`Spread::enough`], are left out. A bank without a spread is as it was.
    ///
    /// Shapes and surfaces are shared by the keys of a body.
    #[must_use]
    pub fn spread_out(mut self) -> Self {
        let Some(spread) = self.spread.take() else {
            return self;
        };
        let zones = self.bodies.iter().zip(&spread.zones);
        self.bodies = zones
            .flat_map(|(body, zone)| {
                let (spread, matter) = (&spread, self.matter_of(body));
                (zone.low..=zone.high).map(move |key| spread.body(matter, body, *zone, key))
            })
            .collect();
        self
    }
}

impl Spread {
    /// `body`, which is of that matter, as it is at `key`.
    pub(super) fn body(&self, matter: Matter, body: &Body, zone: Zone, key: u8) -> Body {
        let rule = zone.rule.unwrap_or(self.rule);
        let tuned_hz = body.modes.get(zone.tuned as usize).map(|mode| mode.hz);
        let (pitch_hz, ratio) = match (rule, tuned_hz) {
            (SpreadRule::Fixed, _) | (_, None) => (body.pitch_hz, 1.0),
            (_, Some(tuned_hz)) => {
                let pitch_hz = equal_temperament_hz(key, self.a4_hz);
                (pitch_hz, pitch_hz / tuned_hz)
            }
        };
        let factors = rule.factors(ratio);
        let (all, limit_hz) = match self.enough {
            Some(enough) => (enough.modes as usize, enough.hz.min(HIGHEST_HZ)),
            None => (usize::MAX, HIGHEST_HZ),
        };
        let kept = |(i, mode): &(usize, &Mode)| {
            let highest_hz = if *i < all { HIGHEST_HZ } else { limit_hz };
            rule == SpreadRule::Fixed || mode.hz * ratio <= highest_hz
        };
        Body {
            key,
            pitch_hz,
            length_m: factors.length * body.length_m,
            mass_kg: factors.mass * body.mass_kg,
            matter: changed(rule, matter, ratio).or(body.matter),
            line: body.line.scaled(factors.length),
            surface: body.surface.as_ref().map(Arc::clone),
            modes: body
                .modes
                .iter()
                .enumerate()
                .filter(kept)
                .map(|(_, mode)| factors.mode(mode))
                .collect(),
        }
    }
}

impl Factors {
    fn mode(&self, mode: &Mode) -> Mode {
        let rate = |factor: f64, rate: f32| (factor * f64::from(rate)) as f32;
        let ears = |ears: &Ears| ears.map(|ear| ear.map(|x| rate(self.ears, x)));
        Mode {
            hz: self.hz * mode.hz,
            coupling: self.coupling * mode.coupling,
            ears: ears(&mode.ears),
            pipe_ears: mode.pipe_ears,
            radiation_per_s: rate(self.radiation, mode.radiation_per_s),
            support_per_s: rate(self.touch, mode.support_per_s),
            felt_per_s: rate(self.touch, mode.felt_per_s),
            pipe_per_s: mode.pipe_per_s,
            residual: mode.residual,
            label: mode.label,
            shape: mode.shape.scaled(self.shape),
        }
    }
}
