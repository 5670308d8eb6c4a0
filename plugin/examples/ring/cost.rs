//! What ringing costs: steadily, with the damping turned, and with strikes.

use crate::bank::{Band, MALLET, WIDE, bank};
use crate::vectors::Vectors;
use crate::{BLOCK, MODES, RATE_HZ, render, ringing, struck};
use idiophone::engine::{Engine, GRID, Losses, Settings};
use modes::{Damping, Rayleigh};
use std::time::Instant;

/// Blocks of a timed run.
const BLOCKS: usize = 16;

/// What sounds longest, and all that drums have.
const LOW: Band = (50.0, 3_450.0);

/// A keyboard of bodies and their modes.
const KEYBOARD: (u8, usize) = (88, 60);

/// Samples from a strike on it to the next: 20 a second.
const BETWEEN_STRIKES: usize = 2400;

/// Least times of runs taken in turn.
pub(crate) struct Cost {
    vectors: Vectors,
    bodies: u8,
    steady_s: f64,
    low_s: f64,
    automated_s: f64,
    struck_s: f64,
}

impl Cost {
    /// Of `bodies` bodies of [`MODES`], and of a keyboard.
    pub(crate) fn of(bodies: u8, runs: usize, vectors: Vectors) -> Self {
        let mut steady = ringing(bodies, WIDE, vectors);
        let mut low = ringing(bodies, LOW, vectors);
        let mut automated = ringing(bodies, WIDE, vectors);
        let (keys, modes) = KEYBOARD;
        let mut keyboard = struck(&bank(keys, modes, WIDE), keys, vectors);
        // The mallets that players get stay on the bodies for longer.
        keyboard.set(&Settings::default());
        let mut cost = Self {
            vectors,
            bodies,
            steady_s: f64::MAX,
            low_s: f64::MAX,
            automated_s: f64::MAX,
            struck_s: f64::MAX,
        };
        for run in 0..runs {
            shorten(&mut cost.steady_s, || render(&mut steady, BLOCKS * BLOCK));
            shorten(&mut cost.low_s, || render(&mut low, BLOCKS * BLOCK));
            shorten(&mut cost.automated_s, || automate(&mut automated));
            // A stride without a common factor goes over all keys, far from the last.
            let key = (run * 37 % usize::from(keys)) as u8;
            shorten(&mut cost.struck_s, || {
                keyboard.strike(key, 0.8);
                render(&mut keyboard, BETWEEN_STRIKES);
            });
        }
        cost
    }

    /// One line for scripts: modes that ring at once in real time, and the share of a core that the
    /// keyboard takes.
    pub(crate) fn json(&self) -> String {
        let modes = usize::from(self.bodies) * MODES;
        let at_once = |spent_s: f64| modes as f64 * (BLOCKS * BLOCK) as f64 / RATE_HZ / spent_s;
        format!(
            concat!(
                r#"{{"vectors": "{}", "modes": {}, "steady_modes": {:.0}, "low_modes": {:.0}, "#,
                r#""automated_modes": {:.0}, "keyboard_share": {:.5}}}"#
            ),
            self.vectors.name(),
            modes,
            at_once(self.steady_s),
            at_once(self.low_s),
            at_once(self.automated_s),
            self.struck_s * RATE_HZ / BETWEEN_STRIKES as f64,
        )
    }
}

fn shorten(least_s: &mut f64, task: impl FnOnce()) {
    let start = Instant::now();
    task();
    *least_s = least_s.min(start.elapsed().as_secs_f64());
}

/// As many samples as a steady run, with the damping of all modes moving in every cell of the grid.
fn automate(engine: &mut Engine) {
    for cell in 0..BLOCKS * BLOCK / GRID {
        let alpha2_per_s = 1e-6 * (1 + cell % 2) as f64;
        let added = Damping {
            rayleigh: Rayleigh {
                alpha1_s: 0.0,
                alpha2_per_s,
            },
            loss_factor: 0.0,
        };
        engine.set(&Settings {
            losses: Losses {
                added,
                ..Losses::AS_BUILT
            },
            ..MALLET
        });
        render(engine, GRID);
    }
}
