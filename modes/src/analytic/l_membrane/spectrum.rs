//! The modes of the L of unit squares, by the method of particular solutions (Fox, Henrici & Moler
//! 1967) in the form of Betcke & Trefethen 2005.

use super::corner::{Waves, about_corner};
use crate::analytic::quadrature::gauss;
use crate::analytic::roots::sharp_zero;
use crate::solve::{SmallestAngle, smallest_angle};
use rayon::prelude::*;
use std::f64::consts::PI;
use std::sync::{Arc, Mutex};

/// The modes of an L of unit squares, computed once for membranes of all sizes.
#[derive(Clone, Debug, PartialEq)]
pub struct LSpectrum {
    /// By rising wave number.
    pub(super) modes: Vec<UnitMode>,
}

/// A mode on unit squares, ∫u² = 1.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum UnitMode {
    /// The same mode of each square, of so many half-waves along x and y.
    Square { half_waves: [u16; 2] },
    /// Waves about the inner corner.
    Corner {
        /// Wave number κ.
        root: f64,
        waves: Waves,
        coefficients: Vec<f64>,
        /// Sine of the angle that is left between it and what rests on the edge.
        sine: f64,
    },
}

/// Step of the search over wave numbers: below the closest that two modes of one symmetry come.
const STEP: f64 = 0.02;

/// A search that starts here misses nothing: the lowest mode's wave number is 3.1.
const START: f64 = 2.5;

/// A least angle's sine that belongs to a mode and not to rounding or a near miss.
const ZERO: f64 = 1e-8;

/// Points on each side where a mode must rest; it has at most a third as many half-waves there.
const EDGE_POINTS: usize = 36;

/// Points inside that keep it from resting everywhere.
const INNER_POINTS: u16 = 50;

/// The spectrum that was asked for last.
static LAST: Mutex<Option<(f64, Arc<LSpectrum>)>> = Mutex::new(None);

impl LSpectrum {
    /// As [`Self::new`], computed anew only for another `highest` than the last time: bodies that are drawn
    /// over and over have the same.
    #[must_use]
    pub fn kept(highest: f64) -> Arc<Self> {
        let known = |last: &Option<(f64, Arc<Self>)>| {
            let last = last.as_ref().filter(|(known, _)| *known == highest);
            last.map(|(_, spectrum)| Arc::clone(spectrum))
        };
        let last = LAST.lock().ok().and_then(|last| known(&last));
        last.unwrap_or_else(|| {
            let spectrum = Arc::new(Self::new(highest));
            if let Ok(mut last) = LAST.lock() {
                *last = Some((highest, Arc::clone(&spectrum)));
            }
            spectrum
        })
    }

    /// All modes up to the wave number `highest`, in units of a square's side.
    #[must_use]
    pub fn new(highest: f64) -> Self {
        let mut modes = squares(highest);
        for symmetric in [true, false] {
            modes.extend(corners(symmetric, highest));
        }
        modes.sort_by(|p, q| p.root().total_cmp(&q.root()));
        Self { modes }
    }

    /// Wave numbers times a square's side, rising; the membrane's eigenvalues are their squares.
    #[must_use]
    pub fn roots(&self) -> Vec<f64> {
        self.modes.iter().map(UnitMode::root).collect()
    }

    /// Greatest sine of the angle between a mode and a function that rests on the edge.
    #[must_use]
    pub fn worst_sine(&self) -> f64 {
        let sines = self.modes.iter().map(|mode| match mode {
            UnitMode::Square { .. } => 0.0,
            UnitMode::Corner { sine, .. } => *sine,
        });
        sines.fold(0.0, f64::max)
    }
}

impl UnitMode {
    pub(super) fn root(&self) -> f64 {
        match self {
            Self::Square { half_waves } => PI * length(*half_waves),
            Self::Corner { root, .. } => *root,
        }
    }

    pub(super) fn value(&self, at: [f64; 2]) -> f64 {
        match self {
            Self::Square { half_waves } => {
                let [x, y] = [0, 1].map(|axis| (PI * f64::from(half_waves[axis]) * at[axis]).sin());
                2.0 / 3f64.sqrt() * x * y
            }
            Self::Corner {
                root,
                waves,
                coefficients,
                ..
            } => dot(&waves.values(*root, about_corner(at)), coefficients),
        }
    }
}

fn length([m, n]: [u16; 2]) -> f64 {
    f64::from(m).hypot(f64::from(n))
}

fn dot(values: &[f64], coefficients: &[f64]) -> f64 {
    values.iter().zip(coefficients).map(|(v, c)| v * c).sum()
}

