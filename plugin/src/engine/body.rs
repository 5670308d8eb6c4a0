//! One object: its modes, and how they wake, change and fall asleep.

use super::GRID;
use super::bow::Rub;
use super::contact::{Blow, Contact};
use super::grips;
use super::losses::Drain;
use super::mallet::Mallet;
use super::oscillators::{Drive, Kernel, LANES, Pack, Step, Tone, Tune, TuneSteps};
use super::source::{Hearing, Source, reached};
use super::sympathy::{Answer, Feel, Strand};
use super::touch::Touch;
use modes::Stencil;
use std::ops::Range;

/// Amplitude below which a mode is stopped, as a fraction of full scale: −180 dB.
const FLOOR: f64 = 1e-9;

/// What the support has to do to a silent body in a cell for it to wake: −160 dB.
const WAKES: f32 = 1e-8;

/// Mallets on a body at the same time.
pub(crate) const MALLETS: usize = 4;

/// Steps a second that a contact is followed with at least, and steps to a contact: below, its higher
/// harmonics fold back into what is heard.
const FOLLOWED_HZ: f64 = 176_400.0;
const FOLLOWED: f64 = 12.0;

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

/// A body that rings.
#[derive(Clone, Debug)]
pub(crate) struct Body {
    pub(crate) mass_kg: f64,
    /// Whether the bank says what the damper's felt does to it.
    pub(crate) has_felt: bool,
    /// Where its modes are among the packs of the instrument.
    pub(crate) place: Range<usize>,
    /// Leading packs that may be ringing.
    pub(crate) live: usize,
    /// Whether something pushes it: then it moves sample by sample and not with the rest.
    pub(crate) driven: bool,
    /// Whether what is heard of it changes over this cell.
    pub(crate) fading: bool,
    tones: Vec<Tone>,
    sources: Vec<Source>,
    /// Leading packs that are heard through a resonator.
    piped: usize,
    /// φ·n̂ in kg^(−1/2), point by point and mode by mode.
    normal: Vec<f32>,
    points: usize,
    mallets: [Contact; MALLETS],
    rub: Rub,
    /// How its lowest modes hang on the common support.
    strand: Strand,
    steps: Vec<Step>,
    substeps: u32,
    /// What the modes are tuned to.
    tuned: Option<Tuned>,
    heard: Option<Hearing>,
}

/// Everything that the steps of a body's modes depend on.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Tuned {
    pub(crate) drain: Drain,
    /// Frequencies over those as built.
    pub(crate) ratio: f64,
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

/// How many leading packs are to be heard otherwise than before.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Moved(pub(crate) usize);

impl Moved {
    pub(crate) const NONE: Self = Self(0);
}

impl Body {
    /// From a bank's body, with its modes at `first` among the packs of the instrument; `scale` takes
    /// Pa to full scale.
    pub(crate) fn new(body: &modes::Body, scale: f64, first: usize) -> Self {
        let modes = reached(body);
        let packs = modes.len().div_ceil(LANES);
        let points = body.line.len();
        let mut tones = vec![Tone::NONE; packs];
        let mut sources = vec![Source::SILENT; packs];
        let mut normal = vec![0.0; points * packs * LANES];
        for (i, mode) in modes.iter().enumerate() {
            let (pack, lane) = (i / LANES, i % LANES);
            tones[pack].omega[lane] = std::f64::consts::TAU * mode.hz;
            for (rates, rate) in tones[pack].rates.iter_mut().zip(mode.air) {
                rates[lane] = rate;
            }
            sources[pack].set(lane, mode, scale);
            for (point, value) in mode.normal.iter().enumerate() {
                normal[point * packs * LANES + i] = *value;
            }
        }
        let strand = Strand::new(tones.first().map_or(&[0.0; LANES], |tone| &tone.rates[1]));
        Self {
            mass_kg: body.mass_kg,
            has_felt: modes.iter().any(|mode| mode.air[3] > 0.0),
            place: first..first + packs,
            live: 0,
            driven: false,
            fading: false,
            piped: usize::from(modes.iter().any(|mode| mode.is_piped())),
            tones,
            sources,
            normal,
            points,
            mallets: std::array::from_fn(|_| Contact::new(packs)),
            strand,
            rub: grips::bow(&modes, body.line.points_m[0]),
            steps: vec![Step::STILL; packs],
            substeps: 1,
            tuned: None,
            heard: None,
        }
    }

