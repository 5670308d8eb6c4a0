//! Modes under a force: every fraction of a sample in f64, in vectors.

use super::pack::{LANES, Pack};
use super::tone::{Tone, turned};
use crate::engine::bow::Rub;
use crate::engine::contact::Contact;
use pulp::{Simd, WithSimd};

/// What moves sixteen modes by a fraction of a sample, and what is heard of them.
#[derive(Clone, Debug)]
#[repr(C, align(64))]
pub(crate) struct Step {
    /// Real and imaginary part of exp((−d + iΩ)T/substeps).
    part: [[f64; LANES]; 2],
    /// The same of exp((−d + iΩ)T).
    whole: [[f64; LANES]; 2],
    /// Left and right, from x and from y: at the end of the cell and at its start.
    hear: [[[[f64; LANES]; 2]; 2]; 2],
}

impl Step {
    /// Of modes that neither move nor are heard.
    pub(crate) const STILL: Self = Self {
        part: [[0.0; LANES]; 2],
        whole: [[0.0; LANES]; 2],
        hear: [[[[0.0; LANES]; 2]; 2]; 2],
    };

    /// Takes over what is heard of `tone`; what was heard before is faded out over this cell, unless
    /// this is to hold `at_once`.
    pub(crate) fn listen(&mut self, tone: &Tone, at_once: bool) {
        let new = tone.gain.map(|ear| ear.map(|gain| gain.map(f64::from)));
        let old = if at_once { new } else { self.hear[0] };
        self.hear = [new, old];
    }
}

/// A task for a kernel: steps of `step_s` for modes at `ratio` times their frequency that decay as they
/// are tuned to.
pub(crate) struct TuneSteps<'a> {
    pub(crate) tones: &'a [Tone],
    pub(crate) steps: &'a mut [Step],
    pub(crate) ratio: f64,
    pub(crate) sample_s: f64,
    pub(crate) substeps: u32,
}

impl WithSimd for TuneSteps<'_> {
    type Output = ();

    #[inline(always)]
    fn with_simd<S: Simd>(self, _: S) {
        let highest = super::tone::HIGHEST * std::f64::consts::PI / self.sample_s;
        let step_s = self.sample_s / f64::from(self.substeps);
        for (tone, step) in self.tones.iter().zip(self.steps) {
            let [re, im] = &mut step.part;
            for i in 0..LANES {
                let omega = tone.omega[i] * self.ratio;
                let decay = f64::from(tone.decay[i]);
                let square = (omega - decay) * (omega + decay);
                let heard = omega < highest && square > 0.01 * omega * omega;
                let damped = square.max(0.01 * omega * omega).sqrt().min(highest);
                let (sin, cos) = turned(damped * step_s);
                let left = fall(decay.min(omega) * step_s);
                re[i] = if heard { left * cos } else { 0.0 };
                im[i] = if heard { left * sin } else { 0.0 };
            }
            step.whole = step.part;
            let [re, im] = &mut step.whole;
            for _ in 1..self.substeps {
                for i in 0..LANES {
                    let [a, b] = [step.part[0][i], step.part[1][i]];
                    (re[i], im[i]) = (re[i] * a - im[i] * b, re[i] * b + im[i] * a);
                }
            }
        }
    }
}

/// e^(−x) for x of 0…4: a series for a 32nd of it, squared five times.
#[inline(always)]
fn fall(x: f64) -> f64 {
    let part = -x.min(4.0) / 32.0;
    let mut sum = 1.0;
    for k in [10.0, 9.0, 8.0, 7.0, 6.0, 5.0, 4.0, 3.0, 2.0, 1.0] {
        sum = 1.0 + part * (1.0 / k) * sum;
    }
    for _ in 0..5 {
        sum *= sum;
    }
    sum
}

/// A task for a kernel: the next `samples` of a body that something pushes, added to `out`.
pub(crate) struct Drive<'a> {
    pub(crate) packs: &'a mut [Pack],
    pub(crate) steps: &'a [Step],
    pub(crate) contacts: &'a mut [Contact],
    /// A bow on it, if there is one.
    pub(crate) rub: Option<&'a mut Rub>,
    /// Steps to a sample.
    pub(crate) substeps: u32,
    pub(crate) step_s: f64,
    /// Share of the cell gone at the first sample, and what each adds, while gains move.
    pub(crate) fade: Option<[f64; 2]>,
    pub(crate) out: [&'a mut [f64]; 2],
}

