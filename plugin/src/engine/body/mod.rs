//! One object: its modes, and how they wake, change and fall asleep.

mod heir;
mod joined;
mod pushed;
mod trimmed;
mod tuned;

pub(crate) use pushed::Strike;
pub(crate) use tuned::{Moved, Tuned};

use super::bow::Rub;
use super::contact::Contact;
use super::grips;
use super::mallet::contact_modulus_pa;
use super::oscillators::{LANES, Pack, Step, Tone};
use super::source::{Hearing, Reached, Source, reached};
use super::sympathy::Strand;
use heir::Names;
use modes::{Damping, Matter, Motions};
use pushed::MALLETS;
use std::ops::Range;
use trimmed::Trimmed;

/// Amplitude below which a mode is stopped, as a fraction of full scale: −180 dB.
pub(crate) const FLOOR: f64 = 1e-9;

/// A body that rings.
#[derive(Clone, Debug)]
pub(crate) struct Body {
    pub(crate) mass_kg: f64,
    /// E/(1 − ν²) of its material, in Pa.
    pub(crate) modulus_pa: f64,
    /// What its material takes by itself.
    pub(crate) own: Damping,
    /// Whether the bank says what the damper's felt does to it.
    pub(crate) has_felt: bool,
    /// Where its modes are among the packs of the instrument.
    pub(crate) place: Range<usize>,
    /// Leading packs that may be ringing.
    pub(crate) live: usize,
    /// Whether something pushes it: then it moves sample by sample and not with the rest.
    pub(crate) driven: bool,
    /// What is heard of it otherwise at the end of this cell than at its start.
    pub(crate) fading: Moved,
    tones: Vec<Tone>,
    trimmed: Trimmed,
    sources: Vec<Source>,
    names: Names,
    /// Leading packs that are heard through a resonator.
    piped: usize,
    /// Frequency of its highest mode as built, in Hz.
    highest_hz: f64,
    /// φ·n̂ of the modes wherever it is struck.
    motions: Motions,
    scratch: Vec<f64>,
    mallets: [Contact; MALLETS],
    rub: Rub,
    /// How its lowest modes hang on the common support.
    strand: Strand,
    steps: Vec<Step>,
    substeps: u32,
    /// Substeps that `steps` are made for; 0 if the modes have been tuned otherwise since.
    stepped: u32,
    /// What the modes are tuned to.
    tuned: Option<Tuned>,
    /// Whether tables are made for damping a hair off.
    off: bool,
    heard: Option<Hearing>,
}

impl Body {
    /// From a bank's body and what it is made of, with its modes at `first` among the packs of the
    /// instrument; `scale` takes Pa to full scale. What it has in common with the body `before` it shares.
    pub(crate) fn new(
        (body, matter): (&modes::Body, &Matter),
        scale: f64,
        first: usize,
        before: Option<&Self>,
    ) -> Self {
        let modes = reached(body);
        let packs = modes.len().div_ceil(LANES);
        let shapes = modes.iter().map(|mode| mode.shape.clone()).collect();
        let motions = match before {
            Some(before) => Motions::like(&before.motions, &body.line, shapes),
            None => Motions::new(&body.line, shapes),
        };
        let mut tones = vec![Tone::NONE; packs];
        let mut sources = vec![Source::SILENT; packs];
        for (i, mode) in modes.iter().enumerate() {
            let (pack, lane) = (i / LANES, i % LANES);
            // Lanes without a mode go with the last one, lest they ask for points of their own.
            tones[pack].omega[lane..].fill(std::f64::consts::TAU * mode.hz);
            for (rates, rate) in tones[pack].rates.iter_mut().zip(mode.air) {
                rates[lane] = rate;
            }
            sources[pack].set(lane, mode, scale);
        }
        let strand = Strand::new(tones.first().map_or(&[0.0; LANES], |tone| &tone.rates[1]));
        Self {
            mass_kg: body.mass_kg,
            modulus_pa: contact_modulus_pa(&matter.material),
            own: matter.damping,
            has_felt: modes.iter().any(|mode| mode.air[3] > 0.0),
            place: first..first + packs,
            live: 0,
            driven: false,
            fading: Moved::NONE,
            piped: usize::from(modes.iter().any(Reached::is_piped)),
            trimmed: Trimmed::new(&modes),
            tones,
            sources,
            names: Names::new(modes.iter().map(|mode| mode.label)),
            scratch: vec![0.0; motions.scratch_len()],
            motions,
            mallets: std::array::from_fn(|_| Contact::new(packs)),
            highest_hz: modes.last().map_or(0.0, |mode| mode.hz),
            strand,
            rub: grips::bow(&modes, body.line.points_m[0]),
            steps: vec![Step::STILL; packs],
            substeps: 1,
            stepped: 0,
            tuned: None,
            off: false,
            heard: None,
        }
    }

    /// What the modes are tuned to, once they have been.
    pub(crate) fn tuned(&self) -> Option<Tuned> {
        self.tuned
    }

    /// Packs that may be ringing, among those of the instrument.
    pub(crate) fn ringing(&self) -> Range<usize> {
        self.place.start..self.place.start + self.live
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
        self.strand.hush();
        self.live = 0;
        self.driven = false;
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
                    swing: energy.sqrt() / tone.omega[i],
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
    /// Its amplitude, in m·kg^(1/2).
    pub(crate) swing: f64,
}
