//! What takes a body's energy: the material, the air, the supports, hands and felt.

use super::oscillators::CAUSES;
use modes::{Damping, Rayleigh};

/// How the player weighs the causes of decay.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Losses {
    /// Factor on the material's own damping.
    pub own: f64,
    /// Material damping beside its own.
    pub added: Damping,
    /// Factor on what radiation takes.
    pub radiation: f64,
    /// Factor on what the supports take.
    pub supports: f64,
}

impl Losses {
    /// As built.
    pub const AS_BUILT: Self = Self {
        own: 1.0,
        added: Damping {
            rayleigh: Rayleigh {
                alpha1_s: 0.0,
                alpha2_per_s: 0.0,
            },
            loss_factor: 0.0,
        },
        radiation: 1.0,
        supports: 1.0,
    };

    /// Nothing but this material damping.
    #[must_use]
    pub const fn only(added: Damping) -> Self {
        Self {
            own: 0.0,
            added,
            radiation: 0.0,
            supports: 0.0,
        }
    }

    /// What these make of a material's own damping.
    #[must_use]
    pub(crate) fn drain(&self, own: &Damping) -> Drain {
        let both = |own: f64, added: f64| self.own * own + added;
        let added = &self.added;
        Drain {
            alpha1_s: both(own.rayleigh.alpha1_s, added.rayleigh.alpha1_s),
            alpha2_per_s: both(own.rayleigh.alpha2_per_s, added.rayleigh.alpha2_per_s),
            loss_factor: both(own.loss_factor, added.loss_factor),
            radiation: self.radiation,
            supports: self.supports,
            resonator: 1.0,
            felt: 0.0,
            hand_per_s: 0.0,
        }
    }
}

/// What takes the energy of all modes of a body now.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct Drain {
    pub(crate) alpha1_s: f64,
    pub(crate) alpha2_per_s: f64,
    pub(crate) loss_factor: f64,
    pub(crate) radiation: f64,
    pub(crate) supports: f64,
    /// Share of what the resonators take.
    pub(crate) resonator: f64,
    /// Share of the felt's weight on the body, 0…1.
    pub(crate) felt: f64,
    /// Decay rate that a hand gives all modes alike, in 1/s.
    pub(crate) hand_per_s: f64,
}

impl Drain {
    /// Shares of what radiation, supports, resonator and felt take.
    pub(crate) fn shares(&self) -> [f64; CAUSES] {
        [self.radiation, self.supports, self.resonator, self.felt]
    }
}
