//! Modes that ring freely, in vectors: samples across lanes, one mode after the other.
//!
//! Over a hop the sound of a mode is x times one table and y times another; what is kept in registers is
//! the sound of a whole cell, and nothing is ever summed across lanes.

use super::pack::{HOP, HOPS, Heard, LANES, Pack};
use super::{Buses, GRID};
use pulp::{Simd, WithSimd};
use std::ops::Range;

/// Packs whose sound is summed in single floats, before it is added to the rest in doubles.
pub(crate) const TOGETHER: usize = 16;

/// One cell of all packs in `ranges`.
pub(super) struct Ring<'a> {
    pub(super) packs: &'a mut [Pack],
    pub(super) ranges: &'a [Range<usize>],
    pub(super) advance: bool,
    pub(super) hops: &'a mut [Hops; TOGETHER],
    pub(super) out: &'a mut Buses,
}

/// States of sixteen modes at the first sample of each hop of a cell, x and y.
#[derive(Clone, Copy, Debug)]
#[repr(C, align(64))]
pub(crate) struct Hops([[[f32; LANES]; 2]; HOPS]);

impl Hops {
    /// Room for the packs that are summed together.
    pub(crate) const ROOM: [Self; TOGETHER] = [Self([[[0.0; LANES]; 2]; HOPS]); TOGETHER];
}

/// The sound of a cell hop by hop: left, then right.
#[repr(C, align(64))]
pub(super) struct Sound(pub(super) [[f32; 2 * HOP]; HOPS]);

impl WithSimd for Ring<'_> {
    type Output = ();

    #[inline(always)]
    fn with_simd<S: Simd>(self, s: S) {
        // Vectors of a hop's sound; where one holds it all, x and y get sums of their own, lest one
        // wait for the other.
        match S::F32_LANES {
            16 => self.sing::<S, 1, 2>(s),
            8 => self.sing::<S, 2, 1>(s),
            4 => self.sing::<S, 4, 1>(s),
            _ => super::plain::ring(self),
        }
    }
}

impl Ring<'_> {
    #[inline(always)]
    fn sing<S: Simd, const V: usize, const SUMS: usize>(self, s: S) {
        for bus in self.out.iter_mut() {
            *bus = [0.0; GRID];
        }
        // What was tuned last is nearest in the cache.
        for range in self.ranges.iter().rev() {
            for packs in self.packs[range.clone()].chunks_mut(TOGETHER) {
                for (hops, pack) in self.hops.iter_mut().zip(&mut *packs) {
                    leap(s, pack, hops);
                    if self.advance {
                        turn(s, pack);
                    }
                }
                let mut sums = [[[s.splat_f32s(0.0); V]; SUMS]; HOPS];
                for (hops, pack) in self.hops.iter().zip(&*packs) {
                    add::<S, V, SUMS>(s, pack, hops, &mut sums);
                }
                let mut sound = Sound([[0.0; 2 * HOP]; HOPS]);
                for (hop, sums) in sound.0.iter_mut().zip(&sums) {
                    for (v, to) in S::as_mut_simd_f32s(hop).0.iter_mut().enumerate() {
                        *to = sums[0][v];
                        for more in &sums[1..] {
                            *to = s.add_f32s(*to, more[v]);
                        }
                    }
                }
                sound.add_to(self.out);
            }
        }
    }
}

impl Sound {
    /// Adds it to both buses.
    #[inline(always)]
    pub(super) fn add_to(&self, out: &mut Buses) {
        let [left, right] = out;
        for (hop, sound) in self.0.iter().enumerate() {
            for k in 0..HOP {
                left[hop * HOP + k] += f64::from(sound[k]);
                right[hop * HOP + k] += f64::from(sound[HOP + k]);
            }
        }
    }
}

