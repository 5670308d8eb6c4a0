//! The player with a host that gives it events.

use super::*;
use crate::Idiophone;
use crate::hands::Modulated;
use modes::tuning::Tuning;
use nice_plug::context::process::{SendEventError, Transport};
use nice_plug::midi::{Channel, VoiceID};
use nice_plug::prelude::{PluginApi, control_change};
use std::sync::Arc;

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
    let tuner = Tuner::new(Tuning::default(), None);
    let controls = Arc::new(Controls::default());
    Player::new(
        Stage::new(0, crate::factory::bank(0), 48_000.0),
        tuner,
        controls,
        48_000.0,
    )
}

fn play(player: &mut Player, frames: usize, events: Vec<Event>) -> (Vec<f32>, Vec<(u32, i32)>) {
    let (mut left, mut right) = (vec![f32::NAN; frames], vec![f32::NAN; frames]);
    let mut host = Host::with(events);
    player.play::<Idiophone>(&mut Outputs::main(&mut left, &mut right), &mut host);
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
    assert_eq!(player.stage.awake(), 1 << 60 | 1 << 64);
    assert_eq!(player.tail(), None, "one is still to be struck");
    play(&mut player, 0, vec![on(0, 5, 72, 0.5)]);
    let (left, ended) = play(&mut player, 64, vec![]);
    assert_eq!(player.stage.awake(), 1 << 60 | 1 << 64 | 1 << 67 | 1 << 72);
    assert!(
        ended.is_empty() && left[0] != 0.0,
        "from the first sample on"
    );
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

fn off(timing: u32, id: i32, key: u8) -> Event {
    NoteEvent::NoteOff {
        timing,
        voice_id: VoiceID::ID(id),
        channel: Channel::Number(0),
        key: Key::Number(key),
        velocity: 0.0,
    }
}

fn modulation(timing: u32, id: i32, what: Modulated, normalized_offset: f32) -> Event {
    NoteEvent::PolyModulation {
        timing,
        voice_id: id,
        poly_modulation_id: what as u32,
        normalized_offset,
    }
}

#[test]
fn what_is_said_of_a_note_at_its_own_sample_counts_for_its_strike() {
    let sound = |events| play(&mut player(), 2400, events).0;
    let plain = sound(vec![on(10, 1, 60, 0.5)]);
    let after = sound(vec![
        on(10, 1, 60, 0.5),
        modulation(10, 1, Modulated::StrikePosition, 0.3),
        cc(10, 74, 0.0),
    ]);
    assert_ne!(after, plain);
    let later = sound(vec![
        on(10, 1, 60, 0.5),
        modulation(11, 1, Modulated::StrikePosition, 0.3),
        cc(11, 74, 0.0),
    ]);
    assert_eq!(later, plain, "too late for the blow");
    let other = sound(vec![
        on(10, 1, 60, 0.5),
        modulation(10, 2, Modulated::StrikePosition, 0.3),
    ]);
    assert_eq!(other, plain, "another note's");
}

#[test]
fn a_key_that_goes_down_and_up_at_once_is_struck_and_damped() {
    let mut player = player();
    let controls = Arc::clone(&player.controls);
    let damping = &controls.damping.note_off;
    // SAFETY: nothing plays.
    #[expect(unsafe_code, reason = "the host's way to set a parameter")]
    unsafe {
        use nice_plug::params::InternalParamMut;
        damping._internal_set_plain_value(true);
    }
    let events = vec![on(0, 1, 60, 0.5), off(0, 1, 60), on(0, 2, 64, 0.5)];
    let (_, ended) = play(&mut player, 48_000, events);
    assert_eq!(player.stage.awake(), 1 << 64);
    assert_eq!(ended.len(), 1);
    assert_eq!(ended[0].1, 1);
}

#[test]
fn note_offs_without_note_ons_do_nothing() {
    let mut player = player();
    let (left, ended) = play(&mut player, 64, vec![off(0, 1, 60), off(3, 2, 64)]);
    assert!(ended.is_empty() && left.iter().all(|sample| *sample == 0.0));
    let ringing = |events| play(&mut self::player(), 4800, events).0;
    let alone = ringing(vec![on(0, 1, 60, 0.5)]);
    assert_eq!(ringing(vec![on(0, 1, 60, 0.5), off(9, 7, 60)]), alone);
}

#[test]
fn a_tail_is_told_while_something_rings() {
    let mut player = player();
    assert_eq!(player.tail(), Some(0));
    play(&mut player, 4800, vec![on(0, 1, 96, 0.5)]);
    let tail = player.tail().unwrap();
    assert!(tail > 9600, "{tail}");
    play(&mut player, 4800, vec![]);
    let later = player.tail().unwrap();
    assert!(later <= tail, "{later} after {tail}");
    // What is left after that is below -100 dB.
    let (left, _) = play(&mut player, later as usize + 48, vec![]);
    let rest = &left[later as usize..];
    assert!(rest.iter().all(|sample| sample.abs() < 2e-5));
}

#[cfg(feature = "gui")]
#[test]
fn trims_reach_what_rings_and_instruments_that_come_later() {
    let mut player = player();
    play(&mut player, 4800, vec![on(0, 1, 60, 0.8)]);
    let bank = crate::factory::bank(0);
    let body = bank.bodies.iter().find(|body| body.key == 60).unwrap();
    let first = crate::engine::Partial::all(body)[0].label;
    player
        .controls
        .trims()
        .change(|trims| trims.set_solo(Some(first)));
    play(&mut player, 64, vec![]);
    let sounding = |player: &mut Player| {
        let mut levels = [0.0f32; 64];
        let count = player.stage().present().1.levels(60, &mut levels);
        levels[..count].iter().filter(|level| **level > 0.0).count()
    };
    assert_eq!(sounding(&mut player), 1);
    let bench = Arc::new(crate::workshop::Bench::new(Arc::default(), 48_000.0));
    for wanted in [1, 0] {
        player.stage().turn(wanted, &bench);
        bench.work();
        player.stage().turn(wanted, &bench);
    }
    play(&mut player, 4800, vec![on(0, 2, 60, 0.8)]);
    assert_eq!(sounding(&mut player), 1, "a new engine knows the trims");
}
