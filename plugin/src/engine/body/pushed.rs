//! What pushes a body: mallets and a bow.

use super::{Body, Moved};
use crate::engine::GRID;
use crate::engine::contact::Blow;
use crate::engine::mallet::Mallet;
use crate::engine::oscillators::{Drive, Kernel, LANES, Pack, Tone};
use crate::engine::touch::Touch;

/// Mallets on a body at the same time.
pub(crate) const MALLETS: usize = 4;

/// Steps to a cycle of the highest mode that is heard by which a contact is followed at least, and steps to
/// a contact: below, its higher harmonics fold back onto the modes. A pulse falls as f^(−5/2), so that what
/// folds back onto the highest mode lies 45 dB below what that gets by itself.
const FOLLOWED_CYCLE: f64 = 8.82;
const FOLLOWED: f64 = 12.0;

/// Highest mode that is heard, in Hz.
const HEARD_HZ: f64 = 20_000.0;

/// Packs of modes up to which steps cost so little that a body is followed as if it had modes up to
/// [`HEARD_HZ`].
const FEW_PACKS: usize = 8;

/// How short the contacts of the hardest mallets are, in s.
const HARDEST_S: f64 = 1.5e-4;

/// Steps a second in which friction is followed.
const RUBBED_HZ: f64 = 88_200.0;

/// Steps to a sample at most.
const MOST_STEPS: f64 = 16.0;

/// Whole steps to a sample, at least `wanted`.
fn substeps(wanted: f64) -> u32 {
    #[expect(clippy::cast_sign_loss, reason = "at least one")]
    let steps = (wanted.min(MOST_STEPS) - 1e-6).ceil().max(1.0) as u32;
    steps
}

/// A blow on a body.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Strike {
    pub(crate) mallet: Mallet,
    /// E/(1 − ν²) of the body, in Pa.
    pub(crate) body_pa: f64,
    /// Mass of the body over that as built.
    pub(crate) heavier: f64,
    pub(crate) touch: Touch,
    /// Seed of the roughness of head and surface.
    pub(crate) seed: u64,
}

impl Body {
    /// Whether a mallet or a bow is on it.
    pub(super) fn is_touched(&self) -> bool {
        self.rub.touches || self.mallets.iter().any(|mallet| mallet.touches)
    }

    /// A mallet touches down at its place on the surface: every mode may ring from now on.
    ///
    /// A mode's sound goes with its acceleration, −ω² times its displacement while it rings; but what
    /// a force F holds it out without moving it, Fφ/ω², is silent. [`Contact::still`] is that part of
    /// the displacement as it would be heard, for one newton.
    pub(crate) fn strike(&mut self, kernel: Kernel, strike: &Strike, step_s: f64) {
        let Strike {
            mallet,
            body_pa,
            heavier,
            touch,
            seed,
        } = *strike;
        let body_kg = self.mass_kg * heavier;
        let contact_s = mallet.contact_s(body_pa, body_kg, touch.speed_m_s);
        let wanted = self.substeps(step_s, contact_s);
        if !self.driven || wanted > self.substeps {
            // Finer steps that are made cost less than others that are not.
            self.substeps = wanted.max(self.stepped);
            self.tune_steps(kernel, step_s);
        }
        self.begin_drive();
        let slot = self.vacant();
        let mobility = self.reach(touch, heavier, slot);
        let contact = &mut self.mallets[slot];
        contact.still = self
            .tones
            .iter()
            .zip(&contact.reach)
            .fold([0.0; 2], |still, (tone, reach)| {
                [0, 1].map(|ear| still[ear] + held(tone, reach, ear))
            });
        contact.begin(&Blow {
            mallet,
            hertz: mallet
                .hertz(body_pa)
                .followed(step_s / f64::from(self.substeps) / contact_s),
            body_kg,
            mobility,
            speed_m_s: touch.speed_m_s,
            seed,
        });
    }

    /// Makes ready, while it sleeps, the steps in which most blows are followed.
    pub(crate) fn prepare(&mut self, kernel: Kernel, step_s: f64) {
        self.substeps = self.substeps(step_s, HARDEST_S);
        self.tune_steps(kernel, step_s);
    }

    /// Steps to a sample in which a contact of that time is followed.
    fn substeps(&self, step_s: f64, contact_s: f64) -> u32 {
        let ratio = self.tuned.map_or(1.0, |tuned| tuned.ratio);
        let highest_hz = if self.tones.len() > FEW_PACKS {
            (ratio * self.highest_hz).min(HEARD_HZ)
        } else {
            HEARD_HZ
        };
        substeps(step_s * (FOLLOWED_CYCLE * highest_hz).max(FOLLOWED / contact_s))
    }

    /// From this point of the grid on it moves sample by sample, though nothing pushes it.
    pub(crate) fn lead(&mut self, kernel: Kernel, step_s: f64) {
        if !self.driven {
            self.substeps = 1;
            self.tune_steps(kernel, step_s);
            self.driven = true;
        }
    }

