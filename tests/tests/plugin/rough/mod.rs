//! Hosts that give `process` less than they should, or more.

#![expect(unsafe_code, reason = "a bad host has pointers")]

mod block;
mod calls;

use block::{Block, MAX_FRAMES, NOWHERE, OUTPUTS, UNTOUCHED, eight, played};
use clap_sys::process::CLAP_PROCESS_ERROR;
use idiophone_tests::peak;
use std::ptr::null_mut;

/// Plays with what a host leaves out: what it gives is to sound as it would in a whole block, and so is the
/// next block. `given` tells of a channel whether the host gives it.
fn bears(what: &str, spoil: impl Fn(&mut Block) + Sync, given: impl Fn(usize, usize) -> bool) {
    let mut plugin = eight();
    let [whole, next] = played(&mut plugin, MAX_FRAMES, |_| {});
    let loud = whole.1.iter().flatten().filter(|side| peak(side) > 1e-4);
    assert_eq!(loud.count(), 4, "two outputs sound");
    assert!(whole.1[0][0] != whole.1[0][1], "on two sides");
    let [spoilt, after] = played(&mut plugin, MAX_FRAMES, spoil);
    assert_ne!(spoilt.0, CLAP_PROCESS_ERROR, "{what}");
    for (output, (sides, wanted)) in spoilt.1.iter().zip(&whole.1).enumerate() {
        for (side, (sound, wanted)) in sides.iter().zip(wanted).enumerate() {
            let untouched = vec![UNTOUCHED; sound.len()];
            let given = given(output, side);
            let wanted = if given { wanted } else { &untouched };
            assert!(sound == wanted, "{what}: output {output}, side {side}");
        }
    }
    assert!(after == next, "{what}: the next block");
}

#[test]
fn outputs_that_a_host_leaves_out_are_not_written_to() {
    for count in 0..OUTPUTS {
        let what = format!("{count} outputs");
        let stop = |block: &mut Block| block.stop_at(count);
        bears(&what, stop, |output, _| output < count);
    }
    let no_outputs = |block: &mut Block| block.process.audio_outputs = null_mut();
    bears("no outputs", no_outputs, |_, _| false);
}

#[test]
fn channels_that_a_host_leaves_out_are_not_written_to() {
    for at in [0, 1, 4, 7] {
        let no_channels = |block: &mut Block| block.outputs[at].data32 = null_mut();
        bears("no channels", no_channels, |output, _| output != at);
        for count in [0, 1, 2, 6, u32::MAX] {
            let what = format!("{count} channels");
            let some = |block: &mut Block| {
                block.outputs[at].channel_count = count;
                if let Some(side) = block.sides[at].get_mut(count as usize) {
                    *side = NOWHERE as *mut f32;
                }
            };
            bears(&what, some, |output, side| {
                output != at || side < count as usize
            });
        }
        for side in [0, 1] {
            let nulls = |block: &mut Block| block.sides[at][side] = null_mut();
            let others = |output: usize, of: usize| (output, of) != (at, side);
            bears("a null channel", nulls, others);
            let odd = |block: &mut Block| {
                let odd = block.sides[at][side].cast::<u8>().wrapping_add(1);
                block.sides[at][side] = odd.cast();
            };
            bears("an odd channel", odd, others);
        }
    }
}

#[test]
fn a_channel_that_is_given_twice_has_what_comes_first() {
    let twice = |block: &mut Block| block.sides[0][1] = block.sides[0][0];
    bears("twice", twice, |output, side| (output, side) != (0, 1));
    let all = |block: &mut Block| {
        let left = block.sides[0][0];
        block.sides.iter_mut().for_each(|sides| *sides = [left; 2]);
    };
    bears("one for all", all, |output, side| (output, side) == (0, 0));
}

#[test]
fn a_block_without_frames_needs_no_channels() {
    let mut plugin = eight();
    let [none, next] = played(&mut plugin, 0, |block| {
        block
            .sides
            .iter_mut()
            .for_each(|sides| *sides = [null_mut(); 2]);
    });
    assert!(none.0 != CLAP_PROCESS_ERROR && next.0 != CLAP_PROCESS_ERROR);
}
