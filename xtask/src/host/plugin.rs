//! A plug-in instance: parameters, state, and its way in and out of playing.

use super::audio::Audio;
use super::handlers::{Handlers, MainThread, Shared};
use super::{Event, Library, Param, ParamId};
use anyhow::{Context, Result, anyhow, bail};
use clack_extensions::params::{ParamInfoBuffer, ParamInfoFlags, PluginParams};
use clack_extensions::remote_controls::{PluginRemoteControls, RemoteControlsPageBuffer};
use clack_extensions::render::{PluginRender, RenderMode};
use clack_extensions::state::PluginState;
use clack_extensions::voice_info::PluginVoiceInfo;
use clack_host::prelude::*;
use std::ffi::CString;

/// A plug-in instance.
pub struct Plugin {
    // Declared before `instance`: an audio processor must be gone before its instance.
    processor: Option<StartedPluginAudioProcessor<Handlers>>,
    pub(super) instance: PluginInstance<Handlers>,
    params: Option<PluginParams>,
    frames_played: u64,
}

impl Plugin {
    pub(super) fn new(library: &Library, id: &str) -> Result<Self> {
        let host = HostInfo::new("Idiophone host", "Idiophone", "", env!("CARGO_PKG_VERSION"))?;
        let id = CString::new(id)?;
        let mut instance = PluginInstance::<Handlers>::new(
            |()| Shared::new(),
            |_| MainThread,
            &library.entry,
            &id,
            &host,
        )
        .with_context(|| format!("{}: refuses to start", library.path.display()))?;
        let handle = instance.plugin_handle();
        let params = handle.get_extension();
        if let Some(render) = handle.get_extension::<PluginRender>() {
            // Nobody listens while it plays: the plug-in may take its time.
            render.set(&handle, RenderMode::Offline)?;
        }
        Ok(Self {
            processor: None,
            instance,
            params,
            frames_played: 0,
        })
    }

    /// Plays as for somebody who listens: from when it is next activated, the plug-in may not take its time.
    ///
    /// # Errors
    ///
    /// If the plug-in refuses.
    pub fn go_live(&mut self) -> Result<()> {
        let handle = self.instance.plugin_handle();
        if let Some(render) = handle.get_extension::<PluginRender>() {
            render.set(&handle, RenderMode::Realtime)?;
        }
        Ok(())
    }

    /// The plug-in's parameters, in its own order.
    pub fn params(&mut self) -> Vec<Param> {
        let Some(params) = self.params else {
            return Vec::new();
        };
        let handle = self.instance.plugin_handle();
        let text = |bytes: &[u8]| String::from_utf8_lossy(bytes).into_owned();
        (0..params.count(&handle))
            .filter_map(|index| {
                let mut buffer = ParamInfoBuffer::new();
                let info = params.get_info(&handle, index, &mut buffer)?;
                Some(Param {
                    id: ParamId(info.id),
                    name: text(info.name),
                    module: text(info.module),
                    min: info.min_value,
                    max: info.max_value,
                    default: info.default_value,
                    stepped: info.flags.contains(ParamInfoFlags::IS_STEPPED),
                    automatable: info.flags.contains(ParamInfoFlags::IS_AUTOMATABLE),
                    modulatable: info
                        .flags
                        .contains(ParamInfoFlags::IS_MODULATABLE_PER_NOTE_ID),
                    hidden: info.flags.contains(ParamInfoFlags::IS_HIDDEN),
                })
            })
            .collect()
    }

    /// A parameter's present value, on the plug-in's own scale.
    pub fn value(&mut self, id: ParamId) -> Option<f64> {
        self.params?.get_value(&self.instance.plugin_handle(), id.0)
    }

    /// How the plug-in writes a value, with its unit.
    pub fn text(&mut self, id: ParamId, value: f64) -> Option<String> {
        let mut buffer = [0; 256];
        let bytes = self
            .params?
            .value_to_text(&self.instance.plugin_handle(), id.0, value, &mut buffer)
            .ok()?;
        Some(String::from_utf8_lossy(bytes).into_owned())
    }

    /// How the plug-in reads a text; `None` if it refuses it.
    pub fn parse(&mut self, id: ParamId, text: &str) -> Option<f64> {
        let text = CString::new(text).ok()?;
        self.params?
            .text_to_value(&self.instance.plugin_handle(), id.0, &text)
    }