/// The modes of the single squares: a square's mode, carried on over the others, rests on the L's edge
/// too.
fn squares(highest: f64) -> Vec<UnitMode> {
    let within = |half_waves: &[u16; 2]| PI * length(*half_waves) <= highest;
    let columns = (1..u16::MAX).take_while(|&m| within(&[m, 1]));
    columns
        .flat_map(|m| (1..u16::MAX).map(move |n| [m, n]).take_while(within))
        .map(|half_waves| UnitMode::Square { half_waves })
        .collect()
}

/// The other modes of one symmetry: where the least angle's sine comes down to zero.
fn corners(symmetric: bool, highest: f64) -> Vec<UnitMode> {
    let points = points();
    let angle = |root: f64| least(&Waves::new(symmetric, root), root, &points);
    #[expect(clippy::cast_sign_loss, reason = "a negative count saturates to none")]
    let steps = ((highest - START) / STEP).ceil() as usize + 2;
    let at = |i: usize| START + STEP * i as f64;
    let sines: Vec<f64> = (0..steps)
        .into_par_iter()
        .map(|i| angle(at(i)).sine)
        .collect();
    (1..steps.saturating_sub(1))
        .into_par_iter()
        .filter(|&i| sines[i] <= sines[i - 1] && sines[i] < sines[i + 1])
        .filter_map(|i| {
            // The same waves on both sides, or their number would make a step.
            let waves = Waves::new(symmetric, at(i));
            let sine = |root: f64| least(&waves, root, &points).sine;
            let root = sharp_zero(sine, at(i - 1), at(i + 1));
            let found = least(&waves, root, &points);
            (found.sine < ZERO && root <= highest).then(|| normalised(waves, root, found))
        })
        .collect()
}

/// Points (r, θ) of the first outer square: on its two far sides, then inside.
fn points() -> Vec<[f64; 2]> {
    let sides = gauss(EDGE_POINTS);
    let far = sides.iter().map(|(at, _)| [1.0, *at]);
    let top = sides.iter().map(|(at, _)| [*at, 1.0]);
    // Points of low discrepancy: multiples of 1/ρ and 1/ρ² with ρ³ = ρ + 1, so that they lie on no
    // node line.
    const RHO: f64 = 1.324_717_957_244_746;
    let inner = (1..=INNER_POINTS).map(|i| {
        let i = f64::from(i);
        [(i / RHO).fract(), (i / (RHO * RHO)).fract()]
    });
    let all = far.chain(top).chain(inner);
    all.map(|[s, t]| [s.hypot(t), t.atan2(s)]).collect()
}

fn least(waves: &Waves, root: f64, points: &[[f64; 2]]) -> SmallestAngle {
    let rows: Vec<Vec<f64>> = points.iter().map(|&p| waves.values(root, p)).collect();
    let functions = rows[0].len();
    let values: Vec<f64> = (0..functions)
        .flat_map(|j| rows.iter().map(move |row| row[j]))
        .collect();
    smallest_angle(&values, points.len(), 2 * EDGE_POINTS)
}

/// A point (s, t) on a side, by its share of the way.
type Side = fn(f64) -> [f64; 2];

/// The mode with ∫u² = 1, by Rellich's identity: 2κ² ∫u² = ∮ (∂u/∂n)² x·n ds (Rellich 1940,
/// Mathematische Zeitschrift 46, p. 635). With the inner corner as origin x·n is 1 on the outer edge
/// and 0 on the two inner sides, and of the outer edge the diagonal leaves one half.
fn normalised(waves: Waves, root: f64, found: SmallestAngle) -> UnitMode {
    let rule = gauss(EDGE_POINTS);
    // Side, and the axis across it: s = 1, t = 1 of the first outer square, t = 1 of the middle one.
    let sides: [(Side, usize); 3] = [
        (|at| [1.0, at], 0),
        (|at| [at, 1.0], 1),
        (|at| [-at, 1.0], 1),
    ];
    let sum: f64 = sides
        .iter()
        .flat_map(|(place, axis)| {
            rule.iter()
                .map(move |(at, weight)| (place(*at), *axis, weight))
        })
        .map(|([s, t], axis, weight)| {
            let gradients = waves.gradients(root, [s.hypot(t), t.atan2(s)]);
            let steepness: f64 = gradients
                .iter()
                .zip(&found.coefficients)
                .map(|(gradient, c)| gradient[axis] * c)
                .sum();
            weight * steepness * steepness
        })
        .sum();
    // Twice the half, over 2κ². The first wave's sign makes the mode positive by its first edge.
    let size = sum.sqrt() / root * found.coefficients[0].signum();
    UnitMode::Corner {
        root,
        waves,
        coefficients: found.coefficients.iter().map(|c| c / size).collect(),
        sine: found.sine,
    }
}
