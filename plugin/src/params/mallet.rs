//! What strikes.

use super::Spec;
use super::build::{choice, float, index, plain, share};
use super::choice::Choice;
use super::mallets::MALLETS;
use super::text::Text;
use crate::engine::{Mallet, Settings, range};
use crate::hands::Modulated;
use nice_plug::prelude::{FloatParam, IntParam, Param, Params};

const NORMAL: Mallet = Mallet::DEFAULT;

/// A mallet by name.
pub const MALLET: Spec = Spec {
    id: "mallet",
    name: "Mallet",
    tooltip: "A mallet by name, from soft yarn (dull and round) to brass (bright and hard), or \"as set\" by \
              the mass, head radius, hardness and head loss below.",
    ..Spec::choice(Choice::Mallet, 0)
};

/// Its mass.
pub const MASS: Spec = Spec {
    id: "mass",
    name: "Mallet mass",
    tooltip: "Mass of the mallet: a heavier one is louder and stays longer on the body, which takes the \
              high partials away.",
    skew: 0.35,
    ..Spec::number(Text::Digits("g"), 1e3, &range::MALLET_KG, NORMAL.mass_kg)
};

/// Radius of its head.
pub const RADIUS: Spec = Spec {
    id: "head",
    name: "Head radius",
    tooltip: "Radius of the mallet's head where it touches: a blunter one leaves a little sooner and \
              sounds a little brighter.",
    skew: 0.4,
    ..Spec::number(
        Text::Digits("mm"),
        1e3,
        &range::HEAD_RADIUS_M,
        NORMAL.head_radius_m,
    )
};

/// How hard it is.
pub const HARDNESS: Spec = Spec {
    id: "hard",
    name: "Mallet hardness",
    tooltip: "Stiffness of the mallet's head: 1 MPa is soft yarn, 1 GPa rawhide, 100 GPa brass. \
              Harder heads leave sooner and sound brighter, up to what the body itself withstands.",
    skew: 0.15,
    unit: "Pa",
    ..Spec::number(Text::Pascals, 1.0, &range::HARDNESS_PA, NORMAL.hardness_pa)
};

/// What it swallows.
pub const LOSS: Spec = Spec {
    id: "hloss",
    name: "Head loss",
    tooltip: "How much of a blow the mallet's head swallows, the more the faster: 0 s/m bounces off as steel \
              does, 0.5 s/m is yarn. Softens hard strikes.",
    ..Spec::number(
        Text::Digits("s/m"),
        1.0,
        &range::HEAD_LOSS_S_M,
        NORMAL.loss_s_m,
    )
};

/// Its grain.
pub const ROUGHNESS: Spec = Spec {
    id: "rough",
    name: "Roughness",
    tooltip: "Grain of head and surface: noise on the force while they touch, a click of its own on every \
              strike.",
    ..Spec::percent(&range::ROUGHNESS, NORMAL.roughness)
};

/// A hand that presses on.
pub const DEAD_STROKE: Spec = Spec {
    id: "dead",
    name: "Dead stroke",
    tooltip: "Force with which the hand presses the mallet on after the blow for as long as the key is down: \
              0 N lets it bounce off, more chokes the sound into a thud.",
    skew: 0.5,
    ..Spec::number(Text::Digits("N"), 1.0, &range::PRESS_N, NORMAL.press_n)
};

pub(super) const SPECS: [Spec; 7] = [MALLET, MASS, RADIUS, HARDNESS, LOSS, ROUGHNESS, DEAD_STROKE];

/// What strikes.
#[derive(Params)]
pub struct Mallets {
    /// See [`MALLET`].
    #[id = "mallet"]
    pub mallet: IntParam,
    /// See [`MASS`].
    #[id = "mass"]
    pub mass: FloatParam,
    /// See [`RADIUS`].
    #[id = "head"]
    pub radius: FloatParam,
    /// See [`HARDNESS`].
    #[id = "hard"]
    pub hardness: FloatParam,
    /// See [`LOSS`].
    #[id = "hloss"]
    pub loss: FloatParam,
    /// See [`ROUGHNESS`].
    #[id = "rough"]
    pub roughness: FloatParam,
    /// See [`DEAD_STROKE`].
    #[id = "dead"]
    pub dead_stroke: FloatParam,
}

impl Default for Mallets {
    fn default() -> Self {
        Self {
            mallet: choice(&MALLET),
            mass: float(&MASS),
            radius: float(&RADIUS),
            hardness: float(&HARDNESS).with_poly_modulation_id(Modulated::Hardness as u32),
            loss: float(&LOSS),
            roughness: float(&ROUGHNESS),
            dead_stroke: float(&DEAD_STROKE),
        }
    }
}

impl Mallets {
    /// How much harder a host's modulation of one note makes its mallet, in powers of ten.
    ///
    /// A named mallet is modulated from where its own hardness lies in the parameter's range.
    pub(crate) fn harder(&self, modulation: f64) -> f64 {
        let set_pa = self.set().hardness_pa as f32;
        let start = match index(&self.mallet) {
            0 => self.hardness.unmodulated_normalized_value(),
            _ => self.hardness.preview_normalized(set_pa),
        };
        if modulation == 0.0 {
            return 0.0;
        }
        let pa = self.hardness.preview_plain(start + modulation as f32);
        f64::from(pa / set_pa).log10()
    }

    /// The mallet that is set, by name or by its numbers.
    fn set(&self) -> Mallet {
        let named = index(&self.mallet)
            .checked_sub(1)
            .and_then(|at| MALLETS.get(at));
        named.map_or_else(
            || Mallet {
                mass_kg: 1e-3 * plain(&self.mass),
                head_radius_m: 1e-3 * plain(&self.radius),
                hardness_pa: plain(&self.hardness),
                loss_s_m: plain(&self.loss),
                ..NORMAL
            },
            |(_, mallet)| *mallet,
        )
    }

    pub(super) fn apply(&self, settings: &mut Settings) {
        settings.mallet = Mallet {
            roughness: share(&self.roughness),
            press_n: plain(&self.dead_stroke),
            ..self.set()
        };
    }
}
