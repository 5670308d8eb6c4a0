//! What takes the sound away.

use super::Spec;
use super::build::{float, plain, switch};
use super::text::Text;
use crate::engine::{Losses, Settings, range};
use crate::hands::Modulated;
use modes::{Damping as Material, Rayleigh};
use nice_plug::prelude::{BoolParam, FloatParam, Params};

const NORMAL: Settings = Settings::DEFAULT;

/// Stiffness-proportional damping.
pub const ALPHA1: Spec = Spec {
    id: "alpha1",
    name: "Alpha 1",
    tooltip: "Adds damping to the material's own that takes high partials first: 1e-7 s rings like \
              metal, 1e-6 s like ceramic, 8e-6 s like wood. Changes what is already ringing.",
    skew: 0.25,
    ..Spec::number(
        Text::Power("s"),
        1.0,
        &range::ALPHA1_S,
        NORMAL.losses.added.rayleigh.alpha1_s,
    )
};

/// Mass-proportional damping.
pub const ALPHA2: Spec = Spec {
    id: "alpha2",
    name: "Alpha 2",
    tooltip: "Adds damping that shortens all partials alike: 0 leaves them as they are, 50 1/s is a \
              dull knock. Changes what is already ringing.",
    skew: 0.35,
    ..Spec::number(
        Text::Digits("1/s"),
        1.0,
        &range::ALPHA2_PER_S,
        NORMAL.losses.added.rayleigh.alpha2_per_s,
    )
};

/// Factor on the material's own damping.
pub const OWN: Spec = Spec {
    id: "own",
    name: "Own damping",
    tooltip: "How much of the material's own damping counts: 1 x is the instrument as built, 0 x a \
              material that never tires. Changes what is already ringing.",
    skew: 0.3,
    ..Spec::number(Text::Digits("x"), 1.0, &range::CAUSE, NORMAL.losses.own)
};

/// Added loss factor.
pub const LOSS_FACTOR: Spec = Spec {
    id: "tanphi",
    name: "Loss factor",
    tooltip: "Adds internal friction (tan phi) that takes the same share of every swing: 1e-4 is bell \
              metal, 1e-3 hard plastic, 1e-2 wood. Changes what is already ringing.",
    skew: 0.25,
    ..Spec::number(
        Text::Power("tan"),
        1.0,
        &range::LOSS_FACTOR,
        NORMAL.losses.added.loss_factor,
    )
};

/// Factor on what radiation takes.
pub const RADIATION: Spec = Spec {
    id: "radia",
    name: "Radiation damping",
    tooltip: "How much the air shortens what it carries away: 1 x is real, 0 x lets the high partials \
              of large bodies ring on as in a vacuum. Changes what is already ringing.",
    skew: 0.3,
    ..Spec::number(
        Text::Digits("x"),
        1.0,
        &range::CAUSE,
        NORMAL.losses.radiation,
    )
};

/// Factor on what the supports take.
pub const SUPPORTS: Spec = Spec {
    id: "suppt",
    name: "Supports",
    tooltip: "How firmly cords and cushions hold: more shortens the partials that move where the body \
              is held. Changes what is already ringing.",
    skew: 0.3,
    ..Spec::number(
        Text::Digits("x"),
        1.0,
        &range::CAUSE,
        NORMAL.losses.supports,
    )
};

/// What a released key does.
pub const NOTE_OFF: Spec = Spec {
    id: "noff",
    name: "Note-off",
    tooltip: "Whether a released key leaves its body ringing or lays a felt damper on it; the sustain \
              pedal keeps the dampers off.",
    ..Spec::switch("rings on", "damps", NORMAL.note_off_damps)
};

pub(super) const SPECS: [Spec; 7] = [
    ALPHA1,
    ALPHA2,
    OWN,
    LOSS_FACTOR,
    RADIATION,
    SUPPORTS,
    NOTE_OFF,
];

/// What takes the sound away.
#[derive(Params)]
pub struct Damping {
    /// See [`ALPHA1`].
    #[id = "alpha1"]
    pub alpha1: FloatParam,
    /// See [`ALPHA2`].
    #[id = "alpha2"]
    pub alpha2: FloatParam,
    /// See [`OWN`].
    #[id = "own"]
    pub own: FloatParam,
    /// See [`LOSS_FACTOR`].
    #[id = "tanphi"]
    pub loss_factor: FloatParam,
    /// See [`RADIATION`].
    #[id = "radia"]
    pub radiation: FloatParam,
    /// See [`SUPPORTS`].
    #[id = "suppt"]
    pub supports: FloatParam,
    /// See [`NOTE_OFF`].
    #[id = "noff"]
    pub note_off: BoolParam,
}

impl Default for Damping {
    fn default() -> Self {
        Self {
            alpha1: float(&ALPHA1),
            alpha2: float(&ALPHA2).with_poly_modulation_id(Modulated::Damping as u32),
            own: float(&OWN),
            loss_factor: float(&LOSS_FACTOR),
            radiation: float(&RADIATION),
            supports: float(&SUPPORTS),
            note_off: switch(&NOTE_OFF),
        }
    }
}

impl Damping {
    /// The decay rate that a host's modulation of one note's Alpha 2 adds to all of its modes, in 1/s:
    /// half of how far Alpha 2 moves (O'Brien 2002, Eq. 9). Below 0 it takes from what Alpha 2 adds.
    pub(crate) fn faster_per_s(&self, modulation: f64) -> f64 {
        0.5 * super::poly::moved(&self.alpha2, modulation)
    }

    pub(super) fn apply(&self, settings: &mut Settings) {
        settings.losses = Losses {
            own: plain(&self.own),
            added: Material {
                rayleigh: Rayleigh {
                    alpha1_s: plain(&self.alpha1),
                    alpha2_per_s: plain(&self.alpha2),
                },
                loss_factor: plain(&self.loss_factor),
            },
            radiation: plain(&self.radiation),
            supports: plain(&self.supports),
        };
        settings.note_off_damps = self.note_off.value();
    }
}
