//! Outputs as the framework wants them, whatever a host gives.

#![expect(unsafe_code, reason = "a host hands buffers over as pointers")]

use crate::engine::OUTPUTS;
use clap_sys::audio_buffer::clap_audio_buffer;
use std::ptr;

/// Channels of each output.
const SIDES: usize = 2;
/// Longest block, in frames, in which channels can be made up.
const LONGEST: u32 = 1 << 16;

/// Channels for what a host leaves out, which nobody hears.
///
/// Only [`Channels::new`] allocates.
pub(super) struct Channels {
    /// Frames of each made-up channel.
    longest: usize,
    /// All of them, one after the other.
    spare: Vec<f32>,
    sides: [[*mut f32; SIDES]; OUTPUTS],
    outputs: [clap_audio_buffer; OUTPUTS],
}

impl Channels {
    /// For blocks of up to `max_frames`.
    pub(super) fn new(max_frames: u32) -> Self {
        let longest = max_frames.min(LONGEST) as usize;
        Self {
            longest,
            spare: vec![0.0; OUTPUTS * SIDES * longest],
            sides: [[ptr::null_mut(); SIDES]; OUTPUTS],
            outputs: [nothing(); OUTPUTS],
        }
    }

    /// As many outputs as any layout has, both sides each: those of the first `count` at `given` that can be
    /// written to, and made-up ones in place of the others; `None` if the block is too long for those.
    ///
    /// # Safety
    ///
    /// `given` is null, or points to `count` outputs, whose `data32` are null or point to `channel_count`
    /// channels, which are null or have so many frames.
    pub(super) unsafe fn complete(
        &mut self,
        given: *const clap_audio_buffer,
        count: u32,
        frames: u32,
    ) -> Option<&mut [clap_audio_buffer; OUTPUTS]> {
        let mut spare = self.spare.chunks_exact_mut(self.longest.max(1));
        let mut missing = false;
        for output in 0..OUTPUTS {
            let here = !given.is_null() && output < count as usize;
            // SAFETY: there is one.
            let host = here.then(|| unsafe { given.add(output).read_unaligned() });
            let host = host.unwrap_or_else(nothing);
            for side in 0..SIDES {
                // SAFETY: the caller's.
                let channel = unsafe { channel(&host, side) };
                // The framework would write to one that is given twice as to two.
                let taken = self.sides[..output].iter().flatten();
                let taken = taken.chain(&self.sides[output][..side]);
                let twice = taken.into_iter().any(|&other| Some(other) == channel);
                let own = spare
                    .next()
                    .map_or(ptr::dangling_mut(), <[f32]>::as_mut_ptr);
                missing |= channel.is_none() || twice;
                self.sides[output][side] = channel.filter(|_| !twice).unwrap_or(own);
            }
            self.outputs[output] = clap_audio_buffer {
                data32: self.sides[output].as_mut_ptr(),
                data64: ptr::null_mut(),
                channel_count: SIDES as u32,
                ..host
            };
        }
        (!missing || frames as usize <= self.longest).then_some(&mut self.outputs)
    }
}

/// No output.
const fn nothing() -> clap_audio_buffer {
    clap_audio_buffer {
        data32: ptr::null_mut(),
        data64: ptr::null_mut(),
        channel_count: 0,
        latency: 0,
        constant_mask: 0,
    }
}

/// The channel on a side, if there is one to write floats to.
///
/// # Safety
///
/// The output's `data32` is null or points to its channels.
unsafe fn channel(output: &clap_audio_buffer, side: usize) -> Option<*mut f32> {
    if output.data32.is_null() || side >= output.channel_count as usize {
        return None;
    }
    // SAFETY: there is one.
    let channel = unsafe { output.data32.add(side).read_unaligned() };
    (!channel.is_null() && channel.is_aligned()).then_some(channel)
}
