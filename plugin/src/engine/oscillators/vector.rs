//! The oscillators in vectors: modes across lanes and in registers, samples in the inner loop.

use super::{Buses, GRID, LANES, Oscillators, Push};
use pulp::{Simd, WithSimd};

/// Vectors of modes in flight: as many as registers hold with what is heard of them.
const FLIGHT: usize = 2;

/// Modes that ring freely.
pub(super) struct Ring<'a> {
    pub(super) oscillators: &'a mut Oscillators,
    pub(super) samples: usize,
    pub(super) out: &'a mut Buses,
}

/// Modes under the force of contacts.
pub(super) struct RingPushed<'a> {
    pub(super) oscillators: &'a mut Oscillators,
    pub(super) push: Push<'a>,
    pub(super) samples: usize,
    pub(super) out: &'a mut Buses,
}

/// States and steps of the vectors of modes still to be done.
struct Rest<'a, V> {
    x: &'a mut [V],
    y: &'a mut [V],
    re: &'a [V],
    im: &'a [V],
    hear: [&'a [V]; 5],
}

/// Sums of what is heard on the three buses, sample by sample.
type Sums<V> = [[V; GRID]; 3];

/// Adds what is heard of the next `N` vectors of modes to each sample's sums and moves them on, if
/// there are as many.
#[inline(always)]
fn fly<S: Simd, const N: usize>(
    s: S,
    rest: &mut Rest<'_, S::f64s>,
    samples: usize,
    sums: &mut Sums<S::f64s>,
) -> bool {
    let (Some(x), Some(y), Some(re), Some(im)) = (
        rest.x.split_off_mut(..N),
        rest.y.split_off_mut(..N),
        rest.re.split_off(..N),
        rest.im.split_off(..N),
    ) else {
        return false;
    };
    let zero = s.splat_f64s(0.0);
    let mut hear = [[zero; N]; 5];
    for (gains, rest) in hear.iter_mut().zip(&mut rest.hear) {
        let Some(next) = rest.split_off(..N) else {
            return false;
        };
        gains.copy_from_slice(next);
    }
    let (mut zx, mut zy, mut wr, mut wi) = ([zero; N], [zero; N], [zero; N], [zero; N]);
    zx.copy_from_slice(x);
    zy.copy_from_slice(y);
    wr.copy_from_slice(re);
    wi.copy_from_slice(im);
    for n in 0..samples {
        for k in 0..N {
            let [left, right, plain] = sums;
            left[n] = s.mul_add_e_f64s(hear[0][k], zy[k], left[n]);
            left[n] = s.mul_add_e_f64s(hear[1][k], zx[k], left[n]);
            right[n] = s.mul_add_e_f64s(hear[2][k], zy[k], right[n]);
            right[n] = s.mul_add_e_f64s(hear[3][k], zx[k], right[n]);
            plain[n] = s.mul_add_e_f64s(hear[4][k], zy[k], plain[n]);
            let across = s.mul_f64s(zx[k], wr[k]);
            let along = s.mul_f64s(zy[k], wr[k]);
            let turned = s.negate_mul_add_e_f64s(zy[k], wi[k], across);
            zy[k] = s.mul_add_e_f64s(zx[k], wi[k], along);
            zx[k] = turned;
        }
    }
    x.copy_from_slice(&zx);
    y.copy_from_slice(&zy);
    true
}

/// Writes the lanes' sums to the buses.
#[inline(always)]
fn write<S: Simd>(s: S, samples: usize, sums: &Sums<S::f64s>, out: &mut Buses) {
    for (bus, sums) in out.iter_mut().zip(sums) {
        for (sample, sum) in bus[..samples].iter_mut().zip(sums) {
            *sample = s.reduce_sum_f64s(*sum);
        }
    }
}

