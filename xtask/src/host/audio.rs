//! Playing events into an active plug-in, block by block.

use super::handlers::Handlers;
use super::{Plugin, TimedEvent};
use anyhow::{Result, bail};
use clack_extensions::tail::{PluginTail, TailLength};
use clack_host::events::spaces::CoreEventSpace;
use clack_host::prelude::*;

/// A plug-in as its audio thread sees it.
pub struct Audio<'a> {
    pub(super) processor: &'a mut StartedPluginAudioProcessor<Handlers>,
    frames_played: &'a mut u64,
    ports: AudioPorts,
    pub(super) input: EventBuffer,
    pub(super) output: EventBuffer,
}

/// What the plug-in said about a block.
#[derive(Clone, Debug, PartialEq)]
pub struct Block {
    /// Whether it wants to go on.
    pub status: ProcessStatus,
    /// Note ids whose sound has ended, with the frame in the block.
    pub ended: Vec<(u64, Option<u32>)>,
}

/// Stereo sound that was played, and what came with it.
#[derive(Clone, Debug, PartialEq)]
pub struct Take {
    /// Left channel.
    pub left: Vec<f32>,
    /// Right channel.
    pub right: Vec<f32>,
    /// Note ids whose sound has ended, with the frame.
    pub ended: Vec<(u64, Option<u32>)>,
    /// What the plug-in said last.
    pub status: ProcessStatus,
}

impl<'a> Audio<'a> {
    pub(super) fn new(
        processor: &'a mut StartedPluginAudioProcessor<Handlers>,
        frames_played: &'a mut u64,
    ) -> Self {
        Self {
            processor,
            frames_played,
            ports: AudioPorts::with_capacity(16, 8),
            input: EventBuffer::with_capacity(1024),
            output: EventBuffer::with_capacity(1024),
        }
    }

    /// Has the plug-in fall silent and forget what it was told.
    pub fn reset(&mut self) {
        self.processor.reset();
    }

    /// Frames that the plug-in says it will go on for if nothing happens; `None` if without end.
    pub fn tail(&mut self) -> Option<u32> {
        let handle = self.processor.plugin_handle();
        let tail: PluginTail = handle.get_extension()?;
        match tail.get(&handle) {
            TailLength::Finite(frames) => Some(frames),
            TailLength::Infinite => None,
        }
    }

    /// Plays one block as long as the channels are, with events at their frames within it, which a
    /// host sorts.
    ///
    /// The channels are filled with NaN beforehand, so that what is not written is seen.
    ///
    /// # Errors
    ///
    /// If the plug-in reports failure.
    pub fn process(
        &mut self,
        events: &[TimedEvent],
        left: &mut [f32],
        right: &mut [f32],
    ) -> Result<Block> {
        self.process_all(events, [[left, right]])
    }

    /// The same with as many outputs as the plug-in has, all of one length.
    ///
    /// # Errors
    ///
    /// If the plug-in reports failure.
    pub fn process_all<'b>(
        &mut self,
        events: &[TimedEvent],
        outputs: impl IntoIterator<Item = [&'b mut [f32]; 2], IntoIter: ExactSizeIterator>,
    ) -> Result<Block> {
        let mut frames = 0;
        self.input.clear();
        self.output.clear();
        for event in events {
            let time = u32::try_from(event.frame)?;
            event.event.push(time, &mut self.input);
        }
        let buffers = outputs.into_iter().map(|mut sides| {
            for side in &mut sides {
                side.fill(f32::NAN);
                frames = side.len() as u64;
            }
            AudioPortBuffer {
                latency: 0,
                channels: AudioPortBufferType::f32_output_only(sides.into_iter()),
            }
        });
        let mut output = self.ports.with_output_buffers(buffers);
        let status = self.processor.process(
            &InputAudioBuffers::empty(),
            &mut output,
            &self.input.as_input(),
            &mut self.output.as_output(),
            Some(*self.frames_played),
            None,
        )?;
        *self.frames_played += frames;
        let ended = self
            .output
            .iter()
            .filter_map(|event| match event.as_core_event()? {
                CoreEventSpace::NoteEnd(end) => Some((
                    u64::from(end.header().time()),
                    end.note_id().into_specific(),
                )),
                _ => None,
            })
            .collect();
        Ok(Block { status, ended })
    }

    /// Plays `frames` in blocks of up to `block`, with events sorted by frame within the whole.
    ///
    /// # Errors
    ///
    /// If the plug-in reports failure or leaves a sample that is no number.
    pub fn play(&mut self, events: &[TimedEvent], frames: usize, block: usize) -> Result<Take> {
        let mut take = Take {
            left: vec![0.0; frames],
            right: vec![0.0; frames],
            ended: Vec::new(),
            status: ProcessStatus::Continue,
        };
        let mut waiting = events;
        let mut start = 0;
        while start < frames {
            let end = (start + block.max(1)).min(frames);
            let due = waiting.partition_point(|event| event.frame < end as u64);
            let (now, later) = waiting.split_at(due);
            waiting = later;
            let now: Vec<_> = now
                .iter()
                .map(|event| event.event.at(event.frame - start as u64))
                .collect();
            let done = self.process(
                &now,
                &mut take.left[start..end],
                &mut take.right[start..end],
            )?;
            let ended = done.ended.into_iter();
            take.ended
                .extend(ended.map(|(frame, id)| (frame + start as u64, id)));
            take.status = done.status;
            start = end;
        }
        let sound = take.left.iter().chain(&take.right);
        if let Some(at) = sound.clone().position(|sample| !sample.is_finite()) {
            bail!("sample {} of {frames} is no finite number", at % frames);
        }
        Ok(take)
    }
}

impl Plugin {
    /// Plays `frames` in blocks of up to `block` on an audio thread.
    ///
    /// # Errors
    ///
    /// If the plug-in is inactive, reports failure, or leaves a sample that is no finite number.
    pub fn play(&mut self, events: &[TimedEvent], frames: usize, block: usize) -> Result<Take> {
        self.on_audio_thread(|audio| audio.play(events, frames, block))?
    }
}
