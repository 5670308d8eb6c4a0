//! A block as a host passes it, to be spoilt.

use clap_sys::audio_buffer::clap_audio_buffer;
use clap_sys::events::{clap_input_events, clap_output_events};
use clap_sys::process::{clap_process, clap_process_status};
use idiophone_tests::{plugin_with, strike};
use std::ptr::{null, null_mut};
use xtask::host::{Plugin, Raw, TimedEvent};

pub(crate) const MAX_FRAMES: u32 = 512;
pub(crate) const OUTPUTS: usize = 8;
/// Where a host that means nothing points: whoever looks there crashes.
pub(crate) const NOWHERE: usize = 64;
/// A sample that nobody has written.
pub(crate) const UNTOUCHED: f32 = 7.0;

/// A block that is to be spoilt, with its outputs.
pub(crate) struct Block {
    pub(crate) sound: Vec<[Vec<f32>; 2]>,
    pub(crate) sides: Vec<[*mut f32; 2]>,
    pub(crate) outputs: Vec<clap_audio_buffer>,
    pub(crate) input: clap_input_events,
    pub(crate) output: clap_output_events,
    pub(crate) process: clap_process,
}

impl Block {
    /// One that is as it should be, of so many frames.
    pub(crate) fn new(frames: u32, raw: &Raw<'_>) -> Box<Self> {
        let mut sound = vec![[0, 1].map(|_| vec![UNTOUCHED; frames as usize]); OUTPUTS];
        let sides = sound.iter_mut();
        let sides = sides.map(|sides| sides.each_mut().map(Vec::as_mut_ptr));
        let mut block = Box::new(Self {
            sides: sides.collect(),
            sound,
            outputs: Vec::new(),
            input: raw.input,
            output: raw.output,
            process: clap_process {
                steady_time: -1,
                frames_count: frames,
                transport: null(),
                audio_inputs: null(),
                audio_outputs: null_mut(),
                audio_inputs_count: 0,
                audio_outputs_count: OUTPUTS as u32,
                in_events: null(),
                out_events: null(),
            },
        });
        let outputs = block.sides.iter_mut().map(|sides| clap_audio_buffer {
            data32: sides.as_mut_ptr(),
            data64: null_mut(),
            channel_count: 2,
            latency: 0,
            constant_mask: 0,
        });
        block.outputs = outputs.collect();
        block.process.audio_outputs = block.outputs.as_mut_ptr();
        block.process.in_events = &raw const block.input;
        block.process.out_events = &raw const block.output;
        block
    }

    /// Leaves out what comes after the first `count` outputs.
    pub(crate) fn stop_at(&mut self, count: usize) {
        self.process.audio_outputs_count = count as u32;
        for output in &mut self.outputs[count..] {
            output.data32 = NOWHERE as *mut _;
        }
    }
}

/// What has come of a block: what the plug-in said, and what it wrote.
pub(crate) type Played = (clap_process_status, Vec<[Vec<f32>; 2]>);

/// A chord on outputs 1 and 5, whose second block a host spoils; both blocks.
pub(crate) fn played(
    plugin: &mut Plugin,
    frames: u32,
    spoil: impl Fn(&mut Block) + Sync,
) -> [Played; 2] {
    plugin
        .on_audio_thread(|audio| {
            audio.reset();
            let chord: Vec<TimedEvent> = [60, 72].map(|key| strike(key, 0.8).at(3)).to_vec();
            let mut play = |events: &[TimedEvent], spoil: &dyn Fn(&mut Block)| {
                let raw = audio.raw(events).unwrap();
                let mut block = Block::new(frames, &raw);
                spoil(&mut block);
                // SAFETY: the plug-in is to bear it.
                let said = unsafe {
                    let process = (*raw.plugin).process.unwrap();
                    process(raw.plugin, &raw const block.process)
                };
                (said, std::mem::take(&mut block.sound))
            };
            [play(&chord, &spoil), play(&[], &|_| {})]
        })
        .unwrap()
}

/// An instance that plays on eight outputs, by body.
pub(crate) fn eight() -> Plugin {
    let mut plugin = plugin_with(&["Split outputs=by body", "Limiter=off"]).unwrap();
    plugin.lay_out("8 x stereo").unwrap();
    plugin.activate(48_000.0, MAX_FRAMES).unwrap();
    plugin
}
