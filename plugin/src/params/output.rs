//! Level of the whole, and what goes to which output.

use super::Spec;
use super::build::{choice, float, index, plain, switch};
use super::choice::Choice;
use super::text::Text;
use crate::engine::{Settings, Split, range};
use nice_plug::prelude::{BoolParam, FloatParam, IntParam, Params};

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
              stays below passes unchanged to the bit. Each output has its own.",
    ..Spec::switch("off", "on", NORMAL.limiter)
};

/// What goes to which output.
pub const OUTPUTS: Spec = Spec {
    id: "outs",
    name: "Split outputs",
    tooltip: "Where the host has the plug-in with eight outputs: an octave on each from C2 up (lower keys in \
              main); a body on each, round again after eight; or MIDI channels 1 to 8. What is sent \
              nowhere else is in main, which with one output is everything.",
    ..Spec::choice(Choice::Outputs, NORMAL.split as usize)
};

pub(super) const SPECS: [Spec; 3] = [GAIN, LIMITER, OUTPUTS];

/// Level and outputs of the whole.
#[derive(Params)]
pub struct Output {
    /// See [`GAIN`].
    #[id = "gain"]
    pub gain: FloatParam,
    /// See [`LIMITER`].
    #[id = "limit"]
    pub limiter: BoolParam,
    /// See [`OUTPUTS`].
    #[id = "outs"]
    pub outputs: IntParam,
}

impl Default for Output {
    fn default() -> Self {
        Self {
            gain: float(&GAIN),
            limiter: switch(&LIMITER),
            outputs: choice(&OUTPUTS),
        }
    }
}

impl Output {
    pub(super) fn apply(&self, settings: &mut Settings) {
        settings.gain_db = plain(&self.gain);
        settings.limiter = self.limiter.value();
        settings.split = Split::from_index(index(&self.outputs));
    }
}