impl WithSimd for Drive<'_> {
    type Output = ();

    #[inline(always)]
    fn with_simd<S: Simd>(self, s: S) {
        let Self {
            packs,
            steps,
            contacts,
            mut rub,
            substeps,
            step_s,
            fade,
            out: [left, right],
        } = self;
        for (n, (left, right)) in left.iter_mut().zip(right).enumerate() {
            let mut heard = hear(s, packs, steps, 0);
            if let Some([from, each]) = fade {
                let old = hear(s, packs, steps, 1);
                let share = from + each * n as f64;
                heard = [0, 1].map(|ear| old[ear] + (heard[ear] - old[ear]) * share);
            }
            push(
                s,
                packs,
                steps,
                contacts,
                rub.as_deref_mut(),
                (substeps, step_s),
            );
            for contact in contacts.iter_mut().filter(|contact| contact.touches) {
                let force_n = contact.force_n(step_s * f64::from(substeps));
                heard = [0, 1].map(|ear| heard[ear] - force_n * contact.still[ear]);
            }
            *left += heard[0];
            *right += heard[1];
        }
    }
}

/// A sample of all modes in `substeps` of `step_s`: in each they move on, and then all contacts give their
/// blows.
#[inline(always)]
fn push<S: Simd>(
    s: S,
    packs: &mut [Pack],
    steps: &[Step],
    contacts: &mut [Contact],
    mut rub: Option<&mut Rub>,
    (substeps, step_s): (u32, f64),
) {
    let sample_s = step_s * f64::from(substeps);
    let mut touching = contacts.iter_mut().filter(|contact| contact.touches);
    let (first, second) = (touching.next(), touching.next());
    match (first, second) {
        _ if rub.is_some() => {
            for _ in 0..substeps {
                turn(s, packs, steps, false, (&[], 0.0));
                meet_all(s, packs, contacts, step_s);
                if let Some(rub) = &mut rub {
                    let impulse_n_s = rub.meet(speed(s, packs, &rub.reach), step_s);
                    kick(s, packs, &rub.reach, impulse_n_s);
                }
            }
        }
        (None, _) => {
            turn(s, packs, steps, true, (&[], 0.0));
        }
        (Some(contact), None) if !contact.is_near(sample_s) => {
            let surface_m_s = turn(s, packs, steps, true, (&contact.reach, 0.0));
            let impulse_n_s = contact.meet(surface_m_s, sample_s);
            if impulse_n_s > 0.0 {
                kick(s, packs, &contact.reach, impulse_n_s);
            }
        }
        (Some(contact), None) => {
            let mut impulse_n_s = 0.0;
            for _ in 0..substeps {
                let surface_m_s = turn(s, packs, steps, false, (&contact.reach, impulse_n_s));
                impulse_n_s = contact.meet(surface_m_s, step_s);
            }
            kick(s, packs, &contact.reach, impulse_n_s);
        }
        (Some(_), Some(_)) => {
            for _ in 0..substeps {
                turn(s, packs, steps, false, (&[], 0.0));
                meet_all(s, packs, contacts, step_s);
            }
        }
    }
}

/// The blows of all contacts over a step.
#[inline(always)]
fn meet_all<S: Simd>(s: S, packs: &mut [Pack], contacts: &mut [Contact], step_s: f64) {
    for contact in contacts.iter_mut().filter(|contact| contact.touches) {
        let surface_m_s = speed(s, packs, &contact.reach);
        let impulse_n_s = contact.meet(surface_m_s, step_s);
        kick(s, packs, &contact.reach, impulse_n_s);
    }
}

