//! Damped complex oscillators: one multiplication per mode and sample (O'Brien 2002, §3.4).

mod scalar;
mod vector;

use super::GRID;
use super::bessel::ORDERS;
use super::contact::Contact;
use pulp::{Arch, WithSimd};

/// Modes are padded to a multiple of this, the widest vector of doubles.
pub(crate) const LANES: usize = 8;

/// States z = x + iy of a body's modes and their steps from sample to sample, mode by mode.
///
/// y is the mode's displacement, in what full scale takes. All in f64: with w in f32 a T60 of a minute is
/// 1 % to 5 % off.
#[derive(Clone, Debug)]
pub(crate) struct Oscillators {
    pub(crate) x: Vec<f64>,
    pub(crate) y: Vec<f64>,
    /// Real part of w = exp((−d + iΩ)T).
    pub(crate) step_re: Vec<f64>,
    /// Imaginary part of w.
    pub(crate) step_im: Vec<f64>,
    /// Real part of exp((−d + iΩ)T/2), from the middle of a sample to its end.
    pub(crate) half_re: Vec<f64>,
    /// Imaginary part of it.
    pub(crate) half_im: Vec<f64>,
    /// What reaches the buses of one unit of y and of x.
    pub(crate) hear: Hear,
    /// Leading modes that may be ringing, a multiple of [`LANES`]; those beyond are zero.
    pub(crate) live: usize,
}

/// Left from y, left from x, right from y, right from x, and without a place from y.
pub(crate) type Hear = [Vec<f64>; 5];

/// Left ear, right ear, and the same power in both without phases, sample by sample.
pub(crate) type Buses = [[f64; GRID]; 3];

/// How each mode takes up the Legendre moments of a force over one sample: j₀, −3j₁, −5j₂, 7j₃ of
/// ΩT/2. Even orders push x and odd ones y, in the middle of the sample.
pub(crate) type Uptake = [Vec<f64>; ORDERS];

/// Contacts that push on one body.
#[derive(Clone, Copy)]
pub(crate) struct Push<'a> {
    pub(crate) contacts: &'a [Contact],
    pub(crate) key: u8,
    pub(crate) uptake: &'a Uptake,
}

impl<'a> Push<'a> {
    /// The body's contacts, always in the same order.
    #[inline(always)]
    fn each(&self) -> impl Iterator<Item = &'a Contact> + use<'a> {
        let key = self.key;
        self.contacts
            .iter()
            .filter(move |contact| contact.key == Some(key))
    }
}

/// The instructions this machine has, found once.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Kernel(Arch);

impl Kernel {
    /// Detects the widest vectors there are.
    pub(crate) fn detect() -> Self {
        Self(Arch::new())
    }

    /// Without fused multiply-add in hardware the vector code would call a library for each.
    fn is_scalar(self) -> bool {
        matches!(self.0, Arch::Scalar)
    }

    /// Runs a plain loop compiled for this machine's vectors; same bits as without.
    pub(crate) fn run(self, task: impl WithSimd<Output = ()>) {
        self.0.dispatch(task);
    }

    /// Writes what is heard of the next `samples` (at most [`GRID`]) to `out` and moves on, under the
    /// force of contacts, whose moments for these samples are ready, if there are any.
    pub(crate) fn ring(
        self,
        oscillators: &mut Oscillators,
        push: Option<Push<'_>>,
        samples: usize,
        out: &mut Buses,
    ) {
        debug_assert!(samples <= GRID);
        match (push, self.is_scalar()) {
            (None, true) => scalar::ring(oscillators, samples, out),
            (None, false) => self.0.dispatch(vector::Ring {
                oscillators,
                samples,
                out,
            }),
            (Some(push), true) => scalar::ring_pushed(oscillators, push, samples, out),
            (Some(push), false) => self.0.dispatch(vector::RingPushed {
                oscillators,
                push,
                samples,
                out,
            }),
        }
    }
}

impl Oscillators {
    /// At rest, for `modes` modes.
    pub(crate) fn new(modes: usize) -> Self {
        let zeros = vec![0.0; modes.next_multiple_of(LANES)];
        Self {
            x: zeros.clone(),
            y: zeros.clone(),
            step_re: zeros.clone(),
            step_im: zeros.clone(),
            half_re: zeros.clone(),
            half_im: zeros.clone(),
            hear: std::array::from_fn(|_| zeros.clone()),
            live: 0,
        }
    }