    /// Names of the pages of controls for remote surfaces, and the parameters on each.
    pub fn pages(&mut self) -> Vec<(String, Vec<ParamId>)> {
        let handle = self.instance.plugin_handle();
        let Some(remote) = handle.get_extension::<PluginRemoteControls>() else {
            return Vec::new();
        };
        (0..remote.count(&handle))
            .filter_map(|index| {
                let mut buffer = RemoteControlsPageBuffer::new();
                let page = remote.get(&handle, index, &mut buffer)?;
                let name = String::from_utf8_lossy(page.page_name).into_owned();
                let ids = page.param_ids.into_iter().flatten().map(ParamId);
                Some((name, ids.collect()))
            })
            .collect()
    }

    /// How many notes the plug-in can sound at once, if it says so.
    pub fn voices(&mut self) -> Option<u32> {
        let handle = self.instance.plugin_handle();
        let voices: PluginVoiceInfo = handle.get_extension()?;
        Some(voices.get(&handle)?.voice_capacity)
    }

    /// Sets parameters at once, without passing through the values between. Only while inactive.
    ///
    /// # Errors
    ///
    /// If the plug-in is active or has no parameters.
    pub fn set(&mut self, values: &[(ParamId, f64)]) -> Result<()> {
        let params = self.params.context("the plug-in has no parameters")?;
        let mut handle = self
            .instance
            .inactive_plugin_handle()
            .context("the plug-in is active")?;
        let mut events = EventBuffer::new();
        for &(id, value) in values {
            Event::Param { id, value }.push(0, &mut events);
        }
        params.flush(&mut handle, &events.as_input(), &mut OutputEvents::void());
        self.pump();
        Ok(())
    }

    /// The plug-in's state.
    ///
    /// # Errors
    ///
    /// If it cannot save it.
    pub fn save(&mut self) -> Result<Vec<u8>> {
        let handle = self.instance.plugin_handle();
        let state: PluginState = handle.get_extension().context("no state extension")?;
        let mut bytes = Vec::new();
        state.save(&handle, &mut bytes)?;
        Ok(bytes)
    }

    /// Puts the plug-in into a saved state.
    ///
    /// # Errors
    ///
    /// If it refuses the state.
    pub fn load(&mut self, mut bytes: &[u8]) -> Result<()> {
        let handle = self.instance.plugin_handle();
        let state: PluginState = handle.get_extension().context("no state extension")?;
        state.load(&handle, &mut bytes)?;
        self.pump();
        Ok(())
    }

    /// Makes the plug-in ready to play at `rate_hz` in blocks of up to `max_frames`.
    ///
    /// # Errors
    ///
    /// If it is active already or refuses.
    pub fn activate(&mut self, rate_hz: f64, max_frames: u32) -> Result<()> {
        if self.processor.is_some() {
            bail!("the plug-in is active already");
        }
        let configuration = PluginAudioConfiguration {
            sample_rate: rate_hz,
            min_frames_count: 1,
            max_frames_count: max_frames,
        };
        let stopped = self
            .instance
            .activate(|_, _| (), configuration)
            .with_context(|| {
                format!("the plug-in refuses {rate_hz} Hz in blocks of {max_frames}")
            })?;
        let started = stopped
            .start_processing()
            .map_err(|_| anyhow!("the plug-in refuses to start processing"))?;
        self.processor = Some(started);
        self.frames_played = 0;
        Ok(())
    }

    /// Stops playing; another [`Self::activate`] may follow.
    pub fn deactivate(&mut self) {
        if let Some(processor) = self.processor.take() {
            self.instance.deactivate(processor.stop_processing());
        }
        self.pump();
    }

    /// Does `work` on an audio thread of its own, as a host would.
    ///
    /// # Errors
    ///
    /// If the plug-in is not active.
    ///
    /// # Panics
    ///
    /// If `work` does.
    pub fn on_audio_thread<R: Send>(
        &mut self,
        work: impl FnOnce(&mut Audio<'_>) -> R + Send,
    ) -> Result<R> {
        let processor = self.processor.as_mut().context("the plug-in is inactive")?;
        let mut audio = Audio::new(processor, &mut self.frames_played);
        let done = std::thread::scope(|scope| scope.spawn(move || work(&mut audio)).join());
        self.pump();
        match done {
            Ok(done) => Ok(done),
            Err(panic) => std::panic::resume_unwind(panic),
        }
    }

    /// Warnings and errors that the plug-in has logged to the host.
    #[must_use]
    pub fn log(&self) -> Vec<String> {
        self.instance.access_shared_handler(Shared::log)
    }

    /// Grants the plug-in the main-thread calls it has asked for.
    fn pump(&mut self) {
        if self.instance.access_shared_handler(Shared::take_callback) {
            self.instance.call_on_main_thread_callback();
        }
    }
}

impl Drop for Plugin {
    fn drop(&mut self) {
        self.deactivate();
    }
}
