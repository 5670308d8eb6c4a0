//! The arch that gives a bar its pitch and its partials.

use super::BarFineness;
use super::beam::beam_hz;
use super::body::bending_hz;
use super::dimensions::{
    ARCH, CENTRE, Dimensions, EXPONENT, EXPONENTS, LARGEST_STEP, LENGTHS, bar_of,
};
use super::miss::{self, improve, solved, within, worst};
use super::quarter::Quarter;
use super::reach::{Reached, START, reach};
use super::tuning::{BarStock, BarTuneError, BarTuning};
use crate::mesh::BarGrid;
use crate::shape::Bar;
use crate::{Material, SolveError};

/// What the search turns to make the partials right.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Turn {
    /// The arch alone, on the stock's length.
    Arch,
    /// The arch at a fixed exponent, and the length.
    Length,
}

/// How much wider the tolerance of the upper modes is.
const UPPER: f64 = 10.0;

/// The search goes on until the pitch and the upper modes are off by these fractions of the
/// tolerance.
const MARGIN: [f64; 2] = [0.1, 1.0];

/// A beam is near enough at so many cents: what a solid bar adds is known no better.
const BEAM_CENTS: f64 = 0.05;

/// Steps that beams take at most; most need three or four.
const BEAM_STEPS: usize = 25;

/// Steps in a row without any gain after which beams are given up: the search is in a corner.
const IDLE_STEPS: usize = 4;

/// Steps that solids take at most; most need three.
const SOLID_STEPS: usize = 12;

impl Turn {
    fn ranges(self) -> [[f64; 2]; 3] {
        match self {
            Self::Arch => [CENTRE, ARCH, EXPONENTS],
            Self::Length => [CENTRE, ARCH, LENGTHS],
        }
    }

    fn start(self) -> [f64; 3] {
        match self {
            Self::Arch => [0.5, 0.35, EXPONENT],
            Self::Length => [0.5, 0.3, 1.0],
        }
        .map(f64::ln)
    }

    /// All four dimensions where the logarithms of what is turned are `x`.
    fn dimensions(self, x: [f64; 3]) -> Dimensions {
        let [centre, arch, last] = x.map(f64::exp);
        match self {
            Self::Arch => [centre, arch, last, 1.0],
            Self::Length => [centre, arch, EXPONENT, last],
        }
    }

    fn bar(self, stock: &BarStock, x: [f64; 3]) -> Bar {
        bar_of(stock, self.dimensions(x))
    }

    fn clamp(self, x: [f64; 3]) -> [f64; 3] {
        let ranges = self.ranges();
        [0, 1, 2].map(|i| x[i].clamp(ranges[i][0].ln(), ranges[i][1].ln()))
    }
}

/// A tuned bar, and where the search for it ended.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TunedBar {
    /// The bar.
    pub bar: Bar,
    end: End,
}

/// Where a search ended, and the next can begin.
#[derive(Clone, Copy, Debug, PartialEq)]
enum End {
    /// By way of beams.
    Beam {
        turn: Turn,
        x: [f64; 3],
        /// How much higher than the beam's the solid's modes are, in cents.
        over_beam_cents: [f64; 3],
    },
    /// By solids alone.
    Reach { x: Dimensions },
}

/// [`tune_bar`] for a bar that is to be much like `last`: what that one adds to a beam, a beam is
/// tuned to allow for, and mostly a solid or two are enough.
///
/// # Errors
///
/// As [`tune_bar`].
pub fn retune_bar(
    last: &TunedBar,
    stock: &BarStock,
    material: &Material,
    fineness: BarFineness,
    tuning: &BarTuning,
) -> Result<TunedBar, BarTuneError> {
    match last.end {
        End::Beam {
            turn,
            x,
            over_beam_cents,
        } => {
            let beam = tune_beam(turn, stock, material, tuning, (x, over_beam_cents))?;
            if worst(beam.cents) < BEAM_CENTS {
                let grid = fineness.grid(&turn.bar(stock, beam.x));
                match tune_solid(turn, stock, material, &[grid], tuning, &beam) {
                    Err(BarTuneError::NotTuned { .. }) => {}
                    Ok(tuned) if !is_in_tune(&tuned, grid, material, fineness, tuning)? => {}
                    result => return result,
                }
            }
        }
        End::Reach { x } => {
            if let Some(tuned) = reached(stock, material, fineness, tuning, x)? {
                return Ok(tuned);
            }
        }
    }
    tune_bar(stock, material, fineness, tuning)
}

