//! Modes that ring freely, in vectors: points of a cell across lanes, one mode after the other.
//!
//! Over a hop the sound of a mode is x times one table and y times another; what is kept in registers is
//! the sound at all points of a cell, and nothing is ever summed across lanes.

use super::Buses;
use super::between::{Between, NO_SUMS, Sums, rows};
use super::pack::{HOP, HOPS, Heard, LANES, Pack};
use super::points::{ALL, KINDS};
use pulp::{Simd, WithSimd};
use std::ops::Range;

/// Packs whose sound is summed in single floats, before it is added to the rest in doubles.
const TOGETHER: usize = 16;

/// One cell of all packs in `ranges`.
pub(super) struct Ring<'a> {
    pub(super) packs: &'a mut [Pack],
    pub(super) ranges: &'a [Range<usize>],
    pub(super) advance: bool,
    pub(super) room: &'a mut Room,
    pub(super) out: &'a mut Buses,
}

/// States of sixteen modes at the first sample of each hop of a cell, x and y.
#[derive(Clone, Copy, Debug)]
#[repr(C, align(64))]
struct Hops([[[f32; LANES]; 2]; HOPS]);

/// What the kernel works with.
pub(crate) struct Room {
    hops: [Hops; TOGETHER],
    pub(super) sums: Sums,
    pub(super) between: Between,
}

impl Room {
    /// Some microseconds' work and some kilobytes.
    pub(crate) fn new() -> Box<Self> {
        Box::new(Self {
            hops: [Hops([[[0.0; LANES]; 2]; HOPS]); TOGETHER],
            sums: NO_SUMS,
            between: Between::new(),
        })
    }
}

/// Sound in single floats hop by hop: left, then right.
#[repr(C, align(64))]
struct Sound<const H: usize>([[f32; 2 * HOP]; H]);

impl WithSimd for Ring<'_> {
    type Output = ();

    #[inline(always)]
    fn with_simd<S: Simd>(self, s: S) {
        // Vectors of a hop's sound, and sums for one, two and four hops: as many as it takes for none to
        // wait for another, and as registers hold.
        match S::F32_LANES {
            16 => self.sing::<S, 1, 8, 4, 2>(s),
            8 => self.sing::<S, 2, 4, 2, 1>(s),
            4 => self.sing::<S, 4, 2, 1, 1>(s),
            _ => super::plain::ring(self),
        }
    }
}

impl Ring<'_> {
    #[inline(always)]
    fn sing<S: Simd, const V: usize, const A: usize, const B: usize, const C: usize>(self, s: S) {
        let Room {
            hops,
            sums,
            between,
        } = self.room;
        *sums = NO_SUMS;
        let mut used = [false; KINDS];
        // What was tuned last is nearest in the cache.
        for range in self.ranges.iter().rev() {
            for packs in self.packs[range.clone()].chunks_mut(TOGETHER) {
                let mut present = [false; KINDS];
                for (hops, pack) in hops.iter_mut().zip(&mut *packs) {
                    match pack.points {
                        0 => leap::<S, 1>(s, pack, hops),
                        1 => leap::<S, 2>(s, pack, hops),
                        _ => leap::<S, HOPS>(s, pack, hops),
                    }
                    present[pack.points.min(ALL)] = true;
                    if self.advance {
                        turn(s, pack);
                    }
                }
                for (used, present) in used.iter_mut().zip(present) {
                    *used |= present;
                }
                if present[0] {
                    add::<S, V, A, 1>(s, packs, hops, (0, rows::<1>(sums, 0)));
                }
                if present[1] {
                    add::<S, V, B, 2>(s, packs, hops, (1, rows::<2>(sums, 1)));
                }
                if present[ALL] {
                    add::<S, V, C, HOPS>(s, packs, hops, (ALL, rows::<HOPS>(sums, ALL)));
                }
            }
        }
        between.fill(s, (sums, used), self.out);
    }
}

