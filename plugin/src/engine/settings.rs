//! What the player can change, as physical values.

use super::{Bow, Discs, Listener, Losses, Mallet, Split, Tweak, range};
use modes::{Damping, Rayleigh};
use std::ops::RangeInclusive;

/// Targets of everything that can be played with; the engine moves towards them without clicks.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Settings {
    /// Where a strike lands on the line, 0…1.
    pub strike_position: f64,
    /// Where across a body's width, or around it, a strike lands, 0…1; bodies with one line have but
    /// that.
    pub strike_across: f64,
    /// How far full velocity moves the strike, as a share of half the line.
    pub velocity_to_position: f64,
    /// How far chance moves the strike either way, as a share of half the line.
    pub position_scatter: f64,
    /// How far chance changes the impact speed either way, in dB.
    pub speed_scatter_db: f64,
    /// What strikes.
    pub mallet: Mallet,
    /// Impact speed between the softest and the hardest touch, in dB.
    pub velocity_range_db: f64,
    /// What rubs.
    pub bow: Bow,
    /// What takes the bodies' energy.
    pub losses: Losses,
    /// Size and material beside those as built.
    pub tweak: Tweak,
    /// Whether a released key damps its body.
    pub note_off_damps: bool,
    /// The discs in the resonators' mouths.
    pub motor: Discs,
    /// Where the listener is.
    pub listener: Listener,
    /// Share of a hung body's swing that is heard, 0…1.
    pub swing: f64,
    /// How firmly a common support joins the bodies, 0…1.
    pub sympathy: f64,
    /// Output gain, in dB.
    pub gain_db: f64,
    /// Whether what would go over full scale is turned down, each output by itself.
    pub limiter: bool,
    /// What goes to which output.
    pub split: Split,
}

impl Default for Settings {
    fn default() -> Self {
        Self::DEFAULT
    }
}

/// `value` within `range`; `default` for what is not a number.
pub(super) fn within(value: f64, range: RangeInclusive<f64>, default: f64) -> f64 {
    if value.is_nan() {
        return default;
    }
    value.clamp(*range.start(), *range.end())
}

impl Settings {
    /// A chime struck near its end with a hard mallet.
    ///
    /// At 3 % of the length each of a free tube's first six bending modes has at least 39 % of its
    /// greatest motion; 22.4 %, where a tube hangs, is a node of the first.
    pub const DEFAULT: Self = Self {
        strike_position: 0.03,
        strike_across: 0.0,
        velocity_to_position: 0.0,
        position_scatter: 0.0,
        speed_scatter_db: 0.0,
        mallet: Mallet::DEFAULT,
        velocity_range_db: 40.0,
        bow: Bow::DEFAULT,
        losses: Losses::AS_BUILT,
        tweak: Tweak::NONE,
        note_off_damps: false,
        motor: Discs::OPEN,
        listener: Listener::AS_BUILT,
        swing: 0.0,
        sympathy: 0.0,
        gain_db: 0.0,
        limiter: true,
        split: Split::Main,
    };

    /// The same with every value inside its [`range`], and what is not a number at its default.
    #[must_use]
    pub fn sane(self) -> Self {
        let normal = Self::DEFAULT;
        Self {
            strike_position: within(
                self.strike_position,
                range::STRIKE_POSITION,
                normal.strike_position,
            ),
            strike_across: within(self.strike_across, range::SHARE, normal.strike_across),
            velocity_to_position: within(
                self.velocity_to_position,
                range::VELOCITY_TO_POSITION,
                normal.velocity_to_position,
            ),
            position_scatter: within(
                self.position_scatter,
                range::POSITION_SCATTER,
                normal.position_scatter,
            ),
            speed_scatter_db: within(self.speed_scatter_db, range::SPEED_SCATTER_DB, 0.0),
            mallet: self.mallet.sane(),
            velocity_range_db: within(
                self.velocity_range_db,
                range::VELOCITY_RANGE_DB,
                normal.velocity_range_db,
            ),
            bow: self.bow.sane(),
            losses: sane_losses(&self.losses),
            tweak: self.tweak.sane(),
            note_off_damps: self.note_off_damps,
            motor: sane_discs(&self.motor),
            listener: self.listener.sane(),
            swing: within(self.swing, range::SHARE, 0.0),
            sympathy: within(self.sympathy, range::SHARE, 0.0),
            gain_db: within(self.gain_db, range::GAIN_DB, normal.gain_db),
            limiter: self.limiter,
            split: self.split,
        }
    }
}

fn sane_losses(losses: &Losses) -> Losses {
    let Rayleigh {
        alpha1_s,
        alpha2_per_s,
    } = losses.added.rayleigh;
    Losses {
        own: within(losses.own, range::CAUSE, 1.0),
        added: Damping {
            rayleigh: Rayleigh {
                alpha1_s: within(alpha1_s, range::ALPHA1_S, 0.0),
                alpha2_per_s: within(alpha2_per_s, range::ALPHA2_PER_S, 0.0),
            },
            loss_factor: within(losses.added.loss_factor, range::LOSS_FACTOR, 0.0),
        },
        radiation: within(losses.radiation, range::CAUSE, 1.0),
        supports: within(losses.supports, range::CAUSE, 1.0),
    }
}

fn sane_discs(discs: &Discs) -> Discs {
    let normal = Discs::OPEN;
    Discs {
        speed_hz: within(discs.speed_hz, range::MOTOR_HZ, normal.speed_hz),
        depth: within(discs.depth, range::MOTOR_DEPTH, normal.depth),
        phase_deg: within(discs.phase_deg, range::MOTOR_DEG, normal.phase_deg),
    }
}

#[cfg(test)]
mod tests {
    use super::{Mallet, Settings};

    #[test]
    fn nonsense_becomes_allowed_values() {
        let wild = Settings {
            mallet: Mallet {
                hardness_pa: f64::NAN,
                ..Mallet::DEFAULT
            },
            gain_db: f64::INFINITY,
            strike_position: -3.0,
            ..Settings::default()
        };
        let sane = wild.sane();
        assert_eq!(sane.mallet.hardness_pa, 2e9);
        assert_eq!(sane.gain_db, 12.0);
        assert_eq!(sane.strike_position, 0.0);
        assert_eq!(Settings::default().sane(), Settings::default());
    }
}