/// A bar of `stock` with the arch that gives it its partials; where no arch does on the stock's own
/// length, of another length.
///
/// A Timoshenko beam of the bar's sections is tuned first, by Newton's method on the logarithms of
/// the arch's dimensions; then solid bars are, starting from it with the beam's derivatives, which
/// each step improves. Of bars too thick or wide to be much like a beam, arch and length are sought
/// together on solids.
///
/// # Errors
///
/// [`BarTuneError::OutOfReach`] if no shape of a beam does, [`BarTuneError::NotTuned`] if no solid,
/// [`BarTuneError::Solve`] if the solver fails.
pub fn tune_bar(
    stock: &BarStock,
    material: &Material,
    fineness: BarFineness,
    tuning: &BarTuning,
) -> Result<TunedBar, BarTuneError> {
    let (mut nearest, mut missed): (Option<Beam>, Option<BarTuneError>) = (None, None);
    let mut starts = Vec::new();
    for turn in [Turn::Arch, Turn::Length] {
        let beam = tune_beam(turn, stock, material, tuning, (turn.start(), [0.0; 3]))?;
        if worst(beam.cents) < BEAM_CENTS {
            // A coarse grid has most of what tells a solid from a beam, and learns the slopes.
            let grid = fineness.grid(&turn.bar(stock, beam.x));
            match tune_solid(turn, stock, material, &[grid.coarse(), grid], tuning, &beam) {
                Err(error @ BarTuneError::NotTuned { .. }) => missed = missed.or(Some(error)),
                Ok(tuned) if !is_in_tune(&tuned, grid, material, fineness, tuning)? => {}
                result => return result,
            }
            starts.push(turn.dimensions(beam.x));
        }
        if nearest.is_none_or(|nearest| worst(beam.cents) < worst(nearest.cents)) {
            nearest = Some(beam);
        }
    }
    starts.push(START);
    for start in starts {
        let x = start.map(f64::ln);
        if let Some(tuned) = reached(stock, material, fineness, tuning, x)? {
            return Ok(tuned);
        }
    }
    Err(missed.unwrap_or_else(|| out_of_reach(stock, tuning, nearest)))
}

/// What the search on solids finds from the logarithms `x` on, if that is in tune.
fn reached(
    stock: &BarStock,
    material: &Material,
    fineness: BarFineness,
    tuning: &BarTuning,
    x: Dimensions,
) -> Result<Option<TunedBar>, SolveError> {
    let goal = MARGIN.map(|share| share * tuning.tolerance_cents);
    let found = reach(stock, material, fineness, (tuning, goal), x)?;
    let found = found.filter(|found| in_tune(found.cents, tuning));
    Ok(found.map(|Reached { x, .. }| TunedBar {
        bar: bar_of(stock, x.map(f64::exp)),
        end: End::Reach { x },
    }))
}

/// Whether a bar that was tuned on `grid` is in tune on the one that it is solved on, which is another if
/// its length has moved far.
fn is_in_tune(
    tuned: &TunedBar,
    grid: BarGrid,
    material: &Material,
    fineness: BarFineness,
    tuning: &BarTuning,
) -> Result<bool, SolveError> {
    let own = fineness.grid(&tuned.bar);
    if own == grid {
        return Ok(true);
    }
    let quarter = Quarter::new(&tuned.bar, own, material)?;
    Ok(in_tune(miss::cents(bending_hz(&quarter)?, tuning), tuning))
}

/// Whether partials so far off are as good as asked for.
fn in_tune(cents: [f64; 3], tuning: &BarTuning) -> bool {
    let most = [1.0, UPPER].map(|share| share * tuning.tolerance_cents);
    within(cents, most)
}

fn out_of_reach(stock: &BarStock, tuning: &BarTuning, nearest: Option<Beam>) -> BarTuneError {
    let cents = nearest.map_or([f64::NAN; 3], |beam| beam.cents);
    let times = cents.map(|cents| (cents / 1200.0).exp2());
    BarTuneError::OutOfReach {
        pitch_hz: tuning.pitch_hz,
        second: tuning.ratios[0],
        third: tuning.ratios[1],
        length_m: stock.length_m,
        thickness_m: stock.thickness_m,
        nearest_hz: tuning.pitch_hz * times[0],
        nearest_second: tuning.ratios[0] * times[1] / times[0],
        nearest_third: tuning.ratios[1] * times[2] / times[0],
    }
}