    /// Packs that may be ringing, among those of the instrument.
    pub(crate) fn ringing(&self) -> Range<usize> {
        self.place.start..self.place.start + self.live
    }

    /// Whether a mallet or a bow is on it.
    pub(crate) fn is_touched(&self) -> bool {
        self.rub.touches || self.mallets.iter().any(|mallet| mallet.touches)
    }

    /// Which packs are to be heard otherwise now.
    pub(crate) fn moved(&self, hearing: &Hearing) -> Moved {
        match &self.heard {
            Some(heard) if heard == hearing => Moved::NONE,
            Some(heard) if heard.without_pipe() == hearing.without_pipe() => Moved(self.piped),
            _ => Moved(self.tones.len()),
        }
    }

    /// Tunes the modes, if they are not tuned so or are to be heard otherwise.
    pub(crate) fn tune(
        &mut self,
        kernel: Kernel,
        packs: &mut [Pack],
        tuned: Tuned,
        hearing: &Hearing,
        step_s: f64,
    ) {
        let Moved(moved) = self.moved(hearing);
        for (tone, source) in self.tones.iter_mut().zip(&self.sources).take(moved) {
            source.gains(hearing, &tone.omega, &mut tone.gain);
        }
        self.heard = Some(*hearing);
        let pitch = self.tuned.is_none_or(|old| old.ratio != tuned.ratio);
        let all = self.tuned != Some(tuned);
        let count = if all { self.tones.len() } else { moved };
        if count == 0 {
            return;
        }
        kernel.run(Tune {
            tones: &mut self.tones[..count],
            packs: &mut packs[self.place.clone()][..count],
            drain: tuned.drain,
            ratio: pitch.then_some(tuned.ratio),
            gains: moved > 0,
            causes: self
                .tuned
                .is_none_or(|old| old.drain.shares() != tuned.drain.shares()),
            step_s,
        });
        self.tuned = Some(tuned);
        if moved > 0 {
            self.listen(moved, self.live == 0);
        }
        if self.driven && all {
            self.tune_steps(kernel, step_s);
        }
    }

    fn tune_steps(&mut self, kernel: Kernel, sample_s: f64) {
        kernel.run(TuneSteps {
            tones: &self.tones,
            steps: &mut self.steps,
            ratio: self.tuned.map_or(1.0, |tuned| tuned.ratio),
            sample_s,
            substeps: self.substeps,
        });
    }

    /// Takes the gains over to where the modes are pushed.
    fn listen(&mut self, packs: usize, at_once: bool) {
        for (step, tone) in self.steps.iter_mut().zip(&self.tones).take(packs) {
            step.listen(tone, at_once);
        }
    }

    /// A mallet touches down at `position` on the line: every mode may ring from now on.
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
        let wanted = substeps(step_s * FOLLOWED_HZ.max(FOLLOWED / contact_s));
        if !self.driven || wanted > self.substeps {
            self.substeps = wanted;
            self.tune_steps(kernel, step_s);
        }
        self.begin_drive();
        let slot = self.vacant();
        let mobility = self.reach(touch.position, heavier, slot);
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

