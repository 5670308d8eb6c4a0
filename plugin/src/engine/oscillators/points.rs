//! Where a mode's sound over a cell is worked out: at every sample, or, for a low mode, at fewer points
//! between which it is smooth.

use super::pack::{HOP, HOPS};
use crate::engine::GRID;

/// Points evenly about the middle of a cell, in hops of [`HOP`].
pub(super) struct Points {
    /// Hops over the cell.
    pub(super) hops: usize,
    /// From one point to the next, in samples.
    pub(super) apart: f64,
    /// Highest mode that they do for, in rad a sample: what is made of its samples is then −120 dB off.
    pub(super) highest: f64,
}

/// How many kinds of points there are.
pub(super) const KINDS: usize = 3;

/// The fewest first; the last are the samples themselves.
pub(super) const POINTS: [Points; KINDS] = [
    Points::new(1, 4.3, 0.121),
    Points::new(2, 2.75, 0.505),
    Points::new(HOPS, 1.0, f64::INFINITY),
];

/// The samples themselves, among [`POINTS`].
pub(super) const ALL: usize = KINDS - 1;

impl Points {
    const fn new(hops: usize, apart: f64, highest: f64) -> Self {
        Self {
            hops,
            apart,
            highest,
        }
    }

    /// How many there are.
    pub(super) const fn count(&self) -> usize {
        self.hops * HOP
    }

    /// The first, in samples from the start of the cell.
    pub(super) const fn first(&self) -> f64 {
        0.5 * ((GRID - 1) as f64 - self.apart * (self.count() - 1) as f64)
    }

    /// What of the first hop is farthest from the start of the cell, in samples.
    pub(super) const fn reach(&self) -> f64 {
        let last = self.first() + self.apart * (HOP - 1) as f64;
        if last < -self.first() {
            -self.first()
        } else {
            last
        }
    }
}

/// The fewest points that do for a mode of `angle` rad a sample: their place in [`POINTS`].
pub(super) fn fewest(angle: f64) -> usize {
    let mut fewest = 0;
    for points in &POINTS[..ALL] {
        fewest += usize::from(angle > points.highest);
    }
    fewest
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_last_points_are_the_samples() {
        let all = &POINTS[ALL];
        assert_eq!((all.count(), all.first(), all.reach()), (GRID, 0.0, 7.0));
    }

    #[test]
    fn low_modes_need_few_points() {
        assert_eq!([0.0, 0.1, 0.3, 0.6, 3.1].map(fewest), [0, 0, 1, 2, 2]);
    }
}
