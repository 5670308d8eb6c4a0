//! What goes to which output.

use super::outputs::OUTPUTS;

/// How bodies are dealt out to the outputs. What is sent nowhere else is in the main one.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[repr(u8)]
pub enum Split {
    /// All in the main output.
    #[default]
    Main = 0,
    /// Octave by octave: C2 to B2 (keys 36 to 47) in output 2, and so on up to output 8, which has all
    /// from C8 on; what is lower in the main output.
    Octave = 1,
    /// Body by body: the lowest in the main output, the next in output 2, and round again after output 8.
    Body = 2,
    /// By the MIDI channel of a body's last blow: channel 1 in the main output, 2 in output 2, up to 8;
    /// the others in the main output.
    Channel = 3,
}

/// The lowest key that [`Split::Octave`] takes out of the main output: C2.
const OCTAVES_FROM: u8 = 36;

impl Split {
    /// All, by number.
    pub const ALL: [Self; 4] = [Self::Main, Self::Octave, Self::Body, Self::Channel];

    /// That of a number; [`Self::Main`] if there is none.
    #[must_use]
    pub fn from_index(index: usize) -> Self {
        Self::ALL.get(index).copied().unwrap_or_default()
    }

    /// Its name in the host.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Main => "all in main",
            Self::Octave => "by octave",
            Self::Body => "by body",
            Self::Channel => "by channel",
        }
    }

    /// The output, 0 for the main one, of a key's body that is the `rank`-th from the lowest, counted from
    /// 0, and whose last blow came on `channel`, 0…15.
    #[must_use]
    pub fn output(self, key: u8, rank: u8, channel: u8) -> u8 {
        const MOST: u8 = OUTPUTS as u8 - 1;
        match self {
            Self::Main => 0,
            Self::Octave if key < OCTAVES_FROM => 0,
            Self::Octave => (1 + (key - OCTAVES_FROM) / 12).min(MOST),
            Self::Body => rank % (MOST + 1),
            Self::Channel if channel <= MOST => channel,
            Self::Channel => 0,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::Split;

    #[test]
    fn every_body_has_the_output_it_is_said_to_have() {
        for (key, output) in [(0, 0), (35, 0), (36, 1), (47, 1), (48, 2), (60, 3)] {
            assert_eq!(Split::Octave.output(key, 5, 5), output, "key {key}");
        }
        for (key, output) in [(107, 6), (108, 7), (120, 7), (127, 7)] {
            assert_eq!(Split::Octave.output(key, 0, 0), output, "key {key}");
        }
        for (rank, output) in [(0, 0), (1, 1), (7, 7), (8, 0), (127, 7)] {
            assert_eq!(Split::Body.output(60, rank, 3), output, "body {rank}");
        }
        for (channel, output) in [(0, 0), (1, 1), (7, 7), (8, 0), (15, 0)] {
            assert_eq!(Split::Channel.output(60, 3, channel), output);
        }
        assert_eq!(Split::Main.output(60, 3, 3), 0);
    }
}
