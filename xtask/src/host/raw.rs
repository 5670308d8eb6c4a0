//! The plug-in as CLAP has it, for what no good host does.

use super::{Audio, TimedEvent};
use anyhow::Result;
use clap_sys::events::{clap_input_events, clap_output_events};
use clap_sys::plugin::clap_plugin;
use std::marker::PhantomData;

/// Pointers that are good for as long as this is.
pub struct Raw<'a> {
    /// An active plug-in that is processing.
    pub plugin: *const clap_plugin,
    /// The events of a block, as a host passes them.
    pub input: clap_input_events,
    /// Where the plug-in may put its own.
    pub output: clap_output_events,
    audio: PhantomData<&'a mut ()>,
}

impl Audio<'_> {
    /// The plug-in and lists for a block with some events.
    ///
    /// # Errors
    ///
    /// If a frame is beyond what CLAP can say.
    pub fn raw(&mut self, events: &[TimedEvent]) -> Result<Raw<'_>> {
        self.input.clear();
        self.output.clear();
        for event in events {
            let time = u32::try_from(event.frame)?;
            event.event.push(time, &mut self.input);
        }
        Ok(Raw {
            plugin: self.processor.plugin_handle().as_raw_ptr(),
            input: *self.input.as_input().as_raw(),
            output: *self.output.as_output().as_raw(),
            audio: PhantomData,
        })
    }
}
