//! A bow on an edge, or a stick around a rim.

use super::friction::rub;
use super::grain::Grain;
use super::oscillators::LANES;
use super::range;
use super::settings::within;
use super::source::delayed;
use std::f64::consts::TAU;

/// What rubs, and how.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bow {
    /// Force at full pressure, in N.
    pub force_n: f64,
    /// Speed, in m/s.
    pub speed_m_s: f64,
    /// Whether keys rub for as long as they are held, instead of striking.
    pub rubs: bool,
}

impl Bow {
    /// A player's puja on a bowl (Inácio, Henrique & Antunes, The dynamics of Tibetan singing bowls, Acta
    /// Acustica 92, 2006, study 1 to 9 N and 0.1 to 0.5 m/s).
    pub const DEFAULT: Self = Self {
        force_n: 10.0,
        speed_m_s: 0.15,
        rubs: false,
    };

    /// The same with every value in its range, and what is not a number as by default.
    pub(super) fn sane(self) -> Self {
        let normal = Self::DEFAULT;
        Self {
            force_n: within(self.force_n, range::BOW_N, normal.force_n),
            speed_m_s: within(self.speed_m_s, range::BOW_M_S, normal.speed_m_s),
            rubs: self.rubs,
        }
    }
}

/// Time in which pressure and speed follow the hand, in s.
const FOLLOWS_S: f64 = 0.03;

/// Pressure below which the bow leaves.
const LEAVES: f64 = 1e-3;

/// How a mode moves along a rim, or up and down at an edge.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct Grip {
    /// Greatest motion along the bow, in kg^(−1/2).
    pub(crate) size: f64,
    /// Waves around the axis.
    pub(crate) waves: f64,
    /// Angle at which the motion is zero, times the waves, in rad.
    pub(crate) from_rad: f64,
}

/// The bow of one body.
#[derive(Clone, Debug)]
pub(crate) struct Rub {
    /// Whether it is on the body.
    pub(crate) touches: bool,
    /// Motion of each mode along the bow where it is now, in kg^(−1/2).
    pub(crate) reach: Vec<[f64; LANES]>,
    grips: Vec<[Grip; LANES]>,
    /// Radius of the rim that it goes around, in m; none for an edge.
    radius_m: Option<f64>,
    angle_rad: f64,
    mobility: f64,
    force_n: f64,
    speed_m_s: f64,
    grain: Grain,
}

/// Share of the force that the grain of hair, wood or leather takes at most: what a mode starts from.
const GRAIN: f64 = 0.1;

impl Rub {
    /// No bow yet, on modes that move as `grips` say along a rim of `radius_m` or at an edge.
    pub(crate) fn new(grips: Vec<[Grip; LANES]>, radius_m: Option<f64>) -> Self {
        Self {
            touches: false,
            reach: vec![[0.0; LANES]; grips.len()],
            grips,
            radius_m,
            angle_rad: 0.0,
            mobility: 0.0,
            force_n: 0.0,
            speed_m_s: 0.0,
            grain: Grain::new(GRAIN, 1),
        }
    }

    /// The hand moves on by `time_s`, towards this force and speed; whether the bow is still on the body.
    /// Modes that `silent` says are too high at this sample rate do not count.
    pub(crate) fn follow(
        &mut self,
        force_n: f64,
        speed_m_s: f64,
        time_s: f64,
        silent: impl Fn(usize, usize) -> bool,
    ) -> bool {
        let share = (time_s / FOLLOWS_S).min(1.0);
        if !self.touches {
            if force_n <= 0.0 {
                return false;
            }
            (self.force_n, self.speed_m_s) = (0.0, speed_m_s);
            self.grain = Grain::new(GRAIN, 1);
        }
        self.force_n += (force_n - self.force_n) * share;
        self.speed_m_s += (speed_m_s - self.speed_m_s) * share;
        self.touches = force_n > 0.0 || self.force_n > LEAVES;
        if let Some(radius_m) = self.radius_m {
            self.angle_rad = (self.angle_rad + self.speed_m_s / radius_m * time_s) % TAU;
        }
        self.mobility = 0.0;
        for (pack, (reach, grips)) in self.reach.iter_mut().zip(&self.grips).enumerate() {
            for (lane, (reach, grip)) in reach.iter_mut().zip(grips).enumerate() {
                *reach = if silent(pack, lane) {
                    0.0
                } else {
                    let angle = grip.waves * self.angle_rad - grip.from_rad;
                    grip.size * f64::from(delayed(angle).1)
                };
                self.mobility += *reach * *reach;
            }
        }
        self.touches
    }

    /// A step of `step_s` on a surface whose modes move at `surface_m_s`: the impulse that they get, in
    /// N·s.
    #[inline(always)]
    pub(crate) fn meet(&mut self, surface_m_s: f64, step_s: f64) -> f64 {
        let pressed = 1.0 - self.grain.next_share();
        rub(
            self.speed_m_s - surface_m_s,
            pressed * self.force_n * step_s,
            self.mobility,
        )
    }

    /// Goes on as `old` does, on another body; whether there is a bow.
    pub(crate) fn carry(&mut self, old: &Self) -> bool {
        self.touches = old.touches;
        (self.force_n, self.speed_m_s) = (old.force_n, old.speed_m_s);
        self.angle_rad = old.angle_rad;
        self.grain = old.grain;
        self.touches
    }

    /// The hand takes the bow away.
    pub(crate) fn lift(&mut self) {
        self.touches = false;
        self.force_n = 0.0;
    }
}
