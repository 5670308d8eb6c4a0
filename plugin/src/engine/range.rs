//! Allowed ranges of [`super::Settings`]; the plug-in's parameters have the same.

use std::ops::RangeInclusive;

/// Strike position along the line, as a fraction of its length.
pub const STRIKE_POSITION: RangeInclusive<f64> = 0.0..=1.0;
/// Share of half the line that the velocity moves the strike.
pub const VELOCITY_TO_POSITION: RangeInclusive<f64> = -1.0..=1.0;
/// Share of half the line that chance moves the strike, either way.
pub const POSITION_SCATTER: RangeInclusive<f64> = 0.0..=1.0;
/// How far chance changes the impact speed either way, in dB.
pub const SPEED_SCATTER_DB: RangeInclusive<f64> = 0.0..=12.0;
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
/// Force of the bow at full pressure, in N.
pub const BOW_N: RangeInclusive<f64> = 0.0..=40.0;
/// Speed of the bow, in m/s.
pub const BOW_M_S: RangeInclusive<f64> = 0.01..=2.0;
/// Stiffness-proportional damping, in s; O'Brien 2002, Table 1 has 1e-7 (metal) to 8e-6 (wood).
pub const ALPHA1_S: RangeInclusive<f64> = 0.0..=2e-5;
/// Mass-proportional damping, in 1/s; O'Brien 2002, Table 1 has 0 to 50.
pub const ALPHA2_PER_S: RangeInclusive<f64> = 0.0..=100.0;
/// Added loss factor; wood has 1e-2.
pub const LOSS_FACTOR: RangeInclusive<f64> = 0.0..=0.1;
/// Factors on the material's own damping, on radiation and on the supports.
pub const CAUSE: RangeInclusive<f64> = 0.0..=10.0;
/// Lengths over those as built.
pub const SIZE: RangeInclusive<f64> = 0.25..=4.0;
/// Stiffness and density over the material's.
pub const MATERIAL: RangeInclusive<f64> = 0.0625..=16.0;
/// How often a second the resonators' discs shut, in Hz.
pub const MOTOR_HZ: RangeInclusive<f64> = 0.0..=12.0;
/// Share of the resonators' mouths that the discs cover.
pub const MOTOR_DEPTH: RangeInclusive<f64> = 0.0..=1.0;
/// Angle of the discs ahead of the motor, in degrees.
pub const MOTOR_DEG: RangeInclusive<f64> = 0.0..=180.0;
/// Stereo width: 0 is mono, 1 what two ears hear.
pub const WIDTH: RangeInclusive<f64> = 0.0..=1.0;
/// Distance of the listener over that of the bank.
pub const DISTANCE: RangeInclusive<f64> = 0.25..=8.0;
/// How far the listener's head is turned, in degrees.
pub const ANGLE_DEG: RangeInclusive<f64> = -90.0..=90.0;
/// Shares that go from nothing to all.
pub const SHARE: RangeInclusive<f64> = 0.0..=1.0;
/// Output gain, in dB.
pub const GAIN_DB: RangeInclusive<f64> = -60.0..=12.0;
/// Level of a trimmed mode over that as built, in dB.
pub const TRIM_DB: RangeInclusive<f64> = -48.0..=12.0;
/// How long a trimmed mode rings over how long it would.
pub const TRIM_RINGING: RangeInclusive<f64> = 0.125..=8.0;
