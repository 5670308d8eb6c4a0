//! A standard MIDI file as events in seconds.

mod clock;

use crate::host::{Event, TimedEvent};
use crate::whole::whole;
use anyhow::{Context, Result, bail};
use clock::Clock;
use midly::{Format, MidiMessage, Smf, Track, TrackEventKind};
use std::collections::VecDeque;
use std::path::Path;

/// A piece of music.
#[derive(Clone, Debug, PartialEq)]
pub struct Song {
    /// What is played, by rising time.
    pub events: Vec<SongEvent>,
    /// When the last track ends, in s.
    pub seconds: f64,
}

/// Something in a song.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SongEvent {
    /// When it happens, in s.
    pub seconds: f64,
    /// What happens.
    pub event: Event,
}

impl Song {
    /// Reads a `.mid` file.
    ///
    /// # Errors
    ///
    /// If it cannot be read, is no MIDI file, or holds no note.
    pub fn read(path: &Path) -> Result<Self> {
        let bytes =
            std::fs::read(path).with_context(|| format!("{}: cannot read", path.display()))?;
        Self::parse(&bytes).with_context(|| path.display().to_string())
    }

    /// Reads the bytes of a MIDI file of format 0 or 1.
    ///
    /// # Errors
    ///
    /// If they are no MIDI file or hold no note.
    pub fn parse(bytes: &[u8]) -> Result<Self> {
        if !bytes.starts_with(b"MThd") {
            bail!("not a MIDI file: byte 0 should start the chunk MThd");
        }
        check_timecode(bytes)?;
        let smf = Smf::parse(bytes).context("not a MIDI file")?;
        if smf.header.format == Format::Sequential {
            bail!("MIDI format 2 is a set of songs; allowed: format 0 or 1");
        }
        let clock = Clock::new(smf.header.timing, &smf.tracks)?;
        let mut open = OpenNotes::default();
        let mut events = Vec::new();
        for (tick, channel, message) in merged(&smf.tracks) {
            let seconds = clock.seconds(tick);
            let event = event(channel, message, &mut open);
            events.extend(event.map(|event| SongEvent { seconds, event }));
        }
        if !events
            .iter()
            .any(|at| matches!(at.event, Event::NoteOn { .. }))
        {
            bail!("holds no note");
        }
        let last_tick = smf.tracks.iter().map(length).max();
        Ok(Self {
            events,
            seconds: clock.seconds(last_tick.unwrap_or(0)),
        })
    }

    /// The events at the nearest frames of `rate_hz`.
    #[must_use]
    pub fn at_rate(&self, rate_hz: f64) -> Vec<TimedEvent> {
        self.events
            .iter()
            .map(|at| at.event.at(frame(at.seconds, rate_hz)))
            .collect()
    }
}

/// The frame nearest to a time.
#[must_use]
pub fn frame(seconds: f64, rate_hz: f64) -> u64 {
    whole((seconds * rate_hz).round()) as u64
}

/// Refuses a timecode that is no film's or television's, which midly 0.5.3 negates unchecked.
fn check_timecode(bytes: &[u8]) -> Result<()> {
    /// Where the header chunk counts timecode frames to the second, as a negative number.
    const PLACE: usize = 12;
    match bytes.get(PLACE) {
        Some(&byte @ 0x80..) if ![24, 25, 29, 30].contains(&byte.wrapping_neg()) => bail!(
            "division counts {} timecode frames to the second; allowed: 24, 25, 29, 30",
            byte.wrapping_neg()
        ),
        _ => Ok(()),
    }
}

/// Ticks to a track's end.
fn length(track: &Track<'_>) -> u64 {
    track
        .iter()
        .map(|event| u64::from(event.delta.as_int()))
        .sum()
}

