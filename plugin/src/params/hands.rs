//! How the player's hands are understood.

use super::Spec;
use super::assign::Assign;
use super::build::{choice, float, index, plain, share};
use super::choice::Choice;
use super::text::Text;
use crate::hands::{self, BEND_RANGE_MOST, Mpe};
use nice_plug::prelude::{FloatParam, IntParam, Params};

const NORMAL: hands::Settings = hands::Settings::DEFAULT;

/// From the velocity of a note to that of the strike.
pub const VELOCITY_CURVE: Spec = Spec {
    id: "vcurve",
    name: "Velocity curve",
    tooltip: "How a light touch is answered: above 0 it strikes harder, below 0 softer, so that keyboards \
              feel right.",
    ..Spec::percent(&(-1.0..=1.0), NORMAL.velocity_curve)
};

/// Range of the pitch wheel.
pub const BEND_RANGE: Spec = Spec {
    id: "bend",
    name: "Bend range",
    tooltip: "How far the pitch wheel bends what rings, either way, until a channel is told another range \
              by RPN 0.",
    ..Spec::number(
        Text::Fixed("st"),
        1.0,
        &(0.0..=BEND_RANGE_MOST),
        NORMAL.bend_range_semitones,
    )
};

/// When MPE is understood.
pub const MPE: Spec = Spec {
    id: "mpe",
    name: "MPE",
    tooltip: "Whether channels 2 to 16 carry one note each with bend, pressure and slide of its own: never, \
              when the controller announces it, or always.",
    ..Spec::choice(Choice::Mpe, NORMAL.mpe as usize)
};

/// Range of an MPE note's bend.
pub const MPE_BEND_RANGE: Spec = Spec {
    id: "mpebnd",
    name: "MPE bend range",
    tooltip: "How far a finger of an MPE controller bends its note, either way; to be the same as in the \
              controller.",
    ..Spec::number(
        Text::Fixed("st"),
        1.0,
        &(0.0..=BEND_RANGE_MOST),
        NORMAL.member_bend_range_semitones,
    )
};

pub(super) const SPECS: [Spec; 4] = [VELOCITY_CURVE, BEND_RANGE, MPE, MPE_BEND_RANGE];

/// How hands are understood.
#[derive(Params)]
pub struct Hands {
    /// See [`VELOCITY_CURVE`].
    #[id = "vcurve"]
    pub velocity_curve: FloatParam,
    /// See [`BEND_RANGE`].
    #[id = "bend"]
    pub bend_range: FloatParam,
    /// See [`MPE`].
    #[id = "mpe"]
    pub mpe: IntParam,
    /// See [`MPE_BEND_RANGE`].
    #[id = "mpebnd"]
    pub mpe_bend_range: FloatParam,
}

impl Default for Hands {
    fn default() -> Self {
        Self {
            velocity_curve: float(&VELOCITY_CURVE),
            bend_range: float(&BEND_RANGE),
            mpe: choice(&MPE),
            mpe_bend_range: float(&MPE_BEND_RANGE),
        }
    }
}

impl Hands {
    pub(super) fn settings(&self, assign: &[Assign; hands::SLOTS]) -> hands::Settings {
        hands::Settings {
            velocity_curve: share(&self.velocity_curve),
            mpe: Mpe::from_index(index(&self.mpe)),
            bend_range_semitones: plain(&self.bend_range),
            member_bend_range_semitones: plain(&self.mpe_bend_range),
            assignments: assign.each_ref().map(Assign::assignment),
        }
    }
}
