//! How far the modes move the surface now: slowed, exaggerated, or one alone.

use super::super::solid::{Solid, Vector, add, dot};
use super::portrait::Swinging;
use std::collections::HashMap;
use std::f32::consts::TAU;

/// Modes that move the picture at most; the rest move it less than these.
const MOVERS: usize = 24;
/// Modes whose motion is kept.
const KEPT: usize = 4 * MOVERS;
/// Least exaggeration of a mode alone, which is to be seen.
const LEAST: f32 = 0.3;
/// Swings a second of the slowest mode, and how swings of others go with their frequency: at the same
/// ratio the fastest would be a blur.
const SLOWEST_HZ: f32 = 1.3;
const FASTER: f32 = 0.6;
const FASTEST_HZ: f32 = 14.0;
/// Greatest swing in the picture as a share of the body's radius, at a motion of 1.
const GREATEST: f32 = 0.055;
/// Share of the greatest swing below which the picture rests.
const STILL: f32 = 2e-3;

/// The motion of the body that is drawn.
#[derive(Default)]
pub(super) struct Sway {
    time_s: f32,
    /// Greatest swing of the instrument so far, in m.
    greatest_m: f32,
    /// What modes do to the points, as far as it has been asked for, and their greatest motion.
    known: HashMap<usize, (Vec<Vector>, f32)>,
    /// Displacements in m as drawn, and how far each point moves along its normal, −1…1.
    pub(super) moved_m: Vec<Vector>,
    pub(super) out: Vec<f32>,
}

impl Sway {
    /// Another body.
    pub(super) fn forget(&mut self, instrument: bool) {
        self.known.clear();
        if instrument {
            self.greatest_m = 0.0;
        }
    }

    /// Time goes by.
    pub(super) fn pass(&mut self, time_s: f32) {
        self.time_s = (self.time_s + time_s) % 1000.0;
    }

    /// What a mode does to the points of `solid`.
    pub(super) fn motion(&mut self, solid: &Solid, mode: usize) -> &(Vec<Vector>, f32) {
        if self.known.len() >= KEPT && !self.known.contains_key(&mode) {
            self.known.clear();
        }
        self.known.entry(mode).or_insert_with(|| {
            let motion = solid.motion(mode);
            let most = motion.iter().fold(0.0f32, |most, u| most.max(dot(*u, *u)));
            (motion, most.sqrt())
        })
    }

    fn begin(&mut self, solid: &Solid) {
        self.moved_m.clear();
        self.moved_m.resize(solid.points_m.len(), [0.0; 3]);
    }

    /// One mode alone, swinging as far as is shown at most.
    pub(super) fn alone(&mut self, solid: &Solid, mode: usize, radius_m: f32, times: f32) {
        self.begin(solid);
        let swing = (TAU * 0.8 * self.time_s).cos();
        let (_, most) = *self.motion(solid, mode);
        if most > 0.0 {
            let share = GREATEST * radius_m * times.max(LEAST) * swing / most;
            self.add(solid, mode, share);
        }
        self.project(solid, GREATEST * radius_m * times.max(LEAST));
    }

    /// All modes that ring; whether anything moves.
    pub(super) fn live(&mut self, solid: &Solid, swinging: &Swinging<'_>, radius_m: f32) -> bool {
        self.begin(solid);
        let Swinging { hz, times, .. } = *swinging;
        let mut swings: Vec<(usize, f32)> = swinging.swings.iter().copied().enumerate().collect();
        swings.retain(|(_, swing)| *swing > 0.0);
        if swings.len() > MOVERS {
            swings.select_nth_unstable_by(MOVERS, |a, b| b.1.total_cmp(&a.1));
            swings.truncate(MOVERS);
        }
        let mut sum_m = 0.0;
        for (mode, swing) in &swings {
            sum_m += swing * self.motion(solid, *mode).1;
        }
        self.greatest_m = self.greatest_m.max(sum_m);
        if times <= 0.0 || self.greatest_m <= 0.0 || sum_m < STILL * self.greatest_m {
            self.project(solid, 1.0);
            return false;
        }
        let scale = GREATEST * radius_m * times / self.greatest_m;
        let first_hz = hz.first().copied().unwrap_or(1.0);
        for (mode, swing) in swings {
            let ratio = hz.get(mode).map_or(1.0, |hz| hz / first_hz) as f32;
            let slowed_hz = (SLOWEST_HZ * ratio.powf(FASTER)).min(FASTEST_HZ);
            let turn = (TAU * slowed_hz * self.time_s).sin();
            self.add(solid, mode, scale * swing * turn);
        }
        self.project(solid, GREATEST * radius_m * times);
        true
    }

    fn add(&mut self, solid: &Solid, mode: usize, share: f32) {
        self.motion(solid, mode);
        let Self { known, moved_m, .. } = self;
        if let Some((motion, _)) = known.get(&mode) {
            for (moved, u) in moved_m.iter_mut().zip(motion) {
                *moved = add(*moved, share, *u);
            }
        }
    }

    /// Works out how far points move along their normals, beside the greatest swing in the picture.
    fn project(&mut self, solid: &Solid, greatest_m: f32) {
        self.out.clear();
        let along = |(moved, normal): (&Vector, &Vector)| {
            (dot(*moved, *normal) / greatest_m.max(f32::MIN_POSITIVE)).clamp(-1.0, 1.0)
        };
        self.out
            .extend(self.moved_m.iter().zip(&solid.normals).map(along));
    }
}
