//! Host events to engine calls, each at its sample.

use crate::engine::Engine;
use crate::guard::put_right;
use crate::notes::{Note, Notes};
use crate::stage::Stage;
use nice_plug::midi::Key;
use nice_plug::prelude::{NoteEvent, Plugin, PluginNoteEvent, ProcessContext, control_change};

/// An engine and the notes it owes the host an end of.
pub(crate) struct Player {
    stage: Stage,
    notes: Notes,
}

impl Player {
    pub(crate) fn new(stage: Stage) -> Self {
        Self {
            stage,
            notes: Notes::new(),
        }
    }

    /// The instruments.
    pub(crate) fn stage(&mut self) -> &mut Stage {
        &mut self.stage
    }

    /// Silence, at once.
    pub(crate) fn reset(&mut self) {
        self.stage.reset();
        self.notes = Notes::new();
    }

    /// Renders a block, cut where events fall; those beyond the block act at its end.
    pub(crate) fn play<P: Plugin>(
        &mut self,
        left: &mut [f32],
        right: &mut [f32],
        context: &mut impl ProcessContext<P>,
    ) {
        let frames = left.len().min(right.len());
        let mut done = 0;
        let mut event = context.next_event();
        loop {
            let until = event.as_ref().map_or(frames, |event| {
                usize::try_from(event.timing()).map_or(frames, |time| time.clamp(done, frames))
            });
            self.stage
                .process(&mut left[done..until], &mut right[done..until]);
            done = until;
            // The host counts in u32, and an end belongs to a sample of this block.
            let now = u32::try_from(done.min(frames.saturating_sub(1))).unwrap_or(u32::MAX);
            let over = event.is_none();
            let api = context.plugin_api();
            if let Some(event) = event.take().and_then(|event| put_right(event, api)) {
                self.handle::<P>(&event, now, context);
            }
            while let Some(note) = self.notes.end_one(self.stage.awake()) {
                end::<P>(note, now, context);
            }
            if over {
                return;
            }
            event = context.next_event();
        }
    }

    fn handle<P: Plugin>(
        &mut self,
        event: &PluginNoteEvent<P>,
        now: u32,
        context: &mut impl ProcessContext<P>,
    ) {
        match *event {
            NoteEvent::NoteOn {
                voice_id,
                channel,
                key: Key::Number(key),
                velocity,
                ..
            } if key < 128 => {
                let note = Note {
                    voice_id,
                    channel,
                    key,
                };
                if let Some(earlier) = self.notes.begin(note) {
                    end::<P>(earlier, now, context);
                }
                self.stage.strike(key, velocity);
            }
            NoteEvent::NoteOff {
                voice_id,
                channel,
                key,
                ..
            } => {
                let keys = self.notes.addressed(voice_id, channel, key);
                for key in each(keys) {
                    self.stage.each(|engine| engine.release(key));
                }
            }
            NoteEvent::Choke {
                voice_id,
                channel,
                key,
                ..
            } => {
                let keys = self.notes.addressed(voice_id, channel, key);
                for key in each(keys) {
                    self.stage.each(|engine| engine.choke(key));
                }
            }
            NoteEvent::MidiCC { cc, value, .. } => match cc {
                control_change::DAMPER_PEDAL => self.stage.pedal(value >= 0.5),
                control_change::RESET_ALL_CONTROLLERS => self.stage.pedal(false),
                control_change::ALL_SOUND_OFF | control_change::ALL_NOTES_OFF => {
                    self.stage.each(Engine::choke_all);
                }
                _ => {}
            },
            _ => {}
        }
    }
}

/// The keys whose bits are set.
fn each(keys: u128) -> impl Iterator<Item = u8> {
    (0..128).filter(move |key| keys >> key & 1 == 1)
}

