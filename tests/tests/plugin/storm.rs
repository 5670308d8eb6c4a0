//! Whatever a host may send, in no order that makes sense.

use idiophone_tests::{BOUND, Noise, peak, playing, random};
use xtask::host::Event;

/// Events in all.
const EVENTS: usize = 30_000;
/// Frames a second.
const RATE: usize = 48_000;
/// Longest block.
const BLOCK: u64 = 512;

#[test]
fn a_storm_of_events_leaves_the_sound_finite() {
    let mut plugin = playing(RATE as f64).unwrap();
    let params: Vec<_> = plugin.params();
    let mut noise = Noise::new(2002);
    let loudest = plugin
        .on_audio_thread(|audio| {
            let (mut sent, mut loudest) = (0, 0.0f32);
            while sent < EVENTS {
                let frames = noise.below(BLOCK) + 1;
                let count = noise.below(48) as usize;
                let mut events: Vec<_> = (0..count)
                    .map(|_| random(&mut noise, &params).at(noise.below(frames)))
                    .collect();
                events.sort_by_key(|event| event.frame);
                let take = audio
                    .play(&events, frames as usize, BLOCK as usize)
                    .unwrap();
                loudest = loudest.max(peak(&take.left)).max(peak(&take.right));
                sent += count;
            }
            // What is once no number would stay it.
            let hush = Event::controller(120, 0).at(0);
            audio.play(&[hush], RATE, BLOCK as usize).unwrap();
            let after = audio.play(&[], 4800, BLOCK as usize).unwrap();
            assert_eq!(peak(&after.left), 0.0, "after the storm");
            loudest
        })
        .unwrap();
    println!("loudest sample {loudest}");
    assert!(loudest > 0.0 && loudest < BOUND, "{loudest}");
}
