//! The plug-in as Cargo has just built it, for tests to load as a DAW does.

pub mod chime;
mod exponentials;
mod noise;
mod storm;

pub use exponentials::{Fit, Found, Partial, fit};
pub use noise::Noise;
pub use storm::{BOUND, random};

use anyhow::{Context, Result};
use std::env;
use std::path::PathBuf;
use xtask::host::{Event, Library, Plugin};

/// File of the dynamic library that was built along with the running test.
///
/// # Errors
///
/// If there is none.
pub fn library_file() -> Result<PathBuf> {
    let name = format!(
        "{}idiophone{}",
        env::consts::DLL_PREFIX,
        env::consts::DLL_SUFFIX
    );
    let test = env::current_exe()?;
    // Cargo leaves it with the dependencies, where the tests themselves lie, and above them.
    test.ancestors()
        .skip(1)
        .take(2)
        .map(|folder| folder.join(&name))
        .find(|file| file.exists())
        .with_context(|| format!("{name}: not beside {}", test.display()))
}

/// An instance at rest.
///
/// # Errors
///
/// If the library does not load.
pub fn plugin() -> Result<Plugin> {
    Library::open(&library_file()?)?.instantiate()
}

/// An instance that plays at `rate_hz` in blocks of up to 4096 frames.
///
/// # Errors
///
/// If the library does not load or refuses the rate.
pub fn playing(rate_hz: f64) -> Result<Plugin> {
    let mut plugin = plugin()?;
    plugin.activate(rate_hz, 4096)?;
    Ok(plugin)
}

/// An inactive instance with parameters set as a user writes them, such as `Output=-6 dB`.
///
/// # Errors
///
/// If the library does not load or there is no such setting.
pub fn plugin_with(settings: &[&str]) -> Result<Plugin> {
    let mut plugin = plugin()?;
    for text in settings {
        let setting = xtask::settings::setting(&mut plugin, text)?;
        plugin.set(&[setting])?;
    }
    Ok(plugin)
}

/// A strike of `key` with the note id that is the key's number.
#[must_use]
pub fn strike(key: u8, velocity: f64) -> Event {
    Event::NoteOn {
        channel: 0,
        key,
        note_id: u32::from(key),
        velocity,
    }
}

/// The key coming up again.
#[must_use]
pub fn release(key: u8) -> Event {
    Event::NoteOff {
        channel: 0,
        key,
        note_id: u32::from(key),
        velocity: 0.5,
    }
}

/// Greatest magnitude.
#[must_use]
pub fn peak(samples: &[f32]) -> f32 {
    samples
        .iter()
        .fold(0.0, |peak, sample| peak.max(sample.abs()))
}