/// Tells the host that a note has ended; a host without room for it is no worse off.
fn end<P: Plugin>(note: Note, now: u32, context: &mut impl ProcessContext<P>) {
    let _ = context.try_send_event(NoteEvent::VoiceTerminated {
        timing: now,
        voice_id: note.voice_id,
        channel: note.channel,
        key: Key::Number(note.key),
    });
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Idiophone;
    use nice_plug::context::process::{SendEventError, Transport};
    use nice_plug::midi::{Channel, VoiceID};
    use nice_plug::prelude::PluginApi;

    type Event = NoteEvent<()>;

    /// A host with some events to give and a list of what it gets.
    struct Host {
        events: std::vec::IntoIter<Event>,
        ended: Vec<(u32, i32)>,
        transport: Transport,
    }

    impl Host {
        fn with(events: Vec<Event>) -> Self {
            Self {
                events: events.into_iter(),
                ended: Vec::new(),
                transport: Transport::new(48_000.0),
            }
        }
    }

    impl ProcessContext<Idiophone> for Host {
        fn plugin_api(&self) -> PluginApi {
            PluginApi::Clap
        }
        fn execute_background(&self, (): ()) {}
        fn execute_gui(&self, (): ()) {}
        fn transport(&self) -> &Transport {
            &self.transport
        }
        fn next_event(&mut self) -> Option<Event> {
            self.events.next()
        }
        fn try_send_event(&mut self, event: Event) -> Result<(), (Event, SendEventError)> {
            if let NoteEvent::VoiceTerminated {
                timing,
                voice_id: VoiceID::ID(id),
                ..
            } = event
            {
                self.ended.push((timing, id));
            }
            Ok(())
        }
        fn set_latency_samples(&self, _: u32) {}
        fn request_restart(&self) {}
        fn set_current_voice_capacity(&self, _: u32) {}
    }

    fn on(timing: u32, id: i32, key: u8, velocity: f32) -> Event {
        NoteEvent::NoteOn {
            timing,
            voice_id: VoiceID::ID(id),
            channel: Channel::Number(0),
            key: Key::Number(key),
            velocity,
        }
    }

    fn cc(timing: u32, cc: u8, value: f32) -> Event {
        NoteEvent::MidiCC {
            timing,
            channel: 0,
            cc,
            value,
        }
    }

    fn player() -> Player {
        Player::new(Stage::new(0, 48_000.0))
    }

    fn play(player: &mut Player, frames: usize, events: Vec<Event>) -> (Vec<f32>, Vec<(u32, i32)>) {
        let (mut left, mut right) = (vec![f32::NAN; frames], vec![f32::NAN; frames]);
        let mut host = Host::with(events);
        player.play::<Idiophone>(&mut left, &mut right, &mut host);
        assert!(left.iter().chain(&right).all(|sample| sample.is_finite()));
        (left, host.ended)
    }

    #[test]
    fn a_note_sounds_from_its_sample_on() {
        let mut player = player();
        let (left, _) = play(&mut player, 512, vec![on(100, 1, 60, 1.0)]);
        assert!(left[..100].iter().all(|sample| *sample == 0.0));
        assert!(left[100] != 0.0);
        assert!(left[101..].iter().any(|sample| sample.abs() > 1e-3));
    }

    #[test]
    fn events_beyond_the_block_and_odd_ones_do_no_harm() {
        let mut player = player();
        let events = vec![
            on(5, 1, 60, f32::NAN),
            on(2, 2, 64, f32::INFINITY),
            on(u32::MAX, 3, 67, 0.5),
            on(70, 4, 200, 0.5),
        ];
        let (_, ended) = play(&mut player, 64, events);
        assert_eq!(ended, []);
        assert_eq!(player.stage.awake(), 1 << 60 | 1 << 64 | 1 << 67);
        play(&mut player, 0, vec![on(0, 5, 72, 0.5)]);
        assert!(player.stage.awake() >> 72 & 1 == 1);
    }

    #[test]
    fn every_note_is_ended() {
        let mut player = player();
        let events = vec![on(0, 1, 60, 0.5), on(10, 2, 60, 0.5), on(20, 3, 20, 0.5)];
        let (_, ended) = play(&mut player, 64, events);
        assert_eq!(
            ended,
            [(10, 1), (20, 3)],
            "one taken over, one without a body"
        );
        let (_, ended) = play(
            &mut player,
            64,
            vec![cc(0, control_change::ALL_SOUND_OFF, 0.0)],
        );
        assert_eq!(ended, []);
        let (left, ended) = play(&mut player, 9600, vec![]);
        assert_eq!(ended.len(), 1);
        assert_eq!(ended[0].1, 2);
        assert_eq!(player.stage.awake(), 0);
        assert_eq!(left[9599], 0.0);
    }

    #[test]
    fn a_choked_key_stops_and_the_others_ring() {
        let mut player = player();
        let choke = NoteEvent::Choke {
            timing: 32,
            voice_id: VoiceID::Wildcard,
            channel: Channel::Wildcard,
            key: Key::Number(60),
        };
        let events = vec![on(0, 1, 60, 0.5), on(0, 2, 64, 0.5), choke];
        play(&mut player, 10_000, events);
        assert_eq!(player.stage.awake(), 1 << 64);
        player.reset();
        assert_eq!(player.stage.awake(), 0);
    }
}
