//! What hosts say.

use super::{Player, end};
use crate::engine::{Engine, chance};
use crate::hands::{Address, Expression, Modulated, Note as Finger, bend_of_share};
use crate::notes::{Note, each};
use nice_plug::midi::{Channel, Key, VoiceID};
use nice_plug::prelude::{NoteEvent, Plugin, PluginNoteEvent, ProcessContext, control_change};

impl Player {
    /// Takes in an event of this sample, frame `now` of the block.
    pub(super) fn hear<P: Plugin>(
        &mut self,
        event: &PluginNoteEvent<P>,
        now: usize,
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
                self.note_on(note, velocity);
            }
            NoteEvent::NoteOff {
                voice_id,
                channel,
                key,
                velocity,
                ..
            } => self.note_off(address(voice_id, channel, key), velocity),
            NoteEvent::Choke {
                voice_id,
                channel,
                key,
                ..
            } => {
                let keys = self.notes.addressed(voice_id, channel, key);
                self.choke(keys, address(voice_id, channel, key));
            }
            NoteEvent::PolyModulation {
                voice_id,
                poly_modulation_id,
                normalized_offset,
                ..
            } => {
                let known = Modulated::ALL.into_iter();
                for what in known.filter(|what| *what as u32 == poly_modulation_id) {
                    let amount = f64::from(normalized_offset);
                    self.hands.modulation(what, Address::id(voice_id), amount);
                    self.modulated = true;
                }
            }
            NoteEvent::MidiCC {
                channel, cc, value, ..
            } => match cc {
                control_change::ALL_SOUND_OFF | control_change::ALL_NOTES_OFF => {
                    self.strike_due(u128::MAX);
                    self.hands.note_off(Address::ALL, 0.0);
                    self.stage.each(Engine::choke_all);
                }
                _ => self.hands.controller(channel, cc, f64::from(value)),
            },
            NoteEvent::MidiPitchBend { channel, value, .. } => {
                let bend = bend_of_share(f64::from(value));
                self.hands.pitch_bend(channel, bend);
            }
            NoteEvent::MidiChannelPressure {
                channel, pressure, ..
            } => self.hands.channel_pressure(channel, f64::from(pressure)),
            _ => {
                if let Some((kind, address, value)) = expression(event) {
                    self.hands.expression(kind, address, f64::from(value));
                }
            }
        }
    }

    fn note_on(&mut self, note: Note, velocity: f32) {
        let key = note.key;
        // Struck twice at once: the first blow is what is known of it by now.
        self.strike_due(1 << key);
        let finger = Finger {
            channel: number(note.channel),
            key,
            id: match note.voice_id {
                VoiceID::ID(id) => Some(id),
                VoiceID::Wildcard => None,
            },
        };
        // Not the numbers that scatter its strike.
        let [chance, _] = chance(key | 0x80, self.position);
        self.hands.note_on(finger, f64::from(velocity), chance);
        self.due |= 1 << key;
        self.look_at = 0;
    }

    fn note_off(&mut self, address: Address, velocity: f32) {
        let keys = self.hands.note_off(address, f64::from(velocity));
        self.up |= keys & self.due;
        for key in each(keys & !self.due) {
            self.let_go(key);
        }
    }

    fn choke(&mut self, keys: u128, address: Address) {
        self.strike_due(keys);
        self.hands.note_off(address, 0.0);
        for key in each(keys) {
            let own = || self.tuner.owner(key).is_none().then_some(key);
            let place = self.tuner.place(key);
            if let Some(body) = place.map(|place| place.body).or_else(own) {
                self.stage.each(|engine| engine.choke(body));
            }
        }
    }
}

/// The channel's number; the first if it is not said.
pub(super) fn number(channel: Channel) -> u8 {
    match channel {
        Channel::Number(channel) => channel,
        Channel::Wildcard => 0,
    }
}

fn address(voice_id: VoiceID, channel: Channel, key: Key) -> Address {
    Address {
        channel: match channel {
            Channel::Number(channel) => Some(channel),
            Channel::Wildcard => None,
        },
        key: match key {
            Key::Number(key) => Some(key),
            Key::Wildcard => None,
        },
        id: match voice_id {
            VoiceID::ID(id) => Some(id),
            VoiceID::Wildcard => None,
        },
    }
}

/// What is said of some notes, if that is what the event does.
fn expression<S>(event: &NoteEvent<S>) -> Option<(Expression, Address, f32)> {
    let (kind, voice_id, channel, key, value) = match *event {
        NoteEvent::PolyTuning {
            voice_id,
            channel,
            key,
            tuning,
            ..
        } => (Expression::Tuning, voice_id, channel, key, tuning),
        NoteEvent::PolyPressure {
            voice_id,
            channel,
            key,
            pressure,
            ..
        } => (Expression::Pressure, voice_id, channel, key, pressure),
        NoteEvent::PolyBrightness {
            voice_id,
            channel,
            key,
            brightness,
            ..
        } => (Expression::Brightness, voice_id, channel, key, brightness),
        NoteEvent::PolyVolume {
            voice_id,
            channel,
            key,
            gain,
            ..
        } => (Expression::Volume, voice_id, channel, key, gain),
        NoteEvent::PolyPan {
            voice_id,
            channel,
            key,
            pan,
            ..
        } => (Expression::Pan, voice_id, channel, key, pan),
        NoteEvent::PolyVibrato {
            voice_id,
            channel,
            key,
            vibrato,
            ..
        } => (Expression::Vibrato, voice_id, channel, key, vibrato),
        NoteEvent::PolyExpression {
            voice_id,
            channel,
            key,
            expression,
            ..
        } => (Expression::Expression, voice_id, channel, key, expression),
        _ => return None,
    };
    Some((kind, address(voice_id, channel, key), value))
}
