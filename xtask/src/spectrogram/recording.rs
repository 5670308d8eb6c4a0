//! The sound of a WAV file.

use anyhow::{Context, Result, bail};
use hound::{SampleFormat, WavReader};
use std::path::Path;

/// A sound, its channels averaged.
#[derive(Clone, Debug, PartialEq)]
pub struct Recording {
    /// Sample rate, in Hz.
    pub rate_hz: f64,
    /// Samples, full scale ±1.
    pub samples: Vec<f32>,
}

impl Recording {
    /// Reads a WAV file.
    ///
    /// # Errors
    ///
    /// If it cannot be read, is no WAV file, or holds no sound.
    pub fn read(path: &Path) -> Result<Self> {
        let place = || path.display().to_string();
        let mut reader = WavReader::open(path).with_context(place)?;
        let spec = reader.spec();
        let interleaved: Vec<f32> = match spec.sample_format {
            SampleFormat::Float => reader.samples::<f32>().collect::<Result<_, _>>(),
            SampleFormat::Int => {
                let full_scale = 2f32.powi(i32::from(spec.bits_per_sample) - 1);
                let samples = reader.samples::<i32>();
                samples.map(|s| s.map(|s| s as f32 / full_scale)).collect()
            }
        }
        .with_context(place)?;
        let channels = usize::from(spec.channels);
        let frames = interleaved.chunks_exact(channels);
        let samples: Vec<f32> = frames
            .map(|frame| frame.iter().sum::<f32>() / channels as f32)
            .collect();
        if samples.is_empty() || !samples.iter().all(|sample| sample.is_finite()) {
            bail!("{}: holds no sound", path.display());
        }
        Ok(Self {
            rate_hz: f64::from(spec.sample_rate),
            samples,
        })
    }

    /// How long it lasts, in s.
    #[must_use]
    pub fn seconds(&self) -> f64 {
        self.samples.len() as f64 / self.rate_hz
    }
}