/// A beam that has been tuned as far as it goes.
#[derive(Clone, Copy)]
struct Beam {
    x: [f64; 3],
    cents: [f64; 3],
    /// Derivatives of the cents (rows) by the logarithms.
    slopes: [[f64; 3]; 3],
}

/// A beam that a solid `over_cents` higher would have its partials, searched from `x` on.
fn tune_beam(
    turn: Turn,
    stock: &BarStock,
    material: &Material,
    tuning: &BarTuning,
    (mut x, over_cents): ([f64; 3], [f64; 3]),
) -> Result<Beam, SolveError> {
    let cents_off = |x| -> Result<[f64; 3], SolveError> {
        let cents = beam_cents(turn, stock, material, tuning, x)?;
        Ok([0, 1, 2].map(|i| cents[i] + over_cents[i]))
    };
    let mut cents = cents_off(x)?;
    let (mut best, mut idle): (Option<Beam>, usize) = (None, 0);
    for _ in 0..BEAM_STEPS {
        let slopes = miss::slopes(cents_off, x, cents)?;
        if best.is_none_or(|best| worst(cents) < worst(best.cents)) {
            best = Some(Beam { x, cents, slopes });
            idle = 0;
        } else {
            idle += 1;
        }
        if idle == IDLE_STEPS {
            break;
        }
        if worst(cents) < BEAM_CENTS {
            break;
        }
        let Some(next) = next(turn, x, cents, &slopes) else {
            break;
        };
        x = next;
        cents = cents_off(x)?;
    }
    Ok(best.expect("at least one step"))
}

/// How far the beam of `x` is off, in cents.
fn beam_cents(
    turn: Turn,
    stock: &BarStock,
    material: &Material,
    tuning: &BarTuning,
    x: [f64; 3],
) -> Result<[f64; 3], SolveError> {
    Ok(miss::cents(beam_hz(&turn.bar(stock, x), material)?, tuning))
}

/// Where the straight line of `slopes` through `cents` at `x` comes to nothing, or as far towards it as
/// the line is to be trusted; `None` if there is none.
fn next(turn: Turn, x: [f64; 3], cents: [f64; 3], slopes: &[[f64; 3]; 3]) -> Option<[f64; 3]> {
    let step = solved(slopes, cents)?;
    let length = step.iter().fold(0.0f64, |max, s| max.max(s.abs()));
    let share = (LARGEST_STEP / length).min(1.0);
    Some(turn.clamp([0, 1, 2].map(|i| x[i] - share * step[i])))
}

/// Solids beginning with `beam`, on one grid after the other.
///
/// A grid stays as it is while one searches on it, so that the pitch is a smooth function.
fn tune_solid(
    turn: Turn,
    stock: &BarStock,
    material: &Material,
    grids: &[BarGrid],
    tuning: &BarTuning,
    beam: &Beam,
) -> Result<TunedBar, BarTuneError> {
    let (mut x, mut cents, mut slopes) = (beam.x, beam.cents, beam.slopes);
    for &grid in grids {
        let cents_off = |x: [f64; 3]| -> Result<[f64; 3], SolveError> {
            let quarter = Quarter::new(&turn.bar(stock, x), grid, material)?;
            Ok(miss::cents(bending_hz(&quarter)?, tuning))
        };
        cents = cents_off(x)?;
        for _ in 0..SOLID_STEPS {
            if within(cents, MARGIN.map(|share| share * tuning.tolerance_cents)) {
                break;
            }
            let Some(next) = next(turn, x, cents, &slopes) else {
                break;
            };
            let moved = [0, 1, 2].map(|i| next[i] - x[i]);
            let next_cents = cents_off(next)?;
            improve(
                &mut slopes,
                moved,
                [0, 1, 2].map(|i| next_cents[i] - cents[i]),
            );
            if worst(next_cents) < 2.0 * worst(cents) {
                (x, cents) = (next, next_cents);
            } else {
                // So far off, the line is better drawn anew than mended.
                slopes = miss::slopes(cents_off, x, cents)?;
            }
        }
    }
    if !in_tune(cents, tuning) {
        return Err(BarTuneError::NotTuned {
            pitch_hz: tuning.pitch_hz,
            cents,
        });
    }
    let beam = beam_cents(turn, stock, material, tuning, x)?;
    Ok(TunedBar {
        bar: turn.bar(stock, x),
        end: End::Beam {
            turn,
            x,
            over_beam_cents: [0, 1, 2].map(|i| cents[i] - beam[i]),
        },
    })
}
