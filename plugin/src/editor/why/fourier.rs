//! The spectrum of a stretch of sound.

use std::f32::consts::TAU;

/// Samples of a stretch.
pub(super) const STRETCH: usize = 2048;

/// Tables for stretches of [`STRETCH`] samples.
pub(super) struct Fourier {
    window: Vec<f32>,
    turns: Vec<(f32, f32)>,
    re: Vec<f32>,
    im: Vec<f32>,
}

impl Default for Fourier {
    fn default() -> Self {
        let turn = |i: usize| TAU * i as f32 / STRETCH as f32;
        Self {
            // Hann's; a sine of amplitude 1 comes out as 1.
            window: (0..STRETCH)
                .map(|i| 2.0 / STRETCH as f32 * (1.0 - turn(i).cos()))
                .collect(),
            turns: (0..STRETCH / 2)
                .map(|i| (turn(i).cos(), -turn(i).sin()))
                .collect(),
            re: vec![0.0; STRETCH],
            im: vec![0.0; STRETCH],
        }
    }
}

impl Fourier {
    /// Amplitudes of the first half of the bins of `sound`, which has [`STRETCH`] samples, by Cooley and
    /// Tukey's radix 2 (Math. Comput. 19, 1965).
    pub(super) fn amplitudes(&mut self, sound: &[f32]) -> impl Iterator<Item = f32> {
        let bits = STRETCH.trailing_zeros();
        for (i, (sample, window)) in sound.iter().zip(&self.window).enumerate() {
            let to = i.reverse_bits() >> (usize::BITS - bits);
            (self.re[to], self.im[to]) = (sample * window, 0.0);
        }
        let mut half = 1;
        while half < STRETCH {
            let stride = STRETCH / (2 * half);
            for start in (0..STRETCH).step_by(2 * half) {
                for k in 0..half {
                    self.butterfly(start + k, half, self.turns[k * stride]);
                }
            }
            half *= 2;
        }
        let bins = self.re.iter().zip(&self.im).take(STRETCH / 2);
        bins.map(|(re, im)| re.hypot(*im))
    }

    fn butterfly(&mut self, a: usize, half: usize, (cos, sin): (f32, f32)) {
        let b = a + half;
        let re = self.re[b] * cos - self.im[b] * sin;
        let im = self.re[b] * sin + self.im[b] * cos;
        (self.re[b], self.im[b]) = (self.re[a] - re, self.im[a] - im);
        self.re[a] += re;
        self.im[a] += im;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_sine_stands_in_its_bin_with_its_amplitude() {
        let bin = 100;
        let sine = |i: usize| 0.3 * (TAU * (bin * i) as f32 / STRETCH as f32).sin();
        let sound: Vec<f32> = (0..STRETCH).map(sine).collect();
        let mut fourier = Fourier::default();
        let found: Vec<f32> = fourier.amplitudes(&sound).collect();
        assert!((found[bin] - 0.3).abs() < 1e-3, "{}", found[bin]);
        for (i, amplitude) in found.iter().enumerate() {
            assert!(i.abs_diff(bin) < 2 || *amplitude < 1e-3, "{i}: {amplitude}");
        }
    }
}
