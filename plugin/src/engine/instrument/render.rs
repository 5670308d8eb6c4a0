//! The sound of an instrument, output by output.

use super::routing::outputs;
use super::{Engine, keys};
use crate::engine::damper::bit;
use crate::engine::oscillators::SILENT;
use crate::engine::{GRID, Outputs};

/// No sample is ever beyond this, whatever is played: 36 dB over full scale, with the limiter off. Below
/// it (with the limiter, below full scale) the output is the sum of the modes, bit for bit.
pub const OUTPUT_BOUND: f32 = 64.0;

/// A sample as the host gets it: bounded, and never a denormal.
fn finish(sample: f64) -> f32 {
    let bound = f64::from(OUTPUT_BOUND);
    // `max` and `min` rather than `clamp`, because they turn NaN into a bound.
    let sample = sample.max(-bound).min(bound);
    if sample.abs() < 1e-30 {
        return 0.0;
    }
    sample as f32
}

impl Engine {
    /// Renders as many samples as the shorter of the two slices holds, everything in one output.
    pub fn process(&mut self, left: &mut [f32], right: &mut [f32]) {
        self.render(&mut Outputs::main(left, right));
    }

    /// Renders all samples of the outputs. What goes to one that is not connected is in the main one.
    pub fn render(&mut self, out: &mut Outputs<'_>) {
        let frames = out.frames();
        let mut done = 0;
        while done < frames {
            let phase = (self.position % GRID as u64) as usize;
            if phase == 0 {
                self.look();
            }
            let run = (GRID - phase).min(frames - done);
            self.run(phase, &mut out.part(done..done + run));
            self.position += run as u64;
            if phase + run == GRID {
                for output in outputs(self.used) {
                    self.cells[output].close();
                }
            }
            done += run;
        }
    }

    /// Renders a run within one cell of the grid, `phase` samples from its start.
    fn run(&mut self, phase: usize, out: &mut Outputs<'_>) {
        if self.awake == 0 {
            for side in out.each().flat_map(|(_, sides)| sides) {
                side.fill(0.0);
            }
            return;
        }
        let run = out.frames();
        for output in outputs(self.used) {
            self.cells[output].hear(phase, run, &mut self.buses[output]);
        }
        self.push(phase, run);
        for output in outputs(self.used & !1).filter(|output| !out.has(*output)) {
            self.bring_home(output, run);
        }
        for (output, sides) in out.each() {
            self.send(output, phase, sides);
        }
    }

    /// Adds the next `run` samples of the bodies that move sample by sample.
    fn push(&mut self, phase: usize, run: usize) {
        for key in keys(self.driven) {
            let Some(body) = self.bodies[usize::from(key)].as_mut() else {
                continue;
            };
            let mut sound = SILENT;
            let moves = self.routes.moving & bit(key) != 0;
            let [left, right] = if moves {
                &mut sound
            } else {
                &mut self.buses[self.routes.output(key)]
            };
            let out = [&mut left[..run], &mut right[..run]];
            body.drive(self.kernel, &mut self.packs, phase, self.step_s, out);
            if moves {
                self.routes.share(key, run, &sound, &mut self.buses);
            }
        }
        self.routes.advance(run);
    }

    /// Adds what an output has to the main one.
    fn bring_home(&mut self, output: usize, run: usize) {
        let (main, others) = self.buses.split_at_mut(1);
        let sides = main[0].iter_mut().zip(&others[output - 1]);
        for (main, other) in sides {
            for (main, other) in main.iter_mut().zip(other).take(run) {
                *main += other;
            }
        }
    }

    /// Hands an output over, as loud as it is to be.
    fn send(&mut self, output: usize, phase: usize, [left, right]: [&mut [f32]; 2]) {
        if self.used >> output & 1 == 0 {
            self.limiters[output].reset();
            left.fill(0.0);
            right.fill(0.0);
            return;
        }
        let [from, to] = self.gain;
        let buses = &self.buses[output];
        for (n, (left, right)) in left.iter_mut().zip(right).enumerate() {
            let share = (phase + n) as f64 / GRID as f64;
            let gain = from + (to - from) * share;
            let mut sample = [gain * buses[0][n], gain * buses[1][n]];
            if self.settings.limiter {
                sample = self.limiters[output].limit(sample);
            }
            [*left, *right] = sample.map(finish);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn samples_are_bounded_and_never_denormal() {
        assert_eq!(finish(1e9), OUTPUT_BOUND);
        assert_eq!(finish(f64::NEG_INFINITY), -OUTPUT_BOUND);
        assert!(finish(f64::NAN).is_finite());
        assert_eq!(finish(1e-39), 0.0);
        assert_eq!(finish(0.25), 0.25);
    }
}
