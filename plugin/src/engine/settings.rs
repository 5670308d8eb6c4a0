//! What the player can change, as physical values.

use super::{Discs, Losses, Mallet};
use modes::{Damping, Rayleigh};

/// Allowed ranges of [`Settings`]; the plug-in's parameters have the same.
pub mod range {
    use std::ops::RangeInclusive;

    /// Strike position along the line, as a fraction of its length.
    pub const STRIKE_POSITION: RangeInclusive<f64> = 0.0..=1.0;
    /// Share of half the line that the velocity moves the strike.
    pub const VELOCITY_TO_POSITION: RangeInclusive<f64> = -1.0..=1.0;
    /// Share of half the line that chance moves the strike, either way.
    pub const POSITION_SCATTER: RangeInclusive<f64> = 0.0..=1.0;
    /// Modulus of the mallet's head, in Pa: 1 MPa is soft yarn, 100 GPa brass.
    pub const HARDNESS_PA: RangeInclusive<f64> = 1e6..=1e11;
    /// Mass of the mallet, in kg.
    pub const MALLET_KG: RangeInclusive<f64> = 0.001..=1.0;
    /// Radius of its head, in m.
    pub const HEAD_RADIUS_M: RangeInclusive<f64> = 0.001..=0.1;
    /// Loss of its head, in s/m.
    pub const HEAD_LOSS_S_M: RangeInclusive<f64> = 0.0..=2.0;
    /// Greatest share of the force by the grain of head and surface.
    pub const ROUGHNESS: RangeInclusive<f64> = 0.0..=1.0;
    /// Force of a hand that presses on after the blow, in N.
    pub const PRESS_N: RangeInclusive<f64> = 0.0..=50.0;
    /// Impact speed between the softest and the hardest touch, in dB.
    pub const VELOCITY_RANGE_DB: RangeInclusive<f64> = 0.0..=60.0;
    /// Stiffness-proportional damping, in s; O'Brien 2002, Table 1 has 1e-7 (metal) to 8e-6 (wood).
    pub const ALPHA1_S: RangeInclusive<f64> = 0.0..=2e-5;
    /// Mass-proportional damping, in 1/s; O'Brien 2002, Table 1 has 0 to 50.
    pub const ALPHA2_PER_S: RangeInclusive<f64> = 0.0..=100.0;
    /// Added loss factor; wood has 1e-2.
    pub const LOSS_FACTOR: RangeInclusive<f64> = 0.0..=0.1;
    /// Factors on the material's own damping, on radiation and on the supports.
    pub const CAUSE: RangeInclusive<f64> = 0.0..=10.0;
    /// How often a second the resonators' discs shut, in Hz.
    pub const MOTOR_HZ: RangeInclusive<f64> = 0.0..=12.0;
    /// Share of the resonators' mouths that the discs cover.
    pub const MOTOR_DEPTH: RangeInclusive<f64> = 0.0..=1.0;
    /// Angle of the discs ahead of the motor, in degrees.
    pub const MOTOR_DEG: RangeInclusive<f64> = 0.0..=180.0;
    /// Stereo width: 0 is mono, 1 what two ears hear.
    pub const WIDTH: RangeInclusive<f64> = 0.0..=1.0;
    /// Output gain, in dB.
    pub const GAIN_DB: RangeInclusive<f64> = -60.0..=12.0;
}

/// Targets of everything that can be played with; the engine moves towards them without clicks.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Settings {
    /// Where a strike lands on the line, 0…1.
    pub strike_position: f64,
    /// How far full velocity moves the strike, as a share of half the line.
    pub velocity_to_position: f64,
    /// How far chance moves the strike either way, as a share of half the line.
    pub position_scatter: f64,
    /// What strikes.
    pub mallet: Mallet,
    /// Impact speed between the softest and the hardest touch, in dB.
    pub velocity_range_db: f64,
    /// What takes the bodies' energy.
    pub losses: Losses,
    /// Whether a released key damps its body.
    pub note_off_damps: bool,
    /// The discs in the resonators' mouths.
    pub motor: Discs,
    /// Stereo width, 0…1.
    pub width: f64,
    /// Output gain, in dB.
    pub gain_db: f64,
}

impl Default for Settings {
    fn default() -> Self {
        Self::DEFAULT
    }
}

impl Settings {
    /// A chime struck near its end with a hard mallet.
    ///
    /// At 3 % of the length each of a free tube's first six bending modes has at least 39 % of its
    /// greatest motion; 22.4 %, where a tube hangs, is a node of the first.
    pub const DEFAULT: Self = Self {
        strike_position: 0.03,
        velocity_to_position: 0.0,
        position_scatter: 0.0,
        mallet: Mallet::DEFAULT,
        velocity_range_db: 40.0,
        losses: Losses::AS_BUILT,
        note_off_damps: false,
        motor: Discs::OPEN,
        width: 1.0,
        gain_db: 0.0,
    };

    /// The same with every value inside its [`range`], and what is not a number at its default.
    #[must_use]
    pub fn sane(self) -> Self {
        let normal = Self::DEFAULT;
        let (mallet, usual) = (self.mallet, normal.mallet);
        let added = self.losses.added;
        let within = |value: f64, range: std::ops::RangeInclusive<f64>, default: f64| {
            if value.is_nan() {
                return default;
            }
            value.clamp(*range.start(), *range.end())
        };
        Self {
            strike_position: within(
                self.strike_position,
                range::STRIKE_POSITION,
                normal.strike_position,
            ),
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
            mallet: Mallet {
                mass_kg: within(mallet.mass_kg, range::MALLET_KG, usual.mass_kg),
                head_radius_m: within(
                    mallet.head_radius_m,
                    range::HEAD_RADIUS_M,
                    usual.head_radius_m,
                ),
                hardness_pa: within(mallet.hardness_pa, range::HARDNESS_PA, usual.hardness_pa),
                loss_s_m: within(mallet.loss_s_m, range::HEAD_LOSS_S_M, usual.loss_s_m),
                roughness: within(mallet.roughness, range::ROUGHNESS, usual.roughness),
                press_n: within(mallet.press_n, range::PRESS_N, usual.press_n),
            },
            velocity_range_db: within(
                self.velocity_range_db,
                range::VELOCITY_RANGE_DB,
                normal.velocity_range_db,
            ),
            losses: Losses {
                own: within(self.losses.own, range::CAUSE, 1.0),
                added: Damping {
                    rayleigh: Rayleigh {
                        alpha1_s: within(added.rayleigh.alpha1_s, range::ALPHA1_S, 0.0),
                        alpha2_per_s: within(added.rayleigh.alpha2_per_s, range::ALPHA2_PER_S, 0.0),
                    },
                    loss_factor: within(added.loss_factor, range::LOSS_FACTOR, 0.0),
                },
                radiation: within(self.losses.radiation, range::CAUSE, 1.0),
                supports: within(self.losses.supports, range::CAUSE, 1.0),
            },
            note_off_damps: self.note_off_damps,
            motor: Discs {
                speed_hz: within(self.motor.speed_hz, range::MOTOR_HZ, normal.motor.speed_hz),
                depth: within(self.motor.depth, range::MOTOR_DEPTH, normal.motor.depth),
                phase_deg: within(
                    self.motor.phase_deg,
                    range::MOTOR_DEG,
                    normal.motor.phase_deg,
                ),
            },
            width: within(self.width, range::WIDTH, normal.width),
            gain_db: within(self.gain_db, range::GAIN_DB, normal.gain_db),
        }
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
