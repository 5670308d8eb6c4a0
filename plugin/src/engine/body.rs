//! One object: its modes, and how they wake, change and fall asleep.

use super::losses::Drain;
use super::oscillators::{Buses, Hear, Kernel, Oscillators, Push, Uptake};
use super::rates::{Rates, Retune, uptake};
use super::resonator::Resonator;
use super::{GRID, contact::Contact};
use modes::{Ears, Stencil};

/// Amplitude below which a mode is stopped, as a fraction of full scale: −180 dB.
const FLOOR: f64 = 1e-9;

/// Share of the strongest mode's reach below which no strike makes a mode heard: −140 dB.
const UNREACHED: f64 = 1e-7;

/// A body that rings.
#[derive(Clone, Debug)]
pub(crate) struct Body {
    pub(crate) mass_kg: f64,
    /// Mallets on it now.
    pub(crate) contacts: usize,
    /// Whether the bank says what the damper's felt does to it.
    pub(crate) has_felt: bool,
    oscillators: Oscillators,
    /// What is heard through the resonator, if there is one.
    resonator: Option<Resonator>,
    rates: Rates,
    uptake: Uptake,
    /// φ·n̂ in kg^(−1/2), point by point and mode by mode.
    normal: Vec<f32>,
    points: usize,
    /// Full scale per modal displacement, at the nearer ear.
    weight: Vec<f64>,
    inverse_omega_s: Vec<f64>,
    /// What the oscillators are tuned for.
    tuned: Option<Drain>,
}

/// Samples to ring.
#[derive(Clone, Copy)]
pub(crate) struct Span {
    pub(crate) samples: usize,
    pub(crate) step_s: f64,
    /// Open share of the resonator at the first sample, and what each adds.
    pub(crate) open: [f64; 2],
}

/// A mode as the engine needs it.
pub(super) struct Reached {
    hz: f64,
    pub(super) ears: Ears,
    /// What of that comes through the resonator.
    pub(super) piped: Ears,
    /// Decay rates in 1/s by radiation, supports, resonator and felt.
    air: [f64; 4],
    normal: Vec<f32>,
}

/// What a mode sends to the ears, by itself and through the resonator below it.
pub(crate) fn heard(mode: &modes::Mode) -> Ears {
    let add = |a: [f32; 2], b: [f32; 2]| [a[0] + b[0], a[1] + b[1]];
    [0, 1].map(|ear| add(mode.ears[ear], mode.pipe_ears[ear]))
}

/// Size of the sound at the ear that gets more of it.
pub(super) fn loudest(ears: &Ears) -> f64 {
    let size = |ear: &[f32; 2]| f64::from(ear[0]).hypot(f64::from(ear[1]));
    ears.iter().map(size).fold(0.0, f64::max)
}

/// The modes that a strike somewhere on the line makes heard, by rising frequency.
fn reached(body: &modes::Body) -> Vec<Reached> {
    let points = body.line.len();
    let sound = |mode: &&modes::Mode| {
        mode.hz.is_finite()
            && mode.hz > 0.0
            && loudest(&heard(mode)).is_finite()
            && mode.shape.len() == points
    };
    let mut all: Vec<(Reached, f64)> = body
        .modes
        .iter()
        .filter(sound)
        .map(|mode| {
            let normal: Vec<f32> = mode
                .shape
                .iter()
                .zip(&body.line.normals)
                .map(|(shape, normal)| {
                    (0..3).map(|k| f64::from(shape[k]) * normal[k]).sum::<f64>() as f32
                })
                .collect();
            let most = normal.iter().fold(0.0, |m: f32, v| m.max(v.abs()));
            let reach = f64::from(most) * loudest(&heard(mode)) / mode.hz;
            let mode = Reached {
                hz: mode.hz,
                ears: heard(mode),
                piped: mode.pipe_ears,
                air: [
                    mode.radiation_per_s,
                    mode.support_per_s,
                    mode.pipe_per_s,
                    mode.felt_per_s,
                ]
                .map(f64::from),
                normal,
            };
            (mode, reach)
        })
        .collect();
    let most = all.iter().fold(0.0, |m: f64, (_, reach)| m.max(*reach));
    all.retain(|(_, reach)| *reach > UNREACHED * most);
    all.sort_by(|(a, _), (b, _)| a.hz.total_cmp(&b.hz));
    all.into_iter().map(|(mode, _)| mode).collect()
}

/// What `ears` make of y and x in units of `size`: left, right, and without a place.
pub(super) fn gains_of(ears: &Ears, size: f64) -> [f64; 5] {
    let [left, right] = ears.map(|ear| ear.map(|x| f64::from(x) / size));
    let power: f64 = left.iter().chain(&right).map(|x| x * x).sum();
    [left[0], left[1], right[0], right[1], (0.5 * power).sqrt()]
}

