//! The discs in the resonators' mouths.

use super::Spec;
use super::build::{float, plain, share};
use super::text::Text;
use crate::engine::{Discs, Settings, range};
use nice_plug::prelude::{FloatParam, Params};

const NORMAL: Discs = Discs::OPEN;

/// Speed of the resonators' discs.
pub const SPEED: Spec = Spec {
    id: "mspeed",
    name: "Motor speed",
    tooltip: "How often a second the motor's discs shut the tubes under the bars: the vibraphone's \
              vibrato. 0 Hz stops them. Bodies without tubes do not change.",
    ..Spec::number(Text::Fixed("Hz"), 1.0, &range::MOTOR_HZ, NORMAL.speed_hz)
};

/// Depth of the resonators' discs.
pub const DEPTH: Spec = Spec {
    id: "mdepth",
    name: "Motor depth",
    tooltip: "How much of the tubes' mouths the discs cover when they lie across them: 100 % shuts them, \
              so that the fundamental comes and goes; 0 % leaves them open.",
    ..Spec::percent(&range::MOTOR_DEPTH, NORMAL.depth)
};

/// Phase of the resonators' discs.
pub const PHASE: Spec = Spec {
    id: "mphase",
    name: "Motor phase",
    tooltip: "Angle of the discs ahead of the motor. With the motor stopped, 90 deg leaves the tubes open \
              (louder and shorter fundamentals) and 0 deg shuts them (softer and longer).",
    ..Spec::number(Text::Fixed("deg"), 1.0, &range::MOTOR_DEG, NORMAL.phase_deg)
};

pub(super) const SPECS: [Spec; 3] = [SPEED, DEPTH, PHASE];

/// The motor.
#[derive(Params)]
pub struct Motor {
    /// See [`SPEED`].
    #[id = "mspeed"]
    pub speed: FloatParam,
    /// See [`DEPTH`].
    #[id = "mdepth"]
    pub depth: FloatParam,
    /// See [`PHASE`].
    #[id = "mphase"]
    pub phase: FloatParam,
}

impl Default for Motor {
    fn default() -> Self {
        Self {
            speed: float(&SPEED),
            depth: float(&DEPTH),
            phase: float(&PHASE),
        }
    }
}

impl Motor {
    pub(super) fn apply(&self, settings: &mut Settings) {
        settings.motor = Discs {
            speed_hz: plain(&self.speed),
            depth: share(&self.depth),
            phase_deg: plain(&self.phase),
        };
    }
}
