//! The outputs of a plug-in, and the layouts it offers of them.

use super::Plugin;
use anyhow::{Context, Result};
use clack_extensions::audio_ports::{AudioPortFlags, AudioPortInfoBuffer, PluginAudioPorts};
use clack_extensions::audio_ports_config::{AudioPortsConfigBuffer, PluginAudioPortsConfig};

/// An output.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Port {
    /// By which the host knows it again.
    pub id: u32,
    /// As it is shown.
    pub name: String,
    /// Channels of it.
    pub channels: u32,
    /// Whether it is the main one.
    pub main: bool,
}

impl Plugin {
    /// The outputs, in the order of their buffers.
    pub fn outputs(&mut self) -> Vec<Port> {
        let handle = self.instance.plugin_handle();
        let Some(ports) = handle.get_extension::<PluginAudioPorts>() else {
            return Vec::new();
        };
        (0..ports.count(&handle, false))
            .filter_map(|index| {
                let mut buffer = AudioPortInfoBuffer::new();
                let info = ports.get(&handle, index, false, &mut buffer)?;
                Some(Port {
                    id: info.id.get(),
                    name: String::from_utf8_lossy(info.name).into_owned(),
                    channels: info.channel_count,
                    main: info.flags.contains(AudioPortFlags::IS_MAIN),
                })
            })
            .collect()
    }

    /// The names of the layouts of outputs, and how many outputs each has.
    pub fn layouts(&mut self) -> Vec<(String, u32)> {
        let handle = self.instance.plugin_handle();
        let Some(layouts) = handle.get_extension::<PluginAudioPortsConfig>() else {
            return Vec::new();
        };
        (0..layouts.count(&handle))
            .filter_map(|index| {
                let mut buffer = AudioPortsConfigBuffer::new();
                let layout = layouts.get(&handle, index, &mut buffer)?;
                let name = String::from_utf8_lossy(layout.name).into_owned();
                Some((name, layout.output_port_count))
            })
            .collect()
    }

    /// Has the plug-in have the outputs of the layout of that name. Only while inactive.
    ///
    /// # Errors
    ///
    /// If it is active, or has no such layout.
    pub fn lay_out(&mut self, name: &str) -> Result<()> {
        self.instance
            .inactive_plugin_handle()
            .context("the plug-in is active")?;
        let handle = self.instance.plugin_handle();
        let layouts: PluginAudioPortsConfig = handle
            .get_extension()
            .context("the plug-in has one layout of outputs")?;
        let id = (0..layouts.count(&handle)).find_map(|index| {
            let mut buffer = AudioPortsConfigBuffer::new();
            let layout = layouts.get(&handle, index, &mut buffer)?;
            (layout.name == name.as_bytes()).then_some(layout.id)
        });
        let id = id.with_context(|| format!("{name}: no such layout of outputs"))?;
        layouts.select(&handle, id)?;
        Ok(())
    }
}
