//! Values of events as the framework can pass them on.

use super::{Event, Span};
use clap_sys::events::{CLAP_TRANSPORT_HAS_TEMPO, clap_event_midi, clap_event_transport};

/// What has become of an event.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Fate {
    /// It was in order.
    Sound,
    /// It is now.
    Mended,
    /// It cannot be: it is about no note there is, or carries no number where only one will do.
    Dropped,
}

impl Event {
    /// Brings what it carries within the limits that CLAP sets.
    pub(super) fn mend(&mut self) -> Fate {
        match self {
            Self::Note(event) if addressed(event.channel, event.key) => {
                confine(&mut event.velocity, Span::UNIT)
            }
            Self::Expression(event) if addressed(event.channel, event.key) => {
                confine(&mut event.value, Span::of(event.expression_id))
            }
            Self::Value(event) if number(event.value) => Fate::Sound,
            Self::Modulation(event) if number(event.amount) => Fate::Sound,
            Self::Transport(event) => transport(event),
            Self::Midi(event) if well_formed(event) => Fate::Sound,
            Self::Sysex(event) if !event.buffer.is_null() => Fate::Sound,
            Self::Other(_) => Fate::Sound,
            _ => Fate::Dropped,
        }
    }
}

/// Takes back the tempo if it is no number.
pub(super) fn transport(event: &mut clap_event_transport) -> Fate {
    if event.flags & CLAP_TRANSPORT_HAS_TEMPO == 0 || event.tempo.is_finite() {
        return Fate::Sound;
    }
    event.flags &= !CLAP_TRANSPORT_HAS_TEMPO;
    event.tempo = 0.0;
    Fate::Mended
}

/// Whether there is such a channel and such a key; −1 is all of them.
fn addressed(channel: i16, key: i16) -> bool {
    (-1..16).contains(&channel) && (-1..128).contains(&key)
}

/// Whether it is a number in the framework's precision.
fn number(value: f64) -> bool {
    (value as f32).is_finite()
}

/// Whether what follows the status byte is data; programs and channel pressure have one byte of it.
fn well_formed(event: &clap_event_midi) -> bool {
    let [status, first, second] = event.data;
    match status >> 4 {
        0x8..=0xB | 0xE => first < 128 && second < 128,
        0xC | 0xD => first < 128,
        _ => true,
    }
}

fn confine(value: &mut f64, span: Span) -> Fate {
    let within = span.confine(*value);
    if within == *value {
        return Fate::Sound;
    }
    *value = within;
    Fate::Mended
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::guard::source::tests::{expression, midi, note, sysex, tempo, value};
    use clap_sys::events::{
        CLAP_NOTE_EXPRESSION_BRIGHTNESS, CLAP_NOTE_EXPRESSION_EXPRESSION, CLAP_NOTE_EXPRESSION_PAN,
        CLAP_NOTE_EXPRESSION_PRESSURE, CLAP_NOTE_EXPRESSION_TUNING, CLAP_NOTE_EXPRESSION_VIBRATO,
        CLAP_NOTE_EXPRESSION_VOLUME,
    };

    const MAX: f64 = f64::INFINITY;

    #[test]
    fn velocities_lie_between_nothing_and_all() {
        for (sent, wanted, fate) in [
            (0.0, 0.0, Fate::Sound),
            (1.0, 1.0, Fate::Sound),
            (f64::NAN, 0.0, Fate::Mended),
            (MAX, 1.0, Fate::Mended),
            (-MAX, 0.0, Fate::Mended),
            (1.5, 1.0, Fate::Mended),
        ] {
            let mut event = note(0, 0, 60, sent);
            assert_eq!(event.mend(), fate, "{sent}");
            assert!(matches!(event, Event::Note(note) if note.velocity == wanted));
        }
    }

    #[test]
    fn expressions_lie_within_their_ranges() {
        for (id, least, greatest, neutral) in [
            (CLAP_NOTE_EXPRESSION_VOLUME, 0.0, 4.0, 1.0),
            (CLAP_NOTE_EXPRESSION_PAN, 0.0, 1.0, 0.5),
            (CLAP_NOTE_EXPRESSION_TUNING, -120.0, 120.0, 0.0),
            (CLAP_NOTE_EXPRESSION_VIBRATO, 0.0, 1.0, 0.0),
            (CLAP_NOTE_EXPRESSION_EXPRESSION, 0.0, 1.0, 1.0),
            (CLAP_NOTE_EXPRESSION_BRIGHTNESS, 0.0, 1.0, 0.5),
            (CLAP_NOTE_EXPRESSION_PRESSURE, 0.0, 1.0, 0.0),
        ] {
            for (sent, wanted) in [
                (-MAX, least),
                (least, least),
                (greatest, greatest),
                (MAX, greatest),
                (f64::NAN, neutral),
            ] {
                let mut event = expression(0, id, sent);
                let sound = sent == wanted;
                assert_eq!(event.mend() == Fate::Sound, sound, "{id}: {sent}");
                assert!(matches!(event, Event::Expression(event) if event.value == wanted));
            }
        }
    }

    #[test]
    fn only_keys_and_channels_that_exist_are_played() {
        for (channel, key, fate) in [
            (0, 0, Fate::Sound),
            (15, 127, Fate::Sound),
            (-1, -1, Fate::Sound),
            (16, 60, Fate::Dropped),
            (0, 128, Fate::Dropped),
            (-2, 60, Fate::Dropped),
            (0, i16::MIN, Fate::Dropped),
        ] {
            assert_eq!(note(0, channel, key, 0.5).mend(), fate, "{channel} {key}");
        }
    }

    #[test]
    fn midi_data_has_seven_bits() {
        for (bytes, fate) in [
            ([0x90, 60, 100], Fate::Sound),
            ([0x90, 200, 100], Fate::Dropped),
            ([0xB0, 64, 255], Fate::Dropped),
            ([0xC0, 5, 255], Fate::Sound),
            ([0xD0, 128, 0], Fate::Dropped),
            ([0xF8, 255, 255], Fate::Sound),
        ] {
            assert_eq!(midi(0, bytes).mend(), fate, "{bytes:?}");
        }
        assert_eq!(sysex(0, std::ptr::null()).mend(), Fate::Dropped);
        assert_eq!(sysex(0, [0xF0, 0xF7].as_ptr()).mend(), Fate::Sound);
    }

    #[test]
    fn parameters_and_tempi_are_numbers() {
        for (sent, fate) in [
            (0.5, Fate::Sound),
            (-3.0, Fate::Sound),
            (f64::NAN, Fate::Dropped),
            (1e300, Fate::Dropped),
        ] {
            assert_eq!(value(0, sent).mend(), fate, "{sent}");
        }
        for (sent, fate) in [(120.0, Fate::Sound), (f64::NAN, Fate::Mended)] {
            let mut event = tempo(0, sent);
            assert_eq!(event.mend(), fate);
            let told = matches!(event, Event::Transport(event) if event.flags != 0);
            assert_eq!(told, fate == Fate::Sound);
        }
    }
}
