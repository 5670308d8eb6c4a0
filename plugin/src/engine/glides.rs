//! Everything the player moves while it sounds, on its way to where it is to be.

use super::glide::Glide;
use super::losses::{Drain, Losses};
use super::motor::Discs;
use super::{GRID, Listener, Settings, Tweak};
use modes::{Damping, Rayleigh};

/// Time a moved parameter takes, in s.
const GLIDE_S: f64 = 0.015;

/// How many values move.
const VALUES: usize = 18;

/// The factor of a level in dB.
fn decibels(db: f64) -> f64 {
    10f64.powf(db / 20.0)
}

/// What moves, as plain numbers, always in the same order. Lengths, stiffness, density and distance
/// move by their logarithms, lest one half of the way sound faster than the other.
fn targets(settings: &Settings) -> [f64; VALUES] {
    let Settings {
        losses,
        motor,
        listener,
        tweak,
        ..
    } = settings;
    [
        losses.own,
        losses.added.rayleigh.alpha1_s,
        losses.added.rayleigh.alpha2_per_s,
        losses.added.loss_factor,
        losses.radiation,
        losses.supports,
        motor.speed_hz,
        motor.depth,
        motor.phase_deg,
        listener.width,
        listener.distance.ln(),
        listener.angle_deg,
        decibels(settings.gain_db),
        tweak.size.ln(),
        tweak.stiffness.ln(),
        tweak.density.ln(),
        settings.swing,
        settings.sympathy,
    ]
}

/// Values that move slowly enough not to click.
#[derive(Clone)]
pub(super) struct Glides {
    all: [Glide; VALUES],
    /// Where they are now.
    now: [f64; VALUES],
}

impl Glides {
    pub(super) fn new(settings: &Settings, step_s: f64) -> Self {
        #[expect(clippy::cast_sign_loss, reason = "both factors are positive")]
        let steps = (GLIDE_S / (step_s * GRID as f64)).ceil() as u32;
        let now = targets(settings);
        Self {
            all: now.map(|value| Glide::new(value, steps)),
            now,
        }
    }

    /// Sets out for `settings`.
    pub(super) fn aim(&mut self, settings: &Settings) {
        for (glide, target) in self.all.iter_mut().zip(targets(settings)) {
            glide.aim(target);
        }
    }

    /// Takes one step; whether anything moved.
    pub(super) fn advance(&mut self) -> bool {
        let before = self.now;
        for (glide, now) in self.all.iter_mut().zip(&mut self.now) {
            glide.advance();
            *now = glide.value();
        }
        before != self.now
    }

    /// Arrives at once; whether anything moved.
    pub(super) fn snap(&mut self) -> bool {
        let before = self.now;
        for (glide, now) in self.all.iter_mut().zip(&mut self.now) {
            glide.snap();
            *now = glide.value();
        }
        before != self.now
    }

    /// What drains the bodies of a material that takes `own` by itself, and the resonators the share
    /// `resonator`.
    pub(super) fn drain(&self, own: &Damping, resonator: f64) -> Drain {
        let losses = Losses {
            own: self.now[0],
            added: Damping {
                rayleigh: Rayleigh {
                    alpha1_s: self.now[1],
                    alpha2_per_s: self.now[2],
                },
                loss_factor: self.now[3],
            },
            radiation: self.now[4],
            supports: self.now[5],
        };
        Drain {
            resonator,
            ..losses.drain(own)
        }
    }

    /// Factor on what the supports take.
    pub(super) fn supports(&self) -> f64 {
        self.now[5]
    }

    /// How the resonators' discs turn.
    pub(super) fn discs(&self) -> Discs {
        Discs {
            speed_hz: self.now[6],
            depth: self.now[7],
            phase_deg: self.now[8],
        }
    }

    /// Where the listener is.
    pub(super) fn listener(&self) -> Listener {
        Listener {
            width: self.now[9],
            distance: self.now[10].exp(),
            angle_deg: self.now[11],
        }
    }

    /// Output gain.
    pub(super) fn gain(&self) -> f64 {
        self.now[12]
    }

    /// Size and material.
    pub(super) fn tweak(&self) -> Tweak {
        Tweak {
            size: self.now[13].exp(),
            stiffness: self.now[14].exp(),
            density: self.now[15].exp(),
        }
    }

    /// Share of a swing that is heard.
    pub(super) fn swing(&self) -> f64 {
        self.now[16]
    }

    /// How firmly the bodies are joined.
    pub(super) fn sympathy(&self) -> f64 {
        self.now[17]
    }
}
