//! The pitch of each key.

use super::{KeyboardMap, Scale};
use crate::equal_temperament_hz;

/// Pitch of key 69 in the equal temperament that offsets count from, in Hz.
const A4_HZ: f64 = 440.0;

/// How each of the 128 MIDI keys is tuned. It owns no memory, so that it can be handed to the audio
/// thread as it is.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Tuning {
    /// Positive and finite where there is one.
    hz: [Option<f64>; 128],
}

impl Default for Tuning {
    /// Equal temperament with 440 Hz on key 69.
    fn default() -> Self {
        Self {
            hz: std::array::from_fn(|key| Some(equal_temperament_hz(key as u8, A4_HZ))),
        }
    }
}

impl Tuning {
    /// The tuning that lays `scale` on the keys as `map` says.
    #[must_use]
    pub fn new(scale: &Scale, map: &KeyboardMap) -> Self {
        Self {
            hz: std::array::from_fn(|key| map.hz(key as u8, scale)),
        }
    }

    /// Pitch of a key in Hz. `None` if the key is silent: unmapped, outside the map's range, no MIDI
    /// key, or so far from the reference that its frequency is no number.
    #[must_use]
    pub fn hz(&self, key: u8) -> Option<f64> {
        self.hz.get(usize::from(key)).copied().flatten()
    }

    /// By how many semitones a key is tuned above its pitch in equal temperament with 440 Hz on key
    /// 69; `None` if the key is silent.
    ///
    /// A body retuned by more than an octave or so is no longer what its recipe made; rather strike
    /// the body that [`nearest_body`](super::nearest_body) finds for [`Self::hz`].
    #[must_use]
    pub fn offset_semitones(&self, key: u8) -> Option<f64> {
        let hz = self.hz(key)?;
        Some(12.0 * (hz / equal_temperament_hz(key, A4_HZ)).log2())
    }
}