impl Body {
    /// From a bank's body; `scale` takes Pa to full scale.
    pub(crate) fn new(body: &modes::Body, step_s: f64, scale: f64) -> Self {
        let modes = reached(body);
        let hz: Vec<f64> = modes.iter().map(|mode| mode.hz).collect();
        let omega: Vec<f64> = hz.iter().map(|hz| std::f64::consts::TAU * hz).collect();
        let mut oscillators = Oscillators::new(modes.len());
        let padded = oscillators.len();
        let points = body.line.len();
        let mut normal = vec![0.0; points * padded];
        let mut weight = vec![0.0; padded];
        for (i, mode) in modes.iter().enumerate() {
            let size = loudest(&mode.ears);
            weight[i] = size * scale;
            if size > 0.0 {
                let hear = gains_of(&mode.ears, size);
                for (gains, gain) in oscillators.hear.iter_mut().zip(hear) {
                    gains[i] = gain;
                }
            }
            for (point, value) in mode.normal.iter().enumerate() {
                normal[point * padded + i] = *value;
            }
        }
        Self {
            mass_kg: body.mass_kg,
            contacts: 0,
            has_felt: modes.iter().any(|mode| mode.air[3] > 0.0),
            rates: Rates::new(&hz, |i| modes[i].air, step_s),
            uptake: uptake(&omega, step_s),
            normal,
            points,
            weight,
            inverse_omega_s: vec![0.0; padded],
            tuned: None,
            resonator: Resonator::take_from(&mut oscillators, &modes),
            oscillators,
        }
    }

    /// Number of modes, with padding.
    pub(crate) fn modes(&self) -> usize {
        self.oscillators.len()
    }

    /// Gives the modes these losses, if they have others.
    pub(crate) fn tune(&mut self, kernel: Kernel, drain: Drain) {
        let wanted = Some(drain);
        if self.tuned != wanted {
            kernel.run(Retune {
                rates: &self.rates,
                drain: &drain,
                oscillators: &mut self.oscillators,
                inverse_omega_s: &mut self.inverse_omega_s,
            });
            self.tuned = wanted;
        }
    }

    /// A mallet touches down at `position` on the line: every mode may ring from now on.
    ///
    /// A mode's sound goes with its acceleration, −ω² times its displacement while it rings; but what
    /// a force F holds it out without moving it, Fφ/ω², is silent. `contact.still` is that part of
    /// the displacement as the buses have it, for one newton.
    pub(crate) fn strike(&mut self, position: f64, contact: &mut Contact) {
        self.gains(position, &mut contact.gain);
        let still = |hear: &Hear| {
            [0, 2, 4].map(|bus| {
                let modes = contact.gain.iter().zip(&self.inverse_omega_s);
                let heard = modes.zip(&hear[bus]);
                heard
                    .map(|((gain, inverse), hear)| gain * inverse * hear)
                    .sum()
            })
        };
        let resonator = self.resonator.as_ref();
        contact.still = [
            still(&self.oscillators.hear),
            resonator.map_or([0.0; 3], |resonator| still(resonator.hear())),
        ];
        self.contacts += 1;
        self.oscillators.live = self.oscillators.len();
    }

    /// What a unit impulse at `position` on the line adds to each mode's x (O'Brien 2002, Eq. 18
    /// without its 2), weighted by what the mode sends out.
    fn gains(&self, position: f64, gains: &mut [f64]) {
        let modes = self.modes();
        let gains = &mut gains[..modes];
        gains.fill(0.0);
        let stencil = Stencil::at(position, self.points);
        for (k, share) in stencil.weights.into_iter().enumerate() {
            let row = &self.normal[(stencil.first + k) * modes..][..modes];
            for (gain, normal) in gains.iter_mut().zip(row) {
                *gain += share * f64::from(*normal);
            }
        }
        for ((gain, weight), inverse) in gains
            .iter_mut()
            .zip(&self.weight)
            .zip(&self.inverse_omega_s)
        {
            *gain *= weight * inverse;
        }
    }

    /// A mallet leaves.
    pub(crate) fn left(&mut self) {
        self.contacts -= 1;
    }

    /// An impulse at once, of a mallet that has to leave early.
    pub(crate) fn kick(&mut self, gains: &[f64], impulse_n_s: f64) {
        for (x, gain) in self.oscillators.x.iter_mut().zip(gains) {
            *x += gain * impulse_n_s;
        }
    }

    /// Writes the next samples to `out`.
    pub(crate) fn ring(
        &mut self,
        kernel: Kernel,
        contacts: &mut [Contact],
        key: u8,
        span: Span,
        out: &mut Buses,
    ) {
        let samples = span.samples;
        debug_assert!(samples <= GRID);
        let push = Push {
            contacts,
            key,
            uptake: &self.uptake,
        };
        let push = (self.contacts > 0).then_some(push);
        let resonator = self.resonator.as_mut();
        let piped = resonator.map(|r| r.ring(kernel, &self.oscillators, push, samples));
        kernel.ring(&mut self.oscillators, push, samples, out);
        if let Some(piped) = piped {
            let [mut open, step] = span.open;
            for n in 0..samples {
                for (bus, piped) in out.iter_mut().zip(&piped) {
                    bus[n] += open * piped[n];
                }
                open += step;
            }
        }
        if self.contacts > 0 {
            for contact in contacts.iter_mut().filter(|c| c.key == Some(key)) {
                contact.press(span, out);
            }
        }
    }

    /// Stops what is no longer heard; whether anything is left.
    pub(crate) fn settle(&mut self) -> bool {
        if self.contacts > 0 {
            return true;
        }
        self.oscillators.cull(FLOOR);
        self.oscillators.live > 0
    }

    /// Stops everything.
    pub(crate) fn hush(&mut self) {
        self.oscillators.hush();
        self.contacts = 0;
    }
}
