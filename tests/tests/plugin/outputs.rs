//! Outputs beside the main one.

use idiophone_tests::{peak, playing, plugin, plugin_with};
use std::collections::HashSet;
use xtask::host::{Audio, Event, Plugin, TimedEvent};

const LAYOUT: &str = "8 x stereo";
const FRAMES: usize = 4800;

/// An instance that plays on eight outputs.
fn laid_out(outputs: &str) -> Plugin {
    let mut plugin = plugin_with(&[&format!("Split outputs={outputs}"), "Limiter=off"]).unwrap();
    plugin.lay_out(LAYOUT).unwrap();
    plugin.activate(48_000.0, 512).unwrap();
    plugin
}

fn note(channel: u8, key: u8) -> TimedEvent {
    Event::NoteOn {
        channel,
        key,
        note_id: u32::from(key),
        velocity: 0.8,
    }
    .at(0)
}

/// Plays a block of what is struck at its start on eight outputs.
fn sound(audio: &mut Audio<'_>, events: &[TimedEvent]) -> Vec<[Vec<f32>; 2]> {
    let mut sound = vec![[vec![0.0; FRAMES], vec![0.0; FRAMES]]; 8];
    for start in (0..FRAMES).step_by(480) {
        let now = if start == 0 { events } else { &[] };
        let outputs = sound
            .iter_mut()
            .map(|sides| sides.each_mut().map(|side| &mut side[start..start + 480]));
        audio.process_all(now, outputs).unwrap();
    }
    sound
}

/// Numbers of the outputs that sound, counted from 1 as they are shown.
fn heard(plugin: &mut Plugin, events: &[TimedEvent]) -> Vec<usize> {
    let sound = plugin
        .on_audio_thread(|audio| {
            audio.reset();
            sound(audio, events)
        })
        .unwrap();
    let sounds = |(number, [left, right]): (usize, &[Vec<f32>; 2])| {
        let finite = left.iter().chain(right).all(|x| x.is_finite());
        assert!(finite, "output {number} is not written");
        (peak(left) > 0.0 && peak(right) > 0.0).then_some(number)
    };
    (1..).zip(&sound).filter_map(sounds).collect()
}

#[test]
fn there_is_one_output_unless_the_host_wants_eight() {
    let mut plugin = plugin().unwrap();
    let [main] = &plugin.outputs()[..] else {
        panic!("{:?}", plugin.outputs());
    };
    assert!(main.main && main.channels == 2 && main.name == "Main");
    let id = main.id;
    let layouts = [("Stereo".to_owned(), 1), (LAYOUT.to_owned(), 8)];
    assert_eq!(plugin.layouts(), layouts);
    plugin.lay_out(LAYOUT).unwrap();
    let outputs = plugin.outputs();
    let names: Vec<_> = outputs.iter().map(|port| port.name.as_str()).collect();
    assert_eq!(
        names,
        [
            "Main", "Output 2", "Output 3", "Output 4", "Output 5", "Output 6", "Output 7",
            "Output 8"
        ]
    );
    let ids: HashSet<_> = outputs.iter().map(|port| port.id).collect();
    assert_eq!(ids.len(), 8);
    assert!(outputs[0].main && outputs[0].id == id);
    assert!(
        outputs[1..]
            .iter()
            .all(|port| !port.main && port.channels == 2)
    );
    plugin.lay_out("Stereo").unwrap();
    assert_eq!(plugin.outputs().len(), 1);
}

#[test]
fn bodies_are_on_the_outputs_that_are_set() {
    let chord = [note(0, 40), note(1, 60), note(9, 72)];
    for (outputs, numbers) in [
        ("all in main", vec![1]),
        ("by octave", vec![2, 4, 5]),
        // The lowest of the chimes is key 36.
        ("by body", vec![1, 5]),
        ("by channel", vec![1, 2]),
    ] {
        assert_eq!(heard(&mut laid_out(outputs), &chord), numbers, "{outputs}");
    }
}

#[test]
fn with_all_in_main_eight_outputs_sound_as_one() {
    let chord = [note(0, 40), note(1, 60), note(9, 72)];
    let sound = laid_out("all in main")
        .on_audio_thread(|audio| sound(audio, &chord))
        .unwrap();
    let mut plain = playing(48_000.0).unwrap();
    let plain = plain.play(&chord, FRAMES, 480).unwrap();
    assert!(peak(&plain.left) > 0.01);
    assert!(sound[0] == [plain.left, plain.right]);
}

#[test]
fn without_other_outputs_everything_is_in_main() {
    let chord = [note(0, 40), note(1, 60), note(9, 72)];
    let mut plain = playing(48_000.0).unwrap();
    let plain = plain.play(&chord, FRAMES, 480).unwrap();
    let mut split = plugin_with(&["Split outputs=by octave"]).unwrap();
    split.activate(48_000.0, 4096).unwrap();
    let split = split.play(&chord, FRAMES, 480).unwrap();
    for (plain, split) in plain.left.iter().zip(&split.left) {
        assert!((plain - split).abs() < 1e-6);
    }
}
