//! What trims make of the modes of one body.

use super::Tuned;
use crate::engine::oscillators::{CAUSES, LANES, Tone};
use crate::engine::source::Reached;
use crate::engine::trims::Trims;
use modes::ModeLabel;

/// The last of the causes of decay is the felt, which trims leave alone.
const RINGING: usize = CAUSES - 1;
/// Least share of the other causes that can carry what a trim adds.
const CARRIES: f64 = 1e-6;

/// Factors on the modes of a body.
#[derive(Clone, Debug)]
pub(super) struct Trimmed {
    modes: Vec<Trimming>,
    /// Number of the table that they are from, and whether it changes anything here.
    number: u32,
    any: bool,
    /// Whether decay rates in the tones are not as built.
    drained: bool,
}

#[derive(Clone, Copy, Debug)]
struct Trimming {
    label: ModeLabel,
    /// Decay rates as built, in 1/s.
    rates: [f32; CAUSES],
    /// Factors on the sound and on the decay rate.
    gain: f32,
    faster: f32,
}

impl Trimmed {
    /// As built.
    pub(super) fn new(modes: &[Reached]) -> Self {
        let as_built = |mode: &Reached| Trimming {
            label: mode.label,
            rates: mode.air,
            gain: 1.0,
            faster: 1.0,
        };
        Self {
            modes: modes.iter().map(as_built).collect(),
            number: 0,
            any: false,
            drained: false,
        }
    }

    /// Takes up a table by its number, if it is not the one known. One mode is alone only on bodies that
    /// have it.
    pub(super) fn follow(&mut self, trims: &Trims, number: u32) {
        if self.number == number {
            return;
        }
        self.number = number;
        let alone = trims
            .solo()
            .filter(|solo| self.modes.iter().any(|mode| mode.label == *solo));
        self.any = false;
        for mode in &mut self.modes {
            let trim = trims.get(&mode.label);
            let heard = alone.is_none_or(|alone| alone == mode.label);
            mode.gain = if heard { trim.gain() } else { 0.0 };
            mode.faster = trim.ringing.recip();
            self.any |= mode.gain != 1.0 || mode.faster != 1.0;
        }
    }

    fn pack(&self, pack: usize) -> &[Trimming] {
        let first = (pack * LANES).min(self.modes.len());
        &self.modes[first..(first + LANES).min(self.modes.len())]
    }

    /// Turns the modes of a pack up or down.
    pub(super) fn turn(&self, pack: usize, gain: &mut [[[f32; LANES]; 2]; 2]) {
        if !self.any {
            return;
        }
        for gain in gain.iter_mut().flatten() {
            for (gain, mode) in gain.iter_mut().zip(self.pack(pack)) {
                *gain *= mode.gain;
            }
        }
    }

    /// Lets the causes outside the material carry what makes modes ring shorter or longer; whether they
    /// are to be summed anew.
    ///
    /// A mode that loses m by its material and Σ sᵢrᵢ by the shares sᵢ of the other causes is to lose f times
    /// both: so rᵢ becomes f·rᵢ + (f − 1)·m/Σ sᵢ. What hands and felt take stays.
    pub(super) fn drain(&mut self, tones: &mut [Tone], tuned: &Tuned) -> bool {
        if !self.any && !self.drained {
            return false;
        }
        self.drained = self.any;
        let drain = &tuned.drain;
        let shares: f64 = drain.shares()[..RINGING].iter().sum();
        for (pack, tone) in tones.iter_mut().enumerate() {
            for (lane, mode) in self.pack(pack).iter().enumerate() {
                let omega = tuned.ratio * tone.omega[lane];
                let material = 0.5
                    * (drain.alpha1_s * omega * omega
                        + drain.loss_factor * omega
                        + drain.alpha2_per_s);
                let faster = f64::from(mode.faster);
                let more = if shares > CARRIES {
                    (faster - 1.0) * material / shares
                } else {
                    0.0
                };
                for cause in 0..RINGING {
                    let rate = faster * f64::from(mode.rates[cause]) + more;
                    tone.rates[cause][lane] = rate as f32;
                }
            }
        }
        true
    }
}
