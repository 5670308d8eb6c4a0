//! The last samples of the output, for the editor to look at.

use std::sync::atomic::{AtomicU32, AtomicU64, Ordering};

/// Samples that are kept: more than a second, a third of one at 192 kHz.
const KEPT: usize = 1 << 16;

/// A ring that one thread writes and another reads without either waiting. What is overwritten while it is
/// read comes out newer than it should be, which a picture does not show.
pub(super) struct Samples {
    ring: Box<[AtomicU32]>,
    written: AtomicU64,
}

impl Default for Samples {
    fn default() -> Self {
        Self {
            ring: (0..KEPT).map(|_| AtomicU32::new(0)).collect(),
            written: AtomicU64::new(0),
        }
    }
}

impl Samples {
    /// Adds the mean of both channels. For the audio thread.
    pub(super) fn write(&self, left: &[f32], right: &[f32]) {
        let mut written = self.written.load(Ordering::Relaxed);
        for (left, right) in left.iter().zip(right) {
            let mean = 0.5 * (left + right);
            self.ring[(written % KEPT as u64) as usize].store(mean.to_bits(), Ordering::Relaxed);
            written += 1;
        }
        self.written.store(written, Ordering::Release);
    }

    /// Appends what has come since `read` samples had been read; how many before that are lost.
    pub(super) fn read(&self, read: &mut u64, out: &mut Vec<f32>) -> u64 {
        let written = self.written.load(Ordering::Acquire);
        // Half the ring is left to the writer.
        let from = written.saturating_sub(KEPT as u64 / 2).max(*read);
        let lost = from - *read;
        out.extend((from..written).map(|at| {
            f32::from_bits(self.ring[(at % KEPT as u64) as usize].load(Ordering::Relaxed))
        }));
        *read = written.max(*read);
        lost
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn samples_come_in_order_and_what_is_too_old_is_counted() {
        let samples = Samples::default();
        let (mut read, mut out) = (0, Vec::new());
        let ramp: Vec<f32> = (0..1000u16).map(f32::from).collect();
        samples.write(&ramp, &ramp);
        assert_eq!(samples.read(&mut read, &mut out), 0);
        assert_eq!(out, ramp);
        out.clear();
        assert_eq!(samples.read(&mut read, &mut out), 0);
        assert!(out.is_empty());
        for _ in 0..100 {
            samples.write(&ramp, &ramp);
        }
        let lost = samples.read(&mut read, &mut out);
        assert_eq!(lost as usize + out.len(), 100_000);
        assert_eq!(out.len(), KEPT / 2);
        assert_eq!(out.last(), ramp.last());
    }
}
