//! The parameters as the host holds them.

use super::spec::{
    ALPHA1, ALPHA2, INSTRUMENT, LOSS_FACTOR, MALLET_HARDNESS, MOTOR_DEPTH, MOTOR_PHASE,
    MOTOR_SPEED, NOTE_OFF, OUTPUT_GAIN, OWN_DAMPING, POSITION_SCATTER, RADIATION, STRIKE_POSITION,
    SUPPORTS, Spec, VELOCITY_RANGE, VELOCITY_TO_POSITION, WIDTH,
};
use crate::engine::{Discs, Losses, Mallet, Settings};
use crate::factory;
use modes::{Damping, Rayleigh};
use nice_plug::prelude::{BoolParam, FloatParam, FloatRange, IntParam, IntRange, Params};
use std::sync::Arc;

/// One control for each [`Spec`]; the engine smooths what they say.
#[derive(Params)]
pub struct Controls {
    /// See [`INSTRUMENT`].
    #[id = "instr"]
    pub instrument: IntParam,
    /// See [`STRIKE_POSITION`].
    #[id = "pos"]
    pub strike_position: FloatParam,
    /// See [`VELOCITY_TO_POSITION`].
    #[id = "vpos"]
    pub velocity_to_position: FloatParam,
    /// See [`POSITION_SCATTER`].
    #[id = "scat"]
    pub position_scatter: FloatParam,
    /// See [`MALLET_HARDNESS`].
    #[id = "hard"]
    pub mallet_hardness: FloatParam,
    /// See [`VELOCITY_RANGE`].
    #[id = "vrng"]
    pub velocity_range: FloatParam,
    /// See [`ALPHA1`].
    #[id = "alpha1"]
    pub alpha1: FloatParam,
    /// See [`ALPHA2`].
    #[id = "alpha2"]
    pub alpha2: FloatParam,
    /// See [`OWN_DAMPING`].
    #[id = "own"]
    pub own_damping: FloatParam,
    /// See [`LOSS_FACTOR`].
    #[id = "tanphi"]
    pub loss_factor: FloatParam,
    /// See [`RADIATION`].
    #[id = "radia"]
    pub radiation: FloatParam,
    /// See [`SUPPORTS`].
    #[id = "suppt"]
    pub supports: FloatParam,
    /// See [`NOTE_OFF`].
    #[id = "noff"]
    pub note_off: BoolParam,
    /// See [`MOTOR_SPEED`].
    #[id = "mspeed"]
    pub motor_speed: FloatParam,
    /// See [`MOTOR_DEPTH`].
    #[id = "mdepth"]
    pub motor_depth: FloatParam,
    /// See [`MOTOR_PHASE`].
    #[id = "mphase"]
    pub motor_phase: FloatParam,
    /// See [`WIDTH`].
    #[id = "width"]
    pub width: FloatParam,
    /// See [`OUTPUT_GAIN`].
    #[id = "gain"]
    pub output_gain: FloatParam,
}

fn float(spec: &'static Spec) -> FloatParam {
    let (min, max) = (spec.min, spec.max);
    let range = if spec.skew == 1.0 {
        FloatRange::Linear { min, max }
    } else {
        FloatRange::Skewed {
            min,
            max,
            factor: spec.skew,
        }
    };
    FloatParam::new(spec.name, spec.default, range)
        .with_value_to_string(Arc::new(|value| spec.format(value)))
        .with_string_to_value(Arc::new(|text| spec.parse(text)))
}

impl Default for Controls {
    fn default() -> Self {
        let range = IntRange::Linear {
            min: 0,
            max: factory::BANKS.len() as i32 - 1,
        };
        Self {
            instrument: IntParam::new(INSTRUMENT.name, 0, range)
                .with_value_to_string(Arc::new(|value| INSTRUMENT.format(value as f32)))
                .with_string_to_value(Arc::new(|text| {
                    INSTRUMENT.parse(text).map(|value| value as i32)
                })),
            strike_position: float(&STRIKE_POSITION),
            velocity_to_position: float(&VELOCITY_TO_POSITION),
            position_scatter: float(&POSITION_SCATTER),
            mallet_hardness: float(&MALLET_HARDNESS),
            velocity_range: float(&VELOCITY_RANGE),
            alpha1: float(&ALPHA1),
            alpha2: float(&ALPHA2),
            own_damping: float(&OWN_DAMPING),
            loss_factor: float(&LOSS_FACTOR),
            radiation: float(&RADIATION),
            supports: float(&SUPPORTS),
            note_off: BoolParam::new(NOTE_OFF.name, NOTE_OFF.default >= 0.5)
                .with_value_to_string(Arc::new(|on| NOTE_OFF.format(f32::from(u8::from(on)))))
                .with_string_to_value(Arc::new(|text| {
                    NOTE_OFF.parse(text).map(|value| value >= 0.5)
                })),
            motor_speed: float(&MOTOR_SPEED),
            motor_depth: float(&MOTOR_DEPTH),
            motor_phase: float(&MOTOR_PHASE),
            width: float(&WIDTH),
            output_gain: float(&OUTPUT_GAIN),
        }
    }
}

