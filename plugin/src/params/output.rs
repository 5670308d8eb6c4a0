//! Level of the whole.

use super::Spec;
use super::build::{float, plain, switch};
use super::text::Text;
use crate::engine::{Settings, range};
use nice_plug::prelude::{BoolParam, FloatParam, Params};

const NORMAL: Settings = Settings::DEFAULT;

/// Output gain.
pub const GAIN: Spec = Spec {
    id: "gain",
    name: "Output gain",
    tooltip: "Level of the whole. At 0 dB no single strike peaks above -15 dB full scale, so that chords \
              fit.",
    ..Spec::number(Text::Fixed("dB"), 1.0, &range::GAIN_DB, NORMAL.gain_db)
};

/// Safety limiter.
pub const LIMITER: Spec = Spec {
    id: "limit",
    name: "Limiter",
    tooltip: "Turns down what would go over full scale, at once, and lets go within half a second. What \
              stays below passes unchanged to the bit.",
    ..Spec::switch("off", "on", NORMAL.limiter)
};

pub(super) const SPECS: [Spec; 2] = [GAIN, LIMITER];

/// Level of the whole.
#[derive(Params)]
pub struct Output {
    /// See [`GAIN`].
    #[id = "gain"]
    pub gain: FloatParam,
    /// See [`LIMITER`].
    #[id = "limit"]
    pub limiter: BoolParam,
}

impl Default for Output {
    fn default() -> Self {
        Self {
            gain: float(&GAIN),
            limiter: switch(&LIMITER),
        }
    }
}

impl Output {
    pub(super) fn apply(&self, settings: &mut Settings) {
        settings.gain_db = plain(&self.gain);
        settings.limiter = self.limiter.value();
    }
}
