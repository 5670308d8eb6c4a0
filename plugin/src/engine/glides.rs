//! Everything the player moves while it sounds, on its way to where it is to be.

use super::glide::Glide;
use super::losses::{Drain, Losses};
use super::motor::Discs;
use super::{GRID, Settings};
use modes::{Damping, Rayleigh};

/// Time a moved parameter takes, in s.
const GLIDE_S: f64 = 0.015;

/// The factor of a level in dB.
fn decibels(db: f64) -> f64 {
    10f64.powf(db / 20.0)
}

/// Values that move slowly enough not to click.
pub(super) struct Glides {
    own: Glide,
    alpha1_s: Glide,
    alpha2_per_s: Glide,
    loss_factor: Glide,
    radiation: Glide,
    supports: Glide,
    motor_hz: Glide,
    motor_depth: Glide,
    motor_deg: Glide,
    width: Glide,
    gain: Glide,
}

impl Glides {
    pub(super) fn new(settings: &Settings, step_s: f64) -> Self {
        #[expect(clippy::cast_sign_loss, reason = "both factors are positive")]
        let steps = (GLIDE_S / (step_s * GRID as f64)).ceil() as u32;
        let Losses {
            own,
            added,
            radiation,
            supports,
        } = settings.losses;
        let glide = |value| Glide::new(value, steps);
        Self {
            own: glide(own),
            alpha1_s: glide(added.rayleigh.alpha1_s),
            alpha2_per_s: glide(added.rayleigh.alpha2_per_s),
            loss_factor: glide(added.loss_factor),
            radiation: glide(radiation),
            supports: glide(supports),
            motor_hz: glide(settings.motor.speed_hz),
            motor_depth: glide(settings.motor.depth),
            motor_deg: glide(settings.motor.phase_deg),
            width: glide(settings.width),
            gain: glide(decibels(settings.gain_db)),
        }
    }

    pub(super) fn each(&mut self) -> [&mut Glide; 11] {
        [
            &mut self.own,
            &mut self.alpha1_s,
            &mut self.alpha2_per_s,
            &mut self.loss_factor,
            &mut self.radiation,
            &mut self.supports,
            &mut self.motor_hz,
            &mut self.motor_depth,
            &mut self.motor_deg,
            &mut self.width,
            &mut self.gain,
        ]
    }

    pub(super) fn aim(&mut self, settings: &Settings) {
        let Losses {
            own,
            added,
            radiation,
            supports,
        } = settings.losses;
        self.own.aim(own);
        self.alpha1_s.aim(added.rayleigh.alpha1_s);
        self.alpha2_per_s.aim(added.rayleigh.alpha2_per_s);
        self.loss_factor.aim(added.loss_factor);
        self.radiation.aim(radiation);
        self.supports.aim(supports);
        self.motor_hz.aim(settings.motor.speed_hz);
        self.motor_depth.aim(settings.motor.depth);
        self.motor_deg.aim(settings.motor.phase_deg);
        self.width.aim(settings.width);
        self.gain.aim(decibels(settings.gain_db));
    }

    /// What drains the bodies of a material that takes `own` by itself, and the resonators the share
    /// `resonator`.
    pub(super) fn drain(&self, own: &Damping, resonator: f64) -> Drain {
        let losses = Losses {
            own: self.own.value(),
            added: Damping {
                rayleigh: Rayleigh {
                    alpha1_s: self.alpha1_s.value(),
                    alpha2_per_s: self.alpha2_per_s.value(),
                },
                loss_factor: self.loss_factor.value(),
            },
            radiation: self.radiation.value(),
            supports: self.supports.value(),
        };
        Drain {
            resonator,
            ..losses.drain(own)
        }
    }

    /// How the resonators' discs turn.
    pub(super) fn discs(&self) -> Discs {
        Discs {
            speed_hz: self.motor_hz.value(),
            depth: self.motor_depth.value(),
            phase_deg: self.motor_deg.value(),
        }
    }

    /// Output gain.
    pub(super) fn gain(&self) -> f64 {
        self.gain.value()
    }

    /// Stereo width, 0…1.
    pub(super) fn width(&self) -> f64 {
        self.width.value()
    }
}