/// Gives the modes an impulse in N·s where they move as `reach` says and moves them on by a substep, or a
/// whole sample; the speed of the surface there after it, in m/s. Without `reach` they only move.
#[inline(always)]
fn turn<S: Simd>(
    s: S,
    packs: &mut [Pack],
    steps: &[Step],
    whole: bool,
    (reach, impulse_n_s): (&[[f64; LANES]], f64),
) -> f64 {
    const NOWHERE: &[f64; LANES] = &[0.0; LANES];
    let impulse = s.splat_f64s(impulse_n_s);
    let mut sums = [s.splat_f64s(0.0); 2];
    for (i, (pack, step)) in packs.iter_mut().zip(steps).enumerate() {
        let reach = S::as_simd_f64s(reach.get(i).unwrap_or(NOWHERE)).0;
        let turn = if whole { &step.whole } else { &step.part };
        let (re, im) = (S::as_simd_f64s(&turn[0]).0, S::as_simd_f64s(&turn[1]).0);
        let x = S::as_mut_simd_f64s(&mut pack.x).0;
        let y = S::as_mut_simd_f64s(&mut pack.y).0;
        for v in 0..x.len() {
            let pushed = s.mul_add_e_f64s(reach[v], impulse, x[v]);
            let along = s.mul_f64s(pushed, re[v]);
            let across = s.mul_f64s(pushed, im[v]);
            x[v] = s.negate_mul_add_e_f64s(y[v], im[v], along);
            y[v] = s.mul_add_e_f64s(y[v], re[v], across);
            sums[v % 2] = s.mul_add_e_f64s(reach[v], x[v], sums[v % 2]);
        }
    }
    s.reduce_sum_f64s(s.add_f64s(sums[0], sums[1]))
}

/// What is heard of all modes now, with gains at the end of the cell (0) or at its start (1).
#[inline(always)]
fn hear<S: Simd>(s: S, packs: &[Pack], steps: &[Step], when: usize) -> [f64; 2] {
    // Four sums to an ear, lest each wait for the last.
    let mut sums = [[[s.splat_f64s(0.0); 2]; 2]; 2];
    for (pack, step) in packs.iter().zip(steps) {
        let x = S::as_simd_f64s(&pack.x).0;
        let y = S::as_simd_f64s(&pack.y).0;
        for (sums, [from_x, from_y]) in sums.iter_mut().zip(&step.hear[when]) {
            let (from_x, from_y) = (S::as_simd_f64s(from_x).0, S::as_simd_f64s(from_y).0);
            for v in 0..x.len() {
                let [along, across] = &mut sums[v % 2];
                *along = s.mul_add_e_f64s(from_x[v], x[v], *along);
                *across = s.mul_add_e_f64s(from_y[v], y[v], *across);
            }
        }
    }
    let mut heard = [0.0; 2];
    // Plain loops: a closure would not be compiled for these vectors.
    for (heard, [[a, b], [c, d]]) in heard.iter_mut().zip(sums) {
        *heard = s.reduce_sum_f64s(s.add_f64s(s.add_f64s(a, b), s.add_f64s(c, d)));
    }
    heard
}

/// Speed of the surface where modes move as `reach` says, in m/s.
#[inline(always)]
fn speed<S: Simd>(s: S, packs: &[Pack], reach: &[[f64; LANES]]) -> f64 {
    let mut sums = [s.splat_f64s(0.0); 2];
    for (pack, reach) in packs.iter().zip(reach) {
        let x = S::as_simd_f64s(&pack.x).0;
        let reach = S::as_simd_f64s(reach).0;
        for v in 0..x.len() {
            sums[v % 2] = s.mul_add_e_f64s(reach[v], x[v], sums[v % 2]);
        }
    }
    s.reduce_sum_f64s(s.add_f64s(sums[0], sums[1]))
}

/// Gives the modes an impulse, in N·s.
#[inline(always)]
fn kick<S: Simd>(s: S, packs: &mut [Pack], reach: &[[f64; LANES]], impulse_n_s: f64) {
    let impulse = s.splat_f64s(impulse_n_s);
    for (pack, reach) in packs.iter_mut().zip(reach) {
        let x = S::as_mut_simd_f64s(&mut pack.x).0;
        for (x, reach) in x.iter_mut().zip(S::as_simd_f64s(reach).0) {
            *x = s.mul_add_e_f64s(*reach, impulse, *x);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::fall;

    #[test]
    fn falls_are_exponential() {
        for i in 0..=400 {
            let x = f64::from(i) / 100.0;
            assert!((fall(x) - (-x).exp()).abs() < 3e-15, "{x}");
        }
    }
}
