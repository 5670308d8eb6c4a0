//! Where and how fast a body is struck.

use super::Spec;
use super::build::{float, plain, share};
use super::text::Text;
use crate::engine::{Settings, range};
use crate::hands::Modulated;
use nice_plug::prelude::{FloatParam, Params};

const NORMAL: Settings = Settings::DEFAULT;

/// Where a strike lands.
pub const POSITION: Spec = Spec {
    id: "pos",
    name: "Strike position",
    tooltip: "Where along its length a body is struck (a bowl from its rim, 0 %, to the middle of its \
              base). Near an end all partials sound and the tone is bright; in the middle every second \
              one is missing; at 22 % the lowest is silent.",
    ..Spec::percent(&range::STRIKE_POSITION, NORMAL.strike_position)
};

/// Where across a body a strike lands.
pub const ACROSS: Spec = Spec {
    id: "acrs",
    name: "Strike across",
    tooltip: "Where across its width, or around it, a body is struck. Counts for bodies with a surface, \
              such as those of meshes, membranes and plates; tubes, bars and bowls have one line.",
    ..Spec::percent(&range::SHARE, NORMAL.strike_across)
};

/// How velocity moves the strike.
pub const FROM_VELOCITY: Spec = Spec {
    id: "vpos",
    name: "Velocity to position",
    tooltip: "How far a hard strike lands from a soft one, in halves of the length, so that loudness \
              changes the mixture of partials too.",
    ..Spec::percent(&range::VELOCITY_TO_POSITION, NORMAL.velocity_to_position)
};

/// How chance moves the strike.
pub const SCATTER: Spec = Spec {
    id: "scat",
    name: "Position scatter",
    tooltip: "How far chance moves each strike, in halves of the length, so that repeated notes \
              differ as a player's do. The same song always scatters alike.",
    ..Spec::percent(&range::POSITION_SCATTER, NORMAL.position_scatter)
};

/// Dynamics.
pub const VELOCITY_RANGE: Spec = Spec {
    id: "vrng",
    name: "Velocity range",
    tooltip: "How much softer the softest strike is than the hardest. Soft strikes are also duller.",
    ..Spec::number(
        Text::Fixed("dB"),
        1.0,
        &range::VELOCITY_RANGE_DB,
        NORMAL.velocity_range_db,
    )
};

/// How chance changes the speed.
pub const SPEED_SCATTER: Spec = Spec {
    id: "sscat",
    name: "Speed scatter",
    tooltip: "How much chance makes each strike harder or softer, either way, as no hand strikes twice \
              alike. The same song always scatters alike.",
    ..Spec::number(
        Text::Fixed("dB"),
        1.0,
        &range::SPEED_SCATTER_DB,
        NORMAL.speed_scatter_db,
    )
};

pub(super) const SPECS: [Spec; 6] = [
    POSITION,
    ACROSS,
    FROM_VELOCITY,
    SCATTER,
    VELOCITY_RANGE,
    SPEED_SCATTER,
];

/// Where and how fast bodies are struck.
#[derive(Params)]
pub struct Strike {
    /// See [`POSITION`].
    #[id = "pos"]
    pub position: FloatParam,
    /// See [`ACROSS`].
    #[id = "acrs"]
    pub across: FloatParam,
    /// See [`FROM_VELOCITY`].
    #[id = "vpos"]
    pub from_velocity: FloatParam,
    /// See [`SCATTER`].
    #[id = "scat"]
    pub scatter: FloatParam,
    /// See [`VELOCITY_RANGE`].
    #[id = "vrng"]
    pub velocity_range: FloatParam,
    /// See [`SPEED_SCATTER`].
    #[id = "sscat"]
    pub speed_scatter: FloatParam,
}

impl Default for Strike {
    fn default() -> Self {
        Self {
            position: float(&POSITION).with_poly_modulation_id(Modulated::StrikePosition as u32),
            across: float(&ACROSS),
            from_velocity: float(&FROM_VELOCITY),
            scatter: float(&SCATTER),
            velocity_range: float(&VELOCITY_RANGE),
            speed_scatter: float(&SPEED_SCATTER),
        }
    }
}

impl Strike {
    /// How far a host's modulation of one note moves its strike, in parts of the line.
    pub(crate) fn moved(&self, modulation: f64) -> f64 {
        super::poly::moved(&self.position, modulation) / 100.0
    }

    pub(super) fn apply(&self, settings: &mut Settings) {
        settings.strike_position = share(&self.position);
        settings.strike_across = share(&self.across);
        settings.velocity_to_position = share(&self.from_velocity);
        settings.position_scatter = share(&self.scatter);
        settings.velocity_range_db = plain(&self.velocity_range);
        settings.speed_scatter_db = plain(&self.speed_scatter);
    }
}
