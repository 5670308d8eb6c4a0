//! What a preset sounds like, without a host.

use super::preset::Preset;
use crate::Idiophone;
use crate::engine::{GRID, Outputs, Trims};
use crate::factory;
use crate::params::{Controls, body::INSTRUMENT, output::LIMITER};
use crate::player::Player;
use crate::stage::Stage;
use crate::tuner::Tuner;
use nice_plug::context::process::{SendEventError, Transport};
use nice_plug::midi::{Channel, Key, VoiceID};
use nice_plug::prelude::{NoteEvent, Params as _, PluginApi, ProcessContext};
use std::sync::Arc;

/// Frames to a block.
const BLOCK: usize = 16 * GRID;

/// A key that is struck and let go.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Note {
    /// MIDI key.
    pub key: u8,
    /// 0…1.
    pub velocity: f32,
    /// From when on, in s.
    pub from_s: f64,
    /// Until when, in s.
    pub until_s: f64,
}

/// Plays notes for `seconds` at a rate; the left and the right channel. The limiter is off, so that what
/// would go over full scale does.
#[must_use]
pub fn audition(preset: &Preset, notes: &[Note], seconds: f64, rate_hz: f64) -> [Vec<f32>; 2] {
    let mut player = player(preset, rate_hz);
    let mut host = Host::new(notes, rate_hz);
    let frames = frame(seconds, rate_hz);
    let [mut left, mut right] = [vec![0.0; frames], vec![0.0; frames]];
    for (left, right) in left.chunks_mut(BLOCK).zip(right.chunks_mut(BLOCK)) {
        player.play::<Idiophone>(&mut Outputs::main(left, right), &mut host);
        host.pass(left.len());
    }
    [left, right]
}

fn frame(seconds: f64, rate_hz: f64) -> usize {
    #[expect(clippy::cast_sign_loss, reason = "what is below 0 saturates")]
    let frame = (seconds * rate_hz).round() as usize;
    frame
}

fn player(preset: &Preset, rate_hz: f64) -> Player {
    let controls = Arc::new(Controls::default());
    let map = controls.param_map();
    let quiet = std::iter::once((&LIMITER, 0.0));
    for (spec, plain) in preset.sound.wanted().chain(quiet) {
        let Some((_, pointer, _)) = map.iter().find(|(id, _, _)| id == spec.id) else {
            continue;
        };
        // SAFETY: `controls`, which the pointers point into, is alive.
        #[expect(unsafe_code, reason = "the framework hands out raw pointers")]
        unsafe {
            pointer._internal_set_normalized_value(pointer.preview_normalized(plain));
        }
    }
    let texts = controls.tuning();
    texts.set_scale(preset.sound.scala.scale.clone());
    texts.set_keyboard(preset.sound.scala.keyboard.clone());
    let trims = Trims::of(&preset.sound.trims);
    let tuner = Tuner::new(texts.tuning(), None);
    let index = preset
        .sound
        .get(INSTRUMENT.id)
        .unwrap_or(INSTRUMENT.default);
    #[expect(
        clippy::cast_sign_loss,
        reason = "a number of an instrument is none below 0"
    )]
    let mut stage = Stage::new(index as usize, factory::bank(index as usize), rate_hz);
    stage.trim(&trims);
    Player::new(stage, tuner, controls, rate_hz)
}

/// A host with the notes to come.
struct Host {
    /// By rising frame, counted from the beginning.
    events: Vec<(usize, NoteEvent<()>)>,
    given: usize,
    passed: usize,
    transport: Transport,
}

impl Host {
    fn new(notes: &[Note], rate_hz: f64) -> Self {
        let channel = Channel::Number(0);
        let voice_id = VoiceID::Wildcard;
        let mut events = Vec::with_capacity(2 * notes.len());
        for note in notes {
            let (key, velocity) = (Key::Number(note.key), note.velocity);
            let on = NoteEvent::NoteOn {
                timing: 0,
                voice_id,
                channel,
                key,
                velocity,
            };
            let off = NoteEvent::NoteOff {
                timing: 0,
                voice_id,
                channel,
                key,
                velocity: 0.5,
            };
            events.push((frame(note.from_s, rate_hz), on));
            events.push((frame(note.until_s, rate_hz), off));
        }
        events.sort_by_key(|(frame, _)| *frame);
        Self {
            events,
            given: 0,
            passed: 0,
            transport: Transport::new(rate_hz as f32),
        }
    }

    fn pass(&mut self, frames: usize) {
        self.passed += frames;
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

    fn next_event(&mut self) -> Option<NoteEvent<()>> {
        let (frame, event) = self.events.get(self.given)?;
        let timing = frame
            .checked_sub(self.passed)
            .filter(|timing| *timing < BLOCK)?;
        self.given += 1;
        let mut event = *event;
        if let NoteEvent::NoteOn { timing: at, .. } | NoteEvent::NoteOff { timing: at, .. } =
            &mut event
        {
            *at = u32::try_from(timing).unwrap_or(0);
        }
        Some(event)
    }

    fn try_send_event(&mut self, _: NoteEvent<()>) -> Result<(), (NoteEvent<()>, SendEventError)> {
        Ok(())
    }

    fn set_latency_samples(&self, _: u32) {}

    fn request_restart(&self) {}

    fn set_current_voice_capacity(&self, _: u32) {}
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn notes_sound_when_they_are_struck() {
        let note = Note {
            key: 60,
            velocity: 0.8,
            from_s: 0.03,
            until_s: 0.05,
        };
        let [left, right] = audition(&Preset::init(0), &[note], 0.1, 48e3);
        assert_eq!(left.len(), 4800);
        assert!(left[..1440].iter().chain(&right[..1440]).all(|x| *x == 0.0));
        assert!(left[1440..].iter().any(|x| x.abs() > 1e-3));
    }

    #[test]
    fn size_tuning_and_trims_are_those_of_the_preset() {
        let play = |text: &str| {
            let preset = Preset::read(text, "a").unwrap();
            let note = Note {
                key: 61,
                velocity: 0.8,
                from_s: 0.0,
                until_s: 0.1,
            };
            audition(&preset, &[note], 0.1, 48e3)
        };
        let plain = play("name = \"A\"\n[sound]\n");
        assert_ne!(plain, play("name = \"A\"\n[sound]\nsize = \"2 x\"\n"));
        let tuned = "name = \"A\"\n[sound]\n[tuning]\nscale = '''\nfive\n1\n240.0\n'''\n";
        assert_ne!(plain, play(tuned));
        let softer = "name = \"A\"\n[sound]\n[trims]\n\"bending 1 a\" = { level = \"-9 dB\" }\n";
        assert_ne!(plain, play(softer));
    }
}
