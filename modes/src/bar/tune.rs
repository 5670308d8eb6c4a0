//! The arch that gives a bar its pitch and its partials.

use super::BarFineness;
use super::beam::beam_hz;
use super::body::bending_hz;
use super::quarter::Quarter;
use super::tuning::{BarStock, BarTuneError, BarTuning};
use crate::mesh::BarGrid;
use crate::shape::{Bar, Undercut};
use crate::{Material, SolveError};

/// What the search turns to make the partials right.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Turn {
    /// The arch alone, on the stock's length.
    Arch,
    /// The arch at a fixed exponent, and the length.
    Length,
}

/// The exponent of the arch where it is fixed, and where the search begins.
const EXPONENT: f64 = 2.5;

/// Ranges that make a bar: centre in thicknesses, half the arch in lengths, then the exponent or
/// the length in stock lengths.
const CENTRE: [f64; 2] = [0.15, 0.95];
const ARCH: [f64; 2] = [0.1, 0.48];
const EXPONENTS: [f64; 2] = [1.5, 8.0];
const LENGTHS: [f64; 2] = [0.6, 1.6];

/// How much wider the tolerance of the upper modes is.
const UPPER: f64 = 10.0;

/// The search goes on until the pitch and the upper modes are off by these fractions of the
/// tolerance.
const MARGIN: [f64; 2] = [0.1, 1.0];

/// Largest step in the logarithm of a dimension: the beam's equations are only nearly linear.
const LARGEST_STEP: f64 = 0.3;

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

    /// The bar of the logarithms of what is turned.
    fn bar(self, stock: &BarStock, x: [f64; 3]) -> Bar {
        let [centre, arch, last] = x.map(f64::exp);
        let (exponent, length_m) = match self {
            Self::Arch => (last, stock.length_m),
            Self::Length => (EXPONENT, stock.length_m * last),
        };
        Bar {
            length_m,
            width_m: stock.width_m,
            thickness_m: stock.thickness_m,
            undercut: Undercut {
                centre_thickness_m: centre * stock.thickness_m,
                half_length_m: arch * length_m,
                exponent,
            },
        }
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
    turn: Turn,
    x: [f64; 3],
    /// How much higher than the beam's the solid's modes are, in cents.
    over_beam_cents: [f64; 3],
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
    let start = (last.x, last.over_beam_cents);
    let beam = tune_beam(last.turn, stock, material, tuning, start)?;
    if worst(beam.cents) < BEAM_CENTS {
        let grid = fineness.grid(&last.turn.bar(stock, beam.x));
        match tune_solid(last.turn, stock, material, &[grid], tuning, &beam) {
            Err(BarTuneError::NotTuned { .. }) => {}
            result => return result,
        }
    }
    tune_bar(stock, material, fineness, tuning)
}

/// A bar of `stock` with the arch that gives it its partials; where no arch does on the stock's own
/// length, of another length.
///
/// A Timoshenko beam of the bar's sections is tuned first, by Newton's method on the logarithms of
/// the arch's dimensions; then solid bars are, starting from it with the beam's derivatives, which
/// each step improves.
///
/// # Errors
///
/// [`BarTuneError::OutOfReach`] if no shape does, [`BarTuneError::Solve`] if the solver fails.
pub fn tune_bar(
    stock: &BarStock,
    material: &Material,
    fineness: BarFineness,
    tuning: &BarTuning,
) -> Result<TunedBar, BarTuneError> {
    let mut nearest: Option<Beam> = None;
    for turn in [Turn::Arch, Turn::Length] {
        let beam = tune_beam(turn, stock, material, tuning, (turn.start(), [0.0; 3]))?;
        if worst(beam.cents) < BEAM_CENTS {
            // A coarse grid has most of what tells a solid from a beam, and learns the slopes.
            let grid = fineness.grid(&turn.bar(stock, beam.x));
            return tune_solid(turn, stock, material, &[coarse(grid), grid], tuning, &beam);
        }
        if nearest.is_none_or(|nearest| worst(beam.cents) < worst(nearest.cents)) {
            nearest = Some(beam);
        }
    }
    let cents = nearest.map_or([f64::NAN; 3], |beam| beam.cents);
    let times = cents.map(|cents| (cents / 1200.0).exp2());
    Err(BarTuneError::OutOfReach {
        pitch_hz: tuning.pitch_hz,
        second: tuning.ratios[0],
        third: tuning.ratios[1],
        length_m: stock.length_m,
        thickness_m: stock.thickness_m,
        nearest_hz: tuning.pitch_hz * times[0],
        nearest_second: tuning.ratios[0] * times[1] / times[0],
        nearest_third: tuning.ratios[1] * times[2] / times[0],
    })
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
        let slopes = slopes(cents_off, x, cents)?;
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
    Ok(cents(beam_hz(&turn.bar(stock, x), material)?, tuning))
}

