//! Levels by time and frequency, from Fourier transforms of windows about each moment.

use super::Recording;
use crate::whole::whole;
use realfft::RealFftPlanner;
use std::f64::consts::TAU;

/// Longest window, in s: it tells apart the lowest partials.
const LONGEST_S: f64 = 0.35;
/// Windows, each half as long as the one before: the higher, the sharper in time.
const WINDOWS: usize = 4;
/// The longest window serves up to this frequency, in Hz, and each shorter one for two octaves.
const LONGEST_TO_HZ: f64 = 160.0;

/// Levels about one moment, for one length of window.
struct Spectrum {
    bin_hz: f64,
    /// Amplitude of a sine in each bin, in dB of full scale.
    levels_db: Vec<f32>,
}

/// For each of `moments_s`, the levels at `frequencies_hz` (rising), in dB of a full-scale sine.
///
/// Low frequencies are seen through long windows and high ones through short ones, with a gradual
/// passage between.
pub(super) fn levels(
    recording: &Recording,
    moments_s: &[f64],
    frequencies_hz: &[f64],
) -> Vec<Vec<f32>> {
    let mut planner = RealFftPlanner::<f32>::new();
    let transforms: Vec<_> = (0..WINDOWS)
        .map(|window| {
            let seconds = LONGEST_S / 2f64.powi(window as i32);
            Transform::new(&mut planner, recording.rate_hz, seconds)
        })
        .collect();
    moments_s
        .iter()
        .map(|moment| {
            let spectra: Vec<_> = transforms
                .iter()
                .map(|transform| transform.about(recording, *moment))
                .collect();
            column(&spectra, frequencies_hz)
        })
        .collect()
}

/// The levels of one moment.
fn column(spectra: &[Spectrum], frequencies_hz: &[f64]) -> Vec<f32> {
    let last = frequencies_hz.len().saturating_sub(1);
    frequencies_hz
        .iter()
        .enumerate()
        .map(|(row, &hz)| {
            let below = (hz * frequencies_hz[row.saturating_sub(1)]).sqrt();
            let above = (hz * frequencies_hz[(row + 1).min(last)]).sqrt();
            let choice = 0.5 * (hz / LONGEST_TO_HZ).log2();
            let choice = choice.clamp(0.0, (WINDOWS - 1) as f64);
            let longer = whole(choice).min(WINDOWS - 2);
            let share = (choice - longer as f64) as f32;
            let level = |spectrum: &Spectrum| spectrum.between(below, above);
            (1.0 - share) * level(&spectra[longer]) + share * level(&spectra[longer + 1])
        })
        .collect()
}

impl Spectrum {
    /// The greatest level from one frequency to another.
    fn between(&self, low_hz: f64, high_hz: f64) -> f32 {
        let (low, high) = (low_hz / self.bin_hz, high_hz / self.bin_hz);
        let ends = self.at(low).max(self.at(high));
        let inside = whole(low.ceil())..(whole(high) + 1).min(self.levels_db.len());
        let inside = self.levels_db.get(inside).unwrap_or_default();
        inside.iter().copied().fold(ends, f32::max)
    }

    /// The level at a fractional bin, between its neighbours.
    fn at(&self, bin: f64) -> f32 {
        let below = whole(bin);
        let level = |bin: usize| self.levels_db.get(bin).copied().unwrap_or(FLOOR_DB);
        let share = (bin - below as f64) as f32;
        (1.0 - share) * level(below) + share * level(below + 1)
    }
}

/// Level of what is not there.
const FLOOR_DB: f32 = -200.0;

/// A windowed Fourier transform of one length.
struct Transform {
    window: Vec<f32>,
    /// Padded with zeros to this length, for bins finer than the window tells apart.
    padded: usize,
    plan: std::sync::Arc<dyn realfft::RealToComplex<f32>>,
    bin_hz: f64,
}

impl Transform {
    fn new(planner: &mut RealFftPlanner<f32>, rate_hz: f64, seconds: f64) -> Self {
        let length = whole(rate_hz * seconds).max(16);
        let padded = (2 * length).next_power_of_two();
        let hann = |i: usize| 0.5 - 0.5 * (TAU * (i as f64 + 0.5) / length as f64).cos();
        // The window's mean is ½ and a sine's energy is shared with its negative frequency.
        let unit = 4.0 / length as f64;
        Self {
            window: (0..length).map(|i| (unit * hann(i)) as f32).collect(),
            padded,
            plan: planner.plan_fft_forward(padded),
            bin_hz: rate_hz / padded as f64,
        }
    }

    fn about(&self, recording: &Recording, moment_s: f64) -> Spectrum {
        let start = (moment_s * recording.rate_hz) as i64 - self.window.len() as i64 / 2;
        let mut input = vec![0.0; self.padded];
        for (i, (sample, weight)) in input.iter_mut().zip(&self.window).enumerate() {
            let at = usize::try_from(start + i as i64);
            let heard = at.ok().and_then(|at| recording.samples.get(at));
            *sample = heard.copied().unwrap_or(0.0) * weight;
        }
        let mut output = self.plan.make_output_vec();
        let mut levels_db = vec![FLOOR_DB; output.len()];
        if self.plan.process(&mut input, &mut output).is_ok() {
            for (level, bin) in levels_db.iter_mut().zip(&output) {
                *level = (10.0 * bin.norm_sqr().log10()).max(FLOOR_DB);
            }
        }
        Spectrum {
            bin_hz: self.bin_hz,
            levels_db,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn sine(hz: f64, amplitude: f64) -> Recording {
        let samples = (0..48_000)
            .map(|i| (amplitude * (TAU * hz * f64::from(i) / 48e3).sin()) as f32)
            .collect();
        Recording {
            rate_hz: 48e3,
            samples,
        }
    }

    #[test]
    fn a_sine_shows_its_level_at_its_frequency() {
        let frequencies: Vec<f64> = (0..600)
            .map(|i| 50.0 * 400f64.powf(f64::from(i) / 600.0))
            .collect();
        for hz in [60.0, 440.0, 3000.0, 15_000.0] {
            let levels = levels(&sine(hz, 0.5), &[0.5], &frequencies);
            let peak = (0..600)
                .max_by(|&a, &b| levels[0][a].total_cmp(&levels[0][b]))
                .unwrap();
            assert!((frequencies[peak] / hz).ln().abs() < 0.02, "{hz} Hz");
            let db = levels[0][peak];
            assert!((db + 6.02).abs() < 0.2, "{hz} Hz at {db} dB");
        }
    }

    #[test]
    fn silence_is_the_floor() {
        let levels = levels(&sine(440.0, 0.0), &[0.5], &[100.0, 1000.0]);
        assert_eq!(levels, [[FLOOR_DB; 2]]);
    }
}
