//! The search for a bar where beams mislead: all four dimensions at once, on solids from the start.
//!
//! Three partials leave one of four dimensions free, so steps are the shortest that the slopes ask for
//! (Levenberg 1944, Marquardt 1963): thick and wide bars, of whose dimensions each alone hardly moves a
//! partial, are found near where the search began.

use super::BarFineness;
use super::body::bending_hz;
use super::dimensions::{
    ARCH, CENTRE, Dimensions, EXPONENT, EXPONENTS, LARGEST_STEP, LENGTHS, bar_of,
};
use super::miss::{cents, improve, slopes, solved, within};
use super::quarter::Quarter;
use super::tuning::{BarStock, BarTuning};
use crate::mesh::BarGrid;
use crate::{Material, SolveError};

const RANGES: [[f64; 2]; 4] = [CENTRE, ARCH, EXPONENTS, LENGTHS];

/// Where the search begins if nothing better is known, before its logarithm is taken.
pub(super) const START: Dimensions = [0.5, 0.35, EXPONENT, 1.0];

/// Steps at most; a search that succeeds takes seven or eight.
const STEPS: usize = 15;

/// Steps without gain, with slopes drawn anew, after which the search is in a corner.
const IDLE_STEPS: usize = 2;

/// The share of the miss that a step may leave before the slopes are drawn anew.
const GOOD: f64 = 0.5;

/// Cents that are held for nothing beside a step of 1 in a logarithm: at first, and what they are
/// multiplied by after a good step and a bad one.
const DAMPING_CENTS: f64 = 1.0;
const AFTER_GOOD: f64 = 0.2;
const AFTER_BAD: f64 = 10.0;

/// Grids of the fineness asked for on which a bar is sought at most.
const GRIDS: usize = 3;

/// Where a search ended.
#[derive(Clone, Copy, Debug)]
pub(super) struct Reached {
    /// Logarithms.
    pub(super) x: Dimensions,
    /// How far the solid's modes are off.
    pub(super) cents: [f64; 3],
}

/// A bar of `stock` as near to its partials as the search comes within `goal` cents, from the logarithms
/// `x` on; on a coarse grid first. None if there it is not within them, or if no bar stays on the grid that
/// it is sought on.
pub(super) fn reach(
    stock: &BarStock,
    material: &Material,
    fineness: BarFineness,
    (tuning, goal): (&BarTuning, [f64; 2]),
    x: Dimensions,
) -> Result<Option<Reached>, SolveError> {
    let on = |grid: BarGrid, x: Dimensions| {
        let cents_off = |x: Dimensions| -> Result<[f64; 3], SolveError> {
            let quarter = Quarter::new(&bar_of(stock, x.map(f64::exp)), grid, material)?;
            Ok(cents(bending_hz(&quarter)?, tuning))
        };
        search(cents_off, goal, x)
    };
    let grid_of = |x: Dimensions| fineness.grid(&bar_of(stock, x.map(f64::exp)));
    let mut at = on(grid_of(x).coarse(), x)?;
    if !within(at.cents, goal) {
        return Ok(None);
    }
    for _ in 0..GRIDS {
        let grid = grid_of(at.x);
        at = on(grid, at.x)?;
        // A bar that has become shorter may be cut otherwise.
        if grid_of(at.x) == grid {
            return Ok(Some(at));
        }
    }
    Ok(None)
}

fn search(
    cents_off: impl Fn(Dimensions) -> Result<[f64; 3], SolveError>,
    goal: [f64; 2],
    x: Dimensions,
) -> Result<Reached, SolveError> {
    let mut at = Reached {
        x,
        cents: cents_off(x)?,
    };
    let mut slopes = self::slopes(&cents_off, x, at.cents)?;
    let (mut fresh, mut idle, mut damping) = (true, 0, DAMPING_CENTS);
    for _ in 0..STEPS {
        if within(at.cents, goal) || idle == IDLE_STEPS {
            break;
        }
        let Some(x) = step(&at, &slopes, damping) else {
            break;
        };
        let cents = cents_off(x)?;
        let left = length(&cents) / length(&at.cents);
        improve(
            &mut slopes,
            [0, 1, 2, 3].map(|i| x[i] - at.x[i]),
            [0, 1, 2].map(|i| cents[i] - at.cents[i]),
        );
        if left < 1.0 {
            at = Reached { x, cents };
        }
        if left < GOOD {
            (fresh, idle) = (false, 0);
            damping *= AFTER_GOOD;
            continue;
        }
        if left >= 1.0 && fresh {
            idle += 1;
            damping *= AFTER_BAD;
        }
        slopes = self::slopes(&cents_off, at.x, at.cents)?;
        fresh = true;
    }
    Ok(at)
}

/// The shortest way to where the straight lines of `slopes` come to nothing, or as far along it as they
/// are to be trusted. What is at the end of its range and would go on is left there.
fn step(at: &Reached, slopes: &[[f64; 4]; 3], damping: f64) -> Option<Dimensions> {
    let ranges = RANGES.map(|range| range.map(f64::ln));
    let mut slopes = *slopes;
    loop {
        let mut square = [[0.0; 3]; 3];
        for (i, row) in square.iter_mut().enumerate() {
            for (j, entry) in row.iter_mut().enumerate() {
                *entry = slopes[i].iter().zip(slopes[j]).map(|(a, b)| a * b).sum();
            }
            row[i] += damping * damping;
        }
        let shares = solved(&square, at.cents)?;
        let step = [0, 1, 2, 3].map(|k| -(0..3).map(|i| slopes[i][k] * shares[i]).sum::<f64>());
        let leaves = |k: usize| {
            let [low, high] = ranges[k];
            step[k] < 0.0 && at.x[k] <= low || step[k] > 0.0 && at.x[k] >= high
        };
        if let Some(held) = (0..4).find(|&k| leaves(k)) {
            for row in &mut slopes {
                row[held] = 0.0;
            }
            continue;
        }
        let longest = step.iter().fold(0.0f64, |most, s| most.max(s.abs()));
        let share = (LARGEST_STEP / longest).min(1.0);
        let [low, high] = [0, 1].map(|end| ranges.map(|range| range[end]));
        return Some([0, 1, 2, 3].map(|k| (at.x[k] + share * step[k]).clamp(low[k], high[k])));
    }
}

fn length(cents: &[f64; 3]) -> f64 {
    cents.iter().map(|c| c * c).sum::<f64>().sqrt()
}
