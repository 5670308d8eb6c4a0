//! A CLAP host that plays on one thread and shows the editor on another.

use crate::screen::Screen;
use clack_extensions::gui::{
    GuiApiType, GuiConfiguration, GuiSize, HostGui, HostGuiImpl, PluginGui, Window,
};
use clack_extensions::params::{
    HostParams, HostParamsImplMainThread, HostParamsImplShared, ParamClearFlags, ParamRescanFlags,
};
use clack_extensions::state::PluginState;
use clack_extensions::thread_check::{HostThreadCheck, HostThreadCheckImpl};
use clack_host::entry::{LibraryEntry, PluginEntry};
use clack_host::prelude::*;
use clack_host::utils::ClapId;
use std::ffi::CString;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, AtomicU32, AtomicU64, Ordering};
use std::thread::{self, JoinHandle, ThreadId};
use std::time::{Duration, Instant};

/// Frames of a block at 48 kHz.
const BLOCK: usize = 480;

/// What the plug-in may call from any thread.
pub(crate) struct Shared {
    main: ThreadId,
    callback: AtomicBool,
}

/// What it may call from the main thread.
pub(crate) struct MainThread;

struct Handlers;

impl HostHandlers for Handlers {
    type Shared<'a> = Shared;
    type MainThread<'a> = MainThread;
    type AudioProcessor<'a> = ();

    fn declare_extensions(builder: &mut HostExtensions<Self>, _: &Shared) {
        builder
            .register::<HostGui>()
            .register::<HostParams>()
            .register::<HostThreadCheck>();
    }
}

impl SharedHandler<'_> for Shared {
    fn request_restart(&self) {}
    fn request_process(&self) {}
    fn request_callback(&self) {
        self.callback.store(true, Ordering::SeqCst);
    }
}

impl MainThreadHandler<'_> for MainThread {}

impl HostThreadCheckImpl for Shared {
    fn is_main_thread(&self) -> bool {
        thread::current().id() == self.main
    }
    fn is_audio_thread(&self) -> bool {
        !self.is_main_thread()
    }
}

impl HostParamsImplShared for Shared {
    fn request_flush(&self) {}
}

impl HostParamsImplMainThread for MainThread {
    fn rescan(&self, _: ParamRescanFlags) {}
    fn clear(&self, _: ClapId, _: ParamClearFlags) {}
}

impl HostGuiImpl for Shared {
    fn resize_hints_changed(&self) {}
    fn request_resize(&self, _: GuiSize) -> Result<(), HostError> {
        Ok(())
    }
    fn request_show(&self) -> Result<(), HostError> {
        Ok(())
    }
    fn request_hide(&self) -> Result<(), HostError> {
        Ok(())
    }
    fn closed(&self, _: bool) {}
}

/// What the two threads tell each other.
#[derive(Default)]
struct Told {
    stop: AtomicBool,
    blocks: AtomicU64,
    /// Greatest sample, as bits.
    peak: AtomicU32,
}

/// The host.
pub(crate) struct Host {
    told: Arc<Told>,
    player: Option<JoinHandle<StartedPluginAudioProcessor<Handlers>>>,
    instance: PluginInstance<Handlers>,
    gui: PluginGui,
}

fn entry() -> PluginEntry {
    let path = idiophone_tests::library_file().unwrap();
    let text = CString::new(path.to_string_lossy().as_bytes()).unwrap();
    // SAFETY: it is our own, and its entry point is CLAP's by its name.
    #[expect(unsafe_code, reason = "loading a dynamic library")]
    unsafe {
        let library = LibraryEntry::load_from_path(&path).unwrap();
        PluginEntry::load_from(library, &text).unwrap()
    }
}

impl Host {
    /// A host that plays nothing, without end.
    pub(crate) fn new() -> Self {
        let entry = entry();
        let factory = entry.get_plugin_factory().unwrap();
        let id = factory.plugin_descriptors().next().unwrap().id().unwrap();
        let info = HostInfo::new("Idiophone host", "Idiophone", "", "1").unwrap();
        let mut instance = PluginInstance::<Handlers>::new(
            |()| Shared {
                main: thread::current().id(),
                callback: AtomicBool::new(false),
            },
            |_| MainThread,
            &entry,
            id,
            &info,
        )
        .unwrap();
        let gui = instance.plugin_handle().get_extension().unwrap();
        let audio = PluginAudioConfiguration {
            sample_rate: 48e3,
            min_frames_count: 1,
            max_frames_count: BLOCK as u32,
        };
        let processor = instance.activate(|_, _| (), audio).unwrap();
        let told = Arc::new(Told::default());
        let there = Arc::clone(&told);
        let player = thread::spawn(move || play(processor, &there));
        Self {
            told,
            player: Some(player),
            instance,
            gui,
        }
    }

