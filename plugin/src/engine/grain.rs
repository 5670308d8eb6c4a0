//! Roughness of what touches: noise for as long as there is contact.

/// Grains that come by, one a step.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Grain {
    /// Greatest share of the force that a grain is worth, 0…1.
    share: f64,
    state: u64,
}

impl Grain {
    /// Grains of up to `share` of the force, always the same for the same `seed`.
    pub(crate) fn new(share: f64, seed: u64) -> Self {
        Self {
            share,
            state: seed | 1,
        }
    }

    /// Whether there is any roughness.
    pub(crate) fn is_felt(&self) -> bool {
        self.share > 0.0
    }

    /// What the next grain is worth, from 0 to the share (Marsaglia's xorshift, J. Stat. Softw. 8, 2003).
    #[inline(always)]
    pub(crate) fn next_share(&mut self) -> f64 {
        self.state ^= self.state << 13;
        self.state ^= self.state >> 7;
        self.state ^= self.state << 17;
        self.share * ((self.state >> 11) as f64 / (1u64 << 53) as f64)
    }
}

#[cfg(test)]
mod tests {
    use super::Grain;

    #[test]
    fn grains_are_spread_evenly_and_come_again() {
        let draw = || {
            let mut grain = Grain::new(0.5, 7);
            (0..10_000).map(|_| grain.next_share()).collect::<Vec<_>>()
        };
        let grains = draw();
        assert_eq!(grains, draw());
        let mean = grains.iter().sum::<f64>() / 1e4;
        assert!((mean - 0.25).abs() < 0.01 && grains.iter().all(|x| (0.0..0.5).contains(x)));
    }
}
