//! How a hung body swings after a blow, and what that does to its sound.

use super::source::SOUND_M_S;
use std::f64::consts::TAU;

/// A pendulum as long as the cord of a wind chime, 0.3 m, and how fast it comes to rest.
const SWING_HZ: f64 = 0.91;
const REST_PER_S: f64 = 0.35;

/// Swings smaller than this are over, in m.
const SMALLEST_M: f64 = 1e-5;

/// How far a body may come towards the listener, as a share of the distance.
const NEAREST: f64 = 0.8;

const OMEGA: f64 = TAU * SWING_HZ;

/// What a swing does in a step.
#[derive(Clone, Copy, Debug)]
pub(super) struct SwingStep {
    sin: f64,
    cos: f64,
}

impl SwingStep {
    /// Steps of `time_s`.
    pub(super) fn new(time_s: f64) -> Self {
        let (sin, cos) = (OMEGA * time_s).sin_cos();
        let fall = (-REST_PER_S * time_s).exp();
        Self {
            sin: fall * sin,
            cos: fall * cos,
        }
    }
}

/// One body on its cord: away from the listener, in m, and how fast, in m/s.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct Swing {
    away_m: f64,
    speed_m_s: f64,
}

impl Swing {
    /// A blow drives the body away from the listener.
    pub(super) fn push(&mut self, speed_m_s: f64) {
        self.speed_m_s += speed_m_s;
    }

    /// Moves on by a step; whether the body still swings.
    pub(super) fn advance(&mut self, step: &SwingStep) -> bool {
        let (away, speed) = (self.away_m, self.speed_m_s / OMEGA);
        self.away_m = away * step.cos + speed * step.sin;
        self.speed_m_s = OMEGA * (speed * step.cos - away * step.sin);
        let size = self.away_m * self.away_m + self.speed_m_s * self.speed_m_s / (OMEGA * OMEGA);
        if size < SMALLEST_M * SMALLEST_M {
            *self = Self::default();
        }
        *self != Self::default()
    }

    /// Pitch over that at rest (Doppler), and level over that at rest, for a listener at `distance_m`
    /// who hears `share` of the swing (O'Brien, Cook & Essl 2001, Fig. 9).
    pub(super) fn heard(&self, share: f64, distance_m: f64) -> (f64, f64) {
        let pitch = 1.0 / (1.0 + share * self.speed_m_s / SOUND_M_S);
        let away = (share * self.away_m / distance_m).max(-NEAREST);
        (pitch.clamp(0.9, 1.1), 1.0 / (1.0 + away))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_pushed_body_swings_and_comes_to_rest() {
        let mut swing = Swing::default();
        swing.push(0.5);
        let (pitch, level) = swing.heard(1.0, 1.0);
        assert!((pitch - 1.0 / (1.0 + 0.5 / 343.2)).abs() < 1e-12);
        assert_eq!(level, 1.0);
        let quarter_s = 0.25 / SWING_HZ;
        let step = SwingStep::new(quarter_s / 1000.0);
        assert!((0..1000).all(|_| swing.advance(&step)));
        let far = 0.5 / OMEGA * (-REST_PER_S * quarter_s).exp();
        assert!((swing.away_m - far).abs() < 1e-12, "{swing:?}");
        assert!((swing.heard(1.0, 2.0).1 - 1.0 / (1.0 + 0.5 * far)).abs() < 1e-12);
        let second = SwingStep::new(1.0);
        while swing.advance(&second) {}
        assert_eq!(swing, Swing::default());
        assert_eq!(swing.heard(1.0, 1.0), (1.0, 1.0));
    }
}
