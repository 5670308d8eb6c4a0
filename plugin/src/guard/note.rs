//! Events as the framework hands them to the plug-in, put right.

use super::Span;
use nice_plug::midi::{Channel, Key};
use nice_plug::prelude::{NoteEvent, PluginApi};

/// The event as the host meant it, with values within their limits; `None` if it is about no key or
/// channel there is.
///
/// The VST3 side of nice-plug 0.4.2 takes expression for brightness and brightness for expression
/// (`vst3/note_expressions.rs`), passes on values that are no numbers, and makes keys and channels
/// that do not exist stand for all, which VST3 itself cannot say.
pub(crate) fn put_right<S>(event: NoteEvent<S>, api: PluginApi) -> Option<NoteEvent<S>> {
    let mut event = match api {
        PluginApi::Vst3 => swap(event),
        PluginApi::Clap | PluginApi::Standalone => event,
    };
    if let Some((channel, key)) = address(&event) {
        let exists = match (channel, key) {
            (Channel::Number(channel), Key::Number(key)) => channel < 16 && key < 128,
            _ => api != PluginApi::Vst3,
        };
        if !exists {
            return None;
        }
    }
    confine(&mut event);
    Some(event)
}

fn swap<S>(event: NoteEvent<S>) -> NoteEvent<S> {
    match event {
        NoteEvent::PolyBrightness {
            timing,
            voice_id,
            channel,
            key,
            brightness,
        } => NoteEvent::PolyExpression {
            timing,
            voice_id,
            channel,
            key,
            expression: brightness,
        },
        NoteEvent::PolyExpression {
            timing,
            voice_id,
            channel,
            key,
            expression,
        } => NoteEvent::PolyBrightness {
            timing,
            voice_id,
            channel,
            key,
            brightness: expression,
        },
        other => other,
    }
}

/// Which notes an event is about, if it is about notes.
const fn address<S>(event: &NoteEvent<S>) -> Option<(Channel, Key)> {
    match event {
        NoteEvent::NoteOn { channel, key, .. }
        | NoteEvent::NoteOff { channel, key, .. }
        | NoteEvent::Choke { channel, key, .. }
        | NoteEvent::PolyPressure { channel, key, .. }
        | NoteEvent::PolyVolume { channel, key, .. }
        | NoteEvent::PolyPan { channel, key, .. }
        | NoteEvent::PolyTuning { channel, key, .. }
        | NoteEvent::PolyVibrato { channel, key, .. }
        | NoteEvent::PolyExpression { channel, key, .. }
        | NoteEvent::PolyBrightness { channel, key, .. } => Some((*channel, *key)),
        _ => None,
    }
}

fn confine<S>(event: &mut NoteEvent<S>) {
    let (value, span) = match event {
        NoteEvent::NoteOn { velocity, .. } | NoteEvent::NoteOff { velocity, .. } => {
            (velocity, Span::UNIT)
        }
        NoteEvent::PolyPressure { pressure, .. }
        | NoteEvent::MidiChannelPressure { pressure, .. } => (pressure, Span::UNIT),
        NoteEvent::PolyVolume { gain, .. } => (gain, Span::VOLUME),
        NoteEvent::PolyPan { pan, .. } => (pan, Span::SIGNED),
        NoteEvent::PolyTuning { tuning, .. } => (tuning, Span::TUNING),
        NoteEvent::PolyVibrato { vibrato, .. } => (vibrato, Span::UNIT),
        NoteEvent::PolyExpression { expression, .. } => (expression, Span::EXPRESSION),
        NoteEvent::PolyBrightness { brightness, .. } => (brightness, Span::BRIGHTNESS),
        NoteEvent::MidiPitchBend { value, .. } => (value, Span::CENTRED),
        NoteEvent::MidiCC { value, .. } => (value, Span::UNIT),
        _ => return,
    };
    *value = span.confine(f64::from(*value)) as f32;
}

#[cfg(test)]
mod tests {
    use super::*;
    use nice_plug::midi::VoiceID;

    type Event = NoteEvent<()>;

    const ALL: [PluginApi; 3] = [PluginApi::Clap, PluginApi::Vst3, PluginApi::Standalone];

    fn expression(expression: f32) -> Event {
        NoteEvent::PolyExpression {
            timing: 3,
            voice_id: VoiceID::ID(5),
            channel: Channel::Number(1),
            key: Key::Number(60),
            expression,
        }
    }

    fn brightness(brightness: f32) -> Event {
        NoteEvent::PolyBrightness {
            timing: 3,
            voice_id: VoiceID::ID(5),
            channel: Channel::Number(1),
            key: Key::Number(60),
            brightness,
        }
    }

    fn on(channel: Channel, key: Key, velocity: f32) -> Event {
        NoteEvent::NoteOn {
            timing: 0,
            voice_id: VoiceID::Wildcard,
            channel,
            key,
            velocity,
        }
    }

    #[test]
    fn expression_and_brightness_are_themselves_again_in_vst3() {
        let right = |event, api| put_right(event, api).unwrap();
        assert_eq!(right(expression(0.3), PluginApi::Vst3), brightness(0.3));
        assert_eq!(right(brightness(0.3), PluginApi::Vst3), expression(0.3));
        for api in [PluginApi::Clap, PluginApi::Standalone] {
            assert_eq!(right(expression(0.3), api), expression(0.3));
            assert_eq!(right(brightness(0.3), api), brightness(0.3));
        }
        assert_eq!(
            right(brightness(f32::NAN), PluginApi::Vst3),
            expression(1.0)
        );
    }

    #[test]
    fn velocities_are_numbers_everywhere() {
        let (channel, key) = (Channel::Number(0), Key::Number(60));
        for api in ALL {
            for (sent, wanted) in [
                (f32::NAN, 0.0),
                (f32::INFINITY, 1.0),
                (-0.1, 0.0),
                (0.7, 0.7),
            ] {
                let right = put_right(on(channel, key, sent), api);
                assert_eq!(right, Some(on(channel, key, wanted)));
            }
        }
    }

    #[test]
    fn bends_and_tunings_have_their_own_limits() {
        let bend = |value| NoteEvent::<()>::MidiPitchBend {
            timing: 0,
            channel: 0,
            value,
        };
        let right = put_right(bend(f32::NAN), PluginApi::Vst3);
        assert_eq!(right, Some(bend(0.5)));
        let tuning = |tuning| NoteEvent::<()>::PolyTuning {
            timing: 0,
            voice_id: VoiceID::ID(1),
            channel: Channel::Number(0),
            key: Key::Number(60),
            tuning,
        };
        let right = put_right(tuning(f32::NEG_INFINITY), PluginApi::Vst3);
        assert_eq!(right, Some(tuning(-120.0)));
    }

    #[test]
    fn what_is_about_no_key_there_is_is_about_none() {
        let some = (Channel::Number(0), Key::Number(60));
        for (channel, key, clap, vst3) in [
            (some.0, some.1, true, true),
            (Channel::Wildcard, some.1, true, false),
            (some.0, Key::Wildcard, true, false),
            (some.0, Key::Number(128), false, false),
            (Channel::Number(16), some.1, false, false),
        ] {
            let event = on(channel, key, 0.5);
            assert_eq!(put_right(event, PluginApi::Clap).is_some(), clap);
            assert_eq!(put_right(event, PluginApi::Vst3).is_some(), vst3);
        }
    }
}
