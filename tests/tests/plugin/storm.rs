//! Whatever a host may send, in no order that makes sense.

use idiophone_tests::{BOUND, Noise, peak, plugin, random};
use xtask::host::{Audio, Event, Param, TimedEvent};

/// Frames a second.
const RATE: usize = 48_000;
/// Longest block.
const BLOCK: u64 = 512;

/// Plays a block on some outputs; its loudest sample.
fn block(audio: &mut Audio<'_>, outputs: usize, events: &[TimedEvent], frames: usize) -> f32 {
    let mut sound = vec![[vec![0.0; frames], vec![0.0; frames]]; outputs];
    let sides = sound
        .iter_mut()
        .map(|sides| sides.each_mut().map(Vec::as_mut_slice));
    audio.process_all(events, sides).unwrap();
    let sides = sound.iter().flatten();
    assert!(sides.clone().flatten().all(|sample| sample.is_finite()));
    sides.fold(0.0, |most, side| peak(side).max(most))
}

/// Sends `most` events or some more to an instance on some outputs; the loudest sample.
fn storm(audio: &mut Audio<'_>, outputs: usize, params: &[Param], most: usize) -> f32 {
    let mut noise = Noise::new(2002);
    let (mut sent, mut loudest) = (0, 0.0f32);
    while sent < most {
        let frames = noise.below(BLOCK) + 1;
        let count = noise.below(48) as usize;
        let mut events: Vec<_> = (0..count)
            .map(|_| random(&mut noise, params).at(noise.below(frames)))
            .collect();
        events.sort_by_key(|event| event.frame);
        loudest = loudest.max(block(audio, outputs, &events, frames as usize));
        sent += count;
    }
    // What is once no number would stay it.
    block(audio, outputs, &[Event::controller(120, 0).at(0)], 512);
    for _ in 0..RATE / 512 {
        block(audio, outputs, &[], 512);
    }
    assert_eq!(block(audio, outputs, &[], 512), 0.0, "after the storm");
    loudest
}

#[test]
fn a_storm_of_events_leaves_the_sound_finite() {
    for (layout, outputs, events) in [("Stereo", 1, 30_000), ("8 x stereo", 8, 10_000)] {
        let mut plugin = plugin().unwrap();
        plugin.lay_out(layout).unwrap();
        // Each of some thousand shapes would be waited for.
        plugin.go_live().unwrap();
        plugin.activate(RATE as f64, 512).unwrap();
        let params = plugin.params();
        let loudest = plugin
            .on_audio_thread(|audio| storm(audio, outputs, &params, events))
            .unwrap();
        println!("{layout}: loudest sample {loudest}");
        assert!(loudest > 0.0 && loudest < BOUND, "{layout}: {loudest}");
    }
}