/// Where the straight line of `slopes` through `cents` at `x` comes to nothing, or as far towards it as
/// the line is to be trusted; `None` if there is none.
fn next(turn: Turn, x: [f64; 3], cents: [f64; 3], slopes: &[[f64; 3]; 3]) -> Option<[f64; 3]> {
    let step = solved(slopes, cents)?;
    let length = step.iter().fold(0.0f64, |max, s| max.max(s.abs()));
    let share = (LARGEST_STEP / length).min(1.0);
    Some(turn.clamp([0, 1, 2].map(|i| x[i] - share * step[i])))
}

/// Turns `slopes` until they foresee `change` where `moved` leads (Broyden 1965).
fn improve(slopes: &mut [[f64; 3]; 3], moved: [f64; 3], change: [f64; 3]) {
    let square: f64 = moved.iter().map(|m| m * m).sum();
    if square == 0.0 {
        return;
    }
    for (row, change) in slopes.iter_mut().zip(change) {
        let foreseen: f64 = row.iter().zip(moved).map(|(slope, m)| slope * m).sum();
        for (slope, m) in row.iter_mut().zip(moved) {
            *slope += (change - foreseen) * m / square;
        }
    }
}

/// Derivatives of `cents_off` (rows) at `x`, where it is `cents`.
fn slopes(
    cents_off: impl Fn([f64; 3]) -> Result<[f64; 3], SolveError>,
    x: [f64; 3],
    cents: [f64; 3],
) -> Result<[[f64; 3]; 3], SolveError> {
    const DIFFERENCE: f64 = 1e-3;
    let mut slopes = [[0.0; 3]; 3];
    for column in 0..3 {
        let mut aside = x;
        aside[column] += DIFFERENCE;
        let moved = cents_off(aside)?;
        for row in 0..3 {
            slopes[row][column] = (moved[row] - cents[row]) / DIFFERENCE;
        }
    }
    Ok(slopes)
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
            Ok(self::cents(bending_hz(&quarter)?, tuning))
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
                slopes = self::slopes(cents_off, x, cents)?;
            }
        }
    }
    if !within(
        cents,
        [1.0, UPPER].map(|share| share * tuning.tolerance_cents),
    ) {
        return Err(BarTuneError::NotTuned {
            pitch_hz: tuning.pitch_hz,
            cents,
        });
    }
    let beam = beam_cents(turn, stock, material, tuning, x)?;
    Ok(TunedBar {
        bar: turn.bar(stock, x),
        turn,
        x,
        over_beam_cents: [0, 1, 2].map(|i| cents[i] - beam[i]),
    })
}

/// Cells about twice as long and wide.
fn coarse(grid: BarGrid) -> BarGrid {
    BarGrid {
        along: grid.along.div_ceil(2),
        across: grid.across.div_ceil(2),
        through: grid.through,
    }
}

/// How far three modes are off, in cents.
fn cents(hz: [f64; 3], tuning: &BarTuning) -> [f64; 3] {
    let [second, third] = tuning.ratios;
    let ratios = [1.0, second, third];
    [0, 1, 2].map(|i| 1200.0 * (hz[i] / (ratios[i] * tuning.pitch_hz)).log2())
}

/// Whether the pitch is off by no more than the first figure, the upper modes than the second.
fn within(cents: [f64; 3], [pitch, upper]: [f64; 2]) -> bool {
    cents[0].abs() <= pitch && cents[1..].iter().all(|c| c.abs() <= upper)
}

fn worst(cents: [f64; 3]) -> f64 {
    cents.iter().fold(0.0, |worst, c| worst.max(c.abs()))
}

/// x of A x = b by Cramer's rule, rows of A given; `None` if A is singular.
fn solved(a: &[[f64; 3]; 3], b: [f64; 3]) -> Option<[f64; 3]> {
    let determinant = |m: &[[f64; 3]; 3]| {
        (0..3)
            .map(|i| {
                let (j, k) = ((i + 1) % 3, (i + 2) % 3);
                m[0][i] * (m[1][j] * m[2][k] - m[1][k] * m[2][j])
            })
            .sum::<f64>()
    };
    let whole = determinant(a);
    let x = [0, 1, 2].map(|column| {
        let mut replaced = *a;
        for row in 0..3 {
            replaced[row][column] = b[row];
        }
        determinant(&replaced) / whole
    });
    x.iter().all(|x| x.is_finite()).then_some(x)
}
