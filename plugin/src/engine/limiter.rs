//! The last safety before the host: what would go over full scale is turned down.

/// Time in which the gain comes back by 1 − 1/e, in s.
const RELEASE_S: f64 = 0.1;

/// A limiter that does nothing, to the bit, while nothing goes over full scale.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Limiter {
    gain: f64,
    release: f64,
}

impl Limiter {
    pub(crate) fn new(step_s: f64) -> Self {
        Self {
            gain: 1.0,
            release: 1.0 - (-step_s / RELEASE_S).exp(),
        }
    }

    /// At rest.
    pub(crate) fn reset(&mut self) {
        self.gain = 1.0;
    }

    /// A sample of both ears, held to −1…1: turned down at once, together, and let go slowly.
    #[inline(always)]
    pub(crate) fn limit(&mut self, sample: [f64; 2]) -> [f64; 2] {
        let peak = sample[0].abs().max(sample[1].abs());
        if self.gain == 1.0 && peak <= 1.0 {
            return sample;
        }
        self.gain += (1.0 - self.gain) * self.release;
        if self.gain > 1.0 - 1e-6 {
            self.gain = 1.0;
        }
        if peak * self.gain > 1.0 {
            self.gain = 1.0 / peak;
        }
        sample.map(|ear| ear * self.gain)
    }
}

#[cfg(test)]
mod tests {
    use super::Limiter;

    fn sine(n: usize, size: f64) -> [f64; 2] {
        let x = size * (n as f64 * 0.05).sin();
        [x, -0.5 * x]
    }

    #[test]
    fn what_stays_below_full_scale_passes_to_the_bit() {
        let mut limiter = Limiter::new(1.0 / 48_000.0);
        for n in 0..10_000 {
            assert_eq!(limiter.limit(sine(n, 1.0)), sine(n, 1.0));
        }
    }

    #[test]
    fn peaks_are_held_and_the_gain_comes_back_to_the_bit() {
        let mut limiter = Limiter::new(1.0 / 48_000.0);
        for n in 0..10_000 {
            let [left, right] = limiter.limit(sine(n, 7.0));
            assert!(left.abs() <= 1.0 + 1e-15 && right.abs() <= 0.5 + 1e-15);
            assert!((right + 0.5 * left).abs() < 1e-15, "the places stay");
        }
        for n in 0..96_000 {
            limiter.limit(sine(n, 0.1));
        }
        assert_eq!(limiter.limit([0.3, 0.2]), [0.3, 0.2]);
    }
}
