//! Where the listener is.

use super::Spec;
use super::build::{float, plain, share};
use super::text::Text;
use crate::engine::{Listener, Settings, range};
use nice_plug::prelude::{FloatParam, Params};

const NORMAL: Listener = Listener::AS_BUILT;

/// Stereo width.
pub const WIDTH: Spec = Spec {
    id: "width",
    name: "Width",
    tooltip: "How far apart the two ears hear: 100 % as a listener before the instrument does, with \
              the low bodies on the left; 0 % is mono.",
    ..Spec::percent(&range::WIDTH, NORMAL.width)
};

/// Distance over that of the bank.
pub const DISTANCE: Spec = Spec {
    id: "dist",
    name: "Distance",
    tooltip: "How far away the listener is, over a seat before the instrument: 2 x is 6 dB softer.",
    skew: 0.3,
    ..Spec::number(Text::Digits("x"), 1.0, &range::DISTANCE, NORMAL.distance)
};

/// How far the head is turned.
pub const ANGLE: Spec = Spec {
    id: "angle",
    name: "Angle",
    tooltip: "How far the listener's head is turned to the left: at 90 deg the instrument is on the right, \
              louder and sooner in that ear.",
    ..Spec::number(Text::Fixed("deg"), 1.0, &range::ANGLE_DEG, NORMAL.angle_deg)
};

pub(super) const SPECS: [Spec; 3] = [WIDTH, DISTANCE, ANGLE];

/// The listener.
#[derive(Params)]
pub struct Ears {
    /// See [`WIDTH`].
    #[id = "width"]
    pub width: FloatParam,
    /// See [`DISTANCE`].
    #[id = "dist"]
    pub distance: FloatParam,
    /// See [`ANGLE`].
    #[id = "angle"]
    pub angle: FloatParam,
}

impl Default for Ears {
    fn default() -> Self {
        Self {
            width: float(&WIDTH),
            distance: float(&DISTANCE),
            angle: float(&ANGLE),
        }
    }
}

impl Ears {
    pub(super) fn apply(&self, settings: &mut Settings) {
        settings.listener = Listener {
            distance: plain(&self.distance),
            angle_deg: plain(&self.angle),
            width: share(&self.width),
        };
    }
}
