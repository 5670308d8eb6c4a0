//! What rubs.

use super::Spec;
use super::build::{choice, float, index, plain};
use super::choice::Choice;
use super::text::Text;
use crate::engine::{Bow, Settings, range};
use nice_plug::prelude::{FloatParam, IntParam, Params};

const NORMAL: Bow = Bow::DEFAULT;

/// What a key does.
pub const KEYS: Spec = Spec {
    id: "keys",
    name: "Keys",
    tooltip: "What a key does: strikes; rubs for as long as it is held, the harder the greater its velocity, \
              as a bow on a bar or a stick around a bowl's rim; or strikes, and rubs while it is held as \
              hard as something assigned to bow pressure says.",
    ..Spec::choice(Choice::Keys, 0)
};

/// Its force.
pub const FORCE: Spec = Spec {
    id: "bowf",
    name: "Bow force",
    tooltip: "Force of the bow at full pressure: too little and a body does not sing, too much and it \
              grates.",
    skew: 0.5,
    ..Spec::number(Text::Digits("N"), 1.0, &range::BOW_N, NORMAL.force_n)
};

/// Its speed.
pub const SPEED: Spec = Spec {
    id: "bowv",
    name: "Bow speed",
    tooltip: "Speed of the bow: how loud a rubbed body grows, and how soon its beats come round as a stick \
              goes around the rim.",
    skew: 0.5,
    ..Spec::number(Text::Digits("m/s"), 1.0, &range::BOW_M_S, NORMAL.speed_m_s)
};

pub(super) const SPECS: [Spec; 3] = [KEYS, FORCE, SPEED];

/// What a key does, by number of [`KEYS`].
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) enum Keys {
    /// Strikes.
    #[default]
    Strike,
    /// Rubs while it is held.
    Rub,
    /// Strikes, and rubs while it is held as hard as hands press.
    Both,
}

/// What rubs.
#[derive(Params)]
pub struct Bows {
    /// See [`KEYS`].
    #[id = "keys"]
    pub keys: IntParam,
    /// See [`FORCE`].
    #[id = "bowf"]
    pub force: FloatParam,
    /// See [`SPEED`].
    #[id = "bowv"]
    pub speed: FloatParam,
}

impl Default for Bows {
    fn default() -> Self {
        Self {
            keys: choice(&KEYS),
            force: float(&FORCE),
            speed: float(&SPEED),
        }
    }
}

impl Bows {
    pub(crate) fn keys(&self) -> Keys {
        match index(&self.keys) {
            0 => Keys::Strike,
            1 => Keys::Rub,
            _ => Keys::Both,
        }
    }

    pub(super) fn apply(&self, settings: &mut Settings) {
        settings.bow = Bow {
            force_n: plain(&self.force),
            speed_m_s: plain(&self.speed),
            rubs: self.keys() == Keys::Rub,
        };
    }
}
