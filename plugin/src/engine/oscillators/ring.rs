//! Modes that ring freely, in vectors: modes across lanes and in registers, four samples a step.

use super::pack::{HOP, HOPS, LANES, Pack};
use super::{Buses, GRID};
use pulp::{Simd, WithSimd};
use std::ops::Range;

/// One cell of all packs in `ranges`.
pub(super) struct Ring<'a> {
    pub(super) packs: &'a mut [Pack],
    pub(super) ranges: &'a [Range<usize>],
    pub(super) advance: bool,
    pub(super) out: &'a mut Buses,
}

/// What is heard on both buses, sample by sample, lane by lane; aligned, lest vectors straddle lines of
/// the cache.
#[repr(align(64))]
struct Sums<V>([[V; 2]; GRID]);

impl WithSimd for Ring<'_> {
    type Output = ();

    #[inline(always)]
    fn with_simd<S: Simd>(self, s: S) {
        // Vectors of a pack, and packs in flight: four chains of states in registers.
        match S::F32_LANES {
            16 => self.fly::<S, 1, 4>(s),
            8 => self.fly::<S, 2, 1>(s),
            4 => self.fly::<S, 4, 1>(s),
            _ => super::plain::ring(self),
        }
    }
}

impl Ring<'_> {
    #[inline(always)]
    fn fly<S: Simd, const V: usize, const P: usize>(self, s: S) {
        let mut sums = Sums([[s.splat_f32s(0.0); 2]; GRID]);
        // What was tuned last is nearest in the cache.
        for range in self.ranges.iter().rev() {
            let packs = &mut self.packs[range.clone()];
            let mut flights = packs.chunks_exact_mut(P);
            for flight in &mut flights {
                if let Ok(flight) = <&mut [Pack; P]>::try_from(flight) {
                    cell::<S, V, P>(s, flight, self.advance, &mut sums);
                }
            }
            for pack in flights.into_remainder() {
                cell::<S, V, 1>(s, std::array::from_mut(pack), self.advance, &mut sums);
            }
        }
        for (n, sums) in sums.0.iter().enumerate() {
            for (bus, sum) in self.out.iter_mut().zip(sums) {
                bus[n] = f64::from(s.reduce_sum_f32s(*sum));
            }
        }
    }
}

/// Adds a cell of `packs` to `sums` and moves them on, if they are to.
#[inline(always)]
fn cell<S: Simd, const V: usize, const P: usize>(
    s: S,
    packs: &mut [Pack; P],
    advance: bool,
    sums: &mut Sums<S::f32s>,
) {
    let zero = s.splat_f32s(0.0);
    let (mut x, mut y) = ([[zero; V]; P], [[zero; V]; P]);
    for p in 0..P {
        x[p].copy_from_slice(S::as_simd_f32s(&single(&packs[p].x)).0);
        y[p].copy_from_slice(S::as_simd_f32s(&single(&packs[p].y)).0);
    }
    for hop in 0..HOPS {
        // Read anew in each hop, or the compiler copies all gains to the stack beforehand.
        let packs = std::hint::black_box(&*packs);
        for j in 0..HOP {
            let [mut left, mut right] = sums.0[hop * HOP + j];
            for p in 0..P {
                let [[lx, ly], [rx, ry]] = &packs[p].hear[j];
                let (lx, ly) = (S::as_simd_f32s(lx).0, S::as_simd_f32s(ly).0);
                let (rx, ry) = (S::as_simd_f32s(rx).0, S::as_simd_f32s(ry).0);
                for v in 0..V {
                    left = s.mul_add_e_f32s(lx[v], x[p][v], left);
                    right = s.mul_add_e_f32s(rx[v], x[p][v], right);
                    left = s.mul_add_e_f32s(ly[v], y[p][v], left);
                    right = s.mul_add_e_f32s(ry[v], y[p][v], right);
                }
            }
            sums.0[hop * HOP + j] = [left, right];
        }
        for p in 0..P {
            let re = S::as_simd_f32s(&packs[p].hop_re).0;
            let im = S::as_simd_f32s(&packs[p].hop_im).0;
            for v in 0..V {
                let along = s.mul_f32s(x[p][v], re[v]);
                let across = s.mul_f32s(x[p][v], im[v]);
                x[p][v] = s.negate_mul_add_e_f32s(y[p][v], im[v], along);
                y[p][v] = s.mul_add_e_f32s(y[p][v], re[v], across);
            }
        }
    }
    if advance {
        for pack in packs {
            turn(s, pack);
        }
    }
}

/// f64 to f32; what f32 has no full digits for becomes 0.
#[inline(always)]
fn single(values: &[f64; LANES]) -> [f32; LANES] {
    let mut singles = [0.0; LANES];
    for i in 0..LANES {
        singles[i] = if values[i].abs() < 1e-30 {
            0.0
        } else {
            values[i] as f32
        };
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
