//! From damping to the oscillators' steps: Eq. 9 of O'Brien 2002 while the body rings.

use super::bessel::{ORDERS, spherical_bessel};
use super::losses::Drain;
use super::oscillators::{LANES, Oscillators, Uptake};
use std::f64::consts::PI;

/// Modes from this share of half the sample rate on are silent, not aliased.
const HIGHEST: f64 = 0.99;

/// exp of a 64th of an exponent, then six squarings (five to the half step).
const SQUARINGS: u32 = 5;

/// Terms of the series for that exponential: its argument is at most 0.1, so 10⁻¹⁷ is left out.
const TERMS: [f64; 9] = [
    1.0 / 9.0,
    1.0 / 8.0,
    1.0 / 7.0,
    1.0 / 6.0,
    1.0 / 5.0,
    1.0 / 4.0,
    1.0 / 3.0,
    1.0 / 2.0,
    1.0,
];

/// What does not change about a body's modes at one sample rate.
#[derive(Clone, Debug)]
pub(crate) struct Rates {
    /// Undamped angular frequency ω, in rad/s.
    omega: Vec<f64>,
    /// exp(iωT/2), or 0 for a mode that is never heard.
    half_re: Vec<f64>,
    half_im: Vec<f64>,
    /// Decay rates in 1/s that radiation, supports, resonator and felt give when they count once.
    air: [Vec<f64>; 4],
    step_s: f64,
}

/// Modal uptake of force moments for modes at `omega` in rad/s, sampled every `step_s`.
pub(crate) fn uptake(omega: &[f64], step_s: f64) -> Uptake {
    let factors = [1.0, -3.0, -5.0, 7.0];
    let padded = omega.len().next_multiple_of(LANES);
    let mut uptake: Uptake = std::array::from_fn(|_| vec![0.0; padded]);
    for (i, omega) in omega.iter().enumerate() {
        let orders = spherical_bessel((0.5 * omega * step_s).min(0.5 * PI));
        for k in 0..ORDERS {
            uptake[k][i] = factors[k] * orders[k];
        }
    }
    uptake
}

impl Rates {
    /// For modes at undamped frequencies `hz`, sampled every `step_s`, to which radiation, supports,
    /// resonator and felt give the decay rates `air` in 1/s.
    pub(crate) fn new(hz: &[f64], air: impl Fn(usize) -> [f64; 4], step_s: f64) -> Self {
        let padded = hz.len().next_multiple_of(LANES);
        // Padding has a frequency too, lest the loop below divide by zero.
        let mut rates = Self {
            omega: vec![1.0; padded],
            half_re: vec![0.0; padded],
            half_im: vec![0.0; padded],
            air: std::array::from_fn(|_| vec![0.0; padded]),
            step_s,
        };
        for (i, hz) in hz.iter().enumerate() {
            let omega = std::f64::consts::TAU * hz;
            rates.omega[i] = omega;
            for (rates, rate) in rates.air.iter_mut().zip(air(i)) {
                rates[i] = rate;
            }
            if omega * step_s < HIGHEST * PI {
                (rates.half_im[i], rates.half_re[i]) = (0.5 * omega * step_s).sin_cos();
            }
        }
        rates
    }

    /// Sets the oscillators' steps, and 1/Ω in s, for what drains the modes.
    ///
    /// A mode so damped that Ω < ω/10 is silenced. No call to a library: exp((−d − i(ω−Ω))T/2)
    /// is a short series squared five times, turned by exp(iωT/2).
    #[inline(always)]
    pub(crate) fn apply(
        &self,
        drain: &Drain,
        oscillators: &mut Oscillators,
        inverse_omega_s: &mut [f64],
    ) {
        let scale = self.step_s / f64::from(1 << (SQUARINGS + 1));
        let n = self.omega.len();
        let (omega, turn_re, turn_im) = (&self.omega[..n], &self.half_re[..n], &self.half_im[..n]);
        let (half_re, half_im) = (&mut oscillators.half_re[..n], &mut oscillators.half_im[..n]);
        let (step_re, step_im) = (&mut oscillators.step_re[..n], &mut oscillators.step_im[..n]);
        let inverse = &mut inverse_omega_s[..n];
        let [radiation, supports, resonator, felt] = [0, 1, 2, 3].map(|k| &self.air[k][..n]);
        for i in 0..n {
            let lambda = omega[i] * omega[i];
            let stiffness = drain.alpha1_s * lambda + drain.loss_factor * omega[i];
            let material = 0.5 * (stiffness + drain.alpha2_per_s);
            let outside = drain.radiation * radiation[i]
                + drain.supports * supports[i]
                + drain.resonator * resonator[i]
                + drain.felt * felt[i];
            let decay = material + outside + drain.hand_per_s;
            let square = (omega[i] - decay) * (omega[i] + decay);
            let heard = square > 0.01 * lambda;
            let decay = decay.min(omega[i]);
            let damped = square.max(0.01 * lambda).sqrt();
            let (re, im) = (-decay * scale, -decay * decay / (omega[i] + damped) * scale);
            let (mut a, mut b) = (1.0, 0.0);
            for term in TERMS {
                (a, b) = (1.0 + (re * a - im * b) * term, (re * b + im * a) * term);
            }
            for _ in 0..SQUARINGS {
                (a, b) = (a * a - b * b, 2.0 * a * b);
            }
            let (mut hr, mut hi) = (
                turn_re[i] * a - turn_im[i] * b,
                turn_re[i] * b + turn_im[i] * a,
            );
            if !heard {
                (hr, hi) = (0.0, 0.0);
            }
            (half_re[i], half_im[i]) = (hr, hi);
            (step_re[i], step_im[i]) = (hr * hr - hi * hi, 2.0 * hr * hi);
            inverse[i] = 1.0 / damped;
        }
    }
}

