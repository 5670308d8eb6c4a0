//! From ticks to seconds.

use anyhow::{Result, bail};
use midly::{Fps, MetaMessage, Timing, Track, TrackEventKind};

/// Seconds to a quarter note until a song says otherwise: 120 to the minute.
const DEFAULT_QUARTER_S: f64 = 0.5;

/// A song's tempo, from its beginning to its end.
pub(super) struct Clock {
    /// Where a tempo begins: tick, the seconds there, and seconds to a tick from there on.
    spans: Vec<(u64, f64, f64)>,
}

impl Clock {
    pub(super) fn new(timing: Timing, tracks: &[Track<'_>]) -> Result<Self> {
        match timing {
            Timing::Metrical(ticks) => match ticks.as_int() {
                0 => bail!("division is 0 ticks to a quarter note; allowed: 1…32767"),
                ticks => Ok(Self::metrical(f64::from(ticks), tracks)),
            },
            Timing::Timecode(_, 0) => {
                bail!("division is 0 ticks to a timecode frame; allowed: 1…255")
            }
            Timing::Timecode(fps, ticks) => {
                let frame_s = match fps {
                    Fps::Fps29 => 1001.0 / 30000.0,
                    whole => 1.0 / f64::from(whole.as_int()),
                };
                Ok(Self {
                    spans: vec![(0, 0.0, frame_s / f64::from(ticks))],
                })
            }
        }
    }

    fn metrical(ticks_per_quarter: f64, tracks: &[Track<'_>]) -> Self {
        let mut spans = vec![(0, 0.0, DEFAULT_QUARTER_S / ticks_per_quarter)];
        for (tick, quarter_us) in tempi(tracks) {
            let &(since, seconds, tick_s) = spans.last().unwrap_or(&(0, 0.0, 0.0));
            let seconds = seconds + (tick - since) as f64 * tick_s;
            let tick_s = f64::from(quarter_us) * 1e-6 / ticks_per_quarter;
            spans.push((tick, seconds, tick_s));
        }
        Self { spans }
    }

    pub(super) fn seconds(&self, tick: u64) -> f64 {
        let begun = self.spans.partition_point(|&(since, ..)| since <= tick);
        let (since, seconds, tick_s) = self.spans[begun.saturating_sub(1)];
        seconds + (tick - since) as f64 * tick_s
    }
}

/// Ticks of all tempo changes, in order, with µs to a quarter note.
fn tempi(tracks: &[Track<'_>]) -> Vec<(u64, u32)> {
    let mut tempi = Vec::new();
    for track in tracks {
        let mut tick = 0;
        for event in track {
            tick += u64::from(event.delta.as_int());
            if let TrackEventKind::Meta(MetaMessage::Tempo(quarter_us)) = event.kind {
                tempi.push((tick, quarter_us.as_int()));
            }
        }
    }
    tempi.sort_by_key(|&(tick, _)| tick);
    tempi
}