impl WithSimd for Ring<'_> {
    type Output = ();

    #[inline(always)]
    fn with_simd<S: Simd>(self, s: S) {
        let Self {
            oscillators,
            samples,
            out,
        } = self;
        let live = oscillators.live;
        let mut rest = Rest {
            x: S::as_mut_simd_f64s(&mut oscillators.x[..live]).0,
            y: S::as_mut_simd_f64s(&mut oscillators.y[..live]).0,
            re: S::as_simd_f64s(&oscillators.step_re[..live]).0,
            im: S::as_simd_f64s(&oscillators.step_im[..live]).0,
            hear: [0, 1, 2, 3, 4].map(|k| S::as_simd_f64s(&oscillators.hear[k][..live]).0),
        };
        let mut sums = [[s.splat_f64s(0.0); GRID]; 3];
        while fly::<S, FLIGHT>(s, &mut rest, samples, &mut sums) {}
        fly::<S, 1>(s, &mut rest, samples, &mut sums);
        write(s, samples, &sums, out);
    }
}

impl WithSimd for RingPushed<'_> {
    type Output = ();

    #[inline(always)]
    fn with_simd<S: Simd>(self, s: S) {
        let Self {
            oscillators,
            push,
            samples,
            out,
        } = self;
        let live = oscillators.live;
        let width = S::F64_LANES;
        debug_assert!(LANES.is_multiple_of(width));
        let zero = s.splat_f64s(0.0);
        let mut sums = [[zero; GRID]; 3];
        let (x, _) = S::as_mut_simd_f64s(&mut oscillators.x[..live]);
        let (y, _) = S::as_mut_simd_f64s(&mut oscillators.y[..live]);
        let (step_re, _) = S::as_simd_f64s(&oscillators.step_re[..live]);
        let (step_im, _) = S::as_simd_f64s(&oscillators.step_im[..live]);
        let (half_re, _) = S::as_simd_f64s(&oscillators.half_re[..live]);
        let (half_im, _) = S::as_simd_f64s(&oscillators.half_im[..live]);
        let hear = [0, 1, 2, 3, 4].map(|k| S::as_simd_f64s(&oscillators.hear[k][..live]).0);
        for v in 0..x.len() {
            let (mut along, mut across) = ([zero; GRID], [zero; GRID]);
            for contact in push.each() {
                let gain = S::as_simd_f64s(&contact.gain).0[v];
                let taken: [S::f64s; 4] = std::array::from_fn(|k| {
                    s.mul_f64s(gain, S::as_simd_f64s(&push.uptake[k]).0[v])
                });
                for n in 0..samples {
                    let moment = |k: usize| s.splat_f64s(contact.moments[k][n]);
                    along[n] = s.mul_add_e_f64s(taken[0], moment(0), along[n]);
                    along[n] = s.mul_add_e_f64s(taken[2], moment(2), along[n]);
                    across[n] = s.mul_add_e_f64s(taken[1], moment(1), across[n]);
                    across[n] = s.mul_add_e_f64s(taken[3], moment(3), across[n]);
                }
            }
            let (mut zx, mut zy) = (x[v], y[v]);
            for n in 0..samples {
                let [left, right, plain] = &mut sums;
                left[n] = s.mul_add_e_f64s(hear[0][v], zy, left[n]);
                left[n] = s.mul_add_e_f64s(hear[1][v], zx, left[n]);
                right[n] = s.mul_add_e_f64s(hear[2][v], zy, right[n]);
                right[n] = s.mul_add_e_f64s(hear[3][v], zx, right[n]);
                plain[n] = s.mul_add_e_f64s(hear[4][v], zy, plain[n]);
                let pushed_x = s.negate_mul_add_e_f64s(
                    half_im[v],
                    across[n],
                    s.mul_f64s(half_re[v], along[n]),
                );
                let pushed_y =
                    s.mul_add_e_f64s(half_im[v], along[n], s.mul_f64s(half_re[v], across[n]));
                let turned = s.mul_add_e_f64s(
                    zx,
                    step_re[v],
                    s.negate_mul_add_e_f64s(zy, step_im[v], pushed_x),
                );
                zy = s.mul_add_e_f64s(zy, step_re[v], s.mul_add_e_f64s(zx, step_im[v], pushed_y));
                zx = turned;
            }
            (x[v], y[v]) = (zx, zy);
        }
        write(s, samples, &sums, out);
    }
}