/// Adds the sound of a pack over a cell.
#[inline(always)]
fn add<S: Simd, const V: usize, const SUMS: usize>(
    s: S,
    pack: &Pack,
    hops: &Hops,
    sums: &mut [[[S::f32s; V]; SUMS]; HOPS],
) {
    let mut all = *sums;
    // Written out, because the compiler would count to eight for every eight modes.
    for (number, heard) in pack.heard.as_chunks::<8>().0.iter().enumerate() {
        let [a, b, c, d, e, f, g, h] = heard;
        let i = 8 * number;
        one::<S, V, SUMS>(s, a, (hops, i), &mut all);
        one::<S, V, SUMS>(s, b, (hops, i + 1), &mut all);
        one::<S, V, SUMS>(s, c, (hops, i + 2), &mut all);
        one::<S, V, SUMS>(s, d, (hops, i + 3), &mut all);
        one::<S, V, SUMS>(s, e, (hops, i + 4), &mut all);
        one::<S, V, SUMS>(s, f, (hops, i + 5), &mut all);
        one::<S, V, SUMS>(s, g, (hops, i + 6), &mut all);
        one::<S, V, SUMS>(s, h, (hops, i + 7), &mut all);
    }
    *sums = all;
}

/// Adds the sound of mode `i`.
#[inline(always)]
fn one<S: Simd, const V: usize, const SUMS: usize>(
    s: S,
    heard: &Heard,
    (hops, i): (&Hops, usize),
    all: &mut [[[S::f32s; V]; SUMS]; HOPS],
) {
    let of_x = S::as_simd_f32s(&heard.0[0]).0;
    let of_y = S::as_simd_f32s(&heard.0[1]).0;
    for (sums, [x, y]) in all.iter_mut().zip(&hops.0) {
        let (x, y) = (s.splat_f32s(x[i]), s.splat_f32s(y[i]));
        for v in 0..V {
            sums[0][v] = s.mul_add_e_f32s(x, of_x[v], sums[0][v]);
            sums[SUMS - 1][v] = s.mul_add_e_f32s(y, of_y[v], sums[SUMS - 1][v]);
        }
    }
}

/// The states at each hop.
#[inline(always)]
fn leap<S: Simd>(s: S, pack: &Pack, hops: &mut Hops) {
    hops.0[0] = [single(&pack.x), single(&pack.y)];
    let (re, im) = (
        S::as_simd_f32s(&pack.hop_re).0,
        S::as_simd_f32s(&pack.hop_im).0,
    );
    for hop in 1..HOPS {
        let (before, after) = hops.0.split_at_mut(hop);
        let ([x, y], [next_x, next_y]) = (&before[hop - 1], &mut after[0]);
        let (x, y) = (S::as_simd_f32s(x).0, S::as_simd_f32s(y).0);
        let next_x = S::as_mut_simd_f32s(next_x).0;
        let next_y = S::as_mut_simd_f32s(next_y).0;
        for v in 0..x.len() {
            next_x[v] = s.negate_mul_add_e_f32s(y[v], im[v], s.mul_f32s(x[v], re[v]));
            next_y[v] = s.mul_add_e_f32s(y[v], re[v], s.mul_f32s(x[v], im[v]));
        }
    }
}

/// f64 to f32. What f32 has no full digits for is stopped before long: see [`FLOOR`].
///
/// [`FLOOR`]: crate::engine::body::FLOOR
#[inline(always)]
pub(super) fn single(values: &[f64; LANES]) -> [f32; LANES] {
    let mut singles = [0.0; LANES];
    for i in 0..LANES {
        singles[i] = values[i] as f32;
    }
    singles
}

/// Moves the state on by a cell.
#[inline(always)]
fn turn<S: Simd>(s: S, pack: &mut Pack) {
    let re = S::as_simd_f64s(&pack.cell_re).0;
    let im = S::as_simd_f64s(&pack.cell_im).0;
    let x = S::as_mut_simd_f64s(&mut pack.x).0;
    let y = S::as_mut_simd_f64s(&mut pack.y).0;
    for (((x, y), re), im) in x.iter_mut().zip(y).zip(re).zip(im) {
        let turned = s.negate_mul_add_e_f64s(*y, *im, s.mul_f64s(*x, *re));
        *y = s.mul_add_e_f64s(*y, *re, s.mul_f64s(*x, *im));
        *x = turned;
    }
}