    /// From now on something pushes it, and every mode may ring.
    fn begin_drive(&mut self) {
        self.driven = true;
        self.live = self.tones.len();
    }

    /// A bow of `force_n` and `speed_m_s` for the next cell, which begins now; whether it is on the body,
    /// which a force of 0 ends.
    pub(crate) fn bow(
        &mut self,
        kernel: Kernel,
        force_n: f64,
        speed_m_s: f64,
        step_s: f64,
    ) -> bool {
        let was = self.rub.touches;
        let tones = &self.tones;
        let silent = |pack: usize, lane: usize| tones[pack].is_silent(lane);
        let cell_s = step_s * GRID as f64;
        if !self.rub.follow(force_n, speed_m_s, cell_s, silent) {
            return false;
        }
        let wanted = substeps(step_s * RUBBED_HZ);
        if !was && (!self.driven || self.substeps < wanted) {
            self.substeps = wanted;
            self.tune_steps(kernel, step_s);
        }
        self.begin_drive();
        true
    }

    /// A place for a mallet: an empty one, or that of the mallet that is there no longer or longest.
    fn vacant(&self) -> usize {
        let mut best = 0;
        for (i, mallet) in self.mallets.iter().enumerate() {
            if !mallet.touches {
                return i;
            }
            if mallet.rather_than(&self.mallets[best]) {
                best = i;
            }
        }
        best
    }

    /// Writes φ·n̂ where `touch` lands for the mallet in `slot`; Σ(φ·n̂)² in 1/kg. Modes that are silent at
    /// this sample rate do not count.
    fn reach(&mut self, touch: Touch, heavier: f64, slot: usize) -> f64 {
        // Shapes go with the root of the mass.
        let lighter = heavier.sqrt().recip();
        let reach = &mut self.mallets[slot].reach;
        let place = [touch.position, touch.across];
        self.motions
            .at(place, &mut self.scratch, reach.as_flattened_mut());
        let mut sum = 0.0;
        for (reach, tone) in reach.iter_mut().zip(&self.tones) {
            for (lane, reach) in reach.iter_mut().enumerate() {
                *reach = if tone.is_silent(lane) {
                    0.0
                } else {
                    lighter * *reach
                };
                sum += *reach * *reach;
            }
        }
        sum
    }

    /// Adds the next samples to `out`, which begin `phase` samples into a cell.
    pub(crate) fn drive(
        &mut self,
        kernel: Kernel,
        packs: &mut [Pack],
        phase: usize,
        step_s: f64,
        out: [&mut [f64]; 2],
    ) {
        let cell = GRID as f64;
        kernel.drive(Drive {
            packs: &mut packs[self.place.clone()][..self.live],
            steps: &self.steps[..self.live],
            contacts: &mut self.mallets,
            rub: self.rub.touches.then_some(&mut self.rub),
            substeps: self.substeps,
            step_s: step_s / f64::from(self.substeps),
            fade: (self.fading != Moved::NONE).then_some([phase as f64 / cell, 1.0 / cell]),
            out,
        });
    }

    /// Takes the mallets away that have left for good; whether it then rings freely from here on.
    pub(crate) fn part(&mut self, packs: &[Pack]) -> bool {
        if !self.driven {
            return false;
        }
        let packs = &packs[self.place.clone()];
        for i in 0..MALLETS {
            if self.mallets[i].touches && self.mallets[i].is_over(self.swing_m(i, packs)) {
                self.mallets[i].lift();
            }
        }
        let free = !self.is_touched();
        if free {
            self.driven = false;
        }
        free
    }

    /// Bound on how far the surface swings under a mallet, in m.
    fn swing_m(&self, mallet: usize, packs: &[Pack]) -> f64 {
        let reach = &self.mallets[mallet].reach;
        let mut sum = 0.0;
        for ((reach, tone), pack) in reach.iter().zip(&self.tones).zip(packs) {
            for (i, reach) in reach.iter().enumerate() {
                sum += reach.abs() * pack.x[i].abs().max(pack.y[i].abs()) / tone.omega[i];
            }
        }
        1.5 * sum
    }

    /// Hands no longer press mallets on.
    pub(crate) fn let_go(&mut self) {
        for mallet in &mut self.mallets {
            mallet.let_go();
        }
    }

    /// Back to the start of the cell that it has rung freely to the end of, to move sample by sample
    /// from there on.
    pub(crate) fn rewind(&mut self, kernel: Kernel, packs: &mut [Pack], step_s: f64) {
        for pack in &mut packs[self.ringing()] {
            pack.rewind();
        }
        self.substeps = 1;
        self.tune_steps(kernel, step_s);
    }
}

/// What one newton at `reach` holds out of the modes of `tone`, as `ear` would hear it.
fn held(tone: &Tone, reach: &[f64; LANES], ear: usize) -> f64 {
    (0..LANES)
        .map(|i| reach[i] * f64::from(tone.gain[ear][1][i]) / tone.omega[i])
        .sum()
}