/// [`Rates::apply`] as a task for a kernel.
pub(crate) struct Retune<'a> {
    pub(crate) rates: &'a Rates,
    pub(crate) drain: &'a Drain,
    pub(crate) oscillators: &'a mut Oscillators,
    pub(crate) inverse_omega_s: &'a mut [f64],
}

impl pulp::WithSimd for Retune<'_> {
    type Output = ();

    #[inline(always)]
    fn with_simd<S: pulp::Simd>(self, _: S) {
        self.rates
            .apply(self.drain, self.oscillators, self.inverse_omega_s);
    }
}

#[cfg(test)]
mod tests {
    use super::Rates;
    use crate::engine::losses::Drain;
    use crate::engine::oscillators::Oscillators;
    use modes::Motion;
    use std::f64::consts::TAU;

    #[test]
    fn steps_agree_with_the_library_for_any_damping() {
        let hz: Vec<f64> = (0..64).map(|i| 20.0 * 1.115f64.powi(i)).collect();
        let mut heard = 0;
        for rate_hz in [44_100.0, 48_000.0, 192_000.0] {
            let air = |i: usize| [0.01 * i as f64, 0.3, 0.8, 20.0];
            let rates = Rates::new(&hz, air, 1.0 / rate_hz);
            let mut bank = Oscillators::new(hz.len());
            let mut inverse = vec![0.0; bank.len()];
            for alpha1_s in [0.0, 1e-7, 1e-6, 8e-6, 2e-5] {
                for alpha2_per_s in [0.0, 0.5, 50.0, 100.0] {
                    let drain = Drain {
                        alpha1_s,
                        alpha2_per_s,
                        loss_factor: 1e-3,
                        radiation: 2.0,
                        supports: 0.5,
                        resonator: 0.25,
                        felt: 0.25,
                        hand_per_s: 1.5,
                    };
                    rates.apply(&drain, &mut bank, &mut inverse);
                    for (i, &hz) in hz.iter().enumerate() {
                        let step = (bank.step_re[i], bank.step_im[i]);
                        let omega = TAU * hz;
                        let decay = 0.5 * (alpha1_s * omega * omega + alpha2_per_s)
                            + 0.5e-3 * omega
                            + 0.02 * i as f64
                            + 0.15
                            + 0.2
                            + 5.0
                            + 1.5;
                        match Motion::of(hz, decay) {
                            Motion::Ringing {
                                hz: damped,
                                decay_per_s,
                            } if damped > 0.101 * hz && hz < 0.49 * rate_hz => {
                                let radius = (-decay_per_s / rate_hz).exp();
                                let (sin, cos) = (TAU * damped / rate_hz).sin_cos();
                                assert!((step.0 - radius * cos).abs() < 1e-13);
                                assert!((step.1 - radius * sin).abs() < 1e-13);
                                assert!((inverse[i] * TAU * damped - 1.0).abs() < 1e-12);
                                heard += 1;
                            }
                            Motion::Ringing { .. } => {}
                            Motion::Overdamped => assert_eq!(step, (0.0, 0.0)),
                        }
                    }
                }
            }
        }
        assert!(heard > 3000);
    }

    #[test]
    fn modes_above_half_the_rate_are_silent() {
        let rates = Rates::new(&[400.0, 499.0, 700.0], |_| [0.0; 4], 1e-3);
        let mut bank = Oscillators::new(3);
        let mut inverse = vec![0.0; bank.len()];
        rates.apply(&Drain::default(), &mut bank, &mut inverse);
        assert!(bank.step_re[0] != 0.0);
        assert_eq!(bank.step_re[1..], [0.0; 7]);
        assert_eq!(bank.step_im[1..], [0.0; 7]);
    }
}
