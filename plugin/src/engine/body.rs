//! One object: its modes, and how they wake, change and fall asleep.

use super::oscillators::{Kernel, Oscillators, Push, Uptake};
use super::rates::{Rates, Retune, uptake};
use super::{GRID, contact::Contact};
use modes::{Rayleigh, Stencil};

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
    /// Left and right gain at the last grid point and at the next.
    pub(crate) ears: [[f64; 2]; 2],
    oscillators: Oscillators,
    rates: Rates,
    uptake: Uptake,
    /// φ·n̂ in kg^(−1/2), point by point and mode by mode.
    normal: Vec<f32>,
    points: usize,
    /// Output per modal displacement, from the mode's coupling.
    weight: Vec<f64>,
    inverse_omega_s: Vec<f64>,
    /// Damping and extra decay rate that the oscillators have now.
    tuned: Option<(Rayleigh, f64)>,
}

/// A mode as the engine needs it.
struct Reached {
    hz: f64,
    coupling: f64,
    normal: Vec<f32>,
}

/// The modes that a strike somewhere on the line makes heard, by rising frequency.
fn reached(body: &modes::Body) -> Vec<Reached> {
    let points = body.line.len();
    let sound = |mode: &&modes::Mode| {
        mode.hz.is_finite()
            && mode.hz > 0.0
            && mode.coupling.is_finite()
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
            let reach = f64::from(most) * mode.coupling.abs() / mode.hz;
            let mode = Reached {
                hz: mode.hz,
                coupling: mode.coupling,
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

impl Body {
    /// From a bank's body; `scale` takes volume velocity in m³/s to full scale.
    pub(crate) fn new(body: &modes::Body, step_s: f64, scale: f64) -> Self {
        let modes = reached(body);
        let hz: Vec<f64> = modes.iter().map(|mode| mode.hz).collect();
        let omega: Vec<f64> = hz.iter().map(|hz| std::f64::consts::TAU * hz).collect();
        let oscillators = Oscillators::new(modes.len());
        let padded = oscillators.len();
        let points = body.line.len();
        let mut normal = vec![0.0; points * padded];
        let mut weight = vec![0.0; padded];
        for (i, mode) in modes.iter().enumerate() {
            weight[i] = mode.coupling * scale;
            for (point, value) in mode.normal.iter().enumerate() {
                normal[point * padded + i] = *value;
            }
        }
        Self {
            mass_kg: body.mass_kg,
            contacts: 0,
            ears: [[0.0; 2]; 2],
            rates: Rates::new(&hz, step_s),
            uptake: uptake(&omega, step_s),
            normal,
            points,
            weight,
            inverse_omega_s: vec![0.0; padded],
            tuned: None,
            oscillators,
        }
    }

    /// Number of modes, with padding.
    pub(crate) fn modes(&self) -> usize {
        self.oscillators.len()
    }

    /// Gives the modes this damping, if they have another.
    pub(crate) fn tune(&mut self, kernel: Kernel, damping: Rayleigh, extra_per_s: f64) {
        let wanted = Some((damping, extra_per_s));
        if self.tuned != wanted {
            kernel.run(Retune {
                rates: &self.rates,
                damping,
                extra_per_s,
                oscillators: &mut self.oscillators,
                inverse_omega_s: &mut self.inverse_omega_s,
            });
            self.tuned = wanted;
        }
    }

    /// What a unit impulse at `position` on the line adds to each mode's x (O'Brien 2002, Eq. 18
    /// without its 2), weighted by what the mode sends out.
    pub(crate) fn gains(&self, position: f64, gains: &mut [f64]) {
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

    /// A mallet touches down: every mode may ring from now on.
    pub(crate) fn touched(&mut self) {
        self.contacts += 1;
        self.oscillators.live = self.oscillators.len();
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
    pub(crate) fn ring(&mut self, kernel: Kernel, contacts: &[Contact], key: u8, out: &mut [f64]) {
        debug_assert!(out.len() <= GRID);
        if self.contacts == 0 {
            kernel.ring(&mut self.oscillators, out);
        } else {
            let push = Push {
                contacts,
                key,
                uptake: &self.uptake,
            };
            kernel.ring_pushed(&mut self.oscillators, push, out);
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
