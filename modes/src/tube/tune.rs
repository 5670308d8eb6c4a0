//! The length at which a tube's bending mode has a given pitch.

use crate::analytic::TimoshenkoBeam;
use crate::fem::Harmonic;
use crate::revolution::{Bell, LAYERS, bell};
use crate::shape::Tube;
use crate::solve::lowest;
use crate::{Material, SolveError};

/// What a tube is to be tuned to.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TubeTuning {
    /// Pitch, in Hz.
    pub pitch_hz: f64,
    /// The bending mode that carries it, counted from 1.
    pub partial: usize,
    /// How far it may be off, in cents.
    pub tolerance_cents: f64,
}

/// Why a tube cannot be tuned.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum TuneError {
    /// No length in the range that is allowed has this pitch.
    #[error(
        "no tube {shortest_m:.3} m to {longest_m} m long has its bending mode at {pitch_hz:.2} Hz: \
         they reach {low_hz:.1} Hz to {high_hz:.0} Hz"
    )]
    OutOfReach {
        /// The pitch asked for, in Hz.
        pitch_hz: f64,
        /// Pitch of the longest tube, in Hz.
        low_hz: f64,
        /// Pitch of the shortest tube, in Hz.
        high_hz: f64,
        /// Shortest length tried, in m.
        shortest_m: f64,
        /// Longest length tried, in m.
        longest_m: f64,
    },
    /// The search stopped short of the tolerance.
    #[error(
        "the tube's pitch stays {cents:.3} cents off {pitch_hz:.2} Hz; a thicker wall, shorter elements or a \
         wider tolerance may do"
    )]
    NotTuned {
        /// The pitch asked for, in Hz.
        pitch_hz: f64,
        /// How far the best tube is off, in cents.
        cents: f64,
    },
    /// No small imperfection makes the lowest pair beat so fast.
    #[error(
        "no {beat_hz} Hz: what leaves the shape of the modes as it is makes the \
         lowest pair beat at up to {greatest_hz:.2} Hz"
    )]
    Beat {
        /// The beat asked for, in Hz.
        beat_hz: f64,
        /// The fastest that can be had, in Hz.
        greatest_hz: f64,
    },
    /// A bar has not the partials.
    #[error(transparent)]
    Bar(#[from] crate::bar::BarTuneError),
    /// A bar has not the partials that were asked for, but others.
    #[error(
        "no bar has partials 1 : {} : {} at {pitch_hz:.2} Hz; {} and {} can be had", asked[0], asked[1],
        within[0], within[1]
    )]
    Ratios {
        /// The pitch asked for, in Hz.
        pitch_hz: f64,
        /// The second and third partial asked for, as multiples of the first.
        asked: [f64; 2],
        /// The farthest towards them from a vibraphone's own that a bar was found to have.
        within: [f64; 2],
    },
    /// The profile is none at the size that a pitch asks for.
    #[error("as large as its pitch asks for, the bowl's {0}")]
    Profile(#[from] crate::shape::ProfileError),
    /// The eigenproblem was not solved.
    #[error(transparent)]
    Solve(#[from] SolveError),
}

/// Longest tube, in m.
const LONGEST_M: f64 = 10.0;

/// Shortest tube in outer diameters: shorter ones are rings, not beams.
const SHORTEST_DIAMETERS: f64 = 2.0;

/// How much longer the cells of the coarse mesh are.
const COARSER: f64 = 3.0;

/// The search goes on to these fractions of the tolerance: on the coarse mesh and on the mesh asked
/// for.
const COARSE_MARGIN: f64 = 0.5;
const MARGIN: f64 = 0.02;

/// How near a beam's length is looked for: a solid tube is further from it.
const PREDICTED: f64 = 2e-3;

/// Solves take this many steps at most; the secant needs three or four.
const STEPS: usize = 12;

/// `shape` with the length that tunes it; its own length does not matter. Elements are no longer
/// than `max_element_m`.
///
/// A Timoshenko beam gives the first length, to which [`retune_tube`] holds finite elements.
///
/// # Errors
///
/// [`TuneError::OutOfReach`] if no length does, [`TuneError::Solve`] if the solver fails.
pub fn tune_tube(
    shape: &Bell,
    material: &Material,
    max_element_m: f64,
    tuning: &TubeTuning,
) -> Result<Bell, TuneError> {
    let length_m = predicted_length_m(&shape.tube, material, tuning)?;
    retune_tube(&cut(shape, length_m), material, max_element_m, tuning)
}

/// A tube like `last` that is tuned, from a length that is nearly right: ln f against ln L, nearly a
/// line of slope −2, is followed by secants of finite-element solves for the one mode, on a coarse
/// mesh first, whose slope the fine one takes over.
///
/// # Errors
///
/// [`TuneError::NotTuned`] if the search does not end, [`TuneError::Solve`] if the solver fails.
pub fn retune_tube(
    last: &Bell,
    material: &Material,
    max_element_m: f64,
    tuning: &TubeTuning,
) -> Result<Bell, TuneError> {
    let mut search = Search {
        x: last.tube.length_m.ln(),
        slope: -2.0 * 1200.0 / std::f64::consts::LN_2,
        cents: f64::NAN,
    };
    for (coarser, layers, margin) in [(COARSER, 1, COARSE_MARGIN), (1.0, LAYERS, MARGIN)] {
        // The cells stay as they are through the search, so that the pitch is a smooth function.
        let cells = cut(last, search.x.exp()).cells(coarser * max_element_m);
        let cents_off = |length_m: f64| -> Result<f64, SolveError> {
            let meridian = bell(&cut(last, length_m), cells, layers).meridian;
            let pencil = Harmonic::new(&meridian, material, 1)?.pencil;
            let hz = lowest(&pencil, tuning.partial - 1)?;
            Ok(1200.0 * (hz / tuning.pitch_hz).log2())
        };
        search.run(cents_off, margin * tuning.tolerance_cents)?;
    }
    if search.cents.abs() <= tuning.tolerance_cents {
        Ok(cut(last, search.x.exp()))
    } else {
        Err(TuneError::NotTuned {
            pitch_hz: tuning.pitch_hz,
            cents: search.cents,
        })
    }
}

/// `shape`, cut to `length_m`.
fn cut(shape: &Bell, length_m: f64) -> Bell {
    Bell {
        tube: Tube {
            length_m,
            ..shape.tube
        },
        ..*shape
    }
}

/// A search for the length.
struct Search {
    /// Logarithm of the length in m.
    x: f64,
    /// Cents by that logarithm.
    slope: f64,
    cents: f64,
}

impl Search {
    /// Goes on until the pitch is off by no more than `margin` cents.
    fn run(
        &mut self,
        cents_off: impl Fn(f64) -> Result<f64, SolveError>,
        margin: f64,
    ) -> Result<(), SolveError> {
        self.cents = cents_off(self.x.exp())?;
        for _ in 0..STEPS {
            if self.cents.abs() < margin {
                break;
            }
            let next = self.x - self.cents / self.slope;
            let cents = cents_off(next.exp())?;
            if cents != self.cents {
                self.slope = (cents - self.cents) / (next - self.x);
            }
            (self.x, self.cents) = (next, cents);
        }
        Ok(())
    }
}

/// Length in m at which the beam that the tube nearly is has the pitch: a matter of milliseconds,
/// where [`tune_tube`] solves eigenproblems.
///
/// # Errors
///
/// [`TuneError::OutOfReach`] if no length has it.
pub fn predicted_length_m(
    shape: &Tube,
    material: &Material,
    tuning: &TubeTuning,
) -> Result<f64, TuneError> {
    let hz = |length_m: f64| {
        let tube = Tube { length_m, ..*shape };
        TimoshenkoBeam::from_tube(&tube, material).free_free_hz(tuning.partial)[tuning.partial - 1]
    };
    // Higher partials need longer tubes to be bending at all.
    let shortest_m = SHORTEST_DIAMETERS * 2.0 * shape.outer_radius_m * tuning.partial as f64;
    let (mut short, mut long) = (shortest_m, LONGEST_M);
    let (high_hz, low_hz) = (hz(short), hz(long));
    if !(low_hz..=high_hz).contains(&tuning.pitch_hz) {
        return Err(TuneError::OutOfReach {
            pitch_hz: tuning.pitch_hz,
            low_hz,
            high_hz,
            shortest_m,
            longest_m: LONGEST_M,
        });
    }
    while long / short > 1.0 + PREDICTED {
        let middle = (short * long).sqrt();
        if hz(middle) > tuning.pitch_hz {
            short = middle;
        } else {
            long = middle;
        }
    }
    Ok((short * long).sqrt())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::TABLE_1;

    fn tune(pitch_hz: f64, partial: usize) -> Result<Bell, TuneError> {
        let tuning = TubeTuning {
            pitch_hz,
            partial,
            tolerance_cents: 1.0,
        };
        tune_tube(&Bell::open(Tube::D5), &TABLE_1[0].material, 0.02, &tuning)
    }

    #[test]
    fn the_tuned_tube_has_the_pitch() {
        for (pitch_hz, partial) in [(110.0, 1), (587.33, 1), (2637.0, 1), (880.0, 4)] {
            let tuned = tune(pitch_hz, partial).unwrap();
            let meridian = tuned.wall(0.02, LAYERS).meridian;
            let harmonic = Harmonic::new(&meridian, &TABLE_1[0].material, 1).unwrap();
            let hz = lowest(&harmonic.pencil, partial - 1).unwrap();
            assert!(
                (1200.0 * (hz / pitch_hz).log2()).abs() < 0.05,
                "{pitch_hz}: {hz}"
            );
        }
    }

    #[test]
    fn a_pitch_out_of_reach_says_what_is_in_reach() {
        for pitch_hz in [0.5, 40_000.0] {
            let error = tune(pitch_hz, 1).unwrap_err();
            assert!(matches!(error, TuneError::OutOfReach { .. }), "{error}");
        }
    }
}
