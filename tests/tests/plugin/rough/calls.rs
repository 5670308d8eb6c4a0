//! Calls with lists, lengths, addresses and rates that are none.

use super::block::{Block, MAX_FRAMES, NOWHERE, eight, played};
use clap_sys::events::{CLAP_EVENT_TRANSPORT, clap_event_header, clap_event_transport};
use clap_sys::events::{clap_input_events, clap_output_events};
use clap_sys::ext::params::{CLAP_EXT_PARAMS, clap_plugin_params};
use clap_sys::process::CLAP_PROCESS_ERROR;
use idiophone_tests::{peak, plugin_with, strike};
use std::ptr::null;

#[test]
fn lists_that_are_missing_are_empty() {
    let mut plugin = eight();
    let mut sounds = |spoil: &(dyn Fn(&mut Block) + Sync)| {
        let [first, next] = played(&mut plugin, MAX_FRAMES, spoil);
        assert_ne!(first.0, CLAP_PROCESS_ERROR);
        let sides = first.1.into_iter().chain(next.1).flatten();
        sides.fold(0.0, |most: f32, side| peak(&side).max(most))
    };
    assert_eq!(sounds(&|block| block.process.in_events = null()), 0.0);
    assert_eq!(sounds(&|block| block.input.size = None), 0.0);
    assert_eq!(sounds(&|block| block.input.get = None), 0.0);
    let odd = |block: &mut Block| block.process.in_events = (NOWHERE + 1) as *const _;
    assert_eq!(sounds(&odd), 0.0);
    // Notes that end are told to nobody.
    assert!(sounds(&|block| block.process.out_events = null()) > 0.0);
    assert!(sounds(&|block| block.output.try_push = None) > 0.0);
    let odd = |block: &mut Block| block.process.out_events = (NOWHERE + 1) as *const _;
    assert!(sounds(&odd) > 0.0);
}

#[test]
fn parameters_are_flushed_without_lists() {
    let mut plugin = eight();
    let flushed = plugin.on_audio_thread(|audio| {
        let raw = audio.raw(&[]).unwrap();
        // SAFETY: the extension of this name is of this type, and the plug-in is to bear what is passed.
        unsafe {
            let params = (*raw.plugin).get_extension.unwrap()(raw.plugin, CLAP_EXT_PARAMS.as_ptr());
            let flush = (*params.cast::<clap_plugin_params>()).flush.unwrap();
            flush(raw.plugin, null(), null());
            let (input, output) = (
                clap_input_events {
                    size: None,
                    ..raw.input
                },
                clap_output_events {
                    try_push: None,
                    ..raw.output
                },
            );
            flush(raw.plugin, &raw const input, &raw const output);
        }
    });
    flushed.unwrap();
}

#[test]
fn a_block_longer_than_was_said_sounds_as_shorter_ones() {
    const LONG: u32 = 16 * MAX_FRAMES;
    let mut plugin = eight();
    let [long, _] = played(&mut plugin, LONG, |_| {});
    let [first, second] = played(&mut plugin, MAX_FRAMES, |_| {});
    let frames = MAX_FRAMES as usize;
    for ((long, first), second) in long.1.iter().zip(&first.1).zip(&second.1) {
        for ((long, first), second) in long.iter().zip(first).zip(second) {
            assert!(long[..frames] == *first && long[frames..2 * frames] == *second);
        }
    }
    // There is no room for what is left out of it.
    let [refused, after] = played(&mut plugin, LONG, |block| block.stop_at(1));
    assert_eq!(refused.0, CLAP_PROCESS_ERROR);
    assert_ne!(after.0, CLAP_PROCESS_ERROR);
}

/// An address that is no multiple of what its type asks for.
fn odd_copy<T: Copy>(of: T, room: &mut Vec<u8>) -> *const T {
    room.resize(size_of::<T>() + 16, 0);
    let start = room.as_ptr().align_offset(16) + 1;
    let odd = room[start..].as_mut_ptr().cast::<T>();
    // SAFETY: there is room.
    unsafe { odd.write_unaligned(of) };
    odd
}

#[test]
fn blocks_at_odd_addresses_are_read() {
    let mut plugin = eight();
    let [whole, _] = played(&mut plugin, MAX_FRAMES, |_| {});
    let sound = plugin
        .on_audio_thread(|audio| {
            audio.reset();
            let chord = [60, 72].map(|key| strike(key, 0.8).at(3));
            let raw = audio.raw(&chord).unwrap();
            let mut block = Block::new(MAX_FRAMES, &raw);
            let mut rooms = [const { Vec::new() }; 3];
            let [process, transport, output] = &mut rooms;
            let outputs = [block.outputs[0]];
            block.process.audio_outputs = odd_copy(outputs, output).cast_mut().cast();
            block.process.audio_outputs_count = 1;
            block.process.transport = odd_copy(still(), transport);
            let process = odd_copy(block.process, process);
            // SAFETY: the plug-in is to bear it.
            unsafe { (*raw.plugin).process.unwrap()(raw.plugin, process) };
            block.sound.swap_remove(0)
        })
        .unwrap();
    assert!(sound == whole.1[0]);
}

/// A transport that says nothing.
fn still() -> clap_event_transport {
    // SAFETY: it is plain numbers.
    let mut transport: clap_event_transport = unsafe { std::mem::zeroed() };
    transport.header = clap_event_header {
        size: size_of::<clap_event_transport>() as u32,
        type_: CLAP_EVENT_TRANSPORT,
        ..transport.header
    };
    transport
}

#[test]
fn what_is_no_block_is_an_error() {
    let mut plugin = eight();
    let said = plugin.on_audio_thread(|audio| {
        let raw = audio.raw(&[]).unwrap();
        // SAFETY: the plug-in is to bear it.
        unsafe { (*raw.plugin).process.unwrap()(raw.plugin, null()) }
    });
    assert_eq!(said.unwrap(), CLAP_PROCESS_ERROR);
}

#[test]
fn rates_that_are_none_are_refused() {
    let mut plugin = plugin_with(&[]).unwrap();
    let beyond = [f64::NAN, f64::INFINITY, f64::MAX, -48_000.0, 0.0, 1e-300];
    for rate_hz in beyond {
        assert!(plugin.activate(rate_hz, MAX_FRAMES).is_err(), "{rate_hz}");
    }
    for (rate_hz, max_frames) in [(1.0, 64), (1e7, 64), (48_000.0, u32::MAX)] {
        plugin.activate(rate_hz, max_frames).unwrap();
        let take = plugin.play(&[strike(60, 0.8).at(3)], 64, 64).unwrap();
        assert!(peak(&take.left) > 0.0, "{rate_hz} Hz");
        plugin.deactivate();
    }
}