impl Controls {
    /// Index of the factory bank that is struck.
    #[must_use]
    pub fn instrument(&self) -> usize {
        usize::try_from(self.instrument.value()).unwrap_or(0)
    }

    /// What the engine is to aim at.
    #[must_use]
    pub fn settings(&self) -> Settings {
        let plain = |control: &FloatParam| f64::from(control.value());
        let fraction = |control: &FloatParam| plain(control) / 100.0;
        Settings {
            strike_position: fraction(&self.strike_position),
            velocity_to_position: fraction(&self.velocity_to_position),
            position_scatter: fraction(&self.position_scatter),
            mallet: Mallet {
                hardness_pa: plain(&self.mallet_hardness),
                ..Mallet::DEFAULT
            },
            velocity_range_db: plain(&self.velocity_range),
            losses: Losses {
                own: plain(&self.own_damping),
                added: Damping {
                    rayleigh: Rayleigh {
                        alpha1_s: plain(&self.alpha1),
                        alpha2_per_s: plain(&self.alpha2),
                    },
                    loss_factor: plain(&self.loss_factor),
                },
                radiation: plain(&self.radiation),
                supports: plain(&self.supports),
            },
            note_off_damps: self.note_off.value(),
            motor: Discs {
                speed_hz: plain(&self.motor_speed),
                depth: fraction(&self.motor_depth),
                phase_deg: plain(&self.motor_phase),
            },
            width: fraction(&self.width),
            gain_db: plain(&self.output_gain),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::params::SPECS;
    use nice_plug::prelude::Param;

    #[test]
    fn controls_and_table_agree() {
        let controls = Controls::default();
        let map = controls.param_map();
        assert_eq!(map.len(), SPECS.len());
        for ((id, pointer, _), spec) in map.iter().zip(&SPECS) {
            assert_eq!(id, spec.id);
            // SAFETY: `controls`, which the pointers point into, is alive.
            #[expect(unsafe_code, reason = "the framework hands out raw pointers")]
            let name = unsafe { pointer.name() };
            assert_eq!(name, spec.name);
        }
    }

    #[test]
    fn defaults_are_the_engine_s() {
        let (ours, engine) = (Controls::default().settings(), Settings::default());
        assert_eq!(ours.sane(), ours);
        assert!((ours.strike_position - engine.strike_position).abs() < 1e-7);
        assert_eq!(ours.losses, engine.losses);
        assert_eq!(ours.motor, engine.motor);
        assert_eq!(ours.mallet, engine.mallet);
        assert_eq!(ours.note_off_damps, engine.note_off_damps);
        assert_eq!(ours.gain_db, engine.gain_db);
        assert_eq!(ours.width, engine.width);
    }

    #[test]
    fn a_host_s_number_keeps_its_text() {
        let controls = Controls::default();
        for text in ["1.00e-7 s", "8.00e-6 s", "2.00e-5 s", "0 s"] {
            let normalized = controls.alpha1.string_to_normalized_value(text);
            let shown = normalized.map(|n| controls.alpha1.normalized_value_to_string(n, true));
            assert_eq!(shown.as_deref(), Some(text));
        }
        for text in ["1.00 MPa", "20.0 MPa", "1.00 GPa", "100 GPa"] {
            let normalized = controls.mallet_hardness.string_to_normalized_value(text);
            let shown =
                normalized.map(|n| controls.mallet_hardness.normalized_value_to_string(n, true));
            assert_eq!(shown.as_deref(), Some(text));
        }
    }
}
