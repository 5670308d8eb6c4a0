//! A mallet that is on a body now.

#[cfg(test)]
mod tests;

use super::grain::Grain;
use super::hertz::Hertz;
use super::mallet::Mallet;
use super::oscillators::LANES;

/// Longest that a mallet stays, in s: then the hand takes it away, one that bounces sooner than one that
/// it presses on.
const BOUNCES_S: f64 = 0.02;
const PRESSED_S: f64 = 0.25;

/// How much faster than now head and surface may close in before the next sample, in m/s.
const SWERVES_M_S: f64 = 10.0;

/// One mallet on one body.
///
/// The body moves as its modes do, and as a whole. The mallet's speed and the body's change by what
/// [`Hertz::step`] gives, so that contact time, second bounces and the energy that a soft head takes
/// out of a ringing body follow by themselves.
#[derive(Clone, Debug)]
pub(crate) struct Contact {
    /// Whether the mallet is there.
    pub(crate) touches: bool,
    /// φ·n̂ of each mode where the mallet touches, in kg^(−1/2).
    pub(crate) reach: Vec<[f64; LANES]>,
    /// What one newton takes off each ear: see [`super::body::Body::strike`].
    pub(crate) still: [f64; 2],
    hertz: Hertz,
    mass_kg: f64,
    body_kg: f64,
    /// Speed towards the body of the mallet, and of the body as a whole, in m/s.
    speed_m_s: f64,
    body_m_s: f64,
    /// Compression of head and surface; a gap when below zero.
    depth_m: f64,
    /// Closing speed before the last step, in m/s.
    closing_m_s: f64,
    /// Change of closing speed by 1 N·s, in 1/kg.
    mobility: f64,
    /// Force of the hand that presses on, in N.
    hand_n: f64,
    grain: Grain,
    impulse_n_s: f64,
    /// Impulse of the sample before.
    last_n_s: f64,
    age_s: f64,
}

/// What a blow is made of.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Blow {
    /// The mallet.
    pub(crate) mallet: Mallet,
    /// The force law of its head and the surface.
    pub(crate) hertz: Hertz,
    /// Mass of the body, in kg.
    pub(crate) body_kg: f64,
    /// Σ(φ·n̂)² over the modes, in 1/kg.
    pub(crate) mobility: f64,
    /// Impact speed, in m/s.
    pub(crate) speed_m_s: f64,
    /// Seed of the surface's roughness.
    pub(crate) seed: u64,
}

impl Contact {
    /// Nothing, on a body of `packs` packs of modes.
    pub(crate) fn new(packs: usize) -> Self {
        Self {
            touches: false,
            reach: vec![[0.0; LANES]; packs],
            still: [0.0; 2],
            hertz: Hertz::default(),
            mass_kg: 1.0,
            body_kg: 1.0,
            speed_m_s: 0.0,
            body_m_s: 0.0,
            depth_m: 0.0,
            closing_m_s: 0.0,
            mobility: 1.0,
            hand_n: 0.0,
            grain: Grain::default(),
            impulse_n_s: 0.0,
            last_n_s: 0.0,
            age_s: 0.0,
        }
    }

    /// A mallet touches down; where, `reach` and `still` must say already.
    pub(crate) fn begin(&mut self, blow: &Blow) {
        let mallet = &blow.mallet;
        self.touches = true;
        self.hertz = blow.hertz;
        self.mass_kg = mallet.mass_kg;
        self.body_kg = blow.body_kg;
        self.speed_m_s = blow.speed_m_s;
        self.body_m_s = 0.0;
        self.depth_m = 0.0;
        self.closing_m_s = blow.speed_m_s;
        self.mobility = 1.0 / mallet.mass_kg + 1.0 / blow.body_kg + blow.mobility;
        self.hand_n = mallet.press_n;
        self.grain = Grain::new(mallet.roughness, blow.seed);
        self.impulse_n_s = 0.0;
        self.last_n_s = 0.0;
        self.age_s = 0.0;
    }

    /// A step of `step_s` against a surface whose modes move at `surface_m_s`: the impulse that they
    /// get, in N·s.
    #[inline(always)]
    pub(crate) fn meet(&mut self, surface_m_s: f64, step_s: f64) -> f64 {
        self.speed_m_s += self.hand_n * step_s / self.mass_kg;
        let closing = self.speed_m_s - self.body_m_s - surface_m_s;
        self.closing_m_s = closing;
        let push = self
            .hertz
            .step(self.depth_m, closing, self.mobility, step_s);
        let mut impulse = push.impulse_n_s;
        self.depth_m = push.depth_m;
        if impulse > 0.0 && self.grain.is_felt() {
            let most = (2.0 * closing / self.mobility).max(0.0);
            impulse = self.alter(impulse, closing, most);
            let mean = closing - 0.5 * self.mobility * impulse;
            self.depth_m += step_s * (mean - (closing - 0.5 * self.mobility * push.impulse_n_s));
        }
        self.speed_m_s -= impulse / self.mass_kg;
        self.body_m_s += impulse / self.body_kg;
        self.impulse_n_s += impulse;
        self.age_s += step_s;
        impulse
    }

    /// Grains give way while they are pressed and do not spring back: more than the smooth impulse while
    /// head and body close in, though no more than `most`, which would stop them; less while they part.
    /// So this noise only takes energy.
    #[inline(always)]
    fn alter(&mut self, impulse: f64, closing: f64, most: f64) -> f64 {
        let share = self.grain.next_share();
        if closing <= 0.0 {
            impulse * (1.0 - share)
        } else {
            (impulse * (1.0 + share)).min(most.max(impulse))
        }
    }

    /// Whether head and surface touch, or may within the next sample.
    #[inline(always)]
    pub(crate) fn is_near(&self, sample_s: f64) -> bool {
        self.depth_m > -(4.0 * self.closing_m_s.abs() + SWERVES_M_S) * sample_s
    }

    /// Mean force about the instant of a sample that has just gone by, in N: half of the sample
    /// before it, half of it.
    #[inline(always)]
    pub(crate) fn force_n(&mut self, sample_s: f64) -> f64 {
        let force = 0.5 * (self.last_n_s + self.impulse_n_s) / sample_s;
        self.last_n_s = self.impulse_n_s;
        self.impulse_n_s = 0.0;
        force
    }

    /// Whether the mallet has left for good a surface that swings by no more than `swing_m`.
    pub(crate) fn is_over(&self, swing_m: f64) -> bool {
        let away = self.body_m_s > self.speed_m_s && self.hand_n == 0.0;
        let clear = away && self.depth_m < -2.0 * swing_m;
        self.last_n_s == 0.0 && (clear || self.age_s > BOUNCES_S && self.hand_n == 0.0)
            || self.age_s > PRESSED_S
    }

    /// Whether the mallet moves away, or has been there longer than `other`: the one to give way.
    pub(crate) fn rather_than(&self, other: &Self) -> bool {
        (self.depth_m < 0.0, self.age_s) > (other.depth_m < 0.0, other.age_s)
    }

    /// The hand takes the mallet away.
    pub(crate) fn lift(&mut self) {
        self.touches = false;
    }

    /// The hand no longer presses.
    pub(crate) fn let_go(&mut self) {
        self.hand_n = 0.0;
    }
}