    /// Writes φ·n̂ at `position` for the mallet in `slot`; Σ(φ·n̂)² in 1/kg. Modes that are silent at
    /// this sample rate do not count.
    fn reach(&mut self, position: f64, heavier: f64, slot: usize) -> f64 {
        // Shapes go with the root of the mass.
        let lighter = heavier.sqrt().recip();
        let reach = &mut self.mallets[slot].reach;
        let width = reach.len() * LANES;
        let stencil = Stencil::at(position, self.points);
        let mut sum = 0.0;
        for (pack, (reach, tone)) in reach.iter_mut().zip(&self.tones).enumerate() {
            *reach = [0.0; LANES];
            for (k, share) in stencil.weights.into_iter().enumerate() {
                let row = &self.normal[(stencil.first + k) * width + pack * LANES..][..LANES];
                for (reach, normal) in reach.iter_mut().zip(row) {
                    *reach += lighter * share * f64::from(*normal);
                }
            }
            for (lane, reach) in reach.iter_mut().enumerate() {
                if tone.is_silent(lane) {
                    *reach = 0.0;
                }
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
            fade: self.fading.then_some([phase as f64 / cell, 1.0 / cell]),
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
            for i in 0..LANES {
                sum += reach[i].abs() * pack.x[i].abs().max(pack.y[i].abs()) / tone.omega[i];
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

    /// Adds what the body does to the common support in the next cell to `all`.
    pub(crate) fn feel(&mut self, kernel: Kernel, packs: &[Pack], all: &mut [f32; GRID]) {
        let (Some(tone), Some(pack)) = (self.tones.first(), packs.get(self.place.start)) else {
            return;
        };
        kernel.run(Feel {
            strand: &mut self.strand,
            pack,
            turn: tone.turn(),
        });
        for (all, own) in all.iter_mut().zip(&self.strand.moves) {
            *all += own;
        }
    }

    /// Works out what the support, moved by `all` bodies, does to this one in the next cell.
    pub(crate) fn answer(&mut self, kernel: Kernel, all: &[f32; GRID], share: f32) {
        if let Some(tone) = self.tones.first() {
            kernel.run(Answer {
                strand: &mut self.strand,
                turn: tone.turn(),
                all,
                share,
            });
        }
    }

    /// Gives the modes what the support has done to them in the last cell, if that is or will be heard;
    /// whether it is.
    pub(crate) fn take_answer(&mut self, packs: &mut [Pack]) -> bool {
        let (Some(source), Some(pack)) = (self.sources.first(), packs.get_mut(self.place.start))
        else {
            return false;
        };
        let [x, y] = &self.strand.answer;
        let level = |i: usize| x[i].hypot(y[i]) * source.weight[i];
        if self.live == 0 && (0..LANES).all(|i| level(i) < WAKES) {
            return false;
        }
        self.strand.take(pack);
        self.live = self.live.max(1);
        true
    }

    /// Stops what is no longer heard; whether anything is left.
    pub(crate) fn settle(&mut self, packs: &mut [Pack]) -> bool {
        if self.driven {
            return true;
        }
        let mut live = 0;
        let packs = packs[self.place.clone()].iter_mut().zip(&self.sources);
        for (number, (pack, source)) in packs.take(self.live).enumerate() {
            let mut left = false;
            for i in 0..LANES {
                let size = pack.x[i] * pack.x[i] + pack.y[i] * pack.y[i];
                let weight = f64::from(source.weight[i]);
                if size * weight * weight < FLOOR * FLOOR {
                    (pack.x[i], pack.y[i]) = (0.0, 0.0);
                } else {
                    left = true;
                }
            }
            if left {
                live = number + 1;
            }
        }
        self.live = live;
        live > 0
    }

    /// Stops everything.
    pub(crate) fn hush(&mut self, packs: &mut [Pack]) {
        for pack in &mut packs[self.place.clone()] {
            pack.hush();
        }
        for mallet in &mut self.mallets {
            mallet.lift();
        }
        self.rub.lift();
        self.live = 0;
        self.driven = false;
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

    /// One of the mallets on it.
    #[cfg(test)]
    pub(crate) fn contact(&self, number: usize) -> &Contact {
        &self.mallets[number]
    }

    /// What each mode sounds like now.
    pub(crate) fn sounds(&self, packs: &[Pack]) -> impl Iterator<Item = Sound> {
        let packs = &packs[self.place.clone()];
        let modes = packs.iter().zip(&self.tones);
        modes.flat_map(|(pack, tone)| {
            (0..LANES).map(|i| {
                let energy = pack.x[i] * pack.x[i] + pack.y[i] * pack.y[i];
                let gains = tone.gain.iter().flatten().map(|gain| f64::from(gain[i]));
                Sound {
                    omega: tone.omega[i],
                    decay_per_s: f64::from(tone.decay[i]),
                    power: energy * gains.map(|gain| gain * gain).sum::<f64>(),
                }
            })
        })
    }
}

/// What a mode sounds like.
pub(crate) struct Sound {
    /// Angular frequency, in rad/s.
    pub(crate) omega: f64,
    /// Decay rate, in 1/s.
    pub(crate) decay_per_s: f64,
    /// Square of its amplitude, sum of both ears.
    pub(crate) power: f64,
}

/// What one newton at `reach` holds out of the modes of `tone`, as `ear` would hear it.
fn held(tone: &Tone, reach: &[f64; LANES], ear: usize) -> f64 {
    (0..LANES)
        .map(|i| reach[i] * f64::from(tone.gain[ear][1][i]) / tone.omega[i])
        .sum()
}