    /// Number of modes with the padding.
    pub(crate) fn len(&self) -> usize {
        self.x.len()
    }

    /// Stops every mode.
    pub(crate) fn hush(&mut self) {
        self.x.fill(0.0);
        self.y.fill(0.0);
        self.live = 0;
    }

    /// Stops the modes weaker than `floor` and forgets the ones beyond the last that rings.
    pub(crate) fn cull(&mut self, floor: f64) {
        let mut last = 0;
        for (i, (x, y)) in self.x[..self.live]
            .iter_mut()
            .zip(&mut self.y[..self.live])
            .enumerate()
        {
            if *x * *x + *y * *y < floor * floor {
                *x = 0.0;
                *y = 0.0;
            } else {
                last = i + 1;
            }
        }
        self.live = last.next_multiple_of(LANES);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::engine::pulse::Pulse;
    use std::f64::consts::{PI, TAU};

    const RATE_HZ: f64 = 48_000.0;

    /// `modes` ringing modes between 40 Hz and 20 kHz that die in 0.1 s to 10 s.
    fn bank(modes: usize) -> (Oscillators, Vec<(f64, f64)>) {
        let mut bank = Oscillators::new(modes);
        let mut motion = Vec::new();
        for i in 0..modes {
            let share = (i as f64 + 0.5) / modes as f64;
            let omega = TAU * 40.0 * 500f64.powf(share);
            let decay = 0.7 * 100f64.powf(share);
            let radius = (-0.5 * decay / RATE_HZ).exp();
            let (sin, cos) = (0.5 * omega / RATE_HZ).sin_cos();
            (bank.half_re[i], bank.half_im[i]) = (radius * cos, radius * sin);
            bank.step_re[i] = radius * radius * (cos * cos - sin * sin);
            bank.step_im[i] = radius * radius * 2.0 * sin * cos;
            bank.x[i] = (1.0 + i as f64).recip();
            for (k, hear) in bank.hear.iter_mut().enumerate() {
                hear[i] = (0.3 + (i * (k + 1)) as f64).cos();
            }
            motion.push((omega, decay));
        }
        bank.live = bank.len();
        (bank, motion)
    }

    const SILENT: Buses = [[0.0; GRID]; 3];

    fn worst(a: &Buses, b: &Buses) -> f64 {
        a.iter()
            .flatten()
            .zip(b.iter().flatten())
            .map(|(a, b)| (a - b).abs())
            .fold(0.0, f64::max)
    }

    #[test]
    fn vectors_scalars_and_the_closed_form_agree() {
        for modes in [1, 8, 9, 24, 63] {
            let (mut fast, motion) = bank(modes);
            let mut plain = fast.clone();
            let kernel = Kernel::detect();
            for grid in 0..1500 {
                let (mut a, mut b, mut closed) = (SILENT, SILENT, SILENT);
                kernel.ring(&mut fast, None, GRID, &mut a);
                scalar::ring(&mut plain, GRID, &mut b);
                let [left, right, plain_bus] = &mut closed;
                let buses = left.iter_mut().zip(right).zip(plain_bus);
                for (n, ((left, right), middle)) in buses.enumerate() {
                    let t = (grid * GRID + n) as f64 / RATE_HZ;
                    for (i, (omega, decay)) in motion.iter().enumerate() {
                        let size = (-decay * t).exp() / (1.0 + i as f64);
                        let (y, x) = (size * (omega * t).sin(), size * (omega * t).cos());
                        let hear = |k: usize| plain.hear[k][i];
                        *left += hear(0) * y + hear(1) * x;
                        *right += hear(2) * y + hear(3) * x;
                        *middle += hear(4) * y;
                    }
                }
                assert!(worst(&a, &b) < 2e-12);
                assert!(worst(&a, &closed) < 1e-10, "{}", worst(&a, &closed));
            }
        }
    }

    fn contact(modes: usize, key: u8) -> Contact {
        let mut contact = Contact::new(modes);
        contact.key = Some(key);
        contact.pulse = Pulse {
            impulse_n_s: 0.3,
            duration_s: 4e-4,
        };
        for (i, gain) in contact.gain.iter_mut().enumerate() {
            *gain = (i as f64 * 0.7).cos();
        }
        contact
    }

    #[test]
    fn pushed_vectors_and_scalars_agree() {
        let (mut fast, motion) = bank(24);
        let mut plain = fast.clone();
        let uptake = crate::engine::rates::uptake(
            &motion.iter().map(|m| m.0).collect::<Vec<_>>(),
            1.0 / RATE_HZ,
        );
        let mut contacts = vec![contact(24, 7), contact(24, 9), contact(24, 7)];
        let kernel = Kernel::detect();
        for _ in 0..3 {
            for contact in &mut contacts {
                contact.prepare(GRID, 1.0 / RATE_HZ);
            }
            let push = Push {
                contacts: &contacts,
                key: 7,
                uptake: &uptake,
            };
            let (mut a, mut b) = (SILENT, SILENT);
            kernel.ring(&mut fast, Some(push), GRID, &mut a);
            scalar::ring_pushed(&mut plain, push, GRID, &mut b);
            assert!(worst(&a, &b) < 1e-12);
        }
    }

    #[test]
    fn a_run_may_be_cut_anywhere() {
        let (mut whole, _) = bank(40);
        let mut cut = whole.clone();
        let kernel = Kernel::detect();
        let (mut a, mut b) = (SILENT, SILENT);
        kernel.ring(&mut whole, None, GRID, &mut a);
        let mut done = 0;
        for samples in [5, 1, GRID - 6] {
            let mut part = SILENT;
            kernel.ring(&mut cut, None, samples, &mut part);
            for (b, part) in b.iter_mut().zip(&part) {
                b[done..done + samples].copy_from_slice(&part[..samples]);
            }
            done += samples;
        }
        assert_eq!(a, b);
    }

    /// The drive against ∫F(s) e^{a(T−s)} ds by a quadrature of 20 000 points.
    #[test]
    fn force_within_a_sample_is_integrated() {
        let step_s = 1.0 / RATE_HZ;
        for (samples, fraction, bound) in [
            (4.0, 0.9, 3e-5),
            (4.0, 0.3, 1e-5),
            (14.0, 0.9, 1e-6),
            (1.0, 0.3, 2e-4),
        ] {
            let pulse = Pulse {
                impulse_n_s: 1.0,
                duration_s: samples * step_s,
            };
            let omega = fraction * PI / step_s;
            let decay = 100.0;
            let uptake = crate::engine::rates::uptake(&[omega], step_s);
            let mut bank = Oscillators::new(1);
            let radius = (-0.5 * decay * step_s).exp();
            let (sin, cos) = (0.5 * omega * step_s).sin_cos();
            (bank.half_re[0], bank.half_im[0]) = (radius * cos, radius * sin);
            bank.step_re[0] = radius * radius * (cos * cos - sin * sin);
            bank.step_im[0] = radius * radius * 2.0 * sin * cos;
            bank.live = LANES;
            let mut contacts = [contact(1, 0)];
            contacts[0].pulse = pulse;
            contacts[0].gain[0] = 1.0;
            contacts[0].prepare(GRID, step_s);
            let push = Push {
                contacts: &contacts,
                key: 0,
                uptake: &uptake,
            };
            Kernel::detect().ring(&mut bank, Some(push), GRID, &mut [[0.0; GRID]; 3]);
            let end = GRID as f64 * step_s;
            let points = 20_000;
            let (mut re, mut im) = (0.0, 0.0);
            for i in 0..points {
                let s = (f64::from(i) + 0.5) / f64::from(points) * pulse.duration_s;
                let share = pulse.force_n(s) * pulse.duration_s / f64::from(points);
                let fall = (-decay * (end - s)).exp();
                re += share * fall * (omega * (end - s)).cos();
                im += share * fall * (omega * (end - s)).sin();
            }
            let error = (bank.x[0] - re).hypot(bank.y[0] - im);
            println!("τ = {samples} samples, {fraction} of Nyquist: {error:.1e}");
            assert!(error < bound, "τ = {samples} samples, {fraction}: {error}");
        }
    }

    #[test]
    fn weak_modes_are_stopped_and_strong_ones_kept() {
        let (mut bank, _) = bank(30);
        bank.x[10..].fill(1e-10);
        bank.cull(1e-9);
        assert_eq!(bank.live, 16);
        assert!(bank.x[9] > 0.0 && bank.x[10] == 0.0);
        bank.cull(2.0);
        assert_eq!(bank.live, 0);
    }
}
