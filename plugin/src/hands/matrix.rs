//! The assignments at work: from what hands do to how far everything is moved.

use super::source::Values;
use super::{Assignment, Curve, SLOTS, Source, Target};

/// Greatest factor on a level.
pub(super) const LEVEL_MOST: f64 = 4.0;

/// One assignment, ready to run.
#[derive(Clone, Copy, Debug)]
struct Wire {
    source: Source,
    target: Target,
    depth: f64,
    curve: Curve,
}

/// All assignments, ready to run.
#[derive(Clone, Copy, Debug)]
pub(super) struct Matrix {
    wires: [Wire; SLOTS],
}

/// How far each target is moved.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Sums {
    /// Factor on the level, 0…[`LEVEL_MOST`].
    level: f64,
    /// The others, in spans.
    moved: [f64; Target::ALL.len()],
}

impl Matrix {
    pub(super) fn new(assignments: &[Assignment; SLOTS]) -> Self {
        Self {
            wires: assignments.map(|assignment| {
                let Assignment {
                    source,
                    target,
                    depth,
                    curve,
                } = assignment.sane();
                Wire {
                    source,
                    target,
                    depth,
                    curve: Curve::new(curve),
                }
            }),
        }
    }

    /// Runs every assignment.
    pub(super) fn run(&self, values: &Values) -> Sums {
        let mut sums = Sums {
            level: 1.0,
            moved: [0.0; Target::ALL.len()],
        };
        for wire in &self.wires {
            let value = values.get(wire.source);
            if value == 0.0 {
                continue;
            }
            let moved = wire.depth * wire.curve.at(value);
            if wire.target == Target::Level {
                sums.level *= (1.0 + moved) * (1.0 + moved);
            } else {
                sums.moved[wire.target.index()] += moved;
            }
        }
        sums
    }
}

impl Sums {
    /// Factor on the level, 0…[`LEVEL_MOST`].
    pub(super) fn level(&self) -> f64 {
        self.level.min(LEVEL_MOST)
    }

    /// How far a target other than the level is moved, in spans, −1…1.
    pub(super) fn of(&self, target: Target) -> f64 {
        self.moved[target.index()].clamp(-1.0, 1.0)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn assignment(source: Source, target: Target, depth: f64, curve: f64) -> Assignment {
        Assignment {
            source,
            target,
            depth,
            curve,
        }
    }

    fn matrix(some: &[Assignment]) -> Matrix {
        let mut all = [Assignment::FREE; SLOTS];
        all[..some.len()].copy_from_slice(some);
        Matrix::new(&all)
    }

    fn values(some: &[(Source, f64)]) -> Values {
        let mut values = Values::default();
        for (source, value) in some {
            values.set(*source, *value);
        }
        values
    }

    /// General MIDI 2, §3.3.6: 40 log₁₀(cc/127) dB, twice if two controllers do it.
    #[test]
    fn level_follows_general_midi() {
        let expression = assignment(Source::Expression, Target::Level, 1.0, 0.0);
        let breath = assignment(Source::Breath, Target::Level, -1.0, 0.0);
        let one = matrix(&[expression]);
        for byte in 0..=127 {
            let value = f64::from(byte) / 127.0;
            let level = one
                .run(&values(&[(Source::Expression, value - 1.0)]))
                .level();
            if byte == 0 {
                assert_eq!(level, 0.0);
            } else {
                let db = 20.0 * level.log10();
                assert!((db - 40.0 * value.log10()).abs() < 1e-9, "{byte}: {db}");
            }
        }
        let two = matrix(&[expression, breath]);
        let both = values(&[(Source::Expression, -0.5), (Source::Breath, 0.5)]);
        assert!((two.run(&both).level() - 1.0 / 16.0).abs() < 1e-15);
        let all = matrix(&[assignment(Source::Key, Target::Level, 1.0, 0.0); SLOTS]);
        assert_eq!(all.run(&values(&[(Source::Key, 1.0)])).level(), LEVEL_MOST);
    }

    #[test]
    fn contributions_add_up_within_the_span() {
        let matrix = matrix(&[
            assignment(Source::ModWheel, Target::Bend, 0.5, 1.0),
            assignment(Source::Pressure, Target::Bend, -0.25, 0.0),
            assignment(Source::Key, Target::Pan, 1.0, 0.0),
            assignment(Source::Random, Target::Pan, 1.0, 0.0),
        ]);
        let sums = matrix.run(&values(&[
            (Source::ModWheel, 0.5),
            (Source::Pressure, 1.0),
            (Source::Key, 0.75),
            (Source::Random, 0.5),
        ]));
        assert!((sums.of(Target::Bend) - (0.5 * 8.0 / 9.0 - 0.25)).abs() < 1e-15);
        assert_eq!(sums.of(Target::Pan), 1.0);
        assert_eq!(sums.of(Target::Hardness), 0.0);
        assert_eq!(sums.level(), 1.0);
    }

    #[test]
    fn hands_at_rest_move_nothing() {
        let sums = Matrix::new(&Assignment::DEFAULT).run(&Values::default());
        assert_eq!(sums.level(), 1.0);
        assert!(Target::ALL.iter().all(|target| sums.of(*target) == 0.0));
    }

    #[test]
    fn nonsense_in_an_assignment_is_tamed() {
        let matrix = matrix(&[
            assignment(Source::Key, Target::Bend, f64::NAN, 0.0),
            assignment(Source::Key, Target::Pan, f64::INFINITY, f64::NAN),
        ]);
        let sums = matrix.run(&values(&[(Source::Key, 0.5)]));
        assert_eq!(sums.of(Target::Bend), 0.0);
        assert_eq!(sums.of(Target::Pan), 0.5);
    }
}
