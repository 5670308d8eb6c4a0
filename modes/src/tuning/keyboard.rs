//! Which key sounds which degree of a scale.

use super::lines::{Line, Lines, decode};
use super::{ScalaError, Scale};
use std::ops::RangeInclusive;

/// The degrees that are read: any that a scale of this world could need.
const DEGREES: RangeInclusive<i32> = -1_000_000..=1_000_000;

/// A keyboard map: degrees of a scale on keys, and the pitch of one key, which has a degree.
#[derive(Clone, Debug, PartialEq)]
pub struct KeyboardMap {
    degrees: Degrees,
    /// The keys that sound.
    keys: RangeInclusive<u8>,
    reference: Place,
    /// Frequency of the key at `reference`, in Hz, positive and finite.
    reference_hz: f64,
    /// The degree by which each repetition of the map lies above the one before.
    octave_degree: i32,
}

#[derive(Clone, Debug, PartialEq)]
struct Degrees {
    /// Keys after which the map repeats; with 0, each key is one degree above the one before.
    size: i32,
    /// The key of the first entry, or with a size of 0 that of degree 0.
    middle_key: u8,
    /// One to a key from `middle_key` on. Keys that none is left for are unmapped as `None` is.
    entries: Vec<Option<i32>>,
}

/// Where a key lies in a map.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Place {
    repetition: i32,
    degree: i32,
}

impl Default for KeyboardMap {
    /// Degree 0 on key 60, one degree to a key, and 440 Hz on key 69.
    fn default() -> Self {
        Self {
            degrees: Degrees {
                size: 0,
                middle_key: 60,
                entries: Vec::new(),
            },
            keys: 0..=127,
            reference: Place {
                repetition: 0,
                degree: 69 - 60,
            },
            reference_hz: 440.0,
            octave_degree: 0,
        }
    }
}

impl KeyboardMap {
    /// The map in a `.kbm` file with the content `file`.
    ///
    /// Lines that begin with `!` are comments. The others give
    ///
    /// 1. the size of the map in keys; 0 for one degree to a key, without end;
    /// 2. the first and
    /// 3. the last key that sound;
    /// 4. the middle key, which the first entry belongs to;
    /// 5. the reference key and
    /// 6. its frequency in Hz;
    /// 7. the degree that makes the interval from one repetition of the map to the next;
    /// 8. the entries: degrees, or `x` for silent keys. Keys that none is left for are silent too.
    ///
    /// Blank lines, and whatever follows the last entry, are not read.
    ///
    /// # Errors
    ///
    /// [`ScalaError::Line`] if a line is not what it should be or the reference key has no degree,
    /// [`ScalaError::End`] if there are too few lines.
    pub fn parse(file: &[u8]) -> Result<Self, ScalaError> {
        let text = decode(file);
        let mut lines = Lines::of(&text);
        let mut next = |name: &str| lines.filled(|| name.to_owned());
        let size = next(SIZE)?.whole(SIZE, 0..=1_000_000)?;
        let first = key(next(FIRST)?, FIRST)?;
        let last_line = next(LAST)?;
        let last = key(last_line, LAST)?;
        if last < first {
            let fault = format!("{LAST} must not lie below the first, which is {first}");
            return Err(last_line.error(fault));
        }
        let middle_key = key(next(MIDDLE)?, MIDDLE)?;
        let reference_line = next(REFERENCE)?;
        let reference_key = key(reference_line, REFERENCE)?;
        let reference_hz = hz(next(FREQUENCY)?)?;
        let octave_degree = next(OCTAVE)?.whole(OCTAVE, DEGREES)?;
        let degrees = Degrees {
            size,
            middle_key,
            entries: lines
                .filter(|line| !line.text.trim().is_empty())
                .take(usize::try_from(size).unwrap_or(0))
                .map(entry)
                .collect::<Result<_, _>>()?,
        };
        let reference = degrees.place(reference_key).ok_or_else(|| {
            let fault = "the reference key must have a degree, but its entry is x or missing; map \
                         it, or choose another key";
            reference_line.error(fault)
        })?;
        Ok(Self {
            degrees,
            keys: first..=last,
            reference,
            reference_hz,
            octave_degree,
        })
    }

    /// Pitch of a key in Hz with the degrees of `scale`; `None` if it is silent.
    pub(super) fn hz(&self, key: u8, scale: &Scale) -> Option<f64> {
        let place = self
            .degrees
            .place(key)
            .filter(|_| self.keys.contains(&key))?;
        let cents = |place: Place| {
            let repetition = f64::from(place.repetition);
            repetition * scale.cents(self.octave_degree) + scale.cents(place.degree)
        };
        let cents = cents(place) - cents(self.reference);
        let hz = self.reference_hz * (cents / 1200.0).exp2();
        hz.is_normal().then_some(hz)
    }
}

impl Degrees {
    fn place(&self, key: u8) -> Option<Place> {
        let keys_up = i32::from(key) - i32::from(self.middle_key);
        if self.size == 0 {
            return Some(Place {
                repetition: 0,
                degree: keys_up,
            });
        }
        let entry = usize::try_from(keys_up.rem_euclid(self.size)).ok()?;
        Some(Place {
            repetition: keys_up.div_euclid(self.size),
            degree: self.entries.get(entry).copied().flatten()?,
        })
    }
}

const SIZE: &str = "the size of the map";
const FIRST: &str = "the first key";
const LAST: &str = "the last key";
const MIDDLE: &str = "the middle key";
const REFERENCE: &str = "the reference key";
const FREQUENCY: &str = "the reference frequency";
const OCTAVE: &str = "the degree of the formal octave";

fn key(line: Line<'_>, name: &str) -> Result<u8, ScalaError> {
    let key = line.whole(name, 0..=127)?;
    #[expect(clippy::cast_sign_loss, reason = "0 to 127")]
    Ok(key as u8)
}

fn hz(line: Line<'_>) -> Result<f64, ScalaError> {
    let hz: Option<f64> = line.word().parse().ok();
    hz.filter(|hz| hz.is_normal() && *hz > 0.0).ok_or_else(|| {
        line.error(format!(
            "{FREQUENCY} must be in Hz and above 0, such as 440.0"
        ))
    })
}

fn entry(line: Line<'_>) -> Result<Option<i32>, ScalaError> {
    if line.word().eq_ignore_ascii_case("x") {
        return Ok(None);
    }
    let degree = line.word().parse().ok();
    let degree = degree.filter(|degree| DEGREES.contains(degree));
    degree
        .map(Some)
        .ok_or_else(|| line.error("an entry must be a degree such as 5, or x for a silent key"))
}