/// Adds the sound of the packs that are heard at points of this kind, in `H` hops.
#[inline(always)]
fn add<S: Simd, const V: usize, const SUMS: usize, const H: usize>(
    s: S,
    packs: &[Pack],
    hops: &[Hops; TOGETHER],
    (kind, sums): (usize, &mut [[f64; 2 * HOP]]),
) {
    let mut all = [[[s.splat_f32s(0.0); V]; SUMS]; H];
    for (pack, hops) in packs.iter().zip(hops) {
        if pack.points == kind {
            add_pack(s, pack, hops, &mut all);
        }
    }
    let mut sound = Sound([[0.0; 2 * HOP]; H]);
    for (hop, all) in sound.0.iter_mut().zip(&all) {
        for (v, to) in S::as_mut_simd_f32s(hop).0.iter_mut().enumerate() {
            *to = all[0][v];
            for more in &all[1..] {
                *to = s.add_f32s(*to, more[v]);
            }
        }
    }
    // In one row, lest the compiler gather columns.
    let sums = sums.as_flattened_mut().iter_mut();
    for (sum, sound) in sums.zip(sound.0.as_flattened()) {
        *sum += f64::from(*sound);
    }
}

/// Adds the sound of a pack at its points.
#[inline(always)]
fn add_pack<S: Simd, const V: usize, const SUMS: usize, const H: usize>(
    s: S,
    pack: &Pack,
    hops: &Hops,
    sums: &mut [[[S::f32s; V]; SUMS]; H],
) {
    let mut all = *sums;
    // Written out, because the compiler would count to eight for every eight modes.
    for (number, heard) in pack.heard.as_chunks::<8>().0.iter().enumerate() {
        let [a, b, c, d, e, f, g, h] = heard;
        let i = 8 * number;
        one::<S, V, SUMS, H, 0>(s, a, (hops, i), &mut all);
        one::<S, V, SUMS, H, 1>(s, b, (hops, i + 1), &mut all);
        one::<S, V, SUMS, H, 2>(s, c, (hops, i + 2), &mut all);
        one::<S, V, SUMS, H, 3>(s, d, (hops, i + 3), &mut all);
        one::<S, V, SUMS, H, 0>(s, e, (hops, i + 4), &mut all);
        one::<S, V, SUMS, H, 1>(s, f, (hops, i + 5), &mut all);
        one::<S, V, SUMS, H, 2>(s, g, (hops, i + 6), &mut all);
        one::<S, V, SUMS, H, 3>(s, h, (hops, i + 7), &mut all);
    }
    *sums = all;
}

/// Adds the sound of mode `i`, to sums in turn.
#[inline(always)]
fn one<S: Simd, const V: usize, const SUMS: usize, const H: usize, const TURN: usize>(
    s: S,
    heard: &Heard,
    (hops, i): (&Hops, usize),
    all: &mut [[[S::f32s; V]; SUMS]; H],
) {
    let of_x = S::as_simd_f32s(&heard.0[0]).0;
    let of_y = S::as_simd_f32s(&heard.0[1]).0;
    let (to_x, to_y) = (2 * TURN % SUMS, (2 * TURN + 1) % SUMS);
    for (sums, [x, y]) in all.iter_mut().zip(&hops.0) {
        let (x, y) = (s.splat_f32s(x[i]), s.splat_f32s(y[i]));
        for v in 0..V {
            sums[to_x][v] = s.mul_add_e_f32s(x, of_x[v], sums[to_x][v]);
            sums[to_y][v] = s.mul_add_e_f32s(y, of_y[v], sums[to_y][v]);
        }
    }
}

/// The states at each hop.
#[inline(always)]
fn leap<S: Simd, const H: usize>(s: S, pack: &Pack, hops: &mut Hops) {
    let re = S::as_simd_f32s(&pack.hop_re).0;
    let im = S::as_simd_f32s(&pack.hop_im).0;
    for v in 0..re.len() {
        // A vector at a time, lest it be put away in pieces and wait for them to be read back.
        let mut x = vector::<S>(&pack.x, v);
        let mut y = vector::<S>(&pack.y, v);
        let (re, im) = (re[v], im[v]);
        for (hop, [to_x, to_y]) in hops.0[..H].iter_mut().enumerate() {
            if hop > 0 {
                let next = s.negate_mul_add_e_f32s(y, im, s.mul_f32s(x, re));
                y = s.mul_add_e_f32s(y, re, s.mul_f32s(x, im));
                x = next;
            }
            S::as_mut_simd_f32s(to_x).0[v] = x;
            S::as_mut_simd_f32s(to_y).0[v] = y;
        }
    }
}

/// Vector `v` of `values` in single floats.
#[inline(always)]
fn vector<S: Simd>(values: &[f64; LANES], v: usize) -> S::f32s {
    let mut singles = [0.0; LANES];
    for (single, value) in singles[..S::F32_LANES]
        .iter_mut()
        .zip(&values[v * S::F32_LANES..])
    {
        *single = *value as f32;
    }
    S::as_simd_f32s(&singles).0[0]
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