    /// Opens the editor in the screen's window; its size in pixels.
    pub(crate) fn open(&mut self, screen: &Screen) -> [u32; 2] {
        let handle = self.instance.plugin_handle();
        let how = GuiConfiguration {
            api_type: GuiApiType::X11,
            is_floating: false,
        };
        self.gui.create(&handle, how).unwrap();
        let size = self.gui.get_size(&handle).unwrap();
        // SAFETY: the screen outlives the editor.
        #[expect(unsafe_code, reason = "a window's handle is a number")]
        unsafe {
            let window = Window::from_x11_handle(screen.window().into());
            self.gui.set_parent(&handle, window).unwrap();
        }
        // Some editors are there as soon as they have a parent.
        let _ = self.gui.show(&handle);
        [size.width, size.height]
    }

    /// Gives it another size in pixels.
    pub(crate) fn resize(&mut self, [width, height]: [u16; 2]) {
        let handle = self.instance.plugin_handle();
        let wanted = GuiSize {
            width: width.into(),
            height: height.into(),
        };
        assert!(self.gui.can_resize(&handle));
        let size = self.gui.adjust_size(&handle, wanted).unwrap();
        self.gui.set_size(&handle, size).unwrap();
    }

    /// Closes it.
    pub(crate) fn close(&mut self) {
        self.gui.destroy(&self.instance.plugin_handle());
    }

    /// Lets time pass, and the plug-in do on the main thread what it wants to.
    pub(crate) fn pump(&mut self, time: Duration) {
        let end = Instant::now() + time;
        while Instant::now() < end {
            let wanted = |shared: &Shared| shared.callback.swap(false, Ordering::SeqCst);
            if self.instance.access_shared_handler(wanted) {
                self.instance.call_on_main_thread_callback();
            }
            thread::sleep(Duration::from_millis(5));
        }
    }

    /// What a song would keep.
    pub(crate) fn state(&mut self) -> Vec<u8> {
        let handle = self.instance.plugin_handle();
        let state: PluginState = handle.get_extension().unwrap();
        let mut bytes = Vec::new();
        state.save(&handle, &mut bytes).unwrap();
        bytes
    }

    /// Greatest sample since it was last asked for.
    pub(crate) fn peak(&self) -> f32 {
        f32::from_bits(self.told.peak.swap(0, Ordering::Relaxed))
    }

    /// Blocks that have been played.
    pub(crate) fn blocks(&self) -> u64 {
        self.told.blocks.load(Ordering::Relaxed)
    }
}

impl Drop for Host {
    fn drop(&mut self) {
        self.told.stop.store(true, Ordering::Relaxed);
        let player = self.player.take().map(JoinHandle::join);
        if let Some(Ok(processor)) = player {
            self.instance.deactivate(processor.stop_processing());
        }
    }
}

fn play(
    processor: StoppedPluginAudioProcessor<Handlers>,
    told: &Told,
) -> StartedPluginAudioProcessor<Handlers> {
    let mut processor = processor.start_processing().ok().unwrap();
    let mut ports = AudioPorts::with_capacity(2, 1);
    let (mut left, mut right) = ([0.0f32; BLOCK], [0.0f32; BLOCK]);
    while !told.stop.load(Ordering::Relaxed) {
        let channels = [&mut left[..], &mut right[..]].into_iter();
        let mut out = ports.with_output_buffers([AudioPortBuffer {
            latency: 0,
            channels: AudioPortBufferType::f32_output_only(channels),
        }]);
        let events = EventBuffer::new();
        let mut heard = EventBuffer::new();
        processor
            .process(
                &InputAudioBuffers::empty(),
                &mut out,
                &events.as_input(),
                &mut OutputEvents::from_buffer(&mut heard),
                None,
                None,
            )
            .unwrap();
        let peak = left.iter().fold(0.0f32, |most, x| most.max(x.abs()));
        // Positive floats are ordered as their bits are.
        told.peak.fetch_max(peak.to_bits(), Ordering::Relaxed);
        told.blocks.fetch_add(1, Ordering::Relaxed);
        thread::sleep(Duration::from_millis(10));
    }
    processor
}
