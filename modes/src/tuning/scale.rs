//! A scale: pitches above a first note that may be anywhere.

use super::ScalaError;
use super::lines::{Lines, decode, printable};
use super::pitch::pitch_cents;

/// The notes of a scale from its second on, the last of which is where it repeats. There is at least
/// one.
#[derive(Clone, Debug, PartialEq)]
pub struct Scale {
    description: String,
    /// Cents of degrees 1, 2, …, each within 100 octaves.
    cents: Vec<f64>,
}

impl Default for Scale {
    /// Twelve equal steps to the octave.
    fn default() -> Self {
        Self {
            description: "12-tone equal temperament".to_owned(),
            cents: (1..=12).map(|step| 100.0 * f64::from(step)).collect(),
        }
    }
}

impl Scale {
    /// The scale in a `.scl` file with the content `file`.
    ///
    /// Lines that begin with `!` are comments. The others give a description, the number of notes,
    /// and as many pitches; whatever follows is not read. Blank lines are passed over but for the
    /// description.
    ///
    /// # Errors
    ///
    /// [`ScalaError::Line`] if a line is not what it should be, [`ScalaError::End`] if there are too
    /// few. A scale of no note but 1/1, which the format allows, is refused too: it says nothing of
    /// the keys around.
    pub fn parse(file: &[u8]) -> Result<Self, ScalaError> {
        let text = decode(file);
        let mut lines = Lines::of(&text);
        let Some(description) = lines.next() else {
            return Err(lines.end("a description or an empty line".to_owned()));
        };
        let line = lines.filled(|| "the number of notes".to_owned())?;
        let count = line.word().parse().ok().filter(|count| *count > 0_u32);
        let count = count.ok_or_else(|| {
            line.error(
                "the number of notes must be a whole number from 1 on, such as 12; if there is no \
                 description, put an empty line before it",
            )
        })?;
        let mut cents = Vec::new();
        for read in 0..count {
            let line = lines.filled(|| format!("pitch {} of {count}", read + 1))?;
            cents.push(pitch_cents(line.text).map_err(|fault| line.error(fault))?);
        }
        Ok(Self {
            description: printable(description.text),
            cents,
        })
    }

    /// What the file says the scale is; may be empty.
    #[must_use]
    pub fn description(&self) -> &str {
        &self.description
    }

    /// How many notes there are to a period.
    #[must_use]
    pub fn notes(&self) -> usize {
        self.cents.len()
    }

    /// Cents of a degree of the scale, continued both ways by its period.
    #[must_use]
    pub fn cents(&self, degree: i32) -> f64 {
        let (degree, notes) = (i64::from(degree), self.cents.len() as i64);
        let periods = degree.div_euclid(notes) as f64;
        let period_cents = self.cents[self.cents.len() - 1];
        let step_cents = match usize::try_from(degree.rem_euclid(notes)) {
            Ok(step @ 1..) => self.cents[step - 1],
            _ => 0.0,
        };
        periods * period_cents + step_cents
    }
}