/// The channel messages of all tracks in order of time; of one time, in order of track.
fn merged(tracks: &[Track<'_>]) -> Vec<(u64, u8, MidiMessage)> {
    let mut messages = Vec::new();
    for track in tracks {
        let mut tick = 0;
        for event in track {
            tick += u64::from(event.delta.as_int());
            if let TrackEventKind::Midi { channel, message } = event.kind {
                messages.push((tick, channel.as_int(), message));
            }
        }
    }
    messages.sort_by_key(|&(tick, ..)| tick);
    messages
}

/// Notes that are down, so that a note-off finds the identity of its note-on.
#[derive(Default)]
struct OpenNotes {
    started: u32,
    down: VecDeque<(u8, u8, u32)>,
}

impl OpenNotes {
    fn start(&mut self, channel: u8, key: u8) -> u32 {
        let id = self.started;
        self.started += 1;
        self.down.push_back((channel, key, id));
        id
    }

    /// Ends the note of this key that has been down longest.
    fn end(&mut self, channel: u8, key: u8) -> Option<u32> {
        let of_key = |&(c, k, _): &(u8, u8, u32)| (c, k) == (channel, key);
        let at = self.down.iter().position(of_key)?;
        self.down.remove(at).map(|(.., id)| id)
    }
}

/// The host's event for a message; `None` for the end of a note that never began.
fn event(channel: u8, message: MidiMessage, open: &mut OpenNotes) -> Option<Event> {
    let raw = |status: u8, a: u8, b: u8| Some(Event::Midi([status | channel, a, b]));
    match message {
        MidiMessage::NoteOn { key, vel } if vel > 0 => Some(Event::NoteOn {
            channel,
            key: key.as_int(),
            note_id: open.start(channel, key.as_int()),
            velocity: f64::from(vel.as_int()) / 127.0,
        }),
        MidiMessage::NoteOn { key, vel } | MidiMessage::NoteOff { key, vel } => {
            Some(Event::NoteOff {
                channel,
                key: key.as_int(),
                note_id: open.end(channel, key.as_int())?,
                velocity: f64::from(vel.as_int()) / 127.0,
            })
        }
        MidiMessage::Aftertouch { key, vel } => raw(0xA0, key.as_int(), vel.as_int()),
        MidiMessage::Controller { controller, value } => {
            raw(0xB0, controller.as_int(), value.as_int())
        }
        MidiMessage::ProgramChange { program } => raw(0xC0, program.as_int(), 0),
        MidiMessage::ChannelAftertouch { vel } => raw(0xD0, vel.as_int(), 0),
        MidiMessage::PitchBend { bend } => {
            let bend = bend.0.as_int();
            raw(0xE0, (bend & 0x7F) as u8, (bend >> 7) as u8)
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A file of one track, its bytes given without the end of track.
    fn file(division: [u8; 2], track: &[u8]) -> Vec<u8> {
        let mut bytes = b"MThd\0\0\0\x06\0\0\0\x01".to_vec();
        bytes.extend(division);
        bytes.extend(b"MTrk");
        bytes.extend((track.len() as u32 + 4).to_be_bytes());
        bytes.extend(track);
        bytes.extend(b"\0\xFF\x2F\0");
        bytes
    }

    fn seconds(division: [u8; 2], track: &[u8]) -> Vec<f64> {
        let song = Song::parse(&file(division, track)).unwrap();
        song.events.iter().map(|at| at.seconds).collect()
    }

    #[test]
    fn without_a_tempo_a_quarter_lasts_half_a_second() {
        let track = b"\x00\x90\x4A\x40\x60\x80\x4A\x40";
        assert_eq!(seconds([0, 96], track), [0.0, 0.5]);
    }

    #[test]
    fn a_tempo_change_counts_from_its_tick() {
        // One quarter at 0.5 s, then quarters at 1 s.
        let track = b"\x00\x90\x4A\x40\x60\xFF\x51\x03\x0F\x42\x40\x60\x80\x4A\x40";
        assert_eq!(seconds([0, 96], track), [0.0, 1.5]);
    }

    #[test]
    fn timecode_needs_no_tempo() {
        // 25 frames of 40 ticks to the second.
        let track = b"\x00\x90\x4A\x40\x87\x68\x80\x4A\x40";
        assert_eq!(seconds([0xE7, 40], track), [0.0, 1.0]);
        // 29.97 frames of 80 ticks.
        let track = b"\x00\x90\x4A\x40\x92\x60\x80\x4A\x40";
        let drop_frame = seconds([0xE3, 80], track)[1];
        assert!((drop_frame - 1.001).abs() < 1e-12, "{drop_frame}");
    }

    #[test]
    fn overlapping_notes_of_a_key_end_in_the_order_they_began() {
        let track = b"\0\x90\x4A\x40\x10\x4A\x50\x10\x4A\x00\x10\x80\x4A\x40";
        let song = Song::parse(&file([0, 96], track)).unwrap();
        let ids: Vec<_> = song
            .events
            .iter()
            .map(|at| match at.event {
                Event::NoteOn { note_id, .. } => (true, note_id),
                Event::NoteOff { note_id, .. } => (false, note_id),
                other => panic!("{other:?}"),
            })
            .collect();
        assert_eq!(ids, [(true, 0), (true, 1), (false, 0), (false, 1)]);
    }

    #[test]
    fn controllers_and_bends_keep_their_bytes() {
        let track = b"\0\x93\x4A\x40\0\xB3\x40\x7F\0\xE3\x01\x60";
        let song = Song::parse(&file([0, 96], track)).unwrap();
        assert_eq!(song.events[1].event, Event::Midi([0xB3, 0x40, 0x7F]));
        assert_eq!(song.events[2].event, Event::Midi([0xE3, 0x01, 0x60]));
    }

    #[test]
    fn what_is_no_song_is_refused() {
        let says = |bytes: &[u8]| format!("{:#}", Song::parse(bytes).unwrap_err());
        assert!(says(b"RIFF....").contains("not a MIDI file"));
        assert!(says(b"").contains("not a MIDI file"));
        assert!(says(b"MThd\0\0\0\x06").contains("not a MIDI file"));
        assert!(says(&file([0, 96], b"")).contains("no note"));
        assert!(says(&file([0, 0], b"\x00\x90\x4A\x40")).contains("division"));
        assert!(says(&file([0x80, 4], b"\x00\x90\x4A\x40")).contains("128 timecode frames"));
    }

    #[test]
    fn any_flipped_byte_is_read_or_refused() {
        let whole = file([0, 96], b"\x00\x90\x4A\x40\x60\x80\x4A\x40");
        for at in 0..whole.len() {
            for bit in 0..8 {
                let mut bytes = whole.clone();
                bytes[at] ^= 1 << bit;
                if let Ok(song) = Song::parse(&bytes) {
                    assert!(song.seconds.is_finite());
                }
            }
            assert!(Song::parse(&whole[..at]).is_err() || at > 20, "cut at {at}");
        }
    }
}
