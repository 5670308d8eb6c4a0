//! Which bodies are played, and what they are made of.

use super::Spec;
use super::build::{choice, float, index, plain, share};
use super::choice::Choice;
use super::text::Text;
use crate::engine::{Settings, Tweak, range};
use nice_plug::prelude::{FloatParam, IntParam, Params};

const NORMAL: Settings = Settings::DEFAULT;

/// Which bodies are struck.
pub const INSTRUMENT: Spec = Spec {
    id: "instr",
    name: "Instrument",
    tooltip: "Which bodies are struck. The next notes strike the new ones; what rings, rings out.",
    ..Spec::choice(Choice::Instrument, 0)
};

/// Lengths over those as built.
pub const SIZE: Spec = Spec {
    id: "size",
    name: "Size",
    tooltip: "The bodies' lengths over those as built: 2 x is an octave lower and eight times as heavy, \
              which the same mallet excites less. Changes what is already ringing.",
    skew: 0.43,
    ..Spec::number(Text::Digits("x"), 1.0, &range::SIZE, NORMAL.tweak.size)
};

/// Stiffness over the material's.
pub const STIFFNESS: Spec = Spec {
    id: "stiff",
    name: "Stiffness",
    tooltip: "The material's stiffness over its own: 4 x is an octave higher. Changes what is already \
              ringing.",
    skew: 0.245,
    ..Spec::number(
        Text::Digits("x"),
        1.0,
        &range::MATERIAL,
        NORMAL.tweak.stiffness,
    )
};

/// Density over the material's.
pub const DENSITY: Spec = Spec {
    id: "dens",
    name: "Density",
    tooltip: "The material's density over its own: 4 x is an octave lower, and a body four times as \
              heavy. Changes what is already ringing.",
    skew: 0.245,
    ..Spec::number(
        Text::Digits("x"),
        1.0,
        &range::MATERIAL,
        NORMAL.tweak.density,
    )
};

/// How much of a hung body's swing is heard.
pub const SWING: Spec = Spec {
    id: "swing",
    name: "Swing",
    tooltip: "How much of a hung body's slow swing after a blow is heard: it comes nearer and goes away, \
              a little louder and higher, softer and lower.",
    ..Spec::percent(&range::SHARE, NORMAL.swing)
};

/// How firmly a common support joins the bodies.
pub const SYMPATHY: Spec = Spec {
    id: "symp",
    name: "Sympathy",
    tooltip: "How firmly one support joins the bodies: what sounds sets those going that are in tune with \
              it and not damped.",
    ..Spec::percent(&range::SHARE, NORMAL.sympathy)
};

pub(super) const SPECS: [Spec; 6] = [INSTRUMENT, SIZE, STIFFNESS, DENSITY, SWING, SYMPATHY];

/// Which bodies there are.
#[derive(Params)]
pub struct Body {
    /// See [`INSTRUMENT`].
    #[id = "instr"]
    pub instrument: IntParam,
    /// See [`SIZE`].
    #[id = "size"]
    pub size: FloatParam,
    /// See [`STIFFNESS`].
    #[id = "stiff"]
    pub stiffness: FloatParam,
    /// See [`DENSITY`].
    #[id = "dens"]
    pub density: FloatParam,
    /// See [`SWING`].
    #[id = "swing"]
    pub swing: FloatParam,
    /// See [`SYMPATHY`].
    #[id = "symp"]
    pub sympathy: FloatParam,
}

impl Default for Body {
    fn default() -> Self {
        Self {
            instrument: choice(&INSTRUMENT),
            size: float(&SIZE),
            stiffness: float(&STIFFNESS),
            density: float(&DENSITY),
            swing: float(&SWING),
            sympathy: float(&SYMPATHY),
        }
    }
}

impl Body {
    /// Index of the instrument that is struck: the factory's banks, then the user's own.
    #[must_use]
    pub fn index(&self) -> usize {
        index(&self.instrument)
    }

    pub(super) fn apply(&self, settings: &mut Settings) {
        settings.tweak = Tweak {
            size: plain(&self.size),
            stiffness: plain(&self.stiffness),
            density: plain(&self.density),
        };
        settings.swing = share(&self.swing);
        settings.sympathy = share(&self.sympathy);
    }
}
