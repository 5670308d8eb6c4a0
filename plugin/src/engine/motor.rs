//! The discs that open and shut the resonators below the bodies.

use super::GRID;
use std::f64::consts::{PI, TAU};

/// How the discs turn in the mouths of the resonators, all on one shaft.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Discs {
    /// How often a second they shut, twice a turn.
    pub speed_hz: f64,
    /// Share of the mouth that they cover when they lie across it, 0…1.
    pub depth: f64,
    /// Angle ahead of the motor, in degrees: at rest, 0 lies across the mouths and 90 along them.
    pub phase_deg: f64,
}

impl Discs {
    /// At rest and out of the way.
    pub const OPEN: Self = Self {
        speed_hz: 0.0,
        depth: 1.0,
        phase_deg: 90.0,
    };

    /// Open share of the mouths when the motor stands at `turn` of a turn: 1 less what a round disc
    /// in a round mouth covers, seen from above.
    fn open(&self, turn: f64) -> f64 {
        let angle = TAU * turn + self.phase_deg * PI / 180.0;
        1.0 - self.depth * angle.cos().abs()
    }
}

/// The motor, and how far the discs leave the resonators open.
///
/// What sounds through a resonator goes with the open share of its mouth, the power that it takes
/// with the square.
#[derive(Clone)]
pub(super) struct Motor {
    /// Angle of the shaft, in turns.
    turn: f64,
    /// Open share at the next grid point.
    open: f64,
}

impl Motor {
    /// At rest, resonators open.
    pub(super) fn new() -> Self {
        Self {
            turn: 0.0,
            open: 1.0,
        }
    }

    /// On to the next grid point; whether the discs have moved.
    pub(super) fn advance(&mut self, discs: &Discs, step_s: f64) -> bool {
        let before = self.open;
        self.turn = (self.turn + 0.5 * discs.speed_hz * step_s * GRID as f64).fract();
        self.open = discs.open(self.turn);
        self.open != before
    }

    /// Share of a resonator's damping that counts now.
    pub(super) fn taken(&self) -> f64 {
        self.open * self.open
    }

    /// Open share of the mouths at the next grid point.
    pub(super) fn open(&self) -> f64 {
        self.open
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn at_rest_the_resonators_are_open() {
        let mut motor = Motor::new();
        motor.advance(&Discs::OPEN, 1e-5);
        assert!((motor.open - 1.0).abs() < 1e-15);
        assert!((motor.taken() - 1.0).abs() < 1e-15);
    }

    #[test]
    fn discs_shut_twice_a_turn() {
        let step_s = 1.0 / 48_000.0;
        let discs = Discs {
            speed_hz: 5.0,
            depth: 0.75,
            phase_deg: 90.0,
        };
        let mut motor = Motor::new();
        let mut open = Vec::new();
        for _ in 0..3000 {
            motor.advance(&discs, step_s);
            open.push(motor.open);
        }
        // Two seconds, ten times shut.
        let shut = open.windows(3).filter(|w| w[1] < w[0] && w[1] <= w[2]);
        assert_eq!(shut.count(), 10);
        let least = open.iter().fold(1.0, |least: f64, x| least.min(*x));
        assert!((least - 0.25).abs() < 5e-3, "{least}");
    }

    #[test]
    fn the_phase_alone_shuts_a_motor_at_rest() {
        let mut motor = Motor::new();
        let shut = Discs {
            phase_deg: 0.0,
            ..Discs::OPEN
        };
        motor.advance(&shut, 1e-5);
        assert_eq!(motor.open, 0.0);
    }
}
